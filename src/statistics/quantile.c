// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/quantile.h"

#include "pdmc/statistics.h"

#include <float.h>
#include <gsl/gsl_cdf.h>
#include <math.h>

/// k = ceil(n p) in [1, n], where n p may be an integer but for its rounding.
static size_t rank_of(size_t n, double p)
{
    const double rank = ceil((double)n * p * (1.0 - 2.0 * DBL_EPSILON));
    return rank < 1.0 ? 1 : rank > (double)n ? n : (size_t)rank;
}

/// The distribution function of the order statistic U_(k) of n uniforms, Beta(k, n - k + 1): the probability of missing
/// the quantile at p with x_(k) as an upper bound; the complement, as a lower bound. U_(0) = 0 and U_(n+1) = 1.
static double chance_below(size_t n, size_t k, double p)
{
    if (k == 0) return 1.0;
    return k > n ? 0.0 : gsl_cdf_beta_P(p, (double)k, (double)(n - k) + 1.0);
}

static double chance_above(size_t n, size_t k, double p)
{
    if (k == 0) return 0.0;
    return k > n ? 1.0 : gsl_cdf_beta_Q(p, (double)k, (double)(n - k) + 1.0);
}

typedef double chance_fn(size_t n, size_t k, double p);

/// The rank nearest to `near` that misses with chance <= tail, between `near`, which does not, and `far`, which does.
/// From 10^7 samples on GSL's beta functions are NaN where they are about 1/2; the negated comparison takes that for
/// more than tail.
static size_t outermost(size_t n, double p, double tail, chance_fn *chance, size_t near, size_t far)
{
    while (near + 1 != far && far + 1 != near) {
        const size_t middle = near < far ? near + (far - near) / 2 : far + (near - far) / 2;
        if (!(chance(n, middle, p) <= tail)) {
            near = middle;
        } else {
            far = middle;
        }
    }
    return far;
}

pdmc_quantile_ranks pdmc_statistics_quantile_ranks(size_t n, double p, double confidence)
{
    const double tail = 0.5 * (1.0 - confidence);
    const size_t k = rank_of(n, p);
    return (pdmc_quantile_ranks){.value = k,
                                 .lower = outermost(n, p, tail, chance_above, k + 1, 0),
                                 .upper = outermost(n, p, tail, chance_below, k - 1, n + 1)};
}

pdmc_estimate pdmc_statistics_quantile(size_t n, const double sorted[], double p, double confidence)
{
    const pdmc_quantile_ranks rank = pdmc_statistics_quantile_ranks(n, p, confidence);
    return (pdmc_estimate){.value = sorted[rank.value - 1],
                           .lower = rank.lower > 0 ? sorted[rank.lower - 1] : -INFINITY,
                           .upper = rank.upper <= n ? sorted[rank.upper - 1] : INFINITY};
}
