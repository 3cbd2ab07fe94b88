// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Plates for the tests of the bond method.

#include "bond/stiffness.h"
#include "check.h"

enum { MOST_OF_EACH = 4 };

typedef struct {
    pdmc_problem problem;
    pdmc_crack cracks[MOST_OF_EACH];
    pdmc_support supports[MOST_OF_EACH];
    pdmc_bond_plate made;
} bond_plate;

/// columns x rows cells of side 0.1, E = 1, plane stress, no cracks and nothing held.
static inline void bond_plate_describe(bond_plate *p, int columns, int rows, double ratio)
{
    *p = (bond_plate){0};
    p->problem = (pdmc_problem){.plate = {0.1 * columns, 0.1 * rows, 1.0},
                                .material = {1.0, PDMC_PLANE_STRESS, 1.0},
                                .cracks = p->cracks,
                                .supports = p->supports,
                                .solver = {.horizon = 0.1 * ratio, .spacing = 0.1, .area = PDMC_AREA_EXACT}};
}

static inline void bond_plate_crack(bond_plate *p, double x0, double y0, double x1, double y1)
{
    p->cracks[p->problem.crack_count++] = (pdmc_crack){.from = {x0, y0}, .to = {x1, y1}};
}

static inline void bond_plate_hold(bond_plate *p, pdmc_side side, int component, double displacement)
{
    pdmc_support *support = &p->supports[p->problem.support_count++];
    *support = (pdmc_support){.side = side};
    support->held[component] = true;
    support->displacement[component] = displacement;
}

static inline void bond_plate_make(bond_plate *p, int bins)
{
    CHECK_OK(pdmc_bond_horizon_create(&p->problem, bins, &p->made.horizon));
    CHECK_OK(pdmc_bond_grid_create(&p->problem, &p->made.grid));
    CHECK_OK(pdmc_bond_families_create(&p->problem, &p->made.grid, &p->made.horizon, &p->made.families));
}

static inline void bond_plate_clear(bond_plate *p)
{
    pdmc_bond_families_clear(&p->made.families);
    pdmc_bond_grid_clear(&p->made.grid);
    pdmc_bond_horizon_clear(&p->made.horizon);
}
