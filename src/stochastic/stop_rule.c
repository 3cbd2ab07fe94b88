// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/stop_rule.h"

#include "base/base_impl.h"
#include "stochastic/summary.h"

#include <math.h>

static const double level = 0.95; // of the quantile

static int greatest_divisor(int a, int b)
{
    return b == 0 ? a : greatest_divisor(b, a % b);
}

static int whole_parts(const pdmc_problem *problem, int together, double samples)
{
    const pdmc_sampling *sampling = &problem->sampling;
    const int parts = sampling->design == PDMC_DESIGN_MONTE_CARLO ? 1 : sampling->replicates;
    const double unit = (double)together * parts / greatest_divisor(together, parts);
    return (int)fmin(unit * ceil(samples / unit), sampling->most_samples);
}

int pdmc_stop_rule_first(const pdmc_problem *problem, int together)
{
    const pdmc_sampling *sampling = &problem->sampling;
    return sampling->target == PDMC_TARGET_NONE ? sampling->samples : whole_parts(problem, together, sampling->samples);
}

int pdmc_stop_rule_most(const pdmc_problem *problem)
{
    const pdmc_sampling *sampling = &problem->sampling;
    return sampling->target == PDMC_TARGET_NONE ? sampling->samples : sampling->most_samples;
}

static size_t largest_direction(const pdmc_results *results, int tip)
{
    const double *bond =
        results->bonds == PDMC_BONDS_ALL ? results->nominal_bond_energy : results->nominal_bond_energy_tensile;
    const double *energy = results->measure == PDMC_MEASURE_BOND ? bond : results->nominal_griffith_energy;
    const size_t angles = (size_t)results->angle_count, first = (size_t)tip * angles;
    size_t largest = first;
    for (size_t d = first; d < first + angles; d++)
        if (energy[d] > energy[largest]) largest = d;
    return largest;
}

static pdmc_status estimate(pdmc_target target, const pdmc_sample_counts *counts, const pdmc_results *results, int tip,
                            pdmc_estimate *found)
{
    pdmc_estimate mean, quantile;
    if (target == PDMC_TARGET_PROBABILITY) return pdmc_summarise_probability(results, tip, found);
    const pdmc_status status =
        pdmc_summarise_energy(counts, results, largest_direction(results, tip), level, &mean, &quantile);
    if (status == PDMC_OK) *found = target == PDMC_TARGET_MEAN ? mean : quantile;
    return status;
}

// Nothing is known of what never happened; nor where an interval has no end.
static double relative_error(const pdmc_estimate *found)
{
    const double error = 0.5 * (found->upper - found->lower) / fabs(found->value);
    return isfinite(error) ? error : INFINITY;
}

pdmc_status pdmc_stop_rule_judge(const pdmc_problem *problem, const pdmc_sample_counts *counts,
                                 const pdmc_results *results, pdmc_round *round)
{
    const pdmc_sampling *sampling = &problem->sampling;
    const bool is_known = results->failed_count < results->sample_count;
    *round = (pdmc_round){.target = sampling->target,
                          .samples = results->sample_count,
                          .tip = results->tips[0].name,
                          .error = is_known ? 0.0 : INFINITY,
                          .wanted = sampling->relative_error};
    for (int t = 0; t < results->tip_count && is_known; t++) {
        pdmc_estimate found;
        const pdmc_status status = estimate(sampling->target, counts, results, t, &found);
        if (status != PDMC_OK) return status;
        const double error = relative_error(&found);
        if (error > round->error) {
            round->error = error;
            round->tip = results->tips[t].name;
        }
    }
    round->needed = round->samples * pow(round->error / round->wanted, 2.0);
    return PDMC_OK;
}

int pdmc_stop_rule_next(const pdmc_problem *problem, int together, const pdmc_round *round)
{
    const double least_growth = 1.1, most_growth = 2.0, samples = round->samples;
    return whole_parts(problem, together, fmin(fmax(round->needed, least_growth * samples), most_growth * samples));
}
