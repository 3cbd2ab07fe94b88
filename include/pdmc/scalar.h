// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A problem of the scalar peridynamic equation, solved by finite elements on a row of levels, so that what it
/// converges to is seen. Plain data in the study's own units; see pdmc/galerkin.h for what is computed.

#include "pdmc/galerkin.h"

/// Equal cells, triangles by Gmsh, or those of a file of Gmsh.
typedef enum { PDMC_ELEMENTS_CELLS, PDMC_ELEMENTS_TRIANGLES, PDMC_ELEMENTS_FILE } pdmc_elements_kind;

/// What is halved from level to level.
typedef enum { PDMC_VARY_SPACING, PDMC_VARY_HORIZON } pdmc_vary;

/// A box with its middle at the origin, or in two dimensions the body of a mesh, and in it a wave u = sin(k.x + phase), whose source and values in the layer are
/// given: the levels of a fixed horizon are compared with it; those of a horizon that vanishes have the source of the
/// classical wave, and are compared with classical elements on the same mesh too.
typedef struct {
    int dimension;
    bool has_width, has_height; // those of a file are found in it
    double width, height;       // length; the height in two dimensions
    double horizon, power;
    int weight_count; // 0 for a kernel of one bin
    double *weights;  // [weight_count]
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
    double wave_length;         // length
    double angle, phase;        // degrees; the angle from the x axis
    pdmc_vary vary;
    int levels;
    bool has_duration; // otherwise nothing moves
    double duration;   // length, as waves have speed 1
    double safety;     // the step over the longest stable one, at the first level
} pdmc_scalar;

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
