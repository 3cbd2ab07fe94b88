// SPDX-License-Identifier: GPL-3.0-or-later
#include "reliability/tally.h"

#include <gsl/gsl_cdf.h>
#include <math.h>

void pdmc_tally_add(pdmc_tally *tally, double x)
{
    tally->count++;
    if (x == 0.0) return;
    if (tally->positive == 0) tally->unit = x;
    const double relative = x / tally->unit;
    tally->positive++;
    tally->sum += relative;
    tally->squares += relative * relative;
    tally->cubes += relative * relative * relative;
    tally->largest = fmax(tally->largest, relative);
}

double pdmc_tally_mean(const pdmc_tally *tally)
{
    return tally->unit * (tally->sum / (double)tally->count);
}

/// With n - 1, and in units of tally->unit.
static double variance(const pdmc_tally *tally)
{
    const double n = (double)tally->count;
    return fmax(0.0, tally->squares - tally->sum * tally->sum / n) / (n - 1.0);
}

double pdmc_tally_variation(const pdmc_tally *tally)
{
    const double n = (double)tally->count;
    return sqrt(variance(tally) / n) / (tally->sum / n);
}

double pdmc_tally_effective(const pdmc_tally *tally)
{
    return tally->positive > 0 ? tally->sum * tally->sum / tally->squares : 0.0;
}

static double skewness(const pdmc_tally *tally)
{
    const double n = (double)tally->count, mean = tally->sum / n, spread = variance(tally);
    const double third = tally->cubes / n - 3.0 * mean * tally->squares / n + 2.0 * mean * mean * mean;
    return spread > 0.0 ? third / (spread * sqrt(spread)) : 0.0;
}

/// The T whose transform is x.
static double hall_inverse(double x, double skew, double n)
{
    const double straight = x - skew / (6.0 * n);
    // Below, the root's difference would be lost in rounding, and the skewness does not matter.
    return fabs(skew) > 1e-6 ? 3.0 / skew * (cbrt(1.0 + skew * straight) - 1.0) : straight;
}

pdmc_estimate pdmc_tally_interval(const pdmc_tally *tally, double confidence)
{
    const double n = (double)tally->count, mean = pdmc_tally_mean(tally);
    if (tally->count < 3) return (pdmc_estimate){mean, 0.0, INFINITY};
    const double s = tally->unit * sqrt(variance(tally)), skew = skewness(tally);
    const double t = gsl_cdf_tdist_Qinv(0.5 * (1.0 - confidence), n - 1.0) / sqrt(n);
    return (pdmc_estimate){mean, fmax(0.0, mean - s * hall_inverse(t, skew, n)), mean - s * hall_inverse(-t, skew, n)};
}

void pdmc_tally_report(const pdmc_tally *events, const pdmc_tally *possible, double confidence,
                       pdmc_reliability *result)
{
    result->probability = pdmc_tally_interval(events, confidence);
    result->probability.upper = fmin(1.0, pdmc_tally_interval(possible, confidence).upper);
    result->variation = pdmc_tally_variation(events);
    result->effective_samples = pdmc_tally_effective(events);
    result->largest_share = events->largest / events->sum;
    if (events->positive == 0) result->probability.value = NAN;
    if (possible->positive == 0) result->probability.upper = 1.0;
}

static double index_of(double probability)
{
    return isnan(probability) ? NAN : gsl_cdf_ugaussian_Qinv(probability);
}

pdmc_estimate pdmc_reliability_index(pdmc_estimate probability)
{
    return (pdmc_estimate){index_of(probability.value), index_of(probability.upper), index_of(probability.lower)};
}
