// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Eight hashes at a time, by AVX2.

#include "particles/hash.h"

#include <immintrin.h>

static inline __m256i pdmc_mix(__m256i h, int shift, uint32_t factor)
{
    const __m256i mixed = _mm256_xor_si256(h, _mm256_srli_epi32(h, shift));
    return _mm256_mullo_epi32(mixed, _mm256_set1_epi32((int)factor));
}

/// Of the pairs cell, cell + 1, ... with other, other + 1, ..., or with one other.
static inline __m256i pdmc_hashes(const pdmc_hash_key *key, uint32_t cell, uint32_t other, bool one)
{
    const __m256i row = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    const __m256i i = _mm256_add_epi32(_mm256_set1_epi32((int)cell), row);
    const __m256i j = _mm256_add_epi32(_mm256_set1_epi32((int)other), one ? _mm256_setzero_si256() : row);
    const __m256i high = _mm256_xor_si256(_mm256_max_epu32(i, j), _mm256_set1_epi32((int)key->second));
    __m256i h = _mm256_xor_si256(_mm256_min_epu32(i, j), _mm256_set1_epi32((int)key->first));
    h = pdmc_mix(h, 16, PDMC_HASH_FIRST);
    h = _mm256_xor_si256(_mm256_xor_si256(h, _mm256_srli_epi32(h, 15)), high);
    h = pdmc_mix(h, 16, PDMC_HASH_FIRST);
    h = pdmc_mix(h, 15, PDMC_HASH_SECOND);
    return _mm256_srli_epi32(_mm256_xor_si256(h, _mm256_srli_epi32(h, 15)), PDMC_HASH_SHIFT);
}
