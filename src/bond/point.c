// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/point.h"

#include <lapacke.h>
#include <math.h>

enum { MOST_TERMS = 6 };

static const double reach = 2.6; // spacings: 21 nodes on an open grid

static bool is_seen(const pdmc_problem *problem, double spacing, const double from[2], const double node[2])
{
    for (int c = 0; c < problem->crack_count; c++)
        if (pdmc_bond_is_cut(&problem->cracks[c], spacing, from, node)) return false;
    return true;
}

// The nodes, and the rows of the weighted fit: monomials of (x_k - x) / h times w_k.
static void gather(const pdmc_problem *problem, const pdmc_bond_grid *grid, const double x[2], const double anchor[2],
                   pdmc_bond_point *out, double weight[], double fit[][MOST_TERMS])
{
    const double h = grid->spacing;
    const int middle[2] = {(int)lround((x[0] - grid->origin[0]) / h), (int)lround((x[1] - grid->origin[1]) / h)};
    out->count = 0;
    for (int row = middle[1] - 3; row <= middle[1] + 3; row++)
        for (int column = middle[0] - 3; column <= middle[0] + 3; column++) {
            if (row < 0 || row >= grid->rows || column < 0 || column >= grid->columns) continue;
            double at[2];
            const int node = row * grid->columns + column;
            pdmc_bond_grid_node(grid, node, at);
            const double d[2] = {(at[0] - x[0]) / h, (at[1] - x[1]) / h},
                         near = 1.0 - (d[0] * d[0] + d[1] * d[1]) / (reach * reach);
            if (near <= 0.0 || !is_seen(problem, h, anchor, at)) continue;
            const double terms[MOST_TERMS] = {1.0, d[0], d[1], d[0] * d[0], d[0] * d[1], d[1] * d[1]};
            weight[out->count] = near;
            for (int t = 0; t < MOST_TERMS; t++) fit[out->count][t] = near * terms[t];
            out->node[out->count++] = node;
        }
}

// The first three rows of the fit's pseudo-inverse, times the weights: value and gradient.
static pdmc_status invert(int count, int terms, const double weight[], double fit[][MOST_TERMS], double spacing,
                          pdmc_bond_point *out)
{
    double unit[PDMC_BOND_POINT_NODES][3] = {{0.0}}, singular[MOST_TERMS];
    int rank;
    // A' X = I: the minimum-norm X of the transposed system is the pseudo-inverse's transpose.
    double transposed[MOST_TERMS][PDMC_BOND_POINT_NODES];
    for (int t = 0; t < terms; t++)
        for (int k = 0; k < count; k++) transposed[t][k] = fit[k][t];
    for (int t = 0; t < 3; t++) unit[t][t] = 1.0;
    const int info = LAPACKE_dgelsd(LAPACK_ROW_MAJOR, terms, count, 3, transposed[0], PDMC_BOND_POINT_NODES, unit[0], 3,
                                    singular, 1e-8, &rank);
    if (info != 0) return pdmc_raise(PDMC_ERR_EXTERN, "LAPACKE_dgelsd returned %d", info);
    if (rank < terms) return PDMC_ERR_SINGULAR;
    for (int k = 0; k < count; k++) {
        out->value[k] = weight[k] * unit[k][0];
        out->by_x[k] = weight[k] * unit[k][1] / spacing;
        out->by_y[k] = weight[k] * unit[k][2] / spacing;
    }
    return PDMC_OK;
}

pdmc_status pdmc_bond_point_at(const pdmc_problem *problem, const pdmc_bond_grid *grid, const double x[2],
                               const double anchor[2], pdmc_bond_point *out)
{
    double weight[PDMC_BOND_POINT_NODES], fit[PDMC_BOND_POINT_NODES][MOST_TERMS];
    gather(problem, grid, x, anchor, out, weight, fit);
    for (int terms = MOST_TERMS; terms >= 1; terms = terms == MOST_TERMS ? 3 : terms - 2) {
        if (out->count < terms) continue;
        const pdmc_status status = invert(out->count, terms, weight, fit, grid->spacing, out);
        if (status != PDMC_ERR_SINGULAR) return status;
    }
    return pdmc_raise(PDMC_ERR_SINGULAR, "no node is seen from (%g, %g)", x[0], x[1]);
}
