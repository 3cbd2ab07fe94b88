// SPDX-License-Identifier: GPL-3.0-or-later
#include "random/distribution_impl.h"

#include <gsl/gsl_math.h>
#include <math.h>

static double uniform_value(const pdmc_distribution *distribution, double z)
{
    const pdmc_tails tails = pdmc_normal_tails(z);
    const double width = distribution->upper - distribution->lower;
    return z < 0.0 ? distribution->lower + width * tails.lower : distribution->upper - width * tails.upper;
}

static pdmc_tails uniform_tails(const pdmc_distribution *distribution, double x)
{
    const double width = distribution->upper - distribution->lower;
    return (pdmc_tails){(x - distribution->lower) / width, (distribution->upper - x) / width};
}

static void uniform_moments(const pdmc_distribution *distribution, double *mean, double *deviation)
{
    *mean = 0.5 * (distribution->lower + distribution->upper);
    *deviation = (distribution->upper - distribution->lower) / (2.0 * M_SQRT3);
}

static void uniform_by_moments(double mean, double deviation, pdmc_distribution *distribution)
{
    distribution->lower = mean - M_SQRT3 * deviation;
    distribution->upper = mean + M_SQRT3 * deviation;
}

const pdmc_family pdmc_family_uniform = {
    .name = "uniform",
    .bounded = true,
    .value = uniform_value,
    .tails = uniform_tails,
    .moments = uniform_moments,
    .by_moments = uniform_by_moments,
};
