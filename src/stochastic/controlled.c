// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/controlled.h"

#include "base/base_impl.h"
#include "stochastic/summary.h"

#include <math.h>

static pdmc_status allocate(pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    pdmc_control_results *control = &results->control;
    const size_t tips = (size_t)results->tip_count, directions = tips * (size_t)results->angle_count;
    PDMC_NEW(control->mean, directions);
    PDMC_NEW(control->correlation, directions);
    PDMC_NEW(control->mean_gain, directions);
    PDMC_NEW(control->probability, tips);
    PDMC_NEW(control->probability_gain, tips);
    control->tip_count = results->tip_count;
done:
    return status;
}

/// The results' own energies in a direction, and those of the same samples of the cheaper method.
static void gather(const pdmc_results *from, size_t samples, size_t direction, double x[])
{
    const size_t directions = (size_t)from->tip_count * (size_t)from->angle_count;
    for (size_t s = 0; s < samples; s++) x[s] = from->energy[from->measure][s * directions + direction];
}

/// @param x, c  scratch, [samples] each
static pdmc_status control_mean(const pdmc_results *cheaper, const pdmc_sample_counts *counts, size_t direction,
                                double x[], double c[], pdmc_results *results)
{
    pdmc_controlled found;
    pdmc_estimate mean, median;
    const size_t samples = (size_t)results->sample_count;
    pdmc_status status = pdmc_summarise_energy(counts, cheaper, direction, 0.5, &mean, &median);
    if (status != PDMC_OK) return status;
    gather(results, samples, direction, x);
    gather(cheaper, samples, direction, c);
    status = pdmc_statistics_control(samples, x, 1, c, &mean.value, cheaper->sample_count, results->confidence, &found);
    if (status != PDMC_OK) return status;
    results->control.mean[direction] = found.mean;
    results->control.correlation[direction] = found.correlation;
    results->control.mean_gain[direction] = found.reduction;
    return PDMC_OK;
}

/// The direction in which the mean plate has its largest energy.
static int largest_direction(const pdmc_results *results, int tip, double *energy)
{
    const bool all = results->bonds == PDMC_BONDS_ALL;
    const double *bond = all ? results->nominal_bond_energy : results->nominal_bond_energy_tensile;
    const double *nominal = results->measure == PDMC_MEASURE_BOND ? bond : results->nominal_griffith_energy;
    int best = tip * results->angle_count;
    for (int a = 1; a < results->angle_count; a++)
        if (nominal[tip * results->angle_count + a] > nominal[best]) best = tip * results->angle_count + a;
    *energy = nominal[best];
    return best;
}

/// The energy that a tip needs to grow by the cheaper method, over G_c: with the ratio of both methods' energies of the mean
/// plate the events agree more often.
static double threshold_of(const pdmc_results *cheaper, const pdmc_results *results, int tip)
{
    double own, other;
    largest_direction(results, tip, &own);
    largest_direction(cheaper, tip, &other);
    return own > 0.0 && other > 0.0 ? other / own : 1.0;
}

static bool grows(const pdmc_results *results, int sample, int tip, double threshold)
{
    const size_t place = (size_t)sample * (size_t)results->tip_count + (size_t)tip;
    return results->largest_energy[results->measure][place] > threshold * results->sample_fracture_energy[place];
}

static double width(const pdmc_estimate *estimate)
{
    return estimate->upper - estimate->lower;
}

static void control_probability(const pdmc_results *cheaper, int tip, pdmc_results *results)
{
    const double threshold = threshold_of(cheaper, results, tip);
    size_t hits[2] = {0}, trials[2] = {0}, known_hits = 0;
    for (int s = 0; s < results->sample_count; s++) {
        const bool control = grows(cheaper, s, tip, threshold);
        trials[control]++;
        hits[control] += grows(results, s, tip, 1.0);
    }
    for (int s = 0; s < cheaper->sample_count; s++) known_hits += grows(cheaper, s, tip, threshold);
    pdmc_estimate *found = &results->control.probability[tip];
    *found = pdmc_statistics_stratified_proportion(hits, trials, known_hits, (size_t)cheaper->sample_count,
                                                   results->confidence);
    results->control.probability_gain[tip] = pow(width(&results->probability[tip]) / width(found), 2.0);
}

static void leave_open(pdmc_results *results)
{
    const pdmc_estimate unknown = {NAN, NAN, NAN};
    pdmc_control_results *control = &results->control;
    for (int t = 0; t < results->tip_count; t++) {
        control->probability[t] = unknown;
        control->probability_gain[t] = NAN;
    }
    for (int i = 0; i < results->tip_count * results->angle_count; i++) {
        control->mean[i] = unknown;
        control->correlation[i] = control->mean_gain[i] = NAN;
    }
}

pdmc_status pdmc_control_samples(const pdmc_results *cheaper, const pdmc_sample_counts *counts, pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    const int directions = results->tip_count * results->angle_count;
    double *x = NULL, *c = NULL;
    PDMC_TRY(allocate(results));
    results->control.samples = cheaper->sample_count;
    results->control.failed = cheaper->failed_count;
    if (results->failed_count > 0 || cheaper->failed_count > 0) {
        leave_open(results);
        goto done;
    }
    PDMC_NEW(x, results->sample_count);
    PDMC_NEW(c, results->sample_count);
    for (int d = 0; d < directions; d++) PDMC_TRY(control_mean(cheaper, counts, (size_t)d, x, c, results));
    for (int t = 0; t < results->tip_count; t++) control_probability(cheaper, t, results);
done:
    pdmc_free(x);
    pdmc_free(c);
    return status;
}

double pdmc_control_advice(const pdmc_results *results, double cost_ratio)
{
    double least = INFINITY;
    for (int t = 0; t < results->tip_count; t++) {
        double energy;
        const double r = results->control.correlation[largest_direction(results, t, &energy)];
        if (isnan(r)) return NAN;
        least = fmin(least, r * r);
    }
    const double n = results->sample_count;
    return fmax(n, n * sqrt(cost_ratio * least / (1.0 - least)));
}
