// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stddef.h>

/// Which order statistics are a quantile and its bounds, see pdmc_statistics_quantile().
typedef struct {
    size_t value; // in [1, n]
    size_t lower; // 0 where there is none
    size_t upper; // n + 1 where there is none
} pdmc_quantile_ranks;

pdmc_quantile_ranks pdmc_statistics_quantile_ranks(size_t n, double p, double confidence);
