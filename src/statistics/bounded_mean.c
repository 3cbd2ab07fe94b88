// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/hall.h"

#include "pdmc/statistics.h"

#include <gsl/gsl_cdf.h>
#include <math.h>

static double skewness_of(size_t n, const double x[], double mean, double deviation)
{
    double cubes = 0.0;
    for (size_t i = 0; i < n; i++) {
        const double z = (x[i] - mean) / deviation;
        cubes += z * z * z;
    }
    return cubes / (double)n;
}

/// No more than the probability of a value above 0 is the mean.
static double upper_of_zeros(size_t n, double confidence)
{
    return pdmc_statistics_proportion(0, n, confidence).upper;
}

pdmc_estimate pdmc_statistics_bounded_mean(size_t n, const double x[], double confidence)
{
    pdmc_estimate mean, deviation;
    pdmc_statistics_moments(n, x, confidence, &mean, &deviation);
    if (n > 0 && mean.value == 0.0) return (pdmc_estimate){0.0, 0.0, upper_of_zeros(n, confidence)};
    if (n < 2 || deviation.value == 0.0) return mean;
    const double root_n = sqrt((double)n), error = deviation.value / root_n;
    const double t = gsl_cdf_tdist_Qinv(0.5 * (1.0 - confidence), (double)(n - 1));
    const double a = skewness_of(n, x, mean.value, deviation.value) / root_n;
    mean.lower = fmin(fmax(mean.value - error * pdmc_hall_inverse(a, t), 0.0), mean.value);
    mean.upper = fmax(fmin(mean.value - error * pdmc_hall_inverse(a, -t), 1.0), mean.value);
    return mean;
}
