// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/statistics.h"

#include <float.h>
#include <gsl/gsl_cdf.h>
#include <math.h>

static double sample_mean(size_t n, const double x[])
{
    double sum = 0.0, rest = 0.0;
    for (size_t i = 0; i < n; i++) sum += x[i];
    const double mean = sum / (double)n;
    for (size_t i = 0; i < n; i++) rest += x[i] - mean; // what the rounding of the sum has lost
    return mean + rest / (double)n;
}

/// Relative to the largest deviation, so that no unit of x makes the squares overflow or vanish.
static double sample_deviation(size_t n, const double x[], double mean)
{
    double largest = 0.0, squares = 0.0;
    for (size_t i = 0; i < n; i++) largest = fmax(largest, fabs(x[i] - mean));
    if (largest == 0.0) return 0.0;
    for (size_t i = 0; i < n; i++) {
        const double d = (x[i] - mean) / largest;
        squares += d * d;
    }
    return largest * sqrt(squares / (double)(n - 1));
}

/// By how much log s^2 grows from the sample without x_i to the whole, times n - 1: Miller's pseudo-value less log s^2.
/// @param[in] z  (x_i - mean) / s
static double pseudo_value(size_t n, double z)
{
    const double m = (double)n;
    const double share = z * z * m / ((m - 1.0) * (m - 1.0)); // of x_i in the sum of squares
    // A share of 1, all other samples equal, leaves no spread; short of 1, it leaves an interval that is wide.
    return -(m - 1.0) * (log1p(-fmin(share, 1.0 - DBL_EPSILON)) + log1p(1.0 / (m - 2.0)));
}

static void jackknife(size_t n, const double x[], double mean, double t, pdmc_estimate *deviation)
{
    const double m = (double)n;
    double shift = 0.0, squares = 0.0;
    for (size_t i = 0; i < n; i++) shift += pseudo_value(n, (x[i] - mean) / deviation->value) / m;
    for (size_t i = 0; i < n; i++) {
        const double d = pseudo_value(n, (x[i] - mean) / deviation->value) - shift;
        squares += d * d;
    }
    const double half_width = t * sqrt(squares / (m * (m - 1.0)));
    // The jackknife corrects the bias of log s^2; at a low confidence that may leave s itself outside.
    deviation->lower = deviation->value * fmin(1.0, exp(0.5 * (shift - half_width)));
    deviation->upper = deviation->value * fmax(1.0, exp(0.5 * (shift + half_width)));
}

void pdmc_statistics_moments(size_t n, const double x[], double confidence, pdmc_estimate *mean,
                             pdmc_estimate *deviation)
{
    *mean = (pdmc_estimate){NAN, NAN, NAN};
    *deviation = *mean;
    if (n > 0) mean->value = sample_mean(n, x);
    if (n < 2) return;

    const double t = gsl_cdf_tdist_Qinv(0.5 * (1.0 - confidence), (double)(n - 1));
    const double s = sample_deviation(n, x, mean->value);
    mean->lower = mean->value - t * s / sqrt((double)n);
    mean->upper = mean->value + t * s / sqrt((double)n);
    *deviation = s > 0.0 ? (pdmc_estimate){s, NAN, NAN} : (pdmc_estimate){0.0, 0.0, 0.0};
    if (n > 2 && s > 0.0) jackknife(n, x, mean->value, t, deviation);
}
