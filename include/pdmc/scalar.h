// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A problem of the scalar peridynamic equation, solved by finite elements on a row of levels, so that what it
/// converges to is seen. Plain data in the study's own units; see pdmc/galerkin.h for what is computed.

#include "pdmc/galerkin.h"
#include "pdmc/given.h"

/// Equal cells, triangles by Gmsh, or those of a file of Gmsh.
typedef enum { PDMC_ELEMENTS_CELLS, PDMC_ELEMENTS_TRIANGLES, PDMC_ELEMENTS_FILE } pdmc_elements_kind;

/// What is halved from level to level.
typedef enum { PDMC_VARY_SPACING, PDMC_VARY_HORIZON } pdmc_vary;

/// A side where nothing is prescribed; its flux is a force flux / horizon in a layer of the body as deep as the horizon.
typedef struct {
    int side; // left, right, bottom, top
    double flux; // 1 / length
} pdmc_open_side;

/// A box with its middle at the origin, or in two dimensions the body of a mesh. Either in it a wave u = sin(k.x + phase), whose source and values in the layer are
/// given: the levels of a fixed horizon are compared with it; those of a horizon that vanishes have the source of the
/// classical wave, and are compared with classical elements on the same mesh too. Or what the study gives: a source, values in
/// the layer, and sides without one; a level is compared with the level before.
typedef struct {
    int dimension;
    bool has_width, has_height; // those of a file are found in it
    double width, height;       // length; the height in two dimensions
    double horizon, power;
    int weight_count; // 0 for a kernel of one bin
    double *weights;  // [weight_count]
    pdmc_bond_law law;
    pdmc_space_kind space;
    pdmc_outer_rule outer;
    pdmc_inner_rule inner;
    pdmc_elements_kind mesh;
    int cells, parts; // cells along the width at the first level
    double spacing;   // of triangles at the first level, length
    bool has_hole_spacing;
    double hole_spacing, near; // ... within `near` of holes
    int hole_count;
    pdmc_hole *holes; // [hole_count], of triangles; the field is prescribed in them
    char *file;       // NULL without
    pdmc_mesh first;  // the file's, with its layer
    double rough_from, rough_to; // x of the rough elements of a mixed space
    bool has_wave;
    double wave_length;         // length
    double angle, phase;        // degrees; the angle from the x axis
    pdmc_given source;          // 1 / length^2, of what has no wave, as the next two
    pdmc_given prescribed;
    int open_count;
    pdmc_open_side *open; // [open_count]
    pdmc_vary vary;
    int levels;
    bool has_duration; // otherwise nothing moves
    double duration;   // length, as waves have speed 1
    double safety;     // the step over the longest stable one, at the first level
} pdmc_scalar;

/// Whether a side has a layer in which the field is prescribed.
PDMC_API bool pdmc_scalar_holds(const pdmc_scalar *problem, int side);

/// Frees what the problem owns and sets it to zero; a zeroed one is allowed.
PDMC_API void pdmc_scalar_clear(pdmc_scalar *problem);

/// What Gmsh is to make of the domain.
PDMC_API pdmc_mesh_plate pdmc_scalar_plate(const pdmc_scalar *problem);

/// Cells along the width and the height at a level, where there are any, and its horizon.
typedef struct {
    int cells[2];
    double horizon;
} pdmc_scalar_level;
PDMC_API pdmc_scalar_level pdmc_scalar_level_of(const pdmc_scalar *problem, int level);

/// Elements, entries of the form and wall time of a level, estimated.
typedef struct {
    double elements, entries, bytes, seconds;
} pdmc_scalar_cost;
PDMC_API pdmc_scalar_cost pdmc_scalar_cost_of(const pdmc_scalar *problem, int level, int threads);
