// SPDX-License-Identifier: GPL-3.0-or-later
#include "random/distribution_impl.h"

#include "base/base_impl.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>
#include <math.h>

/// y = log(x / shape), in which the density of x (of scale 1) is proportional to exp(shape (y - e^y)): log-concave with
/// its mode at 0.
static double tail_of_logarithm(const pdmc_distribution *distribution, double y, int side, double *slope)
{
    const double shape = distribution->shape, x = shape * exp(y);
    *slope = x * gsl_ran_gamma_pdf(x, shape, 1.0);
    return side > 0 ? gsl_cdf_gamma_P(x, shape, 1.0) : gsl_cdf_gamma_Q(x, shape, 1.0);
}

static double gamma_value(const pdmc_distribution *distribution, double z)
{
    const int side = z < 0.0 ? 1 : -1;
    const double target = gsl_cdf_ugaussian_P(-fabs(z)), guess = z / sqrt(distribution->shape);
    const double y = pdmc_log_concave_quantile(tail_of_logarithm, distribution, target, side, guess);
    return distribution->location + distribution->scale * distribution->shape * exp(y);
}

static pdmc_tails gamma_tails(const pdmc_distribution *distribution, double x)
{
    const double t = (x - distribution->location) / distribution->scale;
    return (pdmc_tails){gsl_cdf_gamma_P(t, distribution->shape, 1.0), gsl_cdf_gamma_Q(t, distribution->shape, 1.0)};
}

static void gamma_moments(const pdmc_distribution *distribution, double *mean, double *deviation)
{
    *mean = distribution->location + distribution->scale * distribution->shape;
    *deviation = distribution->scale * sqrt(distribution->shape);
}

static void gamma_by_moments(double mean, double deviation, pdmc_distribution *distribution)
{
    distribution->shape = mean / deviation * (mean / deviation);
    distribution->scale = deviation / mean * deviation;
}

// GSL's incomplete gamma functions fail from a shape of 998 000 on.
static const double least_shape = 0.1, greatest_shape = 1e5;

static pdmc_status gamma_check(const pdmc_distribution *distribution)
{
    PDMC_REQUIRE(
        least_shape <= distribution->shape && distribution->shape <= greatest_shape,
        "the shape of a gamma distribution is %g: it must be in [%g, %g], a coefficient of variation in [%g, %g]",
        distribution->shape, least_shape, greatest_shape, 1.0 / sqrt(greatest_shape), 1.0 / sqrt(least_shape));
    return PDMC_OK;
}

const pdmc_family pdmc_family_gamma = {
    .name = "gamma",
    .scaled = true,
    .shaped = true,
    .positive = true,
    .value = gamma_value,
    .tails = gamma_tails,
    .moments = gamma_moments,
    .by_moments = gamma_by_moments,
    .check = gamma_check,
};
