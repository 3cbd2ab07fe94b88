// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A cracked grid with its affine model.

#include "bond/bond.h"
#include "check.h"

enum { ANGLES = 16, TIPS = 2 };

typedef struct {
    pdmc_problem problem;
    pdmc_crack crack;
    pdmc_load loads[2];
    pdmc_support supports[2];
    pdmc_uncertainty uncertainties[2];
    int tips[TIPS];
    pdmc_bond *bond;
    pdmc_affine model;
} cracked;

// 40 x 40 cells of side 0.1 with a crack of six, between two rows of nodes.
static inline void describe(cracked *c, int bins, double variation)
{
    *c = (cracked){
        .crack = {"a", {-0.3, 0.0}, {0.3, 0.0}},
        .loads = {{PDMC_SIDE_TOP, {0.0, 1.0}}, {PDMC_SIDE_BOTTOM, {0.0, -1.0}}},
        .uncertainties = {{PDMC_QUANTITY_MICROMODULUS, .bins = bins, .variation = variation},
                          {PDMC_QUANTITY_LOAD, .law = {.kind = PDMC_NORMAL, .location = 1.0, .scale = 0.2, .least = -INFINITY, .most = INFINITY}}},
        .tips = {0, 1},
    };
    c->problem = (pdmc_problem){
        .plate = {4.0, 4.0, 1.0},
        .material = {1.0, PDMC_PLANE_STRESS, 1.0},
        .crack_count = 1,
        .cracks = &c->crack,
        .load_count = 2,
        .loads = c->loads,
        .supports = c->supports,
        .uncertainty_count = 2,
        .uncertainties = c->uncertainties,
        .solver = {.method = PDMC_METHOD_BOND,
                   .spacing = 0.1,
                   .horizon = 0.4,
                   .area = PDMC_AREA_CENTROID,
                   .surface_correction = PDMC_ON,
                   .load_layer = 0.1},
        .sampling = {.seed = 3, .samples = 64, .order = 4, .tolerance = 1e-10},
        .energy = {.tip_count = TIPS, .tips = c->tips, .angles = ANGLES, .extension = 0.2, .horizon = 0.4},
    };
}

static inline void make(cracked *c)
{
    CHECK_OK(pdmc_bond_create(&c->problem, 2, &c->bond));
    CHECK_OK(pdmc_bond_affine(c->bond, NULL, &c->model));
}

static inline void clear(cracked *c)
{
    pdmc_affine_clear(&c->model);
    pdmc_bond_destroy(&c->bond);
}
