// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/stochastic.h"

#include "base/base_impl.h"

#include <gsl/gsl_sort.h>
#include <math.h>
#include <string.h>

// Directions whose energies agree to this share the sample: a symmetric plate has two equal maxima, which rounding
// would otherwise deal out.
static const double tie = 1e-6;

static pdmc_status allocate(pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    const size_t tips = (size_t)results->tip_count, directions = tips * (size_t)results->angle_count;
    const size_t bins = (size_t)results->histogram_bins;
    for (int m = 0; m < PDMC_MEASURES; m++) {
        pdmc_energy_statistics *statistics = &results->statistics[m];
        PDMC_NEW(statistics->mean, directions);
        PDMC_NEW(statistics->standard_deviation, directions);
        PDMC_NEW(statistics->quantiles, directions * PDMC_QUANTILES);
        PDMC_NEW(statistics->histogram_edges, directions * (bins + 1));
        PDMC_NEW(statistics->histogram_counts, directions * (bins + 2));
        PDMC_NEW(statistics->density, directions * bins);
    }
    PDMC_NEW(results->direction, directions);
    PDMC_NEW(results->probability, tips);
done:
    return status;
}

// The energies of one measure in one direction, over the samples that did not fail, in the order of the samples.
static size_t gather(const pdmc_results *results, int measure, size_t direction, double x[])
{
    const size_t directions = (size_t)(results->tip_count * results->angle_count);
    size_t count = 0;
    for (int s = 0; s < results->sample_count; s++)
        if (results->failure[s] == PDMC_SAMPLE_OK)
            x[count++] = results->energy[measure][(size_t)s * directions + direction];
    return count;
}

static void summarise_direction(pdmc_results *results, int measure, size_t direction, double x[])
{
    pdmc_energy_statistics *statistics = &results->statistics[measure];
    const double confidence = results->confidence;
    const size_t bins = (size_t)results->histogram_bins, count = gather(results, measure, direction, x);
    pdmc_statistics_moments(count, x, confidence, &statistics->mean[direction],
                            &statistics->standard_deviation[direction]);
    gsl_sort(x, 1, count);
    for (int q = 0; q < PDMC_QUANTILES; q++)
        statistics->quantiles[direction * PDMC_QUANTILES + (size_t)q] =
            pdmc_statistics_quantile(count, x, pdmc_quantile_levels[q], confidence);
    pdmc_statistics_histogram(
        count, x, results->histogram_bins, confidence, &statistics->histogram_edges[direction * (bins + 1)],
        &statistics->histogram_counts[direction * (bins + 2)], &statistics->density[direction * bins]);
}

// Adds one sample to the shares of its largest directions, and tells the largest energy.
static double share_largest(const double energy[], int angles, double share[])
{
    double largest = energy[0];
    int count = 0;
    for (int a = 1; a < angles; a++) largest = fmax(largest, energy[a]);
    for (int a = 0; a < angles; a++) count += energy[a] >= (1.0 - tie) * largest;
    for (int a = 0; a < angles; a++)
        if (energy[a] >= (1.0 - tie) * largest) share[a] += 1.0 / count;
    return largest;
}

static void summarise_tip(pdmc_results *results, int tip, double share[])
{
    const int angles = results->angle_count, tips = results->tip_count;
    const size_t samples = (size_t)results->sample_count, failed = (size_t)results->failed_count;
    size_t hits = 0;
    memset(share, 0, (size_t)angles * sizeof *share);
    for (size_t s = 0; s < samples; s++) {
        if (results->failure[s] != PDMC_SAMPLE_OK) continue;
        const double *energy = &results->energy[results->measure][(s * (size_t)tips + (size_t)tip) * (size_t)angles];
        hits += share_largest(energy, angles, share) > results->sample_fracture_energy[s];
    }
    for (int a = 0; a < angles; a++) {
        pdmc_estimate *direction = &results->direction[tip * angles + a];
        *direction = pdmc_statistics_proportion((size_t)lround(share[a]), samples - failed, results->confidence);
        direction->value = share[a] / (double)(samples - failed);
    }
    // A failed sample may have been either.
    pdmc_estimate *probability = &results->probability[tip];
    *probability = pdmc_statistics_proportion(hits, samples - failed, results->confidence);
    probability->lower = pdmc_statistics_proportion(hits, samples, results->confidence).lower;
    probability->upper = pdmc_statistics_proportion(hits + failed, samples, results->confidence).upper;
}

pdmc_status pdmc_summarise(const pdmc_run_options *options, pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    const int directions = results->tip_count * results->angle_count;
    double *scratch = NULL, *share = NULL;
    const size_t samples = (size_t)results->sample_count;
    if (results->failed_count == results->sample_count)
        PDMC_FAIL(PDMC_ERR_DATA, "all %d samples failed: there is nothing to summarise", results->sample_count);
    PDMC_TRY(allocate(results));
    PDMC_NEW(scratch, samples * (size_t)options->threads);
    PDMC_NEW(share, results->angle_count);
#pragma omp parallel for schedule(static) num_threads(options->threads)
    for (int thread = 0; thread < options->threads; thread++)
        for (int i = thread; i < PDMC_MEASURES * directions; i += options->threads)
            summarise_direction(results, i / directions, (size_t)(i % directions), &scratch[(size_t)thread * samples]);
    for (int t = 0; t < results->tip_count; t++) summarise_tip(results, t, share);
done:
    pdmc_free(scratch);
    pdmc_free(share);
    return status;
}
