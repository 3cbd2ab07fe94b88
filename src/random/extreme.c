// SPDX-License-Identifier: GPL-3.0-or-later
#include "random/distribution_impl.h"

#include <gsl/gsl_math.h>
#include <gsl/gsl_sf_gamma.h>
#include <gsl/gsl_sf_psi.h>
#include <math.h>

static double weibull_value(const pdmc_distribution *distribution, double z)
{
    return distribution->location + distribution->scale * pow(-pdmc_normal_log_upper(z), 1.0 / distribution->shape);
}

static pdmc_tails weibull_tails(const pdmc_distribution *distribution, double x)
{
    const double hazard = pow(fmax(0.0, (x - distribution->location) / distribution->scale), distribution->shape);
    return (pdmc_tails){-expm1(-hazard), exp(-hazard)};
}

/// log(1 + variation^2) of the two-parameter distribution with shape 1 / r, log Gamma(1 + 2 r) - 2 log Gamma(1 + r).
static double weibull_log_spread(double r)
{
    return gsl_sf_lnpoch(1.0, 2.0 * r) - 2.0 * gsl_sf_lnpoch(1.0, r);
}

static void weibull_moments(const pdmc_distribution *distribution, double *mean, double *deviation)
{
    const double r = 1.0 / distribution->shape;
    const double above = distribution->scale * exp(gsl_sf_lnpoch(1.0, r));
    *mean = distribution->location + above;
    *deviation = above * sqrt(expm1(weibull_log_spread(r)));
}

/// The r with that spread. Its function is convex and rises, and lies above the spread at sqrt(spread) + spread: from
/// there Newton's method descends to it, until rounding lets it descend no more.
static double weibull_inverse_shape(double spread)
{
    double r = sqrt(spread) + spread;
    for (;;) {
        const double slope = 2.0 * (gsl_sf_psi(1.0 + 2.0 * r) - gsl_sf_psi(1.0 + r));
        const double next = r - (weibull_log_spread(r) - spread) / slope;
        if (!(next < r)) return r;
        r = next;
    }
}

static void weibull_by_moments(double mean, double deviation, pdmc_distribution *distribution)
{
    const double r = weibull_inverse_shape(log1p(gsl_pow_2(deviation / mean)));
    distribution->scale = mean / exp(gsl_sf_lnpoch(1.0, r));
    distribution->shape = 1.0 / r;
}

const pdmc_family pdmc_family_weibull = {
    .name = "Weibull",
    .scaled = true,
    .shaped = true,
    .positive = true,
    .value = weibull_value,
    .tails = weibull_tails,
    .moments = weibull_moments,
    .by_moments = weibull_by_moments,
};

static double gumbel_value(const pdmc_distribution *distribution, double z)
{
    return distribution->location - distribution->scale * log(-pdmc_normal_log_upper(-z));
}

static pdmc_tails gumbel_tails(const pdmc_distribution *distribution, double x)
{
    const double t = exp(-(x - distribution->location) / distribution->scale);
    return (pdmc_tails){exp(-t), -expm1(-t)};
}

static double gumbel_deviation(double scale)
{
    return scale * M_PI / sqrt(6.0);
}

static void gumbel_moments(const pdmc_distribution *distribution, double *mean, double *deviation)
{
    *mean = distribution->location + M_EULER * distribution->scale;
    *deviation = gumbel_deviation(distribution->scale);
}

static void gumbel_by_moments(double mean, double deviation, pdmc_distribution *distribution)
{
    distribution->scale = deviation / gumbel_deviation(1.0);
    distribution->location = mean - M_EULER * distribution->scale;
}

const pdmc_family pdmc_family_gumbel = {
    .name = "Gumbel",
    .scaled = true,
    .value = gumbel_value,
    .tails = gumbel_tails,
    .moments = gumbel_moments,
    .by_moments = gumbel_by_moments,
};
