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
        .solver = {.method = PDMC_METHOD_BOND, .horizon = 0.05 * ratio, .spacing = 0.05, .area = area,
                   .load_layer = 0.05},
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_bias_falls_with_the_horizon),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
