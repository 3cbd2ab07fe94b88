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
/// The mean's interval is Student's, value +- t s / sqrt(n). The standard deviation's is the asymptotic one that does
/// not assume a normal sample, from the fourth central moment m_4: var(s^2) = (m_4 - s^4) / n, delta method on
/// log s^2, so that the bounds are positive. With n < 2 the deviation and all bounds are NaN.
/// @param[in]  n           number of samples
/// @param[in]  x           [n] samples, in their order
/// @param[in]  confidence  in (0, 1), e.g. 0.95
/// @param[out] mean, deviation
PDMC_API void pdmc_statistics_moments(size_t n, const double x[], double confidence, pdmc_estimate *mean,
                                      pdmc_estimate *deviation);

/// The quantile at p, as the order statistic x_(k), k = ceil(n p), with the distribution-free interval: the
/// tightest pair of order statistics around it with binomial coverage >= confidence, each side at (1 - confidence) / 2
/// (David & Nagaraja, Order Statistics, section 7.1). A bound that no order statistic reaches is -inf or +inf.
/// @param[in] sorted  [n] ascending, n >= 1
PDMC_API pdmc_estimate pdmc_statistics_quantile(size_t n, const double sorted[], double p, double confidence);

/// The probability of an event seen `hits` times in `n` trials: hits / n with the Clopper-Pearson interval, which is
/// [0, upper] where nothing was seen and [lower, 1] where everything was.
PDMC_API pdmc_estimate pdmc_statistics_proportion(size_t hits, size_t n, double confidence);

/// A histogram of equal bins from the 0.1 % to the 99.9 % quantile, wider by a half-bin on each side.
///
/// A sample without spread gets bins of a width relative to its value. density[b] = count / (n width), with the
/// Clopper-Pearson interval of the count divided by the width.
/// @param[in]  n       number of samples, >= 1
/// @param[in]  sorted  [n] ascending
/// @param[in]  bins    number of bins, >= 1
/// @param[out] edges   [bins + 1]
/// @param[out] counts  [bins + 2] underflow, the bins, overflow
/// @param[out] density [bins] per unit of x
PDMC_API void pdmc_statistics_histogram(size_t n, const double sorted[], int bins, double confidence, double edges[],
                                        int64_t counts[], pdmc_estimate density[]);
