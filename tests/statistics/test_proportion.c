// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/statistics.h"

#include "statistics/samples.h"

#include <float.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

/// Two-sided at both ends: 0 of n bounds p by 1 - (alpha / 2)^(1 / n).
static void nothing_and_everything_have_closed_forms(void **state)
{
    (void)state;
    for (size_t n = 1; n <= 1000000; n *= 10) {
        const double root = exp(log(0.025) / (double)n), bound = -expm1(log(0.025) / (double)n);
        const pdmc_estimate none = pdmc_statistics_proportion(0, n, 0.95), all = pdmc_statistics_proportion(n, n, 0.95);
        CHECK_NEAR(none.value, 0.0, 0.0);
        CHECK_NEAR(none.lower, 0.0, 0.0);
        CHECK_NEAR(none.upper, bound, 1e-13 * bound);
        CHECK_NEAR(all.value, 1.0, 0.0);
        CHECK_NEAR(all.lower, root, 1e-13);
        CHECK_NEAR(all.upper, 1.0, 0.0);
    }
}

static void without_trials_nothing_is_known(void **state)
{
    (void)state;
    const pdmc_estimate p = pdmc_statistics_proportion(0, 0, 0.95);
    assert_true(isnan(p.value) && p.lower == 0.0 && p.upper == 1.0);
}

/// Clopper and Pearson's chart reads 3 of 10 as 0.07 to 0.65; the digits are of 30-digit arithmetic.
static void three_of_ten(void **state)
{
    (void)state;
    const pdmc_estimate p = pdmc_statistics_proportion(3, 10, 0.95);
    CHECK_NEAR(p.value, 0.3, 0.0);
    CHECK_NEAR(p.lower, 0.0667395111777345, 1e-14);
    CHECK_NEAR(p.upper, 0.6524528500599973, 1e-14);
}

/// At the lower bound, `hits` or more have probability alpha / 2; at the upper bound, `hits` or fewer.
static void bounds_solve_their_equations(void **state)
{
    (void)state;
    static const unsigned ns[] = {1, 2, 7, 60, 200, 5000, 100000};
    static const double confidences[] = {0.5, 0.95, 0.9999};
    for (size_t i = 0; i < sizeof ns / sizeof ns[0]; i++) {
        for (unsigned hits = 0; hits <= ns[i]; hits += 1 + ns[i] / 13) {
            for (int k = 0; k < 3; k++) {
                const double tail = 0.5 * (1.0 - confidences[k]);
                const pdmc_estimate p = pdmc_statistics_proportion(hits, ns[i], confidences[k]);
                // GSL's binomial is good to 2e-10 at 10^5
                if (hits > 0) CHECK_NEAR(gsl_cdf_binomial_Q(hits - 1, p.lower, ns[i]) / tail, 1.0, 1e-9);
                if (hits < ns[i]) CHECK_NEAR(gsl_cdf_binomial_P(hits, p.upper, ns[i]) / tail, 1.0, 1e-9);
                assert_true(p.lower <= p.value && p.value <= p.upper);
            }
        }
    }
}

static void hits_and_misses_mirror_each_other(void **state)
{
    (void)state;
    for (size_t hits = 0; hits <= 40; hits++) {
        const pdmc_estimate p = pdmc_statistics_proportion(hits, 40, 0.9);
        const pdmc_estimate q = pdmc_statistics_proportion(40 - hits, 40, 0.9);
        CHECK_NEAR(p.lower, 1.0 - q.upper, 4e-14); // each is found to 1e-14 of itself
        CHECK_NEAR(p.upper, 1.0 - q.lower, 4e-14);
    }
}

/// Against the normal approximation, p +- z sqrt(p (1 - p) / n), which is off by O(1/n). Where GSL's beta functions are
/// NaN, about the middle of so many, the bounds are wider and never narrower.
static void ten_million_trials(void **state)
{
    (void)state;
    static const double confidences[] = {0.95, 0.5, 0.01};
    for (int k = 0; k < 3; k++) {
        const pdmc_estimate p = pdmc_statistics_proportion(5000000, 10000000, confidences[k]);
        const double half_width = pdmc_normal_quantile(0.5 + 0.5 * confidences[k]) * 0.5 / sqrt(1e7);
        const double wider = confidences[k] < 0.5 ? 1e-4 : 0.0;
        CHECK_NEAR(p.lower, 0.5 - half_width - 0.5 * wider, 2e-7 + 0.5 * wider);
        CHECK_NEAR(p.upper, 0.5 + half_width + 0.5 * wider, 2e-7 + 0.5 * wider);
    }
}

/// Every outcome with its probability, so that no repetition is needed: Clopper and Pearson never cover too seldom.
static void the_interval_always_covers(void **state)
{
    (void)state;
    static const unsigned ns[] = {1, 5, 50, 200};
    static const double ps[] = {0.001, 0.02, 0.3, 0.5, 0.98};
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 5; j++) {
            double covered = 0.0;
            for (unsigned hits = 0; hits <= ns[i]; hits++) {
                const pdmc_estimate p = pdmc_statistics_proportion(hits, ns[i], 0.95);
                if (p.lower <= ps[j] && ps[j] <= p.upper) covered += gsl_ran_binomial_pdf(hits, ps[j], ns[i]);
            }
            assert_true(covered >= 0.95);
            if (ns[i] == 200 && ps[j] == 0.3) assert_true(covered < 0.965); // nor much too often where n p is large
        }
    }
}

/// The same by repetition, with our own numbers.
static void events_are_covered_as_often_as_their_binomial_says(void **state)
{
    (void)state;
    enum { N = 200, REPETITIONS = 4000 };
    static const double ps[] = {0.02, 0.3};
    for (int i = 0; i < 2; i++) {
        double want = 0.0, got = 0.0;
        for (unsigned hits = 0; hits <= N; hits++) {
            const pdmc_estimate p = pdmc_statistics_proportion(hits, N, 0.95);
            if (p.lower <= ps[i] && ps[i] <= p.upper) want += gsl_ran_binomial_pdf(hits, ps[i], N);
        }
        for (uint64_t r = 0; r < REPETITIONS; r++) {
            double u[N];
            size_t hits = 0;
            pdmc_random_uniform(3, PDMC_STREAM_LOAD, r, 0, N, u);
            for (int k = 0; k < N; k++) hits += u[k] < ps[i];
            const pdmc_estimate p = pdmc_statistics_proportion(hits, N, 0.95);
            got += (p.lower <= ps[i] && ps[i] <= p.upper) / (double)REPETITIONS;
        }
        CHECK_NEAR(got, want, repetition_error(want, REPETITIONS));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_and_everything_have_closed_forms),
        cmocka_unit_test(without_trials_nothing_is_known),
        cmocka_unit_test(three_of_ten),
        cmocka_unit_test(bounds_solve_their_equations),
        cmocka_unit_test(hits_and_misses_mirror_each_other),
        cmocka_unit_test(ten_million_trials),
        cmocka_unit_test(the_interval_always_covers),
        cmocka_unit_test(events_are_covered_as_often_as_their_binomial_says),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
