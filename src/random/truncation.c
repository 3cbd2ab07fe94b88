// SPDX-License-Identifier: GPL-3.0-or-later
#include "random/distribution_impl.h"

#include <gsl/gsl_math.h>
#include <math.h>

bool pdmc_distribution_is_cut(const pdmc_distribution *distribution)
{
    return isfinite(distribution->least) || isfinite(distribution->most);
}

/// P(a < X <= b), by the tails that are the smaller.
static double between(pdmc_tails a, pdmc_tails b)
{
    return b.lower < a.upper ? b.lower - a.lower : a.upper - b.upper;
}

double pdmc_cut_mass(const pdmc_distribution *distribution)
{
    return between(pdmc_distribution_uncut_tails(distribution, distribution->least),
                   pdmc_distribution_uncut_tails(distribution, distribution->most));
}

double pdmc_cut_score(const pdmc_distribution *distribution, double z)
{
    const pdmc_tails least = pdmc_distribution_uncut_tails(distribution, distribution->least);
    const pdmc_tails most = pdmc_distribution_uncut_tails(distribution, distribution->most);
    const pdmc_tails u = pdmc_normal_tails(z);
    // F(least) + u (F(most) - F(least)) without a difference
    return pdmc_normal_score(
        (pdmc_tails){u.upper * least.lower + u.lower * most.lower, u.upper * least.upper + u.lower * most.upper});
}

static double within_unit(double probability)
{
    return GSL_MIN(1.0, GSL_MAX(0.0, probability));
}

pdmc_tails pdmc_cut_tails(const pdmc_distribution *distribution, pdmc_tails uncut)
{
    const pdmc_tails least = pdmc_distribution_uncut_tails(distribution, distribution->least);
    const pdmc_tails most = pdmc_distribution_uncut_tails(distribution, distribution->most);
    const double mass = between(least, most);
    return (pdmc_tails){within_unit(between(least, uncut) / mass), within_unit(between(uncut, most) / mass)};
}
