// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Sixteen floats at a time, by AVX-512 (F and DQ): two blocks.

#include "particles/hash_avx2.h"

typedef float real;
typedef uint16_t lane_mask;
enum { BLOCKS = 2 };

typedef __m512 lanes;

static inline lanes lanes_of(double x)
{
    return _mm512_set1_ps((float)x);
}
static inline lanes load(const float *p)
{
    return _mm512_loadu_ps(p);
}
static inline lanes join(__m512d low, __m512d high)
{
    return _mm512_insertf32x8(_mm512_castps256_ps512(_mm512_cvtpd_ps(low)), _mm512_cvtpd_ps(high), 1);
}
static inline lanes load_double(const double *p)
{
    return join(_mm512_loadu_pd(p), _mm512_loadu_pd(p + 8));
}
static inline lanes add(lanes a, lanes b)
{
    return _mm512_add_ps(a, b);
}
static inline lanes subtract(lanes a, lanes b)
{
    return _mm512_sub_ps(a, b);
}
static inline lanes multiply(lanes a, lanes b)
{
    return _mm512_mul_ps(a, b);
}
static inline lanes divide(lanes a, lanes b)
{
    return _mm512_div_ps(a, b);
}
static inline lanes multiply_add(lanes a, lanes b, lanes c)
{
    return _mm512_fmadd_ps(a, b, c);
}
/// c - a b
static inline lanes subtract_product(lanes c, lanes a, lanes b)
{
    return _mm512_fnmadd_ps(a, b, c);
}
static inline lanes greatest(lanes a, lanes b)
{
    return _mm512_max_ps(a, b);
}
static inline lanes least(lanes a, lanes b)
{
    return _mm512_min_ps(a, b);
}
static inline lanes draw(const double table[], const pdmc_hash_key *key, uint32_t cell, uint32_t other, bool one)
{
    const __m256i low = pdmc_hashes(key, cell, other, one);
    const __m256i high = pdmc_hashes(key, cell + 8, one ? other : other + 8, one);
    return join(_mm512_i32gather_pd(low, table, sizeof *table), _mm512_i32gather_pd(high, table, sizeof *table));
}
static inline uint16_t less(lanes a, lanes b)
{
    return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ);
}

/// To 14 bits.
static inline lanes estimate_inverse_root(lanes a)
{
    return _mm512_rsqrt14_ps(a);
}
/// As for eight.
static inline lanes mending_series(lanes e)
{
    return subtract_product(lanes_of(0.5), lanes_of(3.0 / 8.0), e);
}

static inline lanes multiply_add_where(uint16_t mask, lanes a, lanes b, lanes c)
{
    return _mm512_mask3_fmadd_ps(a, b, c, mask);
}
static inline lanes greatest_where(uint16_t mask, lanes a, lanes b)
{
    return _mm512_mask_max_ps(a, mask, b, a);
}
static inline lanes least_where(uint16_t mask, lanes a, lanes b)
{
    return _mm512_mask_min_ps(a, mask, b, a);
}
static inline void store_where(uint16_t mask, float *p, lanes a)
{
    _mm512_mask_storeu_ps(p, mask, a);
}
/// p = factor a.
static inline void put_where(uint16_t mask, double *p, double factor, lanes a)
{
    const __m512d scale = _mm512_set1_pd(factor);
    const __m256 low = _mm512_castps512_ps256(a), high = _mm512_extractf32x8_ps(a, 1);
    _mm512_mask_storeu_pd(p, (uint8_t)mask, _mm512_mul_pd(scale, _mm512_cvtps_pd(low)));
    _mm512_mask_storeu_pd(p + 8, (uint8_t)(mask >> 8), _mm512_mul_pd(scale, _mm512_cvtps_pd(high)));
}
