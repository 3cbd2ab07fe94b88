// SPDX-License-Identifier: GPL-3.0-or-later
#include "visible/cracked.h"

#include <gsl/gsl_math.h>
#include <string.h>

// The same plate by a bond solver of its own: nodes on a regular grid in |x|, |y| < 1, the local limit's displacements
// outside, a crack of half length a = 0.5 between two rows of nodes, conjugate gradients.

enum {
    CELLS = 12,
    INSIDE = 80,
    REACH = CELLS + 1,
    SIDE = INSIDE + 2 * REACH,
    SPAN = 2 * REACH + 1,
    NODES = SIDE * SIDE
};

static const double horizon = 0.3, half_crack = 0.5, spacing = 0.3 / CELLS;

static pdmc_kansa *local; // the local limit

static void local_displacement(const double x[2], double u[2])
{
    CHECK_OK(pdmc_kansa_displacement(local, x, x, u));
}

typedef struct {
    double weight[SPAN][SPAN][3]; // int c e e^T / r dA over the part of the offset's cell in the disc: xx, xy, yy
    double u[NODES][2], residual[NODES][2], direction[NODES][2], product[NODES][2];
} bond_solver;

static void place(int node, double x[2])
{
    x[0] = (node % SIDE - 0.5 * (SIDE - 1)) * spacing;
    x[1] = (node / SIDE - 0.5 * (SIDE - 1)) * spacing;
}

static bool is_free(int node)
{
    double x[2];
    place(node, x);
    return fabs(x[0]) < 1.0 && fabs(x[1]) < 1.0;
}

static void integrate_cells(bond_solver *s)
{
    enum { FINE = 24 };
    const double c = 9.0 / (M_PI * pow(horizon, 3)), area = spacing * spacing / (FINE * FINE);
    for (int k = 0; k < SPAN * SPAN * FINE * FINE; k++) {
        const int cell = k / (FINE * FINE), part = k % (FINE * FINE);
        const double x = (cell % SPAN - REACH + (part % FINE + 0.5) / FINE - 0.5) * spacing;
        const double y = (cell / SPAN - REACH + (part / FINE + 0.5) / FINE - 0.5) * spacing, r = hypot(x, y);
        if (r > horizon || cell == SPAN * SPAN / 2) continue;
        double *w = s->weight[cell / SPAN][cell % SPAN];
        w[0] += c * area * x * x / pow(r, 3);
        w[1] += c * area * x * y / pow(r, 3);
        w[2] += c * area * y * y / pow(r, 3);
    }
}

static bool is_cut(int node, int i, int j)
{
    double x[2];
    place(node, x);
    const double end = x[1] + j * spacing;
    return x[1] * end < 0.0 && fabs(x[0] - i * spacing * x[1] / (j * spacing)) < half_crack;
}

// out = int c e e^T / r (u - u') dA at the free nodes, 0 elsewhere
static void force(const bond_solver *s, double u[NODES][2], double out[NODES][2])
{
    memset(out, 0, sizeof(double[NODES][2]));
    for (int node = 0; node < NODES; node++) {
        if (!is_free(node)) continue;
        for (int j = -REACH; j <= REACH; j++) {
            for (int i = -REACH; i <= REACH; i++) {
                const double *w = s->weight[j + REACH][i + REACH];
                if ((w[0] == 0.0 && w[2] == 0.0) || is_cut(node, i, j)) continue;
                const double *v = u[node + j * SIDE + i];
                const double dx = u[node][0] - v[0], dy = u[node][1] - v[1];
                out[node][0] += w[0] * dx + w[1] * dy;
                out[node][1] += w[1] * dx + w[2] * dy;
            }
        }
    }
}

static double dot(double a[NODES][2], double b[NODES][2])
{
    double sum = 0.0;
    for (int node = 0; node < NODES; node++)
        if (is_free(node)) sum += a[node][0] * b[node][0] + a[node][1] * b[node][1];
    return sum;
}

static void add(double factor, double a[NODES][2], double to[NODES][2])
{
    for (int k = 0; k < 2 * NODES; k++) to[k / 2][k % 2] += factor * a[k / 2][k % 2];
}

static void solve(bond_solver *s)
{
    for (int node = 0; node < NODES; node++) {
        double x[2];
        place(node, x);
        local_displacement(x, s->u[node]);
    }
    force(s, s->u, s->residual);
    for (int k = 0; k < 2 * NODES; k++) s->direction[k / 2][k % 2] = s->residual[k / 2][k % 2] *= -1.0;
    const double start = dot(s->residual, s->residual);
    for (double now = start; now > 1e-14 * start;) {
        force(s, s->direction, s->product);
        const double step = now / dot(s->direction, s->product);
        add(step, s->direction, s->u);
        add(-step, s->product, s->residual);
        const double next = dot(s->residual, s->residual);
        for (int k = 0; k < 2 * NODES; k++)
            s->direction[k / 2][k % 2] = s->residual[k / 2][k % 2] + next / now * s->direction[k / 2][k % 2];
        now = next;
    }
}

// At nodes next to the crack, ahead of it and away from it. The opening of the crack is 2.1; the largest differences
// are those close to a tip.
static void the_field_is_that_of_bonds(void **state)
{
    (void)state;
    const pdmc_visible_data data = {.outside = local_displacement};
    const int columns[6] = {0, 8, 16, 19, 22, 30}, rows[4] = {0, 2, 6, 20}; // from the middle
    bond_solver *s = test_calloc(1, sizeof *s);
    plate p, small;
    pdmc_visible *visible = NULL;
    double worst = 0.0;
    plate_make_cracked(&small, half_crack, 0.0, 20);
    CHECK_OK(pdmc_kansa_create(&small.problem, NULL, 1, &local));
    cracked_make(&p, 2.0, horizon, 6);
    plate_crack(&p, 0.0, 0.0, half_crack, 0.0);
    CHECK_OK(pdmc_visible_create(&p.problem, &data, 1, &visible));
    integrate_cells(s);
    solve(s);
    for (int k = 0; k < 24; k++) {
        const int node = (SIDE / 2 + rows[k / 6]) * SIDE + SIDE / 2 + columns[k % 6];
        double x[2], u[2];
        place(node, x);
        CHECK_OK(pdmc_visible_displacement(visible, x, x, u));
        for (int i = 0; i < 2; i++) worst = fmax(worst, fabs(u[i] - s->u[node][i]));
    }
    printf("  largest difference to bonds: %.4f\n", worst);
    CHECK_NEAR(worst, 0.0, 0.015);
    pdmc_visible_destroy(&visible);
    pdmc_kansa_destroy(&local);
    test_free(s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_field_is_that_of_bonds)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
