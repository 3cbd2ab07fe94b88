// SPDX-License-Identifier: GPL-3.0-or-later
#include "visible/bond_grid.h"
#include "visible/cracked.h"

// Displacements of the same plates by a grid of bonds, with the same known displacements outside.

static pdmc_kansa *local; // the local limit of a plate

static void of_the_plate(const double x[2], double u[2])
{
    CHECK_OK(pdmc_kansa_displacement(local, x, x, u));
}

static const double beside[2] = {-0.8, 0.0}; // the middle of a crack that ends in the square and begins outside

static void beside_the_square(const double x[2], double u[2])
{
    cracked_in_plane(beside, 0.5, x, u);
}

static void in_the_square(const double x[2], double u[2])
{
    const double origin[2] = {0.0, 0.0};
    cracked_in_plane(origin, 0.5, x, u);
}

// A square, its cracks along x, and a point on each of whose faces the jump is asked for.
typedef struct {
    bond_problem bonds;
    int point_count;
    double points[3][2];
} square;

static void stencil_jump(const pdmc_visible *visible, const double x[2], double jump[2])
{
    double u[2], v[2];
    const double above[2] = {x[0], x[1] + 1e-3}, below[2] = {x[0], x[1] - 1e-3};
    CHECK_OK(pdmc_visible_displacement(visible, x, above, u));
    CHECK_OK(pdmc_visible_displacement(visible, x, below, v));
    for (int d = 0; d < 2; d++) jump[d] = u[d] - v[d];
}

// At 4, 8 and 16 nodes a horizon, extrapolated by the order that they show; 6, 12 and 24 move the limits by 0.03 %, against
// tolerances of 1 %.
static void refined_openings(square *s, double opening[3])
{
    double w[3][3];
    for (int k = 0; k < 3; k++) {
        bond_grid grid;
        s->bonds.cells = 4 << k;
        bond_create(&s->bonds, &grid);
        bond_solve(&grid);
        for (int i = 0; i < s->point_count; i++) {
            double u[2], v[2];
            bond_face(&grid, s->points[i], 1, u);
            bond_face(&grid, s->points[i], -1, v);
            w[k][i] = u[1] - v[1];
        }
        bond_destroy(&grid);
    }
    for (int i = 0; i < s->point_count; i++) {
        const double ratio = (w[1][i] - w[0][i]) / (w[2][i] - w[1][i]);
        opening[i] = w[2][i] + (w[2][i] - w[1][i]) / (ratio - 1.0);
        printf("  bonds at x = %+.2f: %.5f %.5f %.5f, order %.2f, limit %.5f\n", s->points[i][0], w[0][i], w[1][i],
               w[2][i], log2(ratio), opening[i]);
        CHECK_NEAR(log2(ratio), 1.6, 0.6);
    }
}

static void compare(square *s, const int refinements[], int count, double tolerance)
{
    double refined[3];
    refined_openings(s, refined);
    for (int r = 0; r < count; r++) {
        const pdmc_visible_data data = {.outside = s->bonds.outside};
        plate p;
        pdmc_visible *visible = NULL;
        cracked_make(&p, 2.0 * s->bonds.half, s->bonds.horizon, refinements[r]);
        for (int c = 0; c < s->bonds.crack_count; c++) {
            const double *from = s->bonds.cracks[c][0], *to = s->bonds.cracks[c][1];
            plate_crack(&p, 0.5 * (from[0] + to[0]), from[1], 0.5 * (to[0] - from[0]), 0.0);
        }
        CHECK_OK(pdmc_visible_create(&p.problem, &data, 1, &visible));
        for (int i = 0; i < s->point_count; i++) {
            double jump[2];
            stencil_jump(visible, s->points[i], jump);
            printf("  refinement %d: %+.3f %%\n", refinements[r], 100.0 * (jump[1] / refined[i] - 1.0));
            CHECK_NEAR(jump[1], refined[i], tolerance * refined[i]);
        }
        pdmc_visible_destroy(&visible);
    }
}

// Two parallel cracks, a horizon of a half length apart, each in the other's shadow; data from the local limit.
static void two_cracks_open_as_bonds_let_them(void **state)
{
    (void)state;
    const double a = 0.4 - 1e-9;
    square s = {.bonds = {.horizon = 0.2,
                          .half = 1.0,
                          .outside = of_the_plate,
                          .mirrored = {true, true},
                          .crack_count = 2,
                          .cracks = {{{-a, 0.2}, {a, 0.2}}, {{-a, -0.2}, {a, -0.2}}}},
                .point_count = 3,
                .points = {{0.0, 0.2}, {0.2, 0.2}, {0.3, 0.2}}};
    const int refinements[2] = {4, 6};
    plate p;
    plate_make(&p, 5.0, 20, 0.08);
    plate_load(&p, PDMC_SIDE_TOP, 0.0, 1.0);
    plate_load(&p, PDMC_SIDE_BOTTOM, 0.0, -1.0);
    plate_crack(&p, 0.0, 0.2, 0.4, 0.0);
    plate_crack(&p, 0.0, -0.2, 0.4, 0.0);
    p.problem.solver.crack_orders = 10;
    CHECK_OK(pdmc_kansa_create(&p.problem, NULL, 1, &local));
    compare(&s, refinements, 2, 0.01);
    pdmc_kansa_destroy(&local);
}

// A crack that goes through the side of the square: its faces end there, and outside the known displacements jump.
static void an_edge_crack_opens_as_bonds_let_it(void **state)
{
    (void)state;
    square s = {.bonds = {.horizon = 0.15,
                          .half = 0.9,
                          .outside = beside_the_square,
                          .mirrored = {false, true},
                          .crack_count = 1,
                          .cracks = {{{-1.3, 0.0}, {-0.3 - 1e-9, 0.0}}}},
                .point_count = 3,
                .points = {{-0.9, 0.0}, {-0.6, 0.0}, {-0.45, 0.0}}};
    const int refinements[2] = {4, 6};
    compare(&s, refinements, 2, 0.01);
}

// At nodes of one grid beside a crack, ahead of it and away from it. The opening is 2; the largest difference is that
// half a spacing from the tip, where the grid is not refined.
static void the_field_is_that_of_bonds(void **state)
{
    (void)state;
    const double a = 0.5 - 1e-9;
    const bond_problem bonds = {.horizon = 0.3,
                                .half = 1.0,
                                .cells = 12,
                                .outside = in_the_square,
                                .mirrored = {true, true},
                                .crack_count = 1,
                                .cracks = {{{-a, 0.0}, {a, 0.0}}}};
    const pdmc_visible_data data = {.outside = in_the_square};
    const int columns[6] = {0, 8, 16, 19, 22, 30}, rows[4] = {0, 2, 6, 20}; // from the middle
    bond_grid grid;
    plate p;
    pdmc_visible *visible = NULL;
    double worst = 0.0, at_tip = 0.0;
    bond_create(&bonds, &grid);
    bond_solve(&grid);
    cracked_make(&p, 2.0, 0.3, 6);
    plate_crack(&p, 0.0, 0.0, 0.5, 0.0);
    CHECK_OK(pdmc_visible_create(&p.problem, &data, 1, &visible));
    for (int k = 0; k < 24; k++) {
        const int node = (grid.side / 2 + rows[k / 6]) * grid.side + grid.side / 2 + columns[k % 6];
        double x[2], u[2];
        bond_place(&grid, node, x);
        CHECK_OK(pdmc_visible_displacement(visible, x, x, u));
        double *largest = k == 3 ? &at_tip : &worst;
        for (int i = 0; i < 2; i++) *largest = fmax(*largest, fabs(u[i] - grid.u[i][node]));
    }
    printf("  largest difference to bonds: %.4f, half a spacing from the tip %.4f\n", worst, at_tip);
    CHECK_NEAR(worst, 0.0, 0.01);
    CHECK_NEAR(at_tip, 0.0, 0.02);
    pdmc_visible_destroy(&visible);
    bond_destroy(&grid);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_field_is_that_of_bonds),
        cmocka_unit_test(two_cracks_open_as_bonds_let_them),
        cmocka_unit_test(an_edge_crack_opens_as_bonds_let_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
