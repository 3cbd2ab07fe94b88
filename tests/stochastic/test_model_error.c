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

// The worst tip is the one with the least energy.
static double energy_of(int sample, int rank)
{
    return (1.0 + rank) * (1.0 + fmod(sample * 0.618033988749895, 1.0));
}

static pdmc_results describe(bool is_constant, int worst)
{
    for (int s = 0; s < SAMPLES; s++) {
        failure[s] = s % 50 == 7 ? PDMC_SAMPLE_SINGULAR : PDMC_SAMPLE_OK;
        delta[s] = is_constant ? 0.03 : 0.03 * fmod(s * 0.41421356, 1.0);
        for (int t = 0; t < TIPS; t++)
            energies[s * TIPS + t] = failure[s] == PDMC_SAMPLE_OK ? energy_of(s, t != worst) : (double)NAN;
        if (failure[s] != PDMC_SAMPLE_OK) delta[s] = 1.0; // which nobody asks for
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

// Rounding only: the bounds are equalities.
static void equal_errors_reach_the_bounds(void **state)
{
    (void)state;
    double mean, mean_shift, quantile[PDMC_QUANTILES], quantile_shift[PDMC_QUANTILES];
    for (int worst = 0; worst < TIPS; worst++) {
        const pdmc_results results = describe(true, worst);
        pdmc_model_error(&results, PDMC_MEASURE_GRIFFITH, delta, scratch, &mean, quantile);
        find_shifts(worst, &mean_shift, quantile_shift);
        CHECK_NEAR(mean, mean_shift, 1e-13);
        for (int q = 0; q < PDMC_QUANTILES; q++) CHECK_NEAR(quantile[q], quantile_shift[q], 1e-13);
    }
}

// A quantile may be any sample's: its bound is what all would make of it that are off by as much as the worst.
static void unequal_errors_reach_that_of_the_mean(void **state)
{
    (void)state;
    double mean, mean_shift, quantile[PDMC_QUANTILES], quantile_shift[PDMC_QUANTILES], largest = 0.0;
    const pdmc_results results = describe(false, 0);
    pdmc_model_error(&results, PDMC_MEASURE_GRIFFITH, delta, scratch, &mean, quantile);
    find_shifts(0, &mean_shift, quantile_shift);
    CHECK_NEAR(mean, mean_shift, 1e-13);
    for (int s = 0; s < SAMPLES; s++)
        if (failure[s] == PDMC_SAMPLE_OK) largest = fmax(largest, delta[s]);
    for (int s = 0; s < SAMPLES; s++) delta[s] = largest;
    find_shifts(0, &mean_shift, quantile_shift);
    for (int q = 0; q < PDMC_QUANTILES; q++) CHECK_NEAR(quantile[q], quantile_shift[q], 1e-13);
}

// Rounding may leave less than nothing of an energy, which has a root for all that.
static void a_negative_energy_is_none(void **state)
{
    (void)state;
    double mean, mean_of_none, quantile[PDMC_QUANTILES];
    const pdmc_results results = describe(true, 0);
    energies[0] = 0.0;
    pdmc_model_error(&results, PDMC_MEASURE_GRIFFITH, delta, scratch, &mean_of_none, quantile);
    energies[0] = -1e-18;
    pdmc_model_error(&results, PDMC_MEASURE_GRIFFITH, delta, scratch, &mean, quantile);
    CHECK_NEAR(mean, mean_of_none, 0.0);
}

static void nothing_is_known_of_failed_samples_alone(void **state)
{
    (void)state;
    double mean, quantile[PDMC_QUANTILES];
    const pdmc_results results = describe(true, 0);
    memset(failure, PDMC_SAMPLE_SINGULAR, sizeof failure);
    pdmc_model_error(&results, PDMC_MEASURE_GRIFFITH, delta, scratch, &mean, quantile);
    assert_true(isnan(mean) && isnan(quantile[0]));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equal_errors_reach_the_bounds),
        cmocka_unit_test(unequal_errors_reach_that_of_the_mean),
        cmocka_unit_test(a_negative_energy_is_none),
        cmocka_unit_test(nothing_is_known_of_failed_samples_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
