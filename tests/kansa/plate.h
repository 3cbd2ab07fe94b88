// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Plates for the tests of the collocation: E = 1, W = H = 5, the settings of the study file's defaults.

#include "check.h"
#include "pdmc/kansa.h"

/// A problem with room for what it points to.
typedef struct {
    pdmc_problem problem;
    pdmc_crack cracks[4];
    pdmc_load loads[4];
    pdmc_support supports[4];
    pdmc_uncertainty uncertainties[2];
    int tips[8];
} plate;

/// An uncracked plate with `cells` cells a side and no loads.
static inline void plate_make(plate *p, double size, int cells, double horizon)
{
    *p = (plate){0};
    p->problem = (pdmc_problem){
        .plate = {size, size, 1.0},
        .material = {1.0, PDMC_PLANE_STRESS, 1.0},
        .cracks = p->cracks,
        .loads = p->loads,
        .supports = p->supports,
        .uncertainties = p->uncertainties,
        .solver = {.horizon = horizon,
                  .spacing = size / cells,
                  .shape = 6.0 * size / cells,
                  .polynomial_degree = 3,
                  .crack_orders = 6,
                  .radial_points = 6},
        .sampling = {.seed = 1, .samples = 64, .inverse = PDMC_INVERSE_NEUMANN, .order = 4},
        .energy = {.tips = p->tips, .angles = 8, .extension = 0.25 * horizon, .horizon = horizon},
    };
}

static inline void plate_load(plate *p, pdmc_side side, double tx, double ty)
{
    p->loads[p->problem.load_count++] = (pdmc_load){side, {tx, ty}};
}

static inline void plate_crack(plate *p, double x, double y, double half_length, double angle)
{
    const double dx = half_length * cos(angle), dy = half_length * sin(angle);
    const int c = p->problem.crack_count++;
    p->cracks[c] = (pdmc_crack){"crack", {x - dx, y - dy}, {x + dx, y + dy}};
    for (int end = 0; end < 2; end++) p->tips[p->problem.energy.tip_count++] = 2 * c + end;
}

/// A 5 x 5 plate in unit tension along y with one central crack, horizon 0.2 a.
static inline void plate_make_cracked(plate *p, double half_length, double angle, int cells)
{
    plate_make(p, 5.0, cells, 0.2 * half_length);
    plate_load(p, PDMC_SIDE_TOP, 0.0, 1.0);
    plate_load(p, PDMC_SIDE_BOTTOM, 0.0, -1.0);
    plate_crack(p, 0.0, 0.0, half_length, angle);
}
