// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdint.h>

/// The top 52 bits of a word as the midpoint of their cell, ((w >> 12) + 1/2) 2^-52, which is exact and inside (0, 1).
/// A 53-bit integer has no room for the half: (2^53 - 1) + 1/2 rounds to 2^53, and u to 1.
double pdmc_random_open_interval(uint64_t word);
