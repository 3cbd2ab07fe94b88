// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/horizon.h"

#include "check.h"
#include "horizon/reference.h"

#include <gsl/gsl_fit.h>
#include <gsl/gsl_math.h>
#include <stdlib.h>
#include <string.h>

static const double sphere = 4.0 / 3.0 * M_PI * 5832.0; // of radius 18

typedef struct {
    double error, distance; // error: %, the volume's
} figures;

static figures measure(pdmc_horizon_kind kind, int ratio)
{
    const pdmc_horizon_options o = pdmc_horizon_options_default(kind, 3, printed_radius, printed_radius / ratio);
    pdmc_horizon_rule rule;
    CHECK_OK(pdmc_horizon_rule_create(&o, &rule));
    const figures f = {100.0 * (pdmc_horizon_rule_volume(&rule) / sphere - 1.0),
                       pdmc_horizon_rule_distance(&rule, 3, sphere)};
    pdmc_horizon_rule_clear(&rule);
    return f;
}

// One unit of the last printed digit: delta/6, delta/8 and delta/20 are printed as 4.891, 5.367 and 2.028 where the
// rule gives 4.8915, 5.3676 and 2.0274; the others agree as rounded.
static void the_cubic_rule_is_that_of_tables_2_2_and_2_3(void **state)
{
    (void)state;
    for (int i = 0; i < PRINTED_ROWS; i++) {
        CHECK_NEAR(-measure(PDMC_RULE_CUBIC, printed_volumes[i].ratio).error, printed_volumes[i].cubic, 1e-3);
        if (FINEST_LEFT_OUT && printed_cubic[i].ratio > 24) continue;
        const figures f = measure(PDMC_RULE_CUBIC, printed_cubic[i].ratio);
        CHECK_NEAR(-f.error, printed_cubic[i].error, 1e-3);
        CHECK_NEAR(f.distance, printed_cubic[i].distance, 1e-3);
    }
}

static double slope(const double x[], const double y[], int count)
{
    double constant, gradient, c00, c01, c11, sum;
    gsl_fit_linear(x, 1, y, 1, (size_t)count, &constant, &gradient, &c00, &c01, &c11, &sum);
    return gradient;
}

// No larger errors than printed, of no more points than the printed distance stands for, at every spacing; errors fall
// with the printed orders of the spacing, 1.72, and of the distance, 2.20, or faster.
static void the_adaptive_rule_is_no_worse_than_tables_2_2_and_2_3(void **state)
{
    (void)state;
    double error[PRINTED_ROWS], spacing[PRINTED_ROWS], distance[PRINTED_ROWS];
    for (int i = 0; i < PRINTED_ROWS; i++) {
        const figures f = measure(PDMC_RULE_ADAPTIVE, printed_volumes[i].ratio);
        assert_true(fabs(f.error) <= printed_volumes[i].adaptive);
        assert_true(f.distance >= printed_volumes[i].distance);
        error[i] = log(fabs(f.error));
        spacing[i] = -log(printed_volumes[i].ratio);
        distance[i] = log(f.distance);
    }
    assert_true(slope(spacing, error, PRINTED_ROWS) >= 1.72);
    assert_true(slope(distance, error, PRINTED_ROWS) >= 2.20);
}

// EPS bounds what one more index may change of each piece, in each direction. Of the volume 0.04 to 0.4 of EPS is
// reached, less where the signs of cells differ.
static void errors_follow_the_accuracy(void **state)
{
    (void)state;
    for (int dimension = 2; dimension <= 3; dimension++) {
        int points = 0;
        for (double accuracy = 1e-2; accuracy > 1e-6; accuracy *= 0.1) {
            pdmc_horizon_options o = pdmc_horizon_options_default(PDMC_RULE_ADAPTIVE, dimension, 1.0, 1.0 / 4.0);
            const double whole = dimension == 3 ? 4.0 / 3.0 * M_PI : M_PI;
            pdmc_horizon_rule rule;
            o.adaptive.accuracy = accuracy;
            CHECK_OK(pdmc_horizon_rule_create(&o, &rule));
            const double error = fabs(pdmc_horizon_rule_volume(&rule) / whole - 1.0);
            assert_true(error < accuracy);
            assert_true(rule.point_count > points);
            points = rule.point_count;
            pdmc_horizon_rule_clear(&rule);
        }
    }
}

// Plain trapezoidal rules, as printed, need many more points.
static void extrapolation_saves_points(void **state)
{
    (void)state;
    int points[2];
    for (int i = 0; i < 2; i++) {
        pdmc_horizon_options o = pdmc_horizon_options_default(PDMC_RULE_ADAPTIVE, 3, 1.0, 1.0 / 3.0);
        pdmc_horizon_rule rule;
        o.adaptive.extrapolates = i == 1;
        CHECK_OK(pdmc_horizon_rule_create(&o, &rule));
        CHECK_NEAR(pdmc_horizon_rule_volume(&rule) / (4.0 / 3.0 * M_PI), 1.0, 5e-4);
        points[i] = rule.point_count;
        pdmc_horizon_rule_clear(&rule);
    }
    assert_true(points[0] > 4 * points[1]);
}

/// int x_a x_b dV by the rule.
static double second_moment(const pdmc_horizon_rule *rule, int a, int b)
{
    double sum = 0.0;
    for (int i = 0; i < rule->point_count; i++)
        sum += rule->weight[i] * rule->position[3 * i + a] * rule->position[3 * i + b];
    return sum;
}

static void square_of(void *context, const double x[3], double value[])
{
    const int *axis = context;
    value[0] = x[0] * x[0];
    value[1] = x[*axis] * x[*axis];
    value[2] = 1.0;
}

// Second moments, 4 pi / 15 and pi / 4, no products, and the same along all axes. The exact rule lacks that of each
// cell about its centroid, spacing^2 / 12 over radius^2 / 5 or / 4.
static void second_moments(void **state)
{
    (void)state;
    for (int dimension = 2; dimension <= 3; dimension++) {
        const double spacing = 1.0 / 5.0, want = dimension == 3 ? 4.0 * M_PI / 15.0 : M_PI / 4.0;
        int last = dimension - 1;
        for (int k = PDMC_RULE_CUBIC; k <= PDMC_RULE_ADAPTIVE; k++) {
            pdmc_horizon_options o = pdmc_horizon_options_default((pdmc_horizon_kind)k, dimension, 1.0, spacing);
            pdmc_horizon_rule rule;
            o.integrand_count = 3;
            o.integrand = square_of;
            o.context = &last;
            CHECK_OK(pdmc_horizon_rule_create(&o, &rule));
            const double tolerance[] = {0.15, 0.02, spacing * spacing * (dimension + 2) / 12.0, 5e-4};
            CHECK_NEAR(second_moment(&rule, 0, 0) / want, 1.0, tolerance[k]);
            CHECK_NEAR(second_moment(&rule, last, last) / want, 1.0, tolerance[k]);
            CHECK_NEAR(second_moment(&rule, 0, last) / want, 0.0, k == PDMC_RULE_ADAPTIVE ? 5e-4 : 1e-13);
            pdmc_horizon_rule_clear(&rule);
        }
    }
}

// Points of a whole cell are Gauss points of the cell, with its volume; 2, 3 or 4 a side.
static void gauss_points_of_whole_cells(void **state)
{
    (void)state;
    for (int n = 1; n <= 4; n++) {
        pdmc_horizon_options o = pdmc_horizon_options_default(PDMC_RULE_GAUSS, 3, 3.0, 1.0);
        pdmc_horizon_rule rule;
        o.gauss_points = n;
        CHECK_OK(pdmc_horizon_rule_create(&o, &rule));
        for (int c = 0; c < rule.cell_count; c++) {
            if (rule.cell[3 * c] != 1 || rule.cell[3 * c + 1] != 0 || rule.cell[3 * c + 2] != -1) continue;
            double volume = 0.0, power = 0.0, even = 2 * n - 2,
                   exact = (pow(1.5, even + 1) - pow(0.5, even + 1)) / (even + 1);
            assert_int_equal(rule.first[c + 1] - rule.first[c], n * n * n);
            for (int i = rule.first[c]; i < rule.first[c + 1]; i++) {
                volume += rule.weight[i];
                power += rule.weight[i] * pow(rule.position[3 * i], even);
            }
            CHECK_NEAR(volume, 1.0, 1e-14);
            CHECK_NEAR(power, exact, 1e-13 * exact);
        }
        CHECK_NEAR(pdmc_horizon_rule_volume(&rule) / (36.0 * M_PI), 1.0, 0.12 / (n * n));
        pdmc_horizon_rule_clear(&rule);
    }
}

// Half of space: half of the volume, with the plane through nodes, Gauss points or neither; the centre moved off the
// nodes.
static void what_there_is_of_the_body(void **state)
{
    (void)state;
    const double tolerance[] = {0.11, 0.03, 1e-14, 5e-4};
    for (int k = PDMC_RULE_CUBIC; k <= PDMC_RULE_ADAPTIVE; k++) {
        for (int moved = 0; moved < 2; moved++) {
            pdmc_horizon_options o = pdmc_horizon_options_default((pdmc_horizon_kind)k, 3, 1.0, 1.0 / 4.0);
            pdmc_horizon_rule rule;
            if (moved) memcpy(o.origin, (double[]){0.07, -0.031, 0.11}, sizeof o.origin);
            o.within.lower[1] = 0.0;
            CHECK_OK(pdmc_horizon_rule_create(&o, &rule));
            CHECK_NEAR(pdmc_horizon_rule_volume(&rule) / (2.0 / 3.0 * M_PI), 1.0, tolerance[k]);
            o.within.upper[1] = -2.0;
            pdmc_horizon_rule_clear(&rule);
            o.within.lower[1] = -3.0;
            CHECK_OK(pdmc_horizon_rule_create(&o, &rule));
            assert_int_equal(rule.point_count, 0);
            pdmc_horizon_rule_clear(&rule);
        }
    }
}

static void refusals(void **state)
{
    (void)state;
    const pdmc_horizon_options good = pdmc_horizon_options_default(PDMC_RULE_ADAPTIVE, 3, 1.0, 0.5);
    pdmc_horizon_rule rule;
    pdmc_horizon_options bad[9];
    for (int i = 0; i < 9; i++) bad[i] = good;
    bad[0].dimension = 1;
    bad[1].radius = 0.0;
    bad[2].spacing = -1.0;
    bad[3].spacing = 1e-4;
    bad[4].gauss_points = 5;
    bad[5].adaptive.accuracy = 0.0;
    bad[6].adaptive.threshold = -1.0;
    bad[7].adaptive.start = 9;
    bad[8].integrand_count = 1;
    for (int i = 0; i < 9; i++) CHECK_STATUS(pdmc_horizon_rule_create(&bad[i], &rule), PDMC_ERR_ARG);
    CHECK_FAILS_CLEANLY(pdmc_horizon_rule_create(&good, &rule), pdmc_horizon_rule_clear(&rule));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_cubic_rule_is_that_of_tables_2_2_and_2_3),
        cmocka_unit_test(the_adaptive_rule_is_no_worse_than_tables_2_2_and_2_3),
        cmocka_unit_test(errors_follow_the_accuracy),
        cmocka_unit_test(extrapolation_saves_points),
        cmocka_unit_test(second_moments),
        cmocka_unit_test(gauss_points_of_whole_cells),
        cmocka_unit_test(what_there_is_of_the_body),
        cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
