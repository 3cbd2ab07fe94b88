// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/random.h"

/// Independent standard normal numbers, by pdmc_random_uniform() and the quantile.
/// @param[out] z  [count]
void pdmc_random_normal(uint64_t seed, pdmc_stream stream, uint64_t sample, uint64_t first, int count, double z[]);
