// SPDX-License-Identifier: GPL-3.0-or-later
#include "random/distribution_impl.h"

#include "base/base_impl.h"

#include <math.h>

/// Its ends and mode; mirrored, x goes to -x and the tails change places.
typedef struct {
    double lower, mode, upper;
} triangle;

static triangle triangle_of(const pdmc_distribution *distribution)
{
    return (triangle){distribution->lower, distribution->mode, distribution->upper};
}

static triangle mirrored(triangle t)
{
    return (triangle){-t.upper, -t.mode, -t.lower};
}

static double lower_tail(triangle t, double x)
{
    const double width = t.upper - t.lower;
    if (x < t.mode) return (x - t.lower) / width * ((x - t.lower) / (t.mode - t.lower));
    if (x == t.mode) return (t.mode - t.lower) / width;
    return ((t.mode - t.lower) + (x - t.mode) * ((t.upper - x) + (t.upper - t.mode)) / (t.upper - t.mode)) / width;
}

/// The quantile from its lower tail, without a difference of numbers that are nearly equal where that tail is small.
static double lower_quantile(triangle t, pdmc_tails tails)
{
    const double width = t.upper - t.lower, below = t.mode - t.lower, above = t.upper - t.mode;
    if (width * tails.lower <= below) return t.lower + sqrt(width * tails.lower * below);
    return t.mode + (width * tails.lower - below) / (1.0 + sqrt(width * tails.upper / above));
}

static double triangular_value(const pdmc_distribution *distribution, double z)
{
    const triangle t = triangle_of(distribution);
    return z < 0.0 ? lower_quantile(t, pdmc_normal_tails(z)) : -lower_quantile(mirrored(t), pdmc_normal_tails(-z));
}

static pdmc_tails triangular_tails(const pdmc_distribution *distribution, double x)
{
    const triangle t = triangle_of(distribution);
    return (pdmc_tails){lower_tail(t, x), lower_tail(mirrored(t), -x)};
}

static void triangular_moments(const pdmc_distribution *distribution, double *mean, double *deviation)
{
    const double below = distribution->mode - distribution->lower, above = distribution->upper - distribution->mode;
    *mean = distribution->mode + (above - below) / 3.0;
    *deviation = sqrt((below * below + below * above + above * above) / 18.0);
}

static pdmc_status triangular_check(const pdmc_distribution *distribution)
{
    PDMC_REQUIRE(distribution->lower <= distribution->mode && distribution->mode <= distribution->upper,
                 "the mode of a triangular distribution is %g: it must be in [%g, %g]", distribution->mode,
                 distribution->lower, distribution->upper);
    return PDMC_OK;
}

static int triangular_kinks(const pdmc_distribution *distribution)
{
    (void)distribution;
    return 1;
}

static pdmc_tails triangular_kink(const pdmc_distribution *distribution, int index)
{
    (void)index;
    return triangular_tails(distribution, distribution->mode);
}

const pdmc_family pdmc_family_triangular = {
    .name = "triangular",
    .bounded = true,
    .value = triangular_value,
    .tails = triangular_tails,
    .moments = triangular_moments,
    .check = triangular_check,
    .kinks = triangular_kinks,
    .kink = triangular_kink,
};
