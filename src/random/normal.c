// SPDX-License-Identifier: GPL-3.0-or-later
#include "random/distribution_impl.h"

#include "pdmc/random.h"

#include <gsl/gsl_cdf.h>
#include <math.h>

double pdmc_normal_quantile(double u)
{
    // 1 - u is exact in the upper half, so both tails are resolved alike and the quantile is odd about 1/2.
    return u > 0.5 ? gsl_cdf_ugaussian_Qinv(1.0 - u) : gsl_cdf_ugaussian_Pinv(u);
}

pdmc_tails pdmc_normal_tails(double z)
{
    return (pdmc_tails){gsl_cdf_ugaussian_P(z), gsl_cdf_ugaussian_Q(z)};
}

double pdmc_normal_score(pdmc_tails tails)
{
    return tails.lower < tails.upper ? gsl_cdf_ugaussian_Pinv(tails.lower) : gsl_cdf_ugaussian_Qinv(tails.upper);
}

double pdmc_normal_log_upper(double z)
{
    return z > 0.0 ? log(gsl_cdf_ugaussian_Q(z)) : log1p(-gsl_cdf_ugaussian_P(z));
}

static double normal_value(const pdmc_distribution *distribution, double z)
{
    return distribution->location + distribution->scale * z;
}

static pdmc_tails normal_tails(const pdmc_distribution *distribution, double x)
{
    return pdmc_normal_tails((x - distribution->location) / distribution->scale);
}

static void normal_moments(const pdmc_distribution *distribution, double *mean, double *deviation)
{
    *mean = distribution->location;
    *deviation = distribution->scale;
}

static void normal_by_moments(double mean, double deviation, pdmc_distribution *distribution)
{
    distribution->location = mean;
    distribution->scale = deviation;
}

const pdmc_family pdmc_family_normal = {
    .name = "normal",
    .scaled = true,
    .value = normal_value,
    .tails = normal_tails,
    .moments = normal_moments,
    .by_moments = normal_by_moments,
};

static double lognormal_value(const pdmc_distribution *distribution, double z)
{
    return exp(normal_value(distribution, z));
}

static pdmc_tails lognormal_tails(const pdmc_distribution *distribution, double x)
{
    return x > 0.0 ? normal_tails(distribution, log(x)) : (pdmc_tails){0.0, 1.0};
}

static void lognormal_moments(const pdmc_distribution *distribution, double *mean, double *deviation)
{
    const double variance = distribution->scale * distribution->scale;
    *mean = exp(distribution->location + 0.5 * variance);
    *deviation = *mean * sqrt(expm1(variance));
}

static void lognormal_by_moments(double mean, double deviation, pdmc_distribution *distribution)
{
    const double variation = deviation / mean, variance = log1p(variation * variation);
    distribution->location = log(mean) - 0.5 * variance;
    distribution->scale = sqrt(variance);
}

const pdmc_family pdmc_family_lognormal = {
    .name = "lognormal",
    .scaled = true,
    .positive = true,
    .value = lognormal_value,
    .tails = lognormal_tails,
    .moments = lognormal_moments,
    .by_moments = lognormal_by_moments,
};
