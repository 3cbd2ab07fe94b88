// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/statistics.h"

/// The edges that pdmc_statistics_histogram() has for a 0.1 % and a 99.9 % quantile.
/// @param[out] edges  [bins + 1]
void pdmc_statistics_histogram_edges(double low, double high, int bins, double edges[]);

/// The density of a bin that holds `count` of n samples, with its interval.
pdmc_estimate pdmc_statistics_bin_density(int64_t count, size_t n, double width, double confidence);
