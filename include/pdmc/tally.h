// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Statistics of samples that are too many to keep, of several quantities side by side.
///
/// A tally counts the values of each quantity in bins made of the leading bits of a double, sign, exponent and 11 bits
/// of the fraction: every double has its bin, the bins are in the order of the numbers, and one is narrower than 2^-11
/// of the numbers in it. It sums the first four powers of z = (x - shift) / unit, and counts the values above given
/// thresholds. Sums are carried without rounding from block to block, so that a result depends on how the samples are
/// divided into blocks, but not on the order of blocks, nor on which tally of several that are merged took which block:
/// each thread has a tally of its own, and the bits are the same for any number of threads.
///
/// A tally takes about 35 kB for each quantity, and 8 kB for each power of two in which one has values.

#include "pdmc/statistics.h"

typedef struct pdmc_tally pdmc_tally;

/// An empty tally. Shift and unit of each quantity are mean and deviation of some pilot samples, which are not counted:
/// usually the first block, which is added later like the others. They only keep the powers in range: the mean of the
/// samples should be within some 10^4 deviations of the pilots'. Tallies to be merged need the same pilots.
/// @param[in]  quantities  >= 1
/// @param[in]  pilots      number of pilot samples, >= 1
/// @param[in]  pilot       [quantities, pilots] finite
/// @param[in]  thresholds  number of thresholds of each quantity, may be 0
/// @param[in]  threshold   [quantities, thresholds], or NULL where there are none
/// @param[out] tally       to be freed by pdmc_tally_destroy(); written only on success
/// @return PDMC_OK, PDMC_ERR_ARG or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_tally_create(size_t quantities, size_t pilots, const double pilot[],
                                                      size_t thresholds, const double threshold[], pdmc_tally **tally);

/// Frees a tally and sets it to NULL; NULL is allowed.
PDMC_API void pdmc_tally_destroy(pdmc_tally **tally);

/// Adds a block of samples. After an error the tally holds a part of the block and is of no use.
/// @param[in] count   number of samples
/// @param[in] stride  from one quantity's values to the next's, >= count
/// @param[in] value   [quantities, stride], of which the first `count` of each quantity are taken
/// @return PDMC_OK, PDMC_ERR_DATA (a value is not finite, or z^4 is not), PDMC_ERR_ARG (2^32 samples or more in all) or
/// PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_tally_add(pdmc_tally *tally, size_t count, size_t stride,
                                                   const double value[]);

/// Adds the samples of one tally to another, as if it had taken them. After PDMC_ERR_NOMEM `into` is of no use.
/// @return PDMC_OK, PDMC_ERR_ARG (other quantities, pilots or thresholds; 2^32 samples or more in all) or
/// PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_tally_merge(pdmc_tally *into, const pdmc_tally *from);

/// The number of samples.
PDMC_API size_t pdmc_tally_samples(const pdmc_tally *tally);

/// Mean and standard deviation, as pdmc_statistics_moments() with the deviation's interval in its limit for many
/// samples, log s^2 +- t sqrt((kurtosis - 1) / n): what is left out is of the order of 1 / n. A deviation below some
/// 1e-8 of the distance of the mean from the pilots' is lost in rounding.
/// @param[in] quantity  its index
PDMC_API void pdmc_tally_moments(const pdmc_tally *tally, size_t quantity, double confidence, pdmc_estimate *mean,
                                 pdmc_estimate *deviation);

/// The quantile at p, as pdmc_statistics_quantile(): the value is the middle of the bin of the order statistic, off by
/// at most 2^-12 of itself, and the interval is widened to the outer edges of the bins of its two. Magnitudes below
/// DBL_MIN are 0. Without samples all is NaN.
PDMC_API pdmc_estimate pdmc_tally_quantile(const pdmc_tally *tally, size_t quantity, double p, double confidence);

/// A histogram, as pdmc_statistics_histogram() from the tally's own quantiles; but each edge is moved to the nearest
/// edge of a bin of the tally, so that the counts are exact, and no bin is narrower than one of those. Where x < 0, bin
/// b holds edges[b] < x <= edges[b + 1].
/// @param[in]  bins    number of bins, >= 1
/// @param[out] edges   [bins + 1] ascending
/// @param[out] counts  [bins + 2] underflow, the bins, overflow
/// @param[out] density [bins] per unit of x, count / (n width) with the width of the bin itself; NaN without samples
PDMC_API void pdmc_tally_histogram(const pdmc_tally *tally, size_t quantity, int bins, double confidence,
                                   double edges[], int64_t counts[], pdmc_estimate density[]);

/// The probability that a quantity is above a threshold, from exact counts, as pdmc_statistics_proportion().
/// @param[in] threshold  its index
PDMC_API pdmc_estimate pdmc_tally_exceedance(const pdmc_tally *tally, size_t quantity, size_t threshold,
                                             double confidence);
