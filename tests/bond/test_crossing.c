// SPDX-License-Identifier: GPL-3.0-or-later

/// The energy release rate on a grid: uniform stretches, of which it is known, and its bias with the direction.

#include "bond/crossing.h"
#include "check.h"

#include <gsl/gsl_math.h>
#include <math.h>

static pdmc_problem plate(double ratio, pdmc_bond_area area)
{
    static pdmc_crack crack = {"a", {-0.1, 0.0}, {0.1, 0.0}};
    static int tip = 1;
    return (pdmc_problem){
        .plate = {2.0, 2.0, 1.0},
        .material = {1.0, PDMC_PLANE_STRESS, 1.0},
        .crack_count = 1,
        .cracks = &crack,
        .solver =
            {.method = PDMC_METHOD_BOND, .horizon = 0.05 * ratio, .spacing = 0.05, .area = area, .load_layer = 0.05},
        .energy = {.tip_count = 1, .tips = &tip, .angles = 4, .horizon = 0.05 * ratio, .extension = 0.05},
    };
}

// The largest less the smallest bias over 0 .. 90 degrees, relative to their mean.
static double spread(double ratio, pdmc_bond_area area)
{
    const pdmc_problem problem = plate(ratio, area);
    pdmc_bond_horizon horizon;
    double low = INFINITY, high = -INFINITY, sum = 0.0;
    CHECK_OK(pdmc_bond_horizon_create(&problem, 1, &horizon));
    for (int degree = 0; degree <= 90; degree++) {
        const double bias = pdmc_bond_crossing_bias(&problem, &horizon, degree * M_PI / 180.0);
        low = fmin(low, bias);
        high = fmax(high, bias);
        sum += bias / 91.0;
    }
    print_message("horizon %2g spacings, kind of area %d: bias %.4f, from %.4f to %.4f\n", ratio, area, sum, low, high);
    pdmc_bond_horizon_clear(&horizon);
    return (high - low) / sum;
}

// The spreads fall with the horizon; half as large with exact areas and centroids. The figures of the table are those of
// an independent program that counted crossings.
static void the_bias_falls_with_the_horizon(void **state)
{
    (void)state;
    const double ratio[4] = {3.0, 4.0, 6.0, 12.0};
    const double full[4] = {0.053, 0.033, 0.013, 0.004}, centroid[4] = {0.025, 0.014, 0.006, 0.0015};
    for (int i = 0; i < 4; i++) {
        const double a = spread(ratio[i], PDMC_AREA_FULL), b = spread(ratio[i], PDMC_AREA_CENTROID);
        CHECK_NEAR(a, full[i], 5.1e-4 + 0.05 * full[i]); // half of the last digit given, and the range's other points
        CHECK_NEAR(b, centroid[i], 5.1e-4 + 0.05 * centroid[i]);
    }
}

// Of a stretch by 1 everywhere, on a whole plate: the part of G_0 that a line of `length` spacings finds at (x, y)
// spacings from the middle of a cell.
static double found(pdmc_bond *bond, pdmc_problem *problem, double x, double y, double length, double phi)
{
    const double h = problem->solver.spacing, delta = problem->solver.horizon;
    double sum = 0.0;
    pdmc_crossing crossing;
    problem->cracks[0].to[0] = (0.5 + x) * h;
    problem->cracks[0].to[1] = (0.5 + y) * h;
    problem->energy.extension = length * h;
    CHECK_OK(pdmc_bond_crossing_create(bond, 1, phi, &crossing));
    for (int b = 0; b < crossing.bonds; b++) {
        double stretch = 0.0, at[2];
        for (int k = 0; k < PDMC_BOND_ENDS; k++) {
            const int unknown = crossing.column[b * PDMC_BOND_ENDS + k];
            pdmc_bond_grid_node(&bond->plate.grid, unknown / 2, at);
            stretch += crossing.row[b * PDMC_BOND_ENDS + k] * at[unknown % 2];
        }
        sum += gsl_pow_2(stretch);
    }
    pdmc_free(crossing.row);
    pdmc_free(crossing.column);
    pdmc_free(crossing.ring);
    return sum / (0.5 * gsl_pow_4(delta)); // 1/2 c_0 sum against 1/4 c_0 delta^4
}

// Wherever the line lies and whatever its direction it finds the same energy, the better the longer it is: its ends are
// what is left. Kinds of area in which bonds have the nodes' distances, so that the stretch is exactly uniform.
static void a_uniform_stretch_is_found(void **state)
{
    (void)state;
    const double ratio[3] = {3.0, 5.0, 8.0}, length[3] = {1.0, 2.0, 4.0};
    double worst[3][3] = {{0.0}};
    for (int i = 0; i < 3; i++) {
        pdmc_problem problem = plate(ratio[i], PDMC_AREA_EXACT);
        pdmc_bond *bond;
        problem.crack_count = 0; // the line needs a tip, the bonds no crack
        CHECK_OK(pdmc_bond_create(&problem, 1, &bond));
        problem.crack_count = 1;
        for (int j = 0; j < 3; j++)
            for (int k = 0; k < 100; k++) {
                const double x = fmod(0.618 * k, 1.0), y = fmod(0.755 * k, 1.0), phi = 2.0 * M_PI * fmod(0.57 * k, 1.0);
                const double error = found(bond, &problem, x, y, length[j], phi) - 1.0;
                worst[i][j] = fmax(worst[i][j], fabs(error));
            }
        print_message("horizon %g spacings: a line of 1, 2, 4 spacings is off by at most %.4f %.4f %.4f\n", ratio[i],
                      worst[i][0], worst[i][1], worst[i][2]);
        pdmc_bond_destroy(&bond);
    }
    for (int i = 0; i < 3; i++) {
        assert_true(worst[i][2] < 0.5 * worst[i][0]);
        assert_true(worst[i][1] < 0.1);
    }
}

// A line along the grid that begins beside a node has bonds that run along the end of its strip; whether they
// count is not left to rounding, as it was: what is found does not jump with the direction.
static void bonds_along_the_ends_count_a_half(void **state)
{
    (void)state;
    pdmc_problem problem = plate(5.0, PDMC_AREA_FULL);
    pdmc_bond *bond;
    problem.crack_count = 0;
    CHECK_OK(pdmc_bond_create(&problem, 1, &bond));
    problem.crack_count = 1;
    const double ahead = found(bond, &problem, 0.0, 0.5, 1.5, 0.0);
    const double upward = found(bond, &problem, 0.5, 0.0, 1.5, M_PI_2);
    for (int quarter = 0; quarter < 4; quarter++)
        for (int turn = -1; turn <= 1; turn++) {
            const double phi = quarter * M_PI_2 + 1e-6 * turn;
            const double x = quarter % 2 ? 0.5 : 0.0, want = quarter % 2 ? upward : ahead;
            CHECK_NEAR(found(bond, &problem, x, 0.5 - x, 1.5, phi), want, 1e-5);
        }
    CHECK_NEAR(ahead, upward, 1e-12);
    pdmc_bond_destroy(&bond);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_bias_falls_with_the_horizon),
        cmocka_unit_test(a_uniform_stretch_is_found),
        cmocka_unit_test(bonds_along_the_ends_count_a_half),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
