// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A bond solver of the tests' own: nodes on a regular grid over the square |x|, |y| < half with known displacements
/// outside it, straight cracks that cut bonds, conjugate gradients. A bond's weight is the exact integral of the kernel
/// over the part of its cell inside the horizon.

#include "check.h"
#include "pdmc/geometry.h"

#include <gsl/gsl_math.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    double horizon, half;
    int cells; // a horizon; half is a whole number of them
    void (*outside)(const double x[2], double u[2]);
    bool mirrored[2]; // the problem is symmetric to x -> -x, to y -> -y
    int crack_count;
    double cracks[2][2][2]; // [crack, end, component]; not through nodes, which lie at odd multiples of half a spacing
} bond_problem;

typedef struct {
    int node, partner;
    float weight[3];
} bond_cut;

typedef struct {
    const bond_problem *problem;
    double spacing;
    int side, reach, nodes; // nodes a side with those outside, in a horizon, in all
    int first[2], last;     // of the unknown rows and columns: half of them in a mirrored direction
    double *weight;         // [2 reach + 1, 2 reach + 1, 3] int c e e^T / r dA: xx, xy, yy
    double *cell_sum;       // [3] of all weights
    int cut_count, cut_room;
    bond_cut *cut;                                          // bonds of unknown nodes
    double *u[2], *residual[2], *direction[2], *product[2]; // [nodes]
} bond_grid;

static inline void bond_place(const bond_grid *g, int node, double x[2])
{
    x[0] = (node % g->side - 0.5 * (g->side - 1)) * g->spacing;
    x[1] = (node / g->side - 0.5 * (g->side - 1)) * g->spacing;
}

// The kernel c / r^3 (xx, xy, yy) over 24 x 24 parts of every cell.
static inline void bond_integrate_cells(bond_grid *g)
{
    enum { FINE = 24 };
    const double c = 9.0 / (M_PI * pow(g->problem->horizon, 3)), h = g->spacing;
    const int span = 2 * g->reach + 1;
    for (int k = 0; k < span * span * FINE * FINE; k++) {
        const int cell = k / (FINE * FINE), part = k % (FINE * FINE);
        const double x = (cell % span - g->reach + (part % FINE + 0.5) / FINE - 0.5) * h;
        const double y = (cell / span - g->reach + (part / FINE + 0.5) / FINE - 0.5) * h, r2 = x * x + y * y;
        if (r2 > g->problem->horizon * g->problem->horizon || cell == span * span / 2) continue;
        const double f = c * h * h / (FINE * FINE) / (r2 * sqrt(r2)), add[3] = {f * x * x, f * x * y, f * y * y};
        for (int d = 0; d < 3; d++) {
            g->weight[3 * cell + d] += add[d];
            g->cell_sum[d] += add[d];
        }
    }
}

static inline bool bond_is_cut(const bond_problem *p, const double a[2], const double b[2])
{
    for (int c = 0; c < p->crack_count; c++)
        if (pdmc_segments_cross(a, b, p->cracks[c][0], p->cracks[c][1])) return true;
    return false;
}

static inline bool bond_is_near(const bond_problem *p, const double x[2])
{
    for (int c = 0; c < p->crack_count; c++)
        if (pdmc_point_segment_distance(x, p->cracks[c][0], p->cracks[c][1]) <= 1.1 * p->horizon) return true;
    return false;
}

static inline void bond_keep_cut(bond_grid *g, int node, int partner, const double w[3])
{
    if (g->cut_count == g->cut_room) {
        g->cut_room = 2 * g->cut_room + 1024;
        g->cut = realloc(g->cut, (size_t)g->cut_room * sizeof *g->cut);
        assert_non_null(g->cut);
    }
    g->cut[g->cut_count++] = (bond_cut){node, partner, {(float)w[0], (float)w[1], (float)w[2]}};
}

static inline void bond_find_cuts(bond_grid *g)
{
    const int span = 2 * g->reach + 1;
    for (int row = g->first[1]; row < g->last; row++) {
        for (int column = g->first[0]; column < g->last; column++) {
            const int node = row * g->side + column;
            double x[2];
            bond_place(g, node, x);
            if (!bond_is_near(g->problem, x)) continue;
            for (int k = 0; k < span * span; k++) {
                const int i = k % span - g->reach, j = k / span - g->reach;
                const double *w = &g->weight[3 * k], y[2] = {x[0] + i * g->spacing, x[1] + j * g->spacing};
                if (w[0] + w[2] > 0.0 && bond_is_cut(g->problem, x, y))
                    bond_keep_cut(g, node, node + j * g->side + i, w);
            }
        }
    }
}

static inline void bond_create(const bond_problem *problem, bond_grid *g)
{
    const int inside = 2 * (int)round(problem->half / problem->horizon * problem->cells), reach = problem->cells + 1;
    *g = (bond_grid){.problem = problem, .spacing = problem->horizon / problem->cells, .reach = reach};
    g->side = inside + 2 * reach;
    g->nodes = g->side * g->side;
    g->last = g->side - reach;
    for (int d = 0; d < 2; d++) {
        g->first[d] = problem->mirrored[d] ? g->side / 2 : reach;
        g->u[d] = test_calloc((size_t)g->nodes, sizeof(double));
        g->residual[d] = test_calloc((size_t)g->nodes, sizeof(double));
        g->direction[d] = test_calloc((size_t)g->nodes, sizeof(double));
        g->product[d] = test_calloc((size_t)g->nodes, sizeof(double));
    }
    g->weight = test_calloc((size_t)(2 * reach + 1) * (size_t)(2 * reach + 1) * 3, sizeof(double));
    g->cell_sum = test_calloc(3, sizeof(double));
    bond_integrate_cells(g);
    bond_find_cuts(g);
    for (int node = 0; node < g->nodes; node++) {
        double x[2], u[2];
        bond_place(g, node, x);
        problem->outside(x, u);
        for (int d = 0; d < 2; d++) g->u[d][node] = u[d];
    }
}

static inline void bond_destroy(bond_grid *g)
{
    for (int d = 0; d < 2; d++) {
        test_free(g->u[d]);
        test_free(g->residual[d]);
        test_free(g->direction[d]);
        test_free(g->product[d]);
    }
    test_free(g->weight);
    test_free(g->cell_sum);
    free(g->cut);
}

// A row's sum over the bonds of one direction, for all its nodes at once.
static inline void bond_add_row(int count, const double w[3], const double *restrict u, const double *restrict v,
                                double *restrict f, double *restrict g)
{
    for (int k = 0; k < count; k++) {
        f[k] -= w[0] * u[k] + w[1] * v[k];
        g[k] -= w[1] * u[k] + w[2] * v[k];
    }
}

// out = int c e e^T / r (u - u') dA at the unknown nodes.
static inline void bond_force(const bond_grid *g, double *const u[2], double *const out[2])
{
    const int span = 2 * g->reach + 1, count = g->last - g->first[0];
    for (int row = g->first[1]; row < g->last; row++) {
        const int start = row * g->side + g->first[0];
        double *f[2] = {&out[0][start], &out[1][start]};
        for (int d = 0; d < 2; d++) memset(f[d], 0, (size_t)count * sizeof(double));
        const double own[3] = {-g->cell_sum[0], -g->cell_sum[1], -g->cell_sum[2]};
        bond_add_row(count, own, &u[0][start], &u[1][start], f[0], f[1]);
        for (int k = 0; k < span * span; k++) {
            const double *w = &g->weight[3 * k];
            const int to = start + (k / span - g->reach) * g->side + k % span - g->reach;
            if (w[0] + w[2] > 0.0) bond_add_row(count, w, &u[0][to], &u[1][to], f[0], f[1]);
        }
    }
    for (int k = 0; k < g->cut_count; k++) {
        const bond_cut *b = &g->cut[k];
        const double du = u[0][b->node] - u[0][b->partner], dv = u[1][b->node] - u[1][b->partner];
        out[0][b->node] -= (double)b->weight[0] * du + (double)b->weight[1] * dv;
        out[1][b->node] -= (double)b->weight[1] * du + (double)b->weight[2] * dv;
    }
}

// Fills the nodes that symmetry gives: to x -> -x u is odd and v even, to y -> -y u is even and v odd.
static inline void bond_mirror(const bond_grid *g, double *const u[2])
{
    for (int d = 0; d < 2; d++) {
        if (!g->problem->mirrored[d]) continue;
        for (int node = 0; node < g->nodes; node++) {
            const int row = node / g->side, column = node % g->side, last = g->side - 1;
            if ((d == 0 ? column : row) >= g->side / 2) continue;
            const int image = d == 0 ? row * g->side + last - column : (last - row) * g->side + column;
            u[0][node] = (d == 0 ? -1.0 : 1.0) * u[0][image];
            u[1][node] = (d == 0 ? 1.0 : -1.0) * u[1][image];
        }
    }
}

// to = factor * to + a, at the unknown nodes.
static inline void bond_combine(const bond_grid *g, double factor_to, double factor_a, double *const a[2],
                                double *const to[2])
{
    for (int d = 0; d < 2; d++)
        for (int row = g->first[1]; row < g->last; row++)
            for (int node = row * g->side + g->first[0]; node < row * g->side + g->last; node++)
                to[d][node] = factor_to * to[d][node] + factor_a * a[d][node];
}

static inline double bond_dot(const bond_grid *g, double *const a[2], double *const b[2])
{
    double sum = 0.0;
    for (int d = 0; d < 2; d++)
        for (int row = g->first[1]; row < g->last; row++)
            for (int node = row * g->side + g->first[0]; node < row * g->side + g->last; node++)
                sum += a[d][node] * b[d][node];
    return sum;
}

static inline void bond_solve(bond_grid *g)
{
    bond_force(g, g->u, g->product);
    bond_combine(g, 0.0, -1.0, g->product, g->residual);
    bond_combine(g, 0.0, 1.0, g->residual, g->direction);
    const double start = bond_dot(g, g->residual, g->residual);
    for (double now = start; now > 1e-13 * start;) {
        bond_mirror(g, g->direction);
        bond_force(g, g->direction, g->product);
        const double step = now / bond_dot(g, g->direction, g->product);
        bond_combine(g, 1.0, step, g->direction, g->u);
        bond_combine(g, 1.0, -step, g->product, g->residual);
        const double next = bond_dot(g, g->residual, g->residual);
        bond_combine(g, next / now, 1.0, g->residual, g->direction);
        now = next;
    }
    bond_mirror(g, g->u);
}

/// The displacement of a face of a crack along x, from the equation itself, u = D^-1 int c e e^T / r u dA over the half
/// disc: the point at whole numbers of spacings, side 1 above, -1 below.
static inline void bond_face(const bond_grid *g, const double at[2], int side, double u[2])
{
    enum { FINE = 24 };
    const int m = g->problem->cells + 1, column = g->side / 2 + (int)round(at[0] / g->spacing);
    const int row = g->side / 2 + (int)round(at[1] / g->spacing);
    double D[3] = {0.0, 0.0, 0.0}, b[2] = {0.0, 0.0};
    for (int k = 0; k < 2 * m * m * FINE * FINE; k++) {
        const int cell = k / (FINE * FINE), part = k % (FINE * FINE), i = cell % (2 * m) - m, j = cell / (2 * m);
        const double px = i + (part % FINE + 0.5) / FINE, py = side * (j + (part / FINE + 0.5) / FINE);
        const double r2 = px * px + py * py, f = 1.0 / (r2 * sqrt(r2));
        if (r2 > g->problem->cells * g->problem->cells) continue;
        const int node = (row + (side > 0 ? j : -1 - j)) * g->side + column + i;
        const double along = f * (px * g->u[0][node] + py * g->u[1][node]);
        D[0] += f * px * px;
        D[1] += f * px * py;
        D[2] += f * py * py;
        b[0] += px * along;
        b[1] += py * along;
    }
    const double determinant = D[0] * D[2] - D[1] * D[1];
    u[0] = (D[2] * b[0] - D[1] * b[1]) / determinant;
    u[1] = (D[0] * b[1] - D[1] * b[0]) / determinant;
}
