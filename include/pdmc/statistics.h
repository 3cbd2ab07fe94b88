// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Statistics of a sample, each with its interval of confidence. Sums are taken in the order of the samples, so that a
/// result does not depend on threads.

#include "pdmc/base.h"

typedef struct {
    double value, lower, upper;
} pdmc_estimate;

/// Mean and standard deviation (with n - 1), each with its interval.
///
/// The mean's interval is Student's, value +- t s / sqrt(n), exact for a normal sample. The standard deviation's does
/// not assume a normal sample: the jackknife of log s^2 with Student's t (Miller 1968), whose bounds are positive. Both
/// cover too seldom where a small sample is skewed; src/statistics/README.md has figures. A sample without spread has
/// intervals of no width. Bounds that do not exist are NaN: of the mean with n < 2, of the deviation with n < 3; so
/// are the deviation with n < 2 and the mean with n = 0.
/// @param[in]  n           number of samples
/// @param[in]  x           [n] samples, finite
/// @param[in]  confidence  in (0, 1), e.g. 0.95
/// @param[out] mean, deviation
PDMC_API void pdmc_statistics_moments(size_t n, const double x[], double confidence, pdmc_estimate *mean,
                                      pdmc_estimate *deviation);

/// The quantile at p, as the order statistic x_(k), k = ceil(n p), with the distribution-free interval: the tightest
/// pair of order statistics that misses on each side with probability <= (1 - confidence) / 2, from the binomial
/// distribution (David & Nagaraja, Order Statistics, section 7.1). A bound that no order statistic reaches is -inf or
/// +inf.
/// @param[in] n       number of samples, >= 1
/// @param[in] sorted  [n] ascending
/// @param[in] p       in [0, 1]
PDMC_API pdmc_estimate pdmc_statistics_quantile(size_t n, const double sorted[], double p, double confidence);

/// The probability of an event seen `hits` times in `n` trials: hits / n with the Clopper-Pearson interval, which is
/// [0, upper] where nothing was seen and [lower, 1] where everything was. Both sides are at (1 - confidence) / 2 there
/// too: after 0 of n, upper = 1 - ((1 - confidence) / 2)^(1/n), at 95 % about 3.7 / n and not the one-sided 3 / n.
/// Without trials the value is NaN in [0, 1].
/// @param[in] hits  <= n
PDMC_API pdmc_estimate pdmc_statistics_proportion(size_t hits, size_t n, double confidence);

/// A histogram of equal bins from the 0.1 % to the 99.9 % quantile q, wider by a half-bin on each side: their width is
/// (q_99.9 - q_0.1) / (bins - 1), and twice that distance for a single bin.
///
/// A sample without spread, that is with bins below 1e-12 of its value, gets bins of 1e-3 of its value about it (of 1
/// where the value is 0). Bin b holds edges[b] <= x < edges[b + 1]; every sample is in one count. density[b] = count /
/// (n width), with the Clopper-Pearson interval of count of n divided by the width.
/// @param[in]  n       number of samples, >= 1
/// @param[in]  sorted  [n] ascending, finite
/// @param[in]  bins    number of bins, >= 1
/// @param[out] edges   [bins + 1] ascending
/// @param[out] counts  [bins + 2] underflow, the bins, overflow
/// @param[out] density [bins] per unit of x
PDMC_API void pdmc_statistics_histogram(size_t n, const double sorted[], int bins, double confidence, double edges[],
                                        int64_t counts[], pdmc_estimate density[]);
