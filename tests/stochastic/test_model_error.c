// SPDX-License-Identifier: GPL-3.0-or-later

/// The bounds are reached where every root is off by all that its delta allows, and the same way.

#include "stochastic/model_error.h"

#include "check.h"
#include "pdmc/statistics.h"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics.h>
#include <math.h>
#include <string.h>

enum { SAMPLES = 500, TIPS = 2 };

static double energies[SAMPLES * TIPS], delta[SAMPLES], scratch[SAMPLES];
static uint8_t failure[SAMPLES];

static double energy_of(int sample, int tip)
{
    return (1.0 + tip) * (1.0 + fmod(sample * 0.618033988749895, 1.0));
}

static pdmc_results describe(bool is_constant)
{
    for (int s = 0; s < SAMPLES; s++) {
        failure[s] = s % 50 == 7 ? PDMC_SAMPLE_SINGULAR : PDMC_SAMPLE_OK;
        delta[s] = is_constant ? 0.03 : 0.03 * fmod(s * 0.41421356, 1.0);
        for (int t = 0; t < TIPS; t++)
            energies[s * TIPS + t] = failure[s] == PDMC_SAMPLE_OK ? energy_of(s, t) : (double)NAN;
    }
    return (pdmc_results){.tip_count = TIPS,
                          .sample_count = SAMPLES,
                          .failure = failure,
                          .confidence = 0.95,
                          .largest_energy = {[PDMC_MEASURE_GRIFFITH] = energies}};
}

/// The energies of a tip, with the roots off by all of delta, or as they are.
static size_t shifted(int tip, double share, double x[])
{
    size_t count = 0;
    for (int s = 0; s < SAMPLES; s++)
        if (failure[s] == PDMC_SAMPLE_OK) {
            const double root = sqrt(energies[s * TIPS + tip]) + share * delta[s];
            x[count++] = root * root;
        }
    gsl_sort(x, 1, count);
    return count;
}

static void find_shifts(int tip, double *mean_shift, double quantile_shift[])
{
    static double before[SAMPLES], after[SAMPLES];
    const size_t count = shifted(tip, 0.0, before);
    shifted(tip, 1.0, after);
    const double mean = gsl_stats_mean(before, 1, count);
    *mean_shift = gsl_stats_mean(after, 1, count) / mean - 1.0;
    for (int q = 0; q < PDMC_QUANTILES; q++) {
        const double p = pdmc_quantile_levels[q];
        quantile_shift[q] = (pdmc_statistics_quantile(count, after, p, 0.95).value -
                             pdmc_statistics_quantile(count, before, p, 0.95).value) /
                            mean;
    }
}

// Rounding only: the bounds are equalities. The first tip has less energy, and so the larger relative shift.
static void equal_errors_reach_the_bounds(void **state)
{
    (void)state;
    double mean, mean_shift, quantile[PDMC_QUANTILES], quantile_shift[PDMC_QUANTILES];
    const pdmc_results results = describe(true);
    pdmc_model_error(&results, PDMC_MEASURE_GRIFFITH, delta, scratch, &mean, quantile);
    find_shifts(0, &mean_shift, quantile_shift);
    CHECK_NEAR(mean, mean_shift, 1e-13);
    for (int q = 0; q < PDMC_QUANTILES; q++) CHECK_NEAR(quantile[q], quantile_shift[q], 1e-13);
}

static void unequal_errors_reach_that_of_the_mean(void **state)
{
    (void)state;
    double mean, mean_shift, quantile[PDMC_QUANTILES], quantile_shift[PDMC_QUANTILES];
    const pdmc_results results = describe(false);
    pdmc_model_error(&results, PDMC_MEASURE_GRIFFITH, delta, scratch, &mean, quantile);
    find_shifts(0, &mean_shift, quantile_shift);
    CHECK_NEAR(mean, mean_shift, 1e-13);
    for (int q = 0; q < PDMC_QUANTILES; q++) assert_true(quantile[q] > quantile_shift[q] && quantile_shift[q] > 0.0);
}

static void nothing_is_known_of_failed_samples_alone(void **state)
{
    (void)state;
    double mean, quantile[PDMC_QUANTILES];
    const pdmc_results results = describe(true);
    memset(failure, PDMC_SAMPLE_SINGULAR, sizeof failure);
    pdmc_model_error(&results, PDMC_MEASURE_GRIFFITH, delta, scratch, &mean, quantile);
    assert_true(isnan(mean) && isnan(quantile[0]));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equal_errors_reach_the_bounds),
        cmocka_unit_test(unequal_errors_reach_that_of_the_mean),
        cmocka_unit_test(nothing_is_known_of_failed_samples_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
