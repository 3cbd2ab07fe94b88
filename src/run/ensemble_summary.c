// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/ensemble_summary.h"

#include "base/base_impl.h"
#include "stochastic/summary.h"

#include <gsl/gsl_sort.h>
#include <math.h>

static const pdmc_estimate nothing = {NAN, NAN, NAN};

static pdmc_status allocate(pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    pdmc_ensemble_results *e = &results->ensemble;
    const size_t tips = (size_t)e->tip_count, bins = (size_t)results->histogram_bins;
    const size_t stations = tips * (size_t)e->station_count;
    PDMC_NEW(e->share, tips * PDMC_OUTCOMES);
    PDMC_NEW(e->mean_growth, tips);
    PDMC_NEW(e->deviation, tips);
    PDMC_NEW(e->growth_quantiles, tips * PDMC_QUANTILES);
    PDMC_NEW(e->growth_edges, tips * (bins + 1));
    PDMC_NEW(e->growth_counts, tips * (bins + 2));
    PDMC_NEW(e->growth_density, tips * bins);
    PDMC_NEW(e->path_samples, stations);
    PDMC_NEW(e->path_mean, stations);
    PDMC_NEW(e->path_quantiles, stations * PDMC_QUANTILES);
    PDMC_NEW(e->mean_force, e->condition_count);
    PDMC_NEW(e->force_deviation, e->condition_count);
    PDMC_NEW(e->force_quantiles, (size_t)e->condition_count * PDMC_QUANTILES);
done:
    return status;
}

/// The numbers of one column of an array [samples, columns] that are there.
static size_t gather(const pdmc_ensemble_results *e, const double values[], size_t columns, size_t column, double x[])
{
    size_t count = 0;
    for (size_t s = 0; s < (size_t)e->sample_count; s++)
        if (!isnan(values[s * columns + column])) x[count++] = values[s * columns + column];
    return count;
}

/// x: sorted on return
static void find_quantiles(size_t count, double x[], double confidence, pdmc_estimate quantiles[])
{
    gsl_sort(x, 1, count);
    for (int q = 0; q < PDMC_QUANTILES; q++)
        quantiles[q] = count > 0 ? pdmc_statistics_quantile(count, x, pdmc_quantile_levels[q], confidence) : nothing;
}

static void summarise_outcomes(pdmc_results *results, size_t tip)
{
    const pdmc_ensemble_results *e = &results->ensemble;
    const size_t samples = (size_t)e->sample_count, tips = (size_t)e->tip_count;
    size_t hits[PDMC_OUTCOMES] = {0};
    for (size_t s = 0; s < samples; s++)
        if (e->failure[s] == PDMC_SAMPLE_OK) hits[e->outcome[s * tips + tip]]++;
    for (size_t k = 0; k < PDMC_OUTCOMES; k++)
        e->share[tip * PDMC_OUTCOMES + k] =
            pdmc_summarise_share(hits[k], (size_t)e->failed_count, samples, results->confidence);
}

static void summarise_growth(pdmc_results *results, size_t tip, double x[])
{
    const pdmc_ensemble_results *e = &results->ensemble;
    const size_t bins = (size_t)results->histogram_bins;
    const size_t count = gather(e, e->growth, (size_t)e->tip_count, tip, x);
    pdmc_statistics_moments(count, x, results->confidence, &e->mean_growth[tip], &e->deviation[tip]);
    find_quantiles(count, x, results->confidence, &e->growth_quantiles[tip * PDMC_QUANTILES]);
    pdmc_statistics_histogram(count, x, results->histogram_bins, results->confidence,
                              &e->growth_edges[tip * (bins + 1)], &e->growth_counts[tip * (bins + 2)],
                              &e->growth_density[tip * bins]);
}

static void summarise_path(pdmc_results *results, size_t place, double x[])
{
    const pdmc_ensemble_results *e = &results->ensemble;
    const size_t places = (size_t)e->tip_count * (size_t)e->station_count;
    const size_t count = gather(e, e->path, places, place, x);
    pdmc_estimate deviation;
    e->path_samples[place] = (double)count;
    pdmc_statistics_moments(count, x, results->confidence, &e->path_mean[place], &deviation);
    find_quantiles(count, x, results->confidence, &e->path_quantiles[place * PDMC_QUANTILES]);
}

static void summarise_force(pdmc_results *results, size_t condition, double x[])
{
    const pdmc_ensemble_results *e = &results->ensemble;
    const size_t count = gather(e, e->largest_force, (size_t)e->condition_count, condition, x);
    pdmc_statistics_moments(count, x, results->confidence, &e->mean_force[condition], &e->force_deviation[condition]);
    find_quantiles(count, x, results->confidence, &e->force_quantiles[condition * PDMC_QUANTILES]);
}

pdmc_status pdmc_ensemble_summarise(pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    const pdmc_ensemble_results *e = &results->ensemble;
    double *x = NULL;
    if (e->failed_count == e->sample_count)
        PDMC_FAIL(PDMC_ERR_DATA, "all %d samples failed: there is nothing to summarise", e->sample_count);
    PDMC_TRY(allocate(results));
    PDMC_NEW(x, e->sample_count);
    for (size_t t = 0; t < (size_t)e->tip_count; t++) {
        summarise_outcomes(results, t);
        summarise_growth(results, t, x);
        for (size_t j = 0; j < (size_t)e->station_count; j++)
            summarise_path(results, t * (size_t)e->station_count + j, x);
    }
    for (size_t c = 0; c < (size_t)e->condition_count; c++) summarise_force(results, c, x);
done:
    pdmc_free(x);
    return status;
}
