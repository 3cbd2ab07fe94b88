// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/statistics.h"

#include "statistics/samples.h"

#include <gsl/gsl_cdf.h>

enum { LARGEST = 300 };

/// Of the sample 1, 2, ... n the estimate is its own rank.
static pdmc_estimate ranks(size_t n, double p, double confidence)
{
    double sorted[LARGEST];
    for (size_t i = 0; i < n; i++) sorted[i] = (double)i + 1.0;
    return pdmc_statistics_quantile(n, sorted, p, confidence);
}

/// The chance that at most `rank` of n samples lie below the quantile at p.
static double at_most(double rank, double p, size_t n)
{
    if (rank < 0.0) return 0.0;
    return rank >= (double)n ? 1.0 : gsl_cdf_binomial_P((unsigned)rank, p, (unsigned)n);
}

static void each_bound_is_the_tightest_that_holds(void **state)
{
    (void)state;
    static const double ps[] = {0.001, 0.05, 0.3, 0.5, 0.62, 0.95, 0.999}, confidences[] = {0.5, 0.9, 0.95, 0.999};
    for (size_t n = 1; n <= LARGEST; n += 1 + n / 10) {
        for (int i = 0; i < 7; i++) {
            for (int k = 0; k < 4; k++) {
                const pdmc_estimate rank = ranks(n, ps[i], confidences[k]);
                const double tail = 0.5 * (1.0 - confidences[k]), top = (double)n + 1.0;
                const double lower = fmax(rank.lower, 0.0), upper = fmin(rank.upper, top);
                assert_true(at_most(lower - 1.0, ps[i], n) <= tail);       // x_(lower) above the quantile
                assert_true(at_most(lower, ps[i], n) > tail);              // x_(lower + 1) would be too often
                assert_true(1.0 - at_most(upper - 1.0, ps[i], n) <= tail); // x_(upper) below the quantile
                assert_true(1.0 - at_most(upper - 2.0, ps[i], n) > tail);
                assert_true(lower <= rank.value && rank.value <= upper);
            }
        }
    }
}

/// n p is an integer in each, though not always in floating point: 100 * 0.07 is above 7.
static void the_rank_is_ceil_np_despite_rounding(void **state)
{
    (void)state;
    for (int hundredth = 1; hundredth <= 100; hundredth++) {
        CHECK_NEAR(ranks(100, hundredth / 100.0, 0.95).value, hundredth, 0.0);
        CHECK_NEAR(ranks(99, hundredth / 100.0, 0.95).value, ceil(0.99 * hundredth - 1e-9), 0.0);
    }
    CHECK_NEAR(ranks(10, 0.0, 0.95).value, 1.0, 0.0);
    CHECK_NEAR(ranks(10, 1.0, 0.95).value, 10.0, 0.0);
}

/// The table of David and Nagaraja's kind: of 100 samples, the median lies between x_(40) and x_(61) at 95 %.
static void the_median_of_a_hundred(void **state)
{
    (void)state;
    const pdmc_estimate rank = ranks(100, 0.5, 0.95);
    CHECK_NEAR(rank.value, 50.0, 0.0);
    CHECK_NEAR(rank.lower, 40.0, 0.0);
    CHECK_NEAR(rank.upper, 61.0, 0.0);
}

static void a_bound_out_of_reach_is_infinite(void **state)
{
    (void)state;
    const pdmc_estimate low = ranks(50, 0.01, 0.95), high = ranks(50, 0.99, 0.95), single = ranks(1, 0.5, 0.95);
    assert_true(low.lower == -INFINITY && low.upper < INFINITY);
    assert_true(high.lower > -INFINITY && high.upper == INFINITY);
    assert_true(single.value == 1.0 && single.lower == -INFINITY && single.upper == INFINITY);
}

/// The bounds of a large sample are those of the normal approximation, n p +- z sqrt(n p (1 - p)), within two ranks.
/// Where GSL's beta functions are NaN, about the middle of so many, they are wider and never narrower.
static void ten_million_samples(void **state)
{
    (void)state;
    const size_t n = 10000000;
    double *sorted = pdmc_calloc(n, sizeof *sorted);
    assert_non_null(sorted);
    for (size_t i = 0; i < n; i++) sorted[i] = (double)i + 1.0;
    static const double confidences[] = {0.95, 0.5, 0.01};
    for (int k = 0; k < 3; k++) {
        const pdmc_estimate rank = pdmc_statistics_quantile(n, sorted, 0.5, confidences[k]);
        const double half_width = pdmc_normal_quantile(0.5 + 0.5 * confidences[k]) * sqrt(0.25 * (double)n);
        const double wider = confidences[k] < 0.5 ? 1000.0 : 0.0;
        CHECK_NEAR(rank.lower, 5e6 - half_width - 0.5 * wider, 2.0 + 0.5 * wider);
        CHECK_NEAR(rank.upper, 5e6 + half_width + 0.5 * wider, 2.0 + 0.5 * wider);
    }
    pdmc_free(sorted);
}

static double true_quantile(sample_kind kind, double p)
{
    if (kind == SAMPLE_NORMAL) return pdmc_normal_quantile(p);
    return kind == SAMPLE_EXPONENTIAL ? -log1p(-p) : exp(lognormal_sigma * pdmc_normal_quantile(p));
}

/// The coverage does not depend on the distribution: it is the binomial's between the ranks, 0.95 and a little more.
static void coverage_is_the_binomials(void **state)
{
    (void)state;
    enum { N = 200, REPETITIONS = 2000 };
    static const double ps[] = {0.05, 0.5, 0.95};
    for (int kind = SAMPLE_NORMAL; kind <= SAMPLE_LOGNORMAL; kind++) {
        int hits[3] = {0};
        for (uint64_t r = 0; r < REPETITIONS; r++) {
            double x[N];
            draw_sample((sample_kind)kind, r, N, x);
            sort_sample(N, x);
            for (int i = 0; i < 3; i++) {
                const pdmc_estimate q = pdmc_statistics_quantile(N, x, ps[i], 0.95);
                const double truth = true_quantile((sample_kind)kind, ps[i]);
                hits[i] += q.lower <= truth && truth <= q.upper;
            }
        }
        for (int i = 0; i < 3; i++) {
            const pdmc_estimate rank = ranks(N, ps[i], 0.95);
            const double want = at_most(rank.upper - 1.0, ps[i], N) - at_most(rank.lower - 1.0, ps[i], N);
            assert_true(want >= 0.95);
            CHECK_NEAR((double)hits[i] / REPETITIONS, want, repetition_error(want, REPETITIONS));
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_bound_is_the_tightest_that_holds),
        cmocka_unit_test(the_rank_is_ceil_np_despite_rounding),
        cmocka_unit_test(the_median_of_a_hundred),
        cmocka_unit_test(a_bound_out_of_reach_is_infinite),
        cmocka_unit_test(ten_million_samples),
        cmocka_unit_test(coverage_is_the_binomials),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
