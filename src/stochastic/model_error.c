// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/model_error.h"

#include "pdmc/statistics.h"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics.h>
#include <math.h>

// How far an energy is off whose root is off by delta.
static double shift(double energy, double delta)
{
    return delta * (2.0 * sqrt(energy) + delta);
}

static double largest_energy(const pdmc_results *results, pdmc_measure measure, int sample, int tip)
{
    return fmax(results->largest_energy[measure][(size_t)sample * (size_t)results->tip_count + (size_t)tip], 0.0);
}

static void add_tip(const pdmc_results *results, pdmc_measure measure, int tip, const double delta[], double energy[],
                    double *mean_error, double quantile_error[])
{
    size_t count = 0;
    double total_shift = 0.0, largest_delta = 0.0;
    for (int s = 0; s < results->sample_count; s++) {
        if (results->failure[s] != PDMC_SAMPLE_OK) continue;
        energy[count] = largest_energy(results, measure, s, tip);
        total_shift += shift(energy[count++], delta[s]);
        largest_delta = fmax(largest_delta, delta[s]);
    }
    if (count == 0) return;
    const double mean = gsl_stats_mean(energy, 1, count);
    gsl_sort(energy, 1, count);
    *mean_error = fmax(*mean_error, total_shift / (double)count / mean);
    for (int q = 0; q < PDMC_QUANTILES; q++) {
        const double level = pdmc_quantile_levels[q];
        const double quantile = pdmc_statistics_quantile(count, energy, level, results->confidence).value;
        quantile_error[q] = fmax(quantile_error[q], shift(quantile, largest_delta) / mean);
    }
}

void pdmc_model_error(const pdmc_results *results, pdmc_measure measure, const double delta[], double scratch[],
                      double *mean_error, double quantile_error[])
{
    *mean_error = NAN;
    for (int q = 0; q < PDMC_QUANTILES; q++) quantile_error[q] = NAN;
    for (int t = 0; t < results->tip_count; t++)
        add_tip(results, measure, t, delta, scratch, mean_error, quantile_error);
}
