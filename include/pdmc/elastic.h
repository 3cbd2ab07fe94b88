// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A problem of an elastic body at rest: a box of nodes, what holds and pulls its faces, and how it comes to rest. Plain
/// data in the study's own units; see pdmc/solid.h for what is computed.

#include "pdmc/solid.h"

typedef enum {
    PDMC_ELASTIC_STATIC,     // conjugate gradients
    PDMC_ELASTIC_RELAXATION, // dynamic relaxation
    PDMC_ELASTIC_DAMPED,     // damped motion for a number of steps
} pdmc_elastic_method;

/// In the order of the faces of pdmc_solid_options.
typedef enum {
    PDMC_FACE_X_LOW,
    PDMC_FACE_X_HIGH,
    PDMC_FACE_Y_LOW,
    PDMC_FACE_Y_HIGH,
    PDMC_FACE_Z_LOW,
    PDMC_FACE_Z_HIGH
} pdmc_elastic_face;

/// Layers of nodes with the displacement of the strain, or a traction.
typedef struct {
    pdmc_elastic_face face;
    int layers;
    pdmc_solid_load load;
} pdmc_elastic_condition;

typedef struct {
    int nodes[3];
    double spacing, horizon;
    double youngs_modulus;
    pdmc_solid_rule rule;
    int gauss_points;
    bool has_support; // a study that was read has it
    double support;
    pdmc_solid_compensation compensation;
    double strain[6]; // xx, yy, zz, yz, zx, xy
    int condition_count;
    pdmc_elastic_condition *conditions;
    pdmc_elastic_method method;
    double tolerance;
    int most_steps;
    bool has_constant_damping; // of relaxation, in a step of 1; otherwise adaptive
    double constant_damping;
    double density, damping, safety; // of damped motion
    int steps;
} pdmc_elastic;

/// Frees what the problem owns and sets it to zero; a zeroed one is allowed.
PDMC_API void pdmc_elastic_clear(pdmc_elastic *problem);

/// The body of the problem.
PDMC_API pdmc_solid_options pdmc_elastic_body(const pdmc_elastic *problem, int threads);

/// Nodes, bonds of a node, memory and wall time, estimated.
typedef struct {
    double nodes, bonds, bytes, seconds;
} pdmc_elastic_cost;
PDMC_API pdmc_elastic_cost pdmc_elastic_cost_of(const pdmc_elastic *problem, int threads);
