// SPDX-License-Identifier: GPL-3.0-or-later
#include "reliability/average.h"

#include <gsl/gsl_cdf.h>
#include <math.h>

void pdmc_average_add(pdmc_average *average, double x)
{
    average->count++;
    if (x == 0.0) return;
    if (average->positive == 0) average->unit = x;
    const double relative = x / average->unit;
    average->positive++;
    average->sum += relative;
    average->squares += relative * relative;
    average->cubes += relative * relative * relative;
    average->largest = fmax(average->largest, relative);
}

double pdmc_average_value(const pdmc_average *average)
{
    return average->unit * (average->sum / (double)average->count);
}

/// With n - 1, and in units of average->unit.
static double variance(const pdmc_average *average)
{
    const double n = (double)average->count;
    return fmax(0.0, average->squares - average->sum * average->sum / n) / (n - 1.0);
}

double pdmc_average_variation(const pdmc_average *average)
{
    const double n = (double)average->count;
    return sqrt(variance(average) / n) / (average->sum / n);
}

double pdmc_average_effective(const pdmc_average *average)
{
    return average->positive > 0 ? average->sum * average->sum / average->squares : 0.0;
}

double pdmc_average_largest_share(const pdmc_average *average)
{
    return average->largest * average->largest / average->squares;
}

static double skewness(const pdmc_average *average)
{
    const double n = (double)average->count, mean = average->sum / n, spread = variance(average);
    const double third = average->cubes / n - 3.0 * mean * average->squares / n + 2.0 * mean * mean * mean;
    return spread > 0.0 ? third / (spread * sqrt(spread)) : 0.0;
}

/// The T whose transform is x.
static double hall_inverse(double x, double skew, double n)
{
    const double straight = x - skew / (6.0 * n);
    // Below, the root's difference would be lost in rounding, and the skewness does not matter.
    return fabs(skew) > 1e-6 ? 3.0 / skew * (cbrt(1.0 + skew * straight) - 1.0) : straight;
}

pdmc_estimate pdmc_average_interval(const pdmc_average *average, double confidence)
{
    const double n = (double)average->count, mean = pdmc_average_value(average);
    if (average->count < 3) return (pdmc_estimate){mean, 0.0, INFINITY};
    const double s = average->unit * sqrt(variance(average)), skew = skewness(average);
    const double t = gsl_cdf_tdist_Qinv(0.5 * (1.0 - confidence), n - 1.0) / sqrt(n);
    return (pdmc_estimate){mean, fmax(0.0, mean - s * hall_inverse(t, skew, n)), mean - s * hall_inverse(-t, skew, n)};
}

void pdmc_average_report(const pdmc_average *events, const pdmc_average *possible, double confidence,
                         pdmc_reliability *result)
{
    result->probability = pdmc_average_interval(events, confidence);
    result->probability.upper = fmin(1.0, pdmc_average_interval(possible, confidence).upper);
    result->variation = pdmc_average_variation(events);
    result->effective_samples = pdmc_average_effective(events);
    result->largest_share = pdmc_average_largest_share(events);
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
