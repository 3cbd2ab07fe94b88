// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/statistics.h"

#include "statistics/samples.h"

#include <float.h>

/// Means 3 and 5.5 with the variances 5/2 / 5 and 5/3 / 4, and so 6.98 degrees of freedom.
static void welch_by_hand(void **state)
{
    (void)state;
    static const double x[] = {1, 2, 3, 4, 5}, y[] = {4, 5, 6, 7};
    pdmc_estimate difference, ratio;
    pdmc_statistics_means(5, x, 4, y, false, 0.95, &difference, &ratio);
    const double vx = 0.5, vy = 5.0 / 12.0; // of the means
    CHECK_NEAR((vx + vy) * (vx + vy) / (vx * vx / 4.0 + vy * vy / 3.0), 6.98076923, 1e-8);
    const double t = 2.36594542; // Student's at 0.975 of 6.98076923, by integration; of 7 it is 2.3646
    CHECK_NEAR(difference.value, 2.5, 4 * DBL_EPSILON);
    CHECK_NEAR(difference.upper - 2.5, t * sqrt(vx + vy), 1e-8);
    CHECK_NEAR(2.5 - difference.lower, t * sqrt(vx + vy), 1e-8);
    CHECK_NEAR(ratio.value, 5.5 / 3.0, 4 * DBL_EPSILON);
}

/// Of pairs, the difference is one sample; and at Fieller's bounds r the mean of y - r x is just not told from zero.
static void pairs_are_one_sample(void **state)
{
    (void)state;
    enum { N = 30 };
    double x[N], y[N], e[N];
    pdmc_estimate difference, ratio, mean, deviation;
    draw_sample(SAMPLE_EXPONENTIAL, 1, N, x);
    draw_sample(SAMPLE_EXPONENTIAL, 2, N, y);
    for (int i = 0; i < N; i++) y[i] = 3.0 * x[i] + 0.1 * y[i];
    pdmc_statistics_means(N, x, N, y, true, 0.9, &difference, &ratio);
    for (int i = 0; i < N; i++) e[i] = y[i] - x[i];
    pdmc_statistics_moments(N, e, 0.9, &mean, &deviation);
    CHECK_NEAR(difference.value, mean.value, 32 * DBL_EPSILON);
    CHECK_NEAR(difference.lower, mean.lower, 32 * DBL_EPSILON);
    CHECK_NEAR(difference.upper, mean.upper, 32 * DBL_EPSILON);
    for (int i = 0; i < N; i++) e[i] = y[i] - ratio.lower * x[i];
    pdmc_statistics_moments(N, e, 0.9, &mean, &deviation);
    CHECK_NEAR(mean.lower, 0.0, 1e-14); // N roundings of numbers up to 10
    for (int i = 0; i < N; i++) e[i] = y[i] - ratio.upper * x[i];
    pdmc_statistics_moments(N, e, 0.9, &mean, &deviation);
    CHECK_NEAR(mean.upper, 0.0, 1e-14);
    assert_true(ratio.lower < ratio.value && ratio.value < ratio.upper);
}

/// Nearly equal pairs, whose variances cancel all but 1e-9 of themselves.
static void small_differences_of_pairs_are_kept(void **state)
{
    (void)state;
    enum { N = 100 };
    double x[N], y[N], z[N];
    pdmc_estimate difference, ratio, mean, deviation;
    draw_sample(SAMPLE_LOGNORMAL, 1, N, x);
    draw_sample(SAMPLE_NORMAL, 2, N, z);
    for (int i = 0; i < N; i++) y[i] = x[i] + 0x1p-30 * z[i];
    pdmc_statistics_moments(N, z, 0.95, &mean, &deviation);
    pdmc_statistics_means(N, x, N, y, true, 0.95, &difference, &ratio);
    CHECK_NEAR(difference.value / 0x1p-30, mean.value, 1e-5); // y has rounded 0x1p-30 z to 2^-22 of itself
    CHECK_NEAR(difference.upper / 0x1p-30, mean.upper, 1e-5);
    CHECK_NEAR(ratio.upper - ratio.lower, (difference.upper - difference.lower) / 1.03, 0.1 * 0x1p-30);
}

static void a_ratio_to_nothing_is_not_known(void **state)
{
    (void)state;
    static const double x[] = {-1.0, 1.1, -0.9, 1.0}, y[] = {5.0, 6.0, 5.5, 4.0}, zero[] = {0.0, 0.0, 0.0, 0.0};
    pdmc_estimate difference, ratio;
    for (int paired = 0; paired < 2; paired++) {
        pdmc_statistics_means(4, x, 4, y, paired, 0.95, &difference, &ratio);
        assert_true(isinf(ratio.lower) && isinf(ratio.upper) && ratio.lower < ratio.upper);
        assert_true(isfinite(difference.lower) && isfinite(difference.upper));
        pdmc_statistics_means(4, zero, 4, zero, paired, 0.95, &difference, &ratio);
        assert_true(isnan(ratio.value) && difference.lower == 0.0 && difference.upper == 0.0);
    }
    pdmc_statistics_means(1, x, 4, y, false, 0.95, &difference, &ratio);
    assert_true(isnan(difference.value) && isnan(ratio.value));
    pdmc_statistics_means(3, x, 4, y, true, 0.95, &difference, &ratio);
    assert_true(isnan(difference.value) && isnan(ratio.value));
}

static void units_do_not_matter(void **state)
{
    (void)state;
    enum { N = 20 };
    double x[N], y[N], u[N], v[N];
    draw_sample(SAMPLE_EXPONENTIAL, 1, N, x);
    draw_sample(SAMPLE_EXPONENTIAL, 2, N, y);
    for (int i = 0; i < N; i++) u[i] = 0x1p-600 * x[i], v[i] = 0x1p-600 * y[i];
    for (int paired = 0; paired < 2; paired++) {
        pdmc_estimate difference, ratio, tiny, same;
        pdmc_statistics_means(N, x, N, y, paired, 0.95, &difference, &ratio);
        pdmc_statistics_means(N, u, N, v, paired, 0.95, &tiny, &same);
        CHECK_NEAR(tiny.lower / 0x1p-600, difference.lower, 0.0);
        assert_memory_equal(&same, &ratio, sizeof ratio);
    }
}

/// Of exponential samples, independent or as pairs with a correlation of 0.9.
static void intervals_cover(void **state)
{
    (void)state;
    enum { REPETITIONS = 4000, N = 200, M = 150 };
    const double error = repetition_error(0.95, REPETITIONS);
    double x[N], y[N];
    for (int paired = 0; paired < 2; paired++) {
        double differences = 0.0, ratios = 0.0;
        const size_t m = paired ? N : M;
        for (uint64_t r = 0; r < REPETITIONS; r++) {
            pdmc_estimate difference, ratio;
            draw_sample(SAMPLE_EXPONENTIAL, 2 * r, N, x);
            draw_sample(SAMPLE_EXPONENTIAL, 2 * r + 1, m, y);
            for (size_t i = 0; i < m; i++) y[i] = paired ? 1.4 * x[i] + 0.6 * y[i] : 2.0 * y[i]; // with mean 2
            pdmc_statistics_means(N, x, m, y, paired, 0.95, &difference, &ratio);
            differences += (difference.lower <= 1.0 && 1.0 <= difference.upper) / (double)REPETITIONS;
            ratios += (ratio.lower <= 2.0 && 2.0 <= ratio.upper) / (double)REPETITIONS;
        }
        // Skewness takes up to 0.005 of the coverage, as of one mean with n = 200.
        CHECK_NEAR(differences, 0.9475, error + 0.0025);
        CHECK_NEAR(ratios, 0.9475, error + 0.0025);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(welch_by_hand),
        cmocka_unit_test(pairs_are_one_sample),
        cmocka_unit_test(small_differences_of_pairs_are_kept),
        cmocka_unit_test(a_ratio_to_nothing_is_not_known),
        cmocka_unit_test(units_do_not_matter),
        cmocka_unit_test(intervals_cover),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
