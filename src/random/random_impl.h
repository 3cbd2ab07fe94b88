// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/random.h"

/// The top 52 bits of a word as the midpoint of their cell, ((w >> 12) + 1/2) 2^-52, which is exact and inside (0, 1).
/// A 53-bit integer has no room for the half: (2^53 - 1) + 1/2 rounds to 2^53, and u to 1.
double pdmc_random_open_interval(uint64_t word);

typedef struct {
    uint64_t word[4];
} pdmc_random_block;

/// One block of the generator, with the key {seed, stream}. Those of pdmc_random_uniform() have the counters
/// {sample, variable, 0, 0}.
pdmc_random_block pdmc_random_words(uint64_t seed, pdmc_stream stream, const uint64_t counter[4]);
