// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Eight floats at a time, by AVX2 and FMA.

#include "particles/lanes_single.h"

static inline uint8_t less(lanes a, lanes b)
{
    return (uint8_t)_mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LT_OQ));
}

/// To 11 bits.
static inline lanes estimate_inverse_root(lanes a)
{
    return _mm256_rsqrt_ps(a);
}
/// (1 - (1 + e)^(-1/2)) / e for |e| < 2^-10: what is left out is 2^-41.
static inline lanes mending_series(lanes e)
{
    const lanes second = subtract_product(lanes_of(3.0 / 8.0), lanes_of(5.0 / 16.0), e);
    return subtract_product(lanes_of(0.5), second, e);
}

static inline __m256i mask_of(unsigned bits)
{
    const __m256i place = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
    return _mm256_cmpeq_epi32(_mm256_and_si256(_mm256_set1_epi32((int)bits), place), place);
}
static inline lanes choose(unsigned bits, lanes yes, lanes no)
{
    return _mm256_blendv_ps(no, yes, _mm256_castsi256_ps(mask_of(bits)));
}
static inline lanes multiply_add_where(uint8_t mask, lanes a, lanes b, lanes c)
{
    return choose(mask, multiply_add(a, b, c), c);
}
static inline lanes greatest_where(uint8_t mask, lanes a, lanes b)
{
    return choose(mask, _mm256_max_ps(b, a), a);
}
static inline lanes least_where(uint8_t mask, lanes a, lanes b)
{
    return choose(mask, _mm256_min_ps(b, a), a);
}
static inline void store_where(uint8_t mask, float *p, lanes a)
{
    _mm256_maskstore_ps(p, mask_of(mask), a);
}
static inline void to_doubles(lanes a, double at[])
{
    _mm256_storeu_pd(at, _mm256_cvtps_pd(_mm256_castps256_ps128(a)));
    _mm256_storeu_pd(at + 4, _mm256_cvtps_pd(_mm256_extractf128_ps(a, 1)));
}
/// p = factor a.
static inline void put_where(uint8_t mask, double *p, double factor, lanes a)
{
    double at[8];
    to_doubles(a, at);
    for (int k = 0; k < 8; k++)
        if (mask >> k & 1) p[k] = factor * at[k];
}
/// p += factor a.
static inline void add_where(uint8_t mask, double *p, double factor, lanes a)
{
    double at[8];
    to_doubles(a, at);
    for (int k = 0; k < 8; k++)
        if (mask >> k & 1) p[k] += factor * at[k];
}
static inline double sum_where(uint8_t mask, lanes a)
{
    double at[8], sum = 0.0;
    to_doubles(a, at);
    for (int k = 0; k < 8; k++)
        if (mask >> k & 1) sum += at[k];
    return sum;
}
