// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/random.h"

#include <gsl/gsl_cdf.h>
#include <math.h>

double pdmc_normal_quantile(double u)
{
    // 1 - u is exact in the upper half, so both tails are resolved alike and the quantile is odd about 1/2.
    return u > 0.5 ? gsl_cdf_ugaussian_Qinv(1.0 - u) : gsl_cdf_ugaussian_Pinv(u);
}

static double lognormal_quantile(double variation, double z)
{
    const double variance = log1p(variation * variation);
    return exp(sqrt(variance) * z - 0.5 * variance);
}

double pdmc_unit_mean_quantile(pdmc_distribution_kind kind, double variation, double u)
{
    const double z = pdmc_normal_quantile(u);
    switch (kind) {
    case PDMC_NORMAL: return 1.0 + variation * z;
    case PDMC_LOGNORMAL: return lognormal_quantile(variation, z);
    }
    return NAN;
}
