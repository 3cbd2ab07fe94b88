// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/statistics.h"

#include "statistics/samples.h"

#include <float.h>

static void two_values_by_hand(void **state)
{
    (void)state;
    static const double x[] = {0.1, 0.1, 0.1, 0.5}; // mean 0.2, s = 0.2, sum z^3 / n = (-3 / 8 + 27 / 8) / 4 = 3 / 4
    const pdmc_estimate mean = pdmc_statistics_bounded_mean(4, x, 0.8);
    const double t = 1.6377443536962102, a = 0.75 / 2.0; // Student's, 3 degrees of freedom, 0.9
    CHECK_NEAR(mean.value, 0.2, 2 * DBL_EPSILON);
    const double bounds[] = {mean.lower, mean.upper};
    for (int k = 0; k < 2; k++) {
        const double studentised = (mean.value - bounds[k]) / (0.2 / 2.0);
        const double square = studentised * studentised;
        const double hall = studentised + a * square / 3.0 + a * a * square * studentised / 27.0 + a / 6.0;
        CHECK_NEAR(hall, k == 0 ? t : -t, 64 * DBL_EPSILON);
    }
}

static void a_symmetric_sample_has_students_interval(void **state)
{
    (void)state;
    static const double x[] = {0.25, 0.375, 0.5, 0.625, 0.75};
    pdmc_estimate want, deviation;
    pdmc_statistics_moments(5, x, 0.95, &want, &deviation);
    const pdmc_estimate mean = pdmc_statistics_bounded_mean(5, x, 0.95);
    CHECK_NEAR(mean.lower, want.lower, 4 * DBL_EPSILON);
    CHECK_NEAR(mean.upper, want.upper, 4 * DBL_EPSILON);
}

static void bounds_are_probabilities(void **state)
{
    (void)state;
    enum { N = 1000 };
    double x[N] = {0};
    pdmc_estimate mean = pdmc_statistics_bounded_mean(N, x, 0.95);
    CHECK_NEAR(mean.lower, 0.0, 0.0);
    CHECK_NEAR(mean.upper, 1.0 - pow(0.025, 1.0 / N), 1e-15);
    for (int hits = 1; hits <= 3; hits++) {
        x[hits - 1] = 1.0;
        const pdmc_estimate share = pdmc_statistics_proportion((size_t)hits, N, 0.95);
        mean = pdmc_statistics_bounded_mean(N, x, 0.95);
        assert_true(0.0 <= mean.lower && mean.lower < mean.value && mean.upper > 0.7 * share.upper);
    }
    for (int i = 3; i < N - 1; i++) x[i] = 1.0;
    mean = pdmc_statistics_bounded_mean(N, x, 0.95);
    assert_true(mean.lower < mean.value && mean.value < mean.upper && mean.upper <= 1.0);
    for (int i = 0; i < N; i++) x[i] = 0.25;
    mean = pdmc_statistics_bounded_mean(N, x, 0.95);
    assert_true(mean.lower == 0.25 && mean.upper == 0.25);
    assert_true(isnan(pdmc_statistics_bounded_mean(0, x, 0.95).upper));
    assert_true(isnan(pdmc_statistics_bounded_mean(1, x, 0.95).upper));
}

typedef struct {
    double covered, below, above; // shares of the repetitions; below: the interval is below the truth
    double student;               // covered by Student's interval of the same samples
} coverage;

/// 1e-4 times a lognormal of mean 1, cut at 1, which for these is never needed.
static coverage measure(double variation, size_t n, int repetitions)
{
    coverage c = {0};
    const double truth = 1e-4, share = 1.0 / repetitions;
    double *x = pdmc_calloc(n, sizeof *x);
    assert_non_null(x);
    for (int r = 0; r < repetitions; r++) {
        pdmc_random_uniform(1992, PDMC_STREAM_LOAD, (uint64_t)r, 0, n, x);
        for (size_t i = 0; i < n; i++) {
            x[i] = truth * pdmc_unit_mean_quantile(PDMC_LOGNORMAL, variation, x[i]);
            assert_true(x[i] <= 1.0);
        }
        const pdmc_estimate mean = pdmc_statistics_bounded_mean(n, x, 0.95);
        c.below += share * (mean.upper < truth);
        c.above += share * (mean.lower > truth);
        pdmc_estimate plain, deviation;
        pdmc_statistics_moments(n, x, 0.95, &plain, &deviation);
        c.student += share * (plain.lower <= truth && truth <= plain.upper);
    }
    c.covered = 1.0 - c.below - c.above;
    pdmc_free(x);
    return c;
}

/// The shares of 20 000 repetitions, +- 0.002.
static void skewed_means_are_covered(void **state)
{
    (void)state;
    enum { REPETITIONS = 2000 };
    static const struct {
        double variation, covered;
    } cases[] = {{0.5, 0.952}, {1.0, 0.948}, {2.0, 0.940}, {3.0, 0.933}};
    for (int k = 0; k < 4; k++) {
        const coverage c = measure(cases[k].variation, 1000, REPETITIONS);
        CHECK_NEAR(c.covered, cases[k].covered, repetition_error(cases[k].covered, REPETITIONS) + 0.002);
        assert_true(c.above > 0.015); // Student's interval is hardly ever above a skewed mean: 0.006 of CV 3
        if (cases[k].variation == 3.0) assert_true(c.covered > c.student + 0.005);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_values_by_hand),
        cmocka_unit_test(a_symmetric_sample_has_students_interval),
        cmocka_unit_test(bounds_are_probabilities),
        cmocka_unit_test(skewed_means_are_covered),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
