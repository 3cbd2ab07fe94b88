// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/statistics.h"

#include "statistics/samples.h"

#include <float.h>

static void a_small_sample_by_hand(void **state)
{
    (void)state;
    static const double x[] = {2, 4, 4, 4, 5, 5, 7, 9}; // mean 5, sum of squares 32
    pdmc_estimate mean, deviation;
    pdmc_statistics_moments(8, x, 0.95, &mean, &deviation);
    const double s = sqrt(32.0 / 7.0), t = 2.364624251592785; // Student's, 7 degrees of freedom, 0.975
    CHECK_NEAR(mean.value, 5.0, 0.0);
    CHECK_NEAR(mean.lower, 5.0 - t * s / sqrt(8.0), 16 * DBL_EPSILON * 5.0);
    CHECK_NEAR(mean.upper, 5.0 + t * s / sqrt(8.0), 16 * DBL_EPSILON * 5.0);
    CHECK_NEAR(deviation.value, s, 4 * DBL_EPSILON * s);
}

/// The jackknife as it is defined: the statistic without each sample in turn.
static void the_jackknife_by_its_definition(void **state)
{
    (void)state;
    enum { N = 12 };
    double x[N], pseudo[N], centre = 0.0, squares = 0.0;
    draw_sample(SAMPLE_EXPONENTIAL, 0, N, x);
    pdmc_estimate mean, deviation, mean_without, without;
    pdmc_statistics_moments(N, x, 0.9, &mean, &deviation);
    for (size_t i = 0; i < N; i++) {
        double others[N - 1];
        for (size_t j = 0; j < N - 1; j++) others[j] = x[j < i ? j : j + 1];
        pdmc_statistics_moments(N - 1, others, 0.9, &mean_without, &without);
        pseudo[i] = N * 2.0 * log(deviation.value) - (N - 1) * 2.0 * log(without.value);
        centre += pseudo[i] / N;
    }
    for (size_t i = 0; i < N; i++) squares += (pseudo[i] - centre) * (pseudo[i] - centre);
    const double t = 1.7958848187036696; // Student's, 11 degrees of freedom, 0.95
    const double half_width = t * sqrt(squares / (N * (N - 1)));
    CHECK_NEAR(deviation.lower, exp(0.5 * (centre - half_width)), 1e-13); // N^2 roundings of logarithms
    CHECK_NEAR(deviation.upper, exp(0.5 * (centre + half_width)), 1e-13);
}

static void units_and_origin_do_not_matter(void **state)
{
    (void)state;
    enum { N = 100 };
    double x[N], y[N];
    pdmc_estimate mean, deviation, mean_y, deviation_y;
    draw_sample(SAMPLE_LOGNORMAL, 0, N, x);
    pdmc_statistics_moments(N, x, 0.95, &mean, &deviation);
    static const double scales[] = {0x1p-600, 0x1p-30, 0x1p30, 0x1p600}; // squares of the first and last do not exist
    for (int k = 0; k < 4; k++) {
        for (int i = 0; i < N; i++) y[i] = scales[k] * x[i];
        pdmc_statistics_moments(N, y, 0.95, &mean_y, &deviation_y);
        CHECK_NEAR(mean_y.value / scales[k], mean.value, 0.0);
        CHECK_NEAR(mean_y.lower / scales[k], mean.lower, 0.0);
        CHECK_NEAR(deviation_y.value / scales[k], deviation.value, 0.0);
        CHECK_NEAR(deviation_y.lower / scales[k], deviation.lower, 0.0);
        CHECK_NEAR(deviation_y.upper / scales[k], deviation.upper, 0.0);
    }
    const double origin = 0x1p20; // moving there rounds each x by at most 2^-33
    for (int i = 0; i < N; i++) y[i] = origin + x[i];
    pdmc_statistics_moments(N, y, 0.95, &mean_y, &deviation_y);
    CHECK_NEAR(mean_y.value - origin, mean.value, 0x1p-32);
    CHECK_NEAR(deviation_y.value, deviation.value, 0x1p-32);
    CHECK_NEAR(deviation_y.upper, deviation.upper, 0x1p-28);
}

static void check_point(pdmc_estimate estimate, double value)
{
    CHECK_NEAR(estimate.value, value, 0.0);
    CHECK_NEAR(estimate.lower, value, 0.0);
    CHECK_NEAR(estimate.upper, value, 0.0);
}

static void a_sample_without_spread_is_a_point(void **state)
{
    (void)state;
    enum { N = 1000 };
    double x[N];
    for (int i = 0; i < N; i++) x[i] = 0.1; // which a plain sum does not give back
    pdmc_estimate mean, deviation;
    pdmc_statistics_moments(N, x, 0.95, &mean, &deviation);
    check_point(mean, 0.1);
    check_point(deviation, 0.0);
}

/// Without the one sample there is no spread, and by rounding its share of the sum of squares may pass 1.
static void one_sample_apart_gives_wide_but_finite_bounds(void **state)
{
    (void)state;
    enum { LARGEST = 200 };
    for (size_t n = 3; n <= LARGEST; n++) {
        double x[LARGEST];
        for (size_t i = 0; i < n; i++) x[i] = 0.1;
        x[n / 2] = 0.7;
        pdmc_estimate mean, deviation;
        pdmc_statistics_moments(n, x, 0.95, &mean, &deviation);
        CHECK_NEAR(deviation.value, 0.6 / sqrt((double)n), 16 * DBL_EPSILON);
        assert_true(deviation.lower > 0.0 && deviation.lower < 0.01 * deviation.value);
        assert_true(deviation.upper < INFINITY && deviation.upper > 100.0 * deviation.value);
    }
}

static void the_value_lies_between_its_bounds(void **state)
{
    (void)state;
    enum { N = 30 };
    double x[N];
    static const double confidences[] = {0.01, 0.5, 0.95, 0.999999};
    for (uint64_t r = 0; r < 50; r++) {
        for (int k = 0; k < 4; k++) {
            pdmc_estimate mean, deviation;
            draw_sample(SAMPLE_EXPONENTIAL, r, N, x);
            pdmc_statistics_moments(N, x, confidences[k], &mean, &deviation);
            assert_true(mean.lower < mean.value && mean.value < mean.upper);
            assert_true(0.0 < deviation.lower && deviation.lower <= deviation.value);
            assert_true(deviation.value <= deviation.upper && deviation.upper < INFINITY);
        }
    }
}

static void what_too_few_samples_cannot_tell_is_nan(void **state)
{
    (void)state;
    static const double x[] = {3.0, 5.0};
    pdmc_estimate mean, deviation;
    pdmc_statistics_moments(0, x, 0.95, &mean, &deviation);
    assert_true(isnan(mean.value) && isnan(mean.lower) && isnan(mean.upper) && isnan(deviation.value));
    pdmc_statistics_moments(1, x, 0.95, &mean, &deviation);
    assert_true(mean.value == 3.0 && isnan(mean.lower) && isnan(mean.upper));
    assert_true(isnan(deviation.value) && isnan(deviation.lower) && isnan(deviation.upper));
    pdmc_statistics_moments(2, x, 0.95, &mean, &deviation);
    assert_true(mean.value == 4.0 && mean.lower < 3.0 && mean.upper > 5.0);
    CHECK_NEAR(deviation.value, sqrt(2.0), 2 * DBL_EPSILON);
    assert_true(isnan(deviation.lower) && isnan(deviation.upper));
}

typedef struct {
    double mean, deviation; // shares of the repetitions whose interval holds the truth
} coverage;

enum { REPETITIONS = 4000 };

static bool holds(pdmc_estimate estimate, double truth)
{
    return estimate.lower <= truth && truth <= estimate.upper;
}

static coverage measure_coverage(sample_kind kind, size_t n, double true_mean, double true_deviation)
{
    coverage share = {0};
    double *x = pdmc_calloc(n, sizeof *x);
    assert_non_null(x);
    for (uint64_t r = 0; r < REPETITIONS; r++) {
        pdmc_estimate mean, deviation;
        draw_sample(kind, r, n, x);
        pdmc_statistics_moments(n, x, 0.95, &mean, &deviation);
        share.mean += holds(mean, true_mean) / (double)REPETITIONS;
        share.deviation += holds(deviation, true_deviation) / (double)REPETITIONS;
    }
    pdmc_free(x);
    return share;
}

/// Of normal samples Student's interval is exact, for any n.
static void the_interval_of_a_normal_mean_is_exact(void **state)
{
    (void)state;
    CHECK_NEAR(measure_coverage(SAMPLE_NORMAL, 4, 0.0, 1.0).mean, 0.95, repetition_error(0.95, REPETITIONS));
    CHECK_NEAR(measure_coverage(SAMPLE_NORMAL, 200, 0.0, 1.0).mean, 0.95, repetition_error(0.95, REPETITIONS));
}

/// To first order in 1/n a sample of skewness g and excess kurtosis k adds
/// 2 phi(z) / n (k (z^3 - 3 z) / 12 - g^2 (z^5 + 2 z^3 - 3 z) / 18), z = 1.96
/// to the coverage of Student's interval (Hall, The Bootstrap and Edgeworth Expansion, 1992, section 2.6).
static double skewed_coverage(double n, double skewness, double kurtosis)
{
    const double z = pdmc_normal_quantile(0.975), pi = acos(-1.0);
    const double z3 = pow(z, 3), z5 = pow(z, 5), density = exp(-0.5 * z * z) / sqrt(2.0 * pi);
    const double terms = kurtosis * (z3 - 3.0 * z) / 12.0 - skewness * skewness * (z5 + 2.0 * z3 - 3.0 * z) / 18.0;
    return 0.95 + 2.0 * density / n * terms;
}

/// The deviation's interval covers less often, the heavier the tails. Shortfalls at n = 200, of 100 000 repetitions:
/// normal 0.001, exponential 0.028, lognormal 0.011, each +- 0.001.
static void intervals_cover_as_often_as_expected(void **state)
{
    (void)state;
    enum { N = 200 };
    const double w = exp(lognormal_sigma * lognormal_sigma); // the lognormal's variance is w (w - 1)
    const struct {
        sample_kind kind;
        double mean, deviation, skewness, kurtosis, shortfall;
    } cases[] = {
        {SAMPLE_NORMAL, 0.0, 1.0, 0.0, 0.0, 0.001},
        {SAMPLE_EXPONENTIAL, 1.0, 1.0, 2.0, 6.0, 0.028},
        {SAMPLE_LOGNORMAL, sqrt(w), sqrt(w * (w - 1.0)), (w + 2.0) * sqrt(w - 1.0),
         pow(w, 4) + 2.0 * pow(w, 3) + 3.0 * w * w - 6.0, 0.011},
    };
    const double error = repetition_error(0.95, REPETITIONS);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const coverage share = measure_coverage(cases[i].kind, N, cases[i].mean, cases[i].deviation);
        CHECK_NEAR(share.mean, skewed_coverage(N, cases[i].skewness, cases[i].kurtosis), error);
        CHECK_NEAR(share.deviation, 0.95 - cases[i].shortfall, error);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_small_sample_by_hand),
        cmocka_unit_test(the_jackknife_by_its_definition),
        cmocka_unit_test(units_and_origin_do_not_matter),
        cmocka_unit_test(a_sample_without_spread_is_a_point),
        cmocka_unit_test(one_sample_apart_gives_wide_but_finite_bounds),
        cmocka_unit_test(the_value_lies_between_its_bounds),
        cmocka_unit_test(what_too_few_samples_cannot_tell_is_nan),
        cmocka_unit_test(the_interval_of_a_normal_mean_is_exact),
        cmocka_unit_test(intervals_cover_as_often_as_expected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
