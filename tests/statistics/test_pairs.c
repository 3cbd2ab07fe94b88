// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/statistics.h"

#include "statistics/samples.h"

#include <float.h>

static void three_pairs_by_hand(void **state)
{
    (void)state;
    static const double x[] = {1, 2, 3, 0}, y[] = {3, 2, 1, 0};
    pdmc_pairs pairs;
    CHECK_OK(pdmc_statistics_pairs(4, x, y, 0.95, &pairs));
    assert_int_equal(pairs.count, 4);
    CHECK_NEAR(pairs.difference.value, 0.0, DBL_EPSILON); // 1, 0, -1, and 0 of 0 to 0
    CHECK_NEAR(pairs.largest_difference, 1.0, 0.0);
    assert_int_equal(pairs.largest_at, 0);
    CHECK_NEAR(pairs.correlation.value, 1.0 / 5.0, 4 * DBL_EPSILON);      // deviations +-0.5, 0.5, 1.5, 1.5 about 1.5
    const double t = 3.182446305284263;                                   // Student's, 3 degrees of freedom
    CHECK_NEAR(pairs.difference.upper, t * sqrt(2.0 / 3.0 / 4.0), 1e-12); // GSL's t is good to 1e-13
}

/// Fisher's own transform: r = 0.5 of 28 pairs is within tanh(0.549306 -+ 1.959964 / 5).
static void fishers_interval(void **state)
{
    (void)state;
    enum { N = 28 };
    double x[N], y[N];
    for (int i = 0; i < N; i++)
        x[i] = i % 2 ? 1.0 : -1.0, y[i] = i / 7 % 4 == 3 ? -x[i] : x[i]; // one in four disagrees
    pdmc_pairs pairs;
    CHECK_OK(pdmc_statistics_pairs(N, x, y, 0.95, &pairs));
    CHECK_NEAR(pairs.correlation.value, 0.5, 0.01);
    const double z = atanh(pairs.correlation.value), width = 1.9599639845400545 / 5.0;
    CHECK_NEAR(pairs.correlation.lower, tanh(z - width), 1e-14);
    CHECK_NEAR(pairs.correlation.upper, tanh(z + width), 1e-14);
}

static void equal_and_opposite_samples(void **state)
{
    (void)state;
    enum { N = 50 };
    double x[N], y[N];
    pdmc_pairs pairs;
    draw_sample(SAMPLE_NORMAL, 1, N, x);
    CHECK_OK(pdmc_statistics_pairs(N, x, x, 0.95, &pairs));
    CHECK_NEAR(pairs.correlation.value, 1.0, 16 * DBL_EPSILON);
    assert_true(pairs.correlation.upper <= 1.0 && pairs.correlation.lower > 0.999);
    assert_true(pairs.difference.value == 0.0 && pairs.difference.upper == 0.0 && pairs.largest_difference == 0.0);
    for (int i = 0; i < N; i++) y[i] = -0x1p-700 * x[i];
    CHECK_OK(pdmc_statistics_pairs(N, x, y, 0.95, &pairs));
    CHECK_NEAR(pairs.correlation.value, -1.0, 16 * DBL_EPSILON);
    CHECK_NEAR(fabs(pairs.largest_difference), 2.0, DBL_EPSILON);
}

/// Of normal pairs with r = 0.8, where Fisher's interval is made for.
static void the_interval_of_a_correlation_covers(void **state)
{
    (void)state;
    enum { REPETITIONS = 4000, N = 50 };
    double covered = 0.0, x[N], y[N];
    for (uint64_t r = 0; r < REPETITIONS; r++) {
        pdmc_pairs pairs;
        draw_sample(SAMPLE_NORMAL, 2 * r, N, x);
        draw_sample(SAMPLE_NORMAL, 2 * r + 1, N, y);
        for (int i = 0; i < N; i++) y[i] = 0.8 * x[i] + 0.6 * y[i];
        CHECK_OK(pdmc_statistics_pairs(N, x, y, 0.95, &pairs));
        covered += (pairs.correlation.lower <= 0.8 && 0.8 <= pairs.correlation.upper) / (double)REPETITIONS;
    }
    CHECK_NEAR(covered, 0.95, repetition_error(0.95, REPETITIONS));
}

static void what_too_few_cannot_tell_is_nan(void **state)
{
    (void)state;
    static const double x[] = {1.0, 2.0, 4.0}, flat[] = {1.0, 1.0, 1.0};
    pdmc_pairs pairs;
    CHECK_OK(pdmc_statistics_pairs(0, x, x, 0.95, &pairs));
    assert_true(isnan(pairs.difference.value) && isnan(pairs.correlation.value) && isnan(pairs.largest_difference));
    CHECK_OK(pdmc_statistics_pairs(3, x, x, 0.95, &pairs));
    assert_true(pairs.correlation.value > 0.999 && isnan(pairs.correlation.lower));
    CHECK_OK(pdmc_statistics_pairs(3, x, flat, 0.95, &pairs));
    assert_true(isnan(pairs.correlation.value) && isfinite(pairs.difference.upper));
    CHECK_FAILS_CLEANLY(pdmc_statistics_pairs(3, x, flat, 0.95, &pairs), (void)0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(three_pairs_by_hand),
        cmocka_unit_test(fishers_interval),
        cmocka_unit_test(equal_and_opposite_samples),
        cmocka_unit_test(the_interval_of_a_correlation_covers),
        cmocka_unit_test(what_too_few_cannot_tell_is_nan),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
