// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Plates of bonds by finite elements.

#include "check.h"
#include "galerkin/plate.h"
#include "galerkin/plate_mesh.h"

typedef struct {
    pdmc_problem problem;
    pdmc_crack crack;
    pdmc_load loads[2];
    pdmc_support supports[2];
    pdmc_uncertainty noise;
    int tips[2];
} cracked;

// A plate of E = 1 that is pulled upwards and downwards, with a crack in its middle.
static inline void describe(double width, double height, double half_crack, double horizon, double spacing, cracked *c)
{
    *c = (cracked){
        .crack = {"a", {-half_crack, 0.0}, {half_crack, 0.0}},
        .loads = {{PDMC_SIDE_TOP, {0.0, 1.0}}, {PDMC_SIDE_BOTTOM, {0.0, -1.0}}},
        .noise = {PDMC_QUANTITY_MICROMODULUS, .bins = 3, .variation = 0.1},
        .tips = {0, 1},
    };
    c->problem = (pdmc_problem){
        .plate = {width, height, 1.0},
        .material = {1.0, PDMC_PLANE_STRESS, 1.0},
        .crack_count = 1,
        .cracks = &c->crack,
        .load_count = 2,
        .loads = c->loads,
        .supports = c->supports,
        .uncertainties = &c->noise,
        .solver = {.method = PDMC_METHOD_GALERKIN,
                   .spacing = spacing,
                   .horizon = horizon,
                   .load_layer = 0.5 * horizon,
                   .outer_parts = 1},
        .sampling = {.seed = 3, .samples = 64, .order = 4},
        .energy = {.tip_count = 2, .tips = c->tips, .angles = 8, .extension = 0.5 * horizon, .horizon = horizon},
    };
}
