// SPDX-License-Identifier: GPL-3.0-or-later
#include "random/distribution_impl.h"

#include "base/base_impl.h"
#include "pdmc/random.h"

#include <math.h>

static const pdmc_family *const families[PDMC_DISTRIBUTIONS] = {
    [PDMC_NORMAL] = &pdmc_family_normal,       [PDMC_LOGNORMAL] = &pdmc_family_lognormal,
    [PDMC_WEIBULL] = &pdmc_family_weibull,     [PDMC_GUMBEL] = &pdmc_family_gumbel,
    [PDMC_GAMMA] = &pdmc_family_gamma,         [PDMC_BETA] = &pdmc_family_beta,
    [PDMC_UNIFORM] = &pdmc_family_uniform,     [PDMC_TRIANGULAR] = &pdmc_family_triangular,
    [PDMC_EMPIRICAL] = &pdmc_family_empirical,
};

const pdmc_family *pdmc_family_of(const pdmc_distribution *distribution)
{
    return families[distribution->kind];
}

static pdmc_status check_kind(pdmc_distribution_kind kind)
{
    PDMC_REQUIRE((int)kind >= 0 && kind < PDMC_DISTRIBUTIONS, "no such kind of distribution: %d", (int)kind);
    return PDMC_OK;
}

static bool without_spread(const pdmc_distribution *distribution)
{
    const pdmc_family *family = pdmc_family_of(distribution);
    return (family->scaled && distribution->scale == 0.0) ||
           (family->bounded && distribution->lower == distribution->upper);
}

static pdmc_status check_moments(const pdmc_family *family, double mean, double variation)
{
    PDMC_REQUIRE(family->by_moments, "a mean and a coefficient of variation do not make a %s distribution",
                 family->name);
    PDMC_REQUIRE(isfinite(mean) && isfinite(variation) && variation >= 0.0,
                 "a distribution with mean %g and coefficient of variation %g", mean, variation);
    PDMC_REQUIRE(mean > 0.0 || !family->positive, "the mean of a %s distribution is %g: it must be positive",
                 family->name, mean);
    PDMC_REQUIRE(mean != 0.0 || variation == 0.0, "a mean of 0 has no coefficient of variation but 0, not %g",
                 variation);
    return PDMC_OK;
}

pdmc_status pdmc_distribution_by_moments(pdmc_distribution_kind kind, double mean, double variation,
                                         pdmc_distribution *distribution)
{
    pdmc_status status = PDMC_OK;
    PDMC_TRY(check_kind(kind));
    const pdmc_family *family = families[kind];
    PDMC_TRY(check_moments(family, mean, variation));
    pdmc_distribution made = {.kind = kind, .least = -INFINITY, .most = INFINITY};
    if (family->shaped && variation == 0.0) {
        made.location = mean;
        made.shape = 1.0;
    } else {
        family->by_moments(mean, variation * fabs(mean), &made);
    }
    PDMC_TRY(pdmc_distribution_check(&made));
    *distribution = made;
done:
    return status;
}

static pdmc_status check_parameters(const pdmc_distribution *distribution)
{
    const pdmc_family *family = pdmc_family_of(distribution);
    const double scale = distribution->scale, shape = distribution->shape;
    PDMC_REQUIRE(isfinite(distribution->location) && isfinite(distribution->lower) && isfinite(distribution->upper),
                 "the parameters of a %s distribution must be finite", family->name);
    PDMC_REQUIRE(!family->scaled || (isfinite(scale) && scale >= 0.0),
                 "the scale of a %s distribution is %g: it must not be negative", family->name, scale);
    PDMC_REQUIRE(!family->shaped || (isfinite(shape) && shape > 0.0),
                 "the shape of a %s distribution is %g: it must be positive", family->name, shape);
    PDMC_REQUIRE(!family->bounded || distribution->lower <= distribution->upper,
                 "the lower end of a %s distribution is %g: it must not be above the upper, %g", family->name,
                 distribution->lower, distribution->upper);
    return family->check ? family->check(distribution) : PDMC_OK;
}

static pdmc_status check_cut(const pdmc_distribution *distribution)
{
    const double least = distribution->least, most = distribution->most;
    PDMC_REQUIRE(least < most, "a distribution is cut off below %g and above %g: it needs least < most", least, most);
    PDMC_REQUIRE(pdmc_cut_mass(distribution) > 0.0,
                 "a %s distribution has no probability between %g and %g, where it is cut off",
                 pdmc_family_of(distribution)->name, least, most);
    return PDMC_OK;
}

pdmc_status pdmc_distribution_check(const pdmc_distribution *distribution)
{
    pdmc_status status = PDMC_OK;
    PDMC_TRY(check_kind(distribution->kind));
    PDMC_TRY(check_parameters(distribution));
    PDMC_TRY(check_cut(distribution));
done:
    return status;
}

double pdmc_distribution_value(const pdmc_distribution *distribution, double z)
{
    const pdmc_family *family = pdmc_family_of(distribution);
    if (!pdmc_distribution_is_cut(distribution)) return family->value(distribution, z);
    const double x = family->value(distribution, pdmc_cut_score(distribution, z));
    return fmin(fmax(x, distribution->least), distribution->most);
}

pdmc_tails pdmc_distribution_uncut_tails(const pdmc_distribution *distribution, double x)
{
    const pdmc_family *family = pdmc_family_of(distribution);
    const pdmc_tails below = {0.0, 1.0}, above = {1.0, 0.0};
    if (without_spread(distribution)) return x < family->value(distribution, 0.0) ? below : above;
    if (x == -INFINITY || (family->bounded && x <= distribution->lower)) return below;
    if (x == INFINITY || (family->bounded && x >= distribution->upper)) return above;
    return family->tails(distribution, x);
}

static pdmc_tails tails(const pdmc_distribution *distribution, double x)
{
    const pdmc_tails uncut = pdmc_distribution_uncut_tails(distribution, x);
    return pdmc_distribution_is_cut(distribution) ? pdmc_cut_tails(distribution, uncut) : uncut;
}

double pdmc_distribution_lower_tail(const pdmc_distribution *distribution, double x)
{
    return tails(distribution, x).lower;
}

double pdmc_distribution_upper_tail(const pdmc_distribution *distribution, double x)
{
    return tails(distribution, x).upper;
}

void pdmc_distribution_moments(const pdmc_distribution *distribution, double *mean, double *deviation)
{
    if (pdmc_distribution_is_cut(distribution)) pdmc_distribution_moments_by_quadrature(distribution, mean, deviation);
    else pdmc_family_of(distribution)->moments(distribution, mean, deviation);
}

double pdmc_unit_mean_quantile(pdmc_distribution_kind kind, double variation, double u)
{
    pdmc_distribution distribution;
    if (pdmc_distribution_by_moments(kind, 1.0, variation, &distribution) != PDMC_OK) return NAN;
    return pdmc_distribution_value(&distribution, pdmc_normal_quantile(u));
}
