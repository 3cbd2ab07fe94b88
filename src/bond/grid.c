// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/grid.h"

#include <math.h>

// Of the four sides, in the order of pdmc_side.
typedef struct {
    bool held[4][2];
    double displacement[4][2];
} held_sides;

static held_sides read_supports(const pdmc_problem *problem)
{
    held_sides sides = {0};
    for (int s = 0; s < problem->support_count; s++) {
        const pdmc_support *support = &problem->supports[s];
        for (int i = 0; i < 2; i++) {
            if (!support->held[i]) continue;
            sides.held[support->side][i] = true;
            sides.displacement[support->side][i] = support->displacement[i];
        }
    }
    return sides;
}

// The mean over the sides beyond which the node lies: one, or two in a corner, where both hold the component.
static void hold(pdmc_bond_grid *grid, const held_sides *sides, int node, const bool is_beyond[4])
{
    for (int i = 0; i < 2; i++) {
        double sum = 0.0;
        int count = 0;
        for (int side = 0; side < 4; side++) {
            if (!is_beyond[side] || !sides->held[side][i]) continue;
            sum += sides->displacement[side][i];
            count++;
        }
        if (count == 0) continue;
        grid->held[node] |= (uint8_t)(1U << i);
        grid->prescribed[2 * node + i] = sum / count;
    }
}

pdmc_status pdmc_bond_grid_create(const pdmc_problem *problem, pdmc_bond_grid *out)
{
    pdmc_status status = PDMC_OK;
    const double h = problem->solver.spacing;
    const int width = (int)lround(problem->plate.width / h), height = (int)lround(problem->plate.height / h);
    const int layer = (int)ceil(problem->solver.horizon / h - 1e-9);
    const held_sides sides = read_supports(problem);
    int beyond[4];
    for (int side = 0; side < 4; side++) beyond[side] = sides.held[side][0] || sides.held[side][1] ? layer : 0;

    *out = (pdmc_bond_grid){.spacing = h};
    out->columns = beyond[PDMC_SIDE_LEFT] + width + beyond[PDMC_SIDE_RIGHT];
    out->rows = beyond[PDMC_SIDE_BOTTOM] + height + beyond[PDMC_SIDE_TOP];
    out->nodes = out->columns * out->rows;
    out->origin[0] = (0.5 - beyond[PDMC_SIDE_LEFT]) * h - 0.5 * problem->plate.width;
    out->origin[1] = (0.5 - beyond[PDMC_SIDE_BOTTOM]) * h - 0.5 * problem->plate.height;
    PDMC_NEW(out->held, out->nodes);
    PDMC_NEW(out->prescribed, 2 * (size_t)out->nodes);
    for (int node = 0; node < out->nodes; node++) {
        const int column = node % out->columns - beyond[PDMC_SIDE_LEFT];
        const int row = node / out->columns - beyond[PDMC_SIDE_BOTTOM];
        const bool is_beyond[4] = {column < 0, column >= width, row < 0, row >= height};
        hold(out, &sides, node, is_beyond);
    }
done:
    if (status != PDMC_OK) pdmc_bond_grid_clear(out);
    return status;
}

void pdmc_bond_grid_clear(pdmc_bond_grid *grid)
{
    pdmc_free(grid->held);
    pdmc_free(grid->prescribed);
    *grid = (pdmc_bond_grid){0};
}

void pdmc_bond_grid_node(const pdmc_bond_grid *grid, int node, double x[2])
{
    const int column = node % grid->columns, row = node / grid->columns;
    x[0] = grid->origin[0] + column * grid->spacing;
    x[1] = grid->origin[1] + row * grid->spacing;
}

pdmc_status pdmc_bond_grid_nodes(const pdmc_bond_grid *grid, double **x)
{
    pdmc_status status = PDMC_OK;
    *x = NULL;
    PDMC_NEW(*x, 2 * (size_t)grid->nodes);
    for (int k = 0; k < grid->nodes; k++) pdmc_bond_grid_node(grid, k, &(*x)[2 * (size_t)k]);
done:
    return status;
}
