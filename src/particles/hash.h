// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Which of PDMC_STRENGTH_CLASSES equally likely classes a bond belongs to, from the cells of its nodes and a key: the
/// multiplications and xorshifts of C. Wellons' "hash prospector" (https://nullprogram.com/blog/2018/07/31/; these constants have
/// the least bias that it found), one of them with the lower cell, two with the higher one. The key is a Philox number.

#include "pdmc/particles.h"

#define PDMC_HASH_FIRST 0x21f0aaadU
#define PDMC_HASH_SECOND 0x735a2d97U

enum { PDMC_HASH_SHIFT = 22 }; // 2^32 over PDMC_STRENGTH_CLASSES

_Static_assert(PDMC_STRENGTH_CLASSES == 1 << (32 - PDMC_HASH_SHIFT), "classes of another number");

typedef struct {
    uint32_t first, second;
} pdmc_hash_key;

static inline uint32_t pdmc_hash(uint32_t low, uint32_t high, const pdmc_hash_key *key)
{
    uint32_t h = low ^ key->first;
    h = (h ^ h >> 16) * PDMC_HASH_FIRST;
    h ^= h >> 15 ^ high ^ key->second;
    h = (h ^ h >> 16) * PDMC_HASH_FIRST;
    h = (h ^ h >> 15) * PDMC_HASH_SECOND;
    return (h ^ h >> 15) >> PDMC_HASH_SHIFT;
}
