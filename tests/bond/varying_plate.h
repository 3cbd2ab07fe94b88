// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A stretched square of bonds with a crack of half length 0.5, for stiffnesses that vary in space.

#include "bond/bond.h"
#include "bond/release.h"
#include "check.h"

#include <stdlib.h>

enum { TIPS = 2, ANGLES = 8 };

typedef struct {
    pdmc_problem problem;
    pdmc_crack crack;
    pdmc_load loads[2];
    pdmc_support supports[2];
    pdmc_uncertainty uncertainties[2];
    int tips[TIPS];
    pdmc_bond *bond;
} varying_plate;

static inline double *new_values(size_t count)
{
    double *values = calloc(count, sizeof *values);
    assert_non_null(values);
    return values;
}

static inline double inner(int n, const double a[], const double b[])
{
    double sum = 0.0;
    for (int i = 0; i < n; i++) sum += a[i] * b[i];
    return sum;
}

// Side 5; the crack is between two rows of nodes.
static inline void varying_plate_describe(varying_plate *v, int cells, double ratio)
{
    const double h = 5.0 / cells;
    *v = (varying_plate){
        .crack = {"a", {-0.5, 0.0}, {0.5, 0.0}},
        .loads = {{PDMC_SIDE_TOP, {0.0, 1.0}}, {PDMC_SIDE_BOTTOM, {0.0, -1.0}}},
        .tips = {0, 1},
    };
    v->problem = (pdmc_problem){
        .plate = {5.0, 5.0, 1.0},
        .material = {1.0, PDMC_PLANE_STRESS, 1.0},
        .crack_count = 1,
        .cracks = &v->crack,
        .load_count = 2,
        .loads = v->loads,
        .supports = v->supports,
        .uncertainties = v->uncertainties,
        .solver = {.method = PDMC_METHOD_BOND,
                   .spacing = h,
                   .horizon = ratio * h,
                   .area = PDMC_AREA_CENTROID,
                   .load_layer = h},
        .sampling = {.seed = 3, .samples = 64, .order = 4, .tolerance = 1e-10},
        .energy = {.tip_count = TIPS, .tips = v->tips, .angles = ANGLES, .extension = 2.0 * h, .horizon = ratio * h},
    };
}

// psi = M - 1 at the nodes.
static inline double *varying_values(const pdmc_bond *bond, double (*modulus)(const void *context, const double x[2]),
                                     const void *context)
{
    double *value = new_values((size_t)bond->plate.grid.nodes);
    for (int node = 0; node < bond->plate.grid.nodes; node++) {
        double x[2];
        pdmc_bond_grid_node(&bond->plate.grid, node, x);
        value[node] = modulus(context, x) - 1.0;
    }
    return value;
}

static inline double *varying_release(const pdmc_bond *bond)
{
    const size_t nodes = (size_t)bond->plate.grid.nodes;
    double *release = new_values(TIPS * nodes);
    for (int t = 0; t < TIPS; t++) CHECK_OK(pdmc_bond_release(bond, t, &release[(size_t)t * nodes]));
    return release;
}

// G by a model of one term.
static inline double varying_energy(const pdmc_affine *model, int tip, double xi)
{
    const double scale[2] = {1.0, 1.0}, stiffness = 1.0 + xi * model->tip_stiffness[tip];
    const int n = model->unknowns;
    double *x = new_values((size_t)n), sum = 0.0;
    CHECK_OK(model->verbs->solve(model, &xi, scale, x));
    for (int k = 0; k < 2; k++) {
        const double K = inner(n, &model->stress_intensity[(size_t)(2 * tip + k) * (size_t)n], x);
        sum += stiffness * K * K; // E = 1, plane stress
    }
    free(x);
    return sum;
}
