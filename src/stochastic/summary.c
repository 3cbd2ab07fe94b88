// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/stochastic.h"

#include "base/base_impl.h"
#include "stochastic/counts.h"
#include "stochastic/summary.h"

#include <gsl/gsl_sort.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

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
    PDMC_NEW(results->conditional_probability, tips);
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

// The replicates of the design; 0 where samples are independent. A design that samples have failed in is none: their places
// in the replicates are empty. Its intervals are then those of independent samples, which are too wide rather than too narrow.
static size_t replicates_of(const pdmc_results *results)
{
    return results->failed_count == 0 && results->replicates > 0.0 ? (size_t)results->replicates : 0;
}

static void find_moments(const pdmc_results *results, size_t count, const double x[], pdmc_estimate *mean,
                         pdmc_estimate *deviation)
{
    const size_t replicates = replicates_of(results);
    if (replicates > 0) pdmc_statistics_replicates_moments(count, x, replicates, results->confidence, mean, deviation);
    else pdmc_statistics_moments(count, x, results->confidence, mean, deviation);
}

static pdmc_estimate find_quantile(const pdmc_results *results, size_t count, const double x[], const double sorted[],
                                   double p)
{
    const size_t replicates = replicates_of(results);
    return replicates > 0 ? pdmc_statistics_replicates_quantile(count, x, sorted, replicates, p, results->confidence)
                          : pdmc_statistics_quantile(count, sorted, p, results->confidence);
}

// x, sorted: scratch, [samples] each
static void summarise_direction(pdmc_results *results, int measure, size_t direction, double x[], double sorted[])
{
    pdmc_energy_statistics *statistics = &results->statistics[measure];
    const size_t bins = (size_t)results->histogram_bins, count = gather(results, measure, direction, x);
    find_moments(results, count, x, &statistics->mean[direction], &statistics->standard_deviation[direction]);
    memcpy(sorted, x, count * sizeof *x);
    gsl_sort(sorted, 1, count);
    for (int q = 0; q < PDMC_QUANTILES; q++)
        statistics->quantiles[direction * PDMC_QUANTILES + (size_t)q] =
            find_quantile(results, count, x, sorted, pdmc_quantile_levels[q]);
    pdmc_statistics_histogram(count, sorted, results->histogram_bins, results->confidence,
                              &statistics->histogram_edges[direction * (bins + 1)],
                              &statistics->histogram_counts[direction * (bins + 2)],
                              &statistics->density[direction * bins]);
}

// The same from a tally.
static void summarise_counted(const pdmc_sample_counts *counts, pdmc_results *results, int measure, size_t direction)
{
    pdmc_energy_statistics *statistics = &results->statistics[measure];
    const size_t bins = (size_t)results->histogram_bins, directions = (size_t)(counts->tips * counts->angles);
    const size_t quantity = (size_t)measure * directions + direction;
    pdmc_tally_moments(counts->tally, quantity, results->confidence, &statistics->mean[direction],
                       &statistics->standard_deviation[direction]);
    for (int q = 0; q < PDMC_QUANTILES; q++)
        statistics->quantiles[direction * PDMC_QUANTILES + (size_t)q] =
            pdmc_tally_quantile(counts->tally, quantity, pdmc_quantile_levels[q], results->confidence);
    pdmc_tally_histogram(counts->tally, quantity, results->histogram_bins, results->confidence,
                         &statistics->histogram_edges[direction * (bins + 1)],
                         &statistics->histogram_counts[direction * (bins + 2)], &statistics->density[direction * bins]);
}

// Adds one sample to the shares of its largest directions.
static void share_largest(const double energy[], int angles, double share[])
{
    double largest = energy[0];
    int count = 0;
    for (int a = 1; a < angles; a++) largest = fmax(largest, energy[a]);
    for (int a = 0; a < angles; a++) count += pdmc_is_largest(energy[a], largest);
    for (int a = 0; a < angles; a++)
        if (pdmc_is_largest(energy[a], largest)) share[a] += 1.0 / count;
}

// The number of samples whose energy is largest at each angle; one that has it at several is shared out.
static void share_directions(const pdmc_sample_counts *counts, const pdmc_results *results, int tip, double share[])
{
    const size_t angles = (size_t)results->angle_count, tips = (size_t)results->tip_count;
    memset(share, 0, angles * sizeof *share);
    for (size_t s = 0; !counts && s < (size_t)results->sample_count; s++)
        if (results->failure[s] == PDMC_SAMPLE_OK)
            share_largest(&results->energy[results->measure][(s * tips + (size_t)tip) * angles], (int)angles, share);
    for (size_t a = 0; counts && a < angles; a++)
        for (size_t n = 0; n < angles; n++)
            share[a] += (double)counts->largest[((size_t)tip * angles + a) * angles + n] / (double)(n + 1);
}

pdmc_estimate pdmc_summarise_share(size_t hits, size_t failed, size_t samples, double confidence)
{
    return (pdmc_estimate){pdmc_statistics_proportion(hits, samples - failed, confidence).value,
                           pdmc_statistics_proportion(hits, samples, confidence).lower,
                           pdmc_statistics_proportion(hits + failed, samples, confidence).upper};
}

static pdmc_estimate find_probability(const pdmc_results *results, const bool event[])
{
    const size_t samples = (size_t)results->sample_count, failed = (size_t)results->failed_count;
    const double confidence = results->confidence;
    const size_t replicates = replicates_of(results);
    size_t hits = 0;
    if (replicates > 0) return pdmc_statistics_replicates_proportion(samples, event, replicates, confidence);
    for (size_t s = 0; s < samples; s++) hits += event[s];
    return pdmc_summarise_share(hits, failed, samples, confidence);
}

// Samples that failed have `otherwise`, or are left out where that is NaN.
static size_t gather_given_rest(const pdmc_results *results, int tip, double otherwise, double x[])
{
    const size_t tips = (size_t)results->tip_count;
    size_t count = 0;
    for (size_t s = 0; s < (size_t)results->sample_count; s++) {
        const bool is_solved = results->failure[s] == PDMC_SAMPLE_OK;
        if (is_solved || !isnan(otherwise))
            x[count++] = is_solved ? results->growth_given_rest[s * tips + (size_t)tip] : otherwise;
    }
    return count;
}

static pdmc_estimate find_mean_probability(const pdmc_results *results, size_t count, const double x[])
{
    pdmc_estimate mean, deviation;
    if (replicates_of(results) == 0) return pdmc_statistics_bounded_mean(count, x, results->confidence);
    find_moments(results, count, x, &mean, &deviation);
    return (pdmc_estimate){mean.value, fmax(mean.lower, 0.0), fmin(mean.upper, 1.0)};
}

// The mean over the samples that did not fail, with bounds for which a failed sample may have been either.
// x: scratch, [samples]
static pdmc_estimate find_conditional(const pdmc_results *results, int tip, double x[])
{
    const size_t count = gather_given_rest(results, tip, NAN, x), samples = (size_t)results->sample_count;
    for (size_t k = 0; k < count; k++)
        if (isnan(x[k])) return (pdmc_estimate){NAN, NAN, NAN};
    pdmc_estimate found = find_mean_probability(results, count, x);
    if (count == samples) return found;
    gather_given_rest(results, tip, 0.0, x);
    found.lower = find_mean_probability(results, samples, x).lower;
    gather_given_rest(results, tip, 1.0, x);
    found.upper = find_mean_probability(results, samples, x).upper;
    return found;
}

static void mark_growth(const pdmc_results *results, int tip, bool event[])
{
    const double *largest = results->largest_energy[results->measure];
    for (size_t s = 0; s < (size_t)results->sample_count; s++) {
        const size_t place = s * (size_t)results->tip_count + (size_t)tip;
        event[s] = results->failure[s] == PDMC_SAMPLE_OK && largest[place] > results->sample_fracture_energy[place];
    }
}

static void summarise_tip(const pdmc_sample_counts *counts, pdmc_results *results, int tip, double share[],
                          bool event[], double x[])
{
    const int angles = results->angle_count;
    const size_t samples = (size_t)results->sample_count, failed = (size_t)results->failed_count;
    share_directions(counts, results, tip, share);
    for (int a = 0; a < angles; a++) {
        pdmc_estimate *direction = &results->direction[tip * angles + a];
        *direction = pdmc_statistics_proportion((size_t)lround(share[a]), samples - failed, results->confidence);
        direction->value = share[a] / (double)(samples - failed);
    }
    mark_growth(results, tip, event);
    results->probability[tip] = find_probability(results, event);
    results->conditional_probability[tip] = find_conditional(results, tip, x);
}

// Each thread has a scratch of its own, [2, samples].
static pdmc_status summarise_kept(const pdmc_run_options *options, pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    const int measured = PDMC_MEASURES * results->tip_count * results->angle_count,
              directions = measured / PDMC_MEASURES;
    const size_t samples = (size_t)results->sample_count;
    double *scratch = NULL;
    PDMC_NEW(scratch, 2 * samples * (size_t)options->threads);
#pragma omp parallel for schedule(static) num_threads(options->threads)
    for (int thread = 0; thread < options->threads; thread++)
        for (int i = thread; i < measured; i += options->threads)
            summarise_direction(results, i / directions, (size_t)(i % directions),
                                &scratch[2 * (size_t)thread * samples], &scratch[(2 * (size_t)thread + 1) * samples]);
done:
    pdmc_free(scratch);
    return status;
}

static void summarise_all_counted(const pdmc_run_options *options, const pdmc_sample_counts *counts,
                                  pdmc_results *results)
{
    const int directions = results->tip_count * results->angle_count;
#pragma omp parallel for schedule(dynamic) num_threads(options->threads)
    for (int i = 0; i < PDMC_MEASURES * directions; i++)
        summarise_counted(counts, results, i / directions, (size_t)(i % directions));
}

pdmc_status pdmc_summarise_probability(const pdmc_results *results, int tip, pdmc_estimate *probability)
{
    pdmc_status status = PDMC_OK;
    bool *event = NULL;
    PDMC_NEW(event, results->sample_count);
    mark_growth(results, tip, event);
    *probability = find_probability(results, event);
done:
    pdmc_free(event);
    return status;
}

pdmc_status pdmc_summarise_energy(const pdmc_sample_counts *counts, const pdmc_results *results, size_t direction,
                                  double p, pdmc_estimate *mean, pdmc_estimate *quantile)
{
    pdmc_status status = PDMC_OK;
    const size_t samples = (size_t)results->sample_count;
    double *x = NULL, *sorted = NULL;
    pdmc_estimate deviation;
    if (counts) {
        const size_t quantity = (size_t)results->measure * (size_t)(counts->tips * counts->angles) + direction;
        pdmc_tally_moments(counts->tally, quantity, results->confidence, mean, &deviation);
        *quantile = pdmc_tally_quantile(counts->tally, quantity, p, results->confidence);
        goto done;
    }
    PDMC_NEW(x, samples);
    PDMC_NEW(sorted, samples);
    const size_t count = gather(results, (int)results->measure, direction, x);
    find_moments(results, count, x, mean, &deviation);
    memcpy(sorted, x, count * sizeof *x);
    gsl_sort(sorted, 1, count);
    *quantile = find_quantile(results, count, x, sorted, p);
done:
    pdmc_free(x);
    pdmc_free(sorted);
    return status;
}

// Why samples failed, and in how many.
static pdmc_status refuse_nothing(const pdmc_results *results)
{
    static const char *const reasons[] = {
        [PDMC_SAMPLE_DIVERGED] = "the expansion does not contract",
        [PDMC_SAMPLE_SINGULAR] = "the system is singular",
        [PDMC_SAMPLE_SOFT] = "the modulus or the thickness is not positive",
        [PDMC_SAMPLE_GEOMETRY] = "cracks leave the plate, are too short, come too near, or cannot be discretised",
    };
    char text[512] = "";
    for (int reason = PDMC_SAMPLE_DIVERGED; reason <= PDMC_SAMPLE_GEOMETRY; reason++) {
        const size_t length = strlen(text);
        int count = 0;
        for (int s = 0; s < results->sample_count; s++) count += results->failure[s] == reason;
        if (count > 0)
            snprintf(&text[length], sizeof text - length, "%s in %d %s", length > 0 ? "," : "", count, reasons[reason]);
    }
    return pdmc_raise(PDMC_ERR_DATA, "all %d samples failed, there is nothing to summarise:%s", results->sample_count,
                      text);
}

pdmc_status pdmc_summarise(const pdmc_run_options *options, const pdmc_sample_counts *counts, pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    double *x = NULL, *share = NULL;
    bool *event = NULL;
    const size_t samples = (size_t)results->sample_count;
    if (results->failed_count == results->sample_count) return refuse_nothing(results);
    PDMC_TRY(allocate(results));
    PDMC_NEW(x, samples);
    PDMC_NEW(event, samples);
    PDMC_NEW(share, results->angle_count);
    if (counts) summarise_all_counted(options, counts, results);
    else PDMC_TRY(summarise_kept(options, results));
    for (int t = 0; t < results->tip_count; t++) summarise_tip(counts, results, t, share, event, x);
done:
    pdmc_free(x);
    pdmc_free(share);
    pdmc_free(event);
    return status;
}
