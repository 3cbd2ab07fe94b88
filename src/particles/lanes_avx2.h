// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Eight doubles at a time, by AVX2 and FMA.

#include "particles/hash_avx2.h"

typedef double real;
typedef uint8_t lane_mask;
enum { BLOCKS = 1 };

typedef struct {
    __m256d low, high;
} lanes;

static inline lanes lanes_of(double x)
{
    return (lanes){_mm256_set1_pd(x), _mm256_set1_pd(x)};
}
static inline lanes load(const double *p)
{
    return (lanes){_mm256_loadu_pd(p), _mm256_loadu_pd(p + 4)};
}
static inline lanes load_double(const double *p)
{
    return load(p);
}
static inline lanes add(lanes a, lanes b)
{
    return (lanes){_mm256_add_pd(a.low, b.low), _mm256_add_pd(a.high, b.high)};
}
static inline lanes subtract(lanes a, lanes b)
{
    return (lanes){_mm256_sub_pd(a.low, b.low), _mm256_sub_pd(a.high, b.high)};
}
static inline lanes multiply(lanes a, lanes b)
{
    return (lanes){_mm256_mul_pd(a.low, b.low), _mm256_mul_pd(a.high, b.high)};
}
static inline lanes divide(lanes a, lanes b)
{
    return (lanes){_mm256_div_pd(a.low, b.low), _mm256_div_pd(a.high, b.high)};
}
static inline lanes multiply_add(lanes a, lanes b, lanes c)
{
    return (lanes){_mm256_fmadd_pd(a.low, b.low, c.low), _mm256_fmadd_pd(a.high, b.high, c.high)};
}
/// c - a b
static inline lanes subtract_product(lanes c, lanes a, lanes b)
{
    return (lanes){_mm256_fnmadd_pd(a.low, b.low, c.low), _mm256_fnmadd_pd(a.high, b.high, c.high)};
}

static inline lanes greatest(lanes a, lanes b)
{
    return (lanes){_mm256_max_pd(a.low, b.low), _mm256_max_pd(a.high, b.high)};
}
static inline lanes least(lanes a, lanes b)
{
    return (lanes){_mm256_min_pd(a.low, b.low), _mm256_min_pd(a.high, b.high)};
}
static inline lanes draw(const double table[], const pdmc_hash_key *key, uint32_t cell, uint32_t other, bool one)
{
    const __m256i at = pdmc_hashes(key, cell, other, one);
    return (lanes){_mm256_i32gather_pd(table, _mm256_castsi256_si128(at), sizeof *table),
                   _mm256_i32gather_pd(table, _mm256_extracti128_si256(at, 1), sizeof *table)};
}
static inline uint8_t less(lanes a, lanes b)
{
    const int low = _mm256_movemask_pd(_mm256_cmp_pd(a.low, b.low, _CMP_LT_OQ));
    const int high = _mm256_movemask_pd(_mm256_cmp_pd(a.high, b.high, _CMP_LT_OQ));
    return (uint8_t)(low | high << 4);
}

static inline __m256d estimate_inverse_root(__m256d a)
{
    return _mm256_cvtps_pd(_mm_rsqrt_ps(_mm256_cvtpd_ps(a)));
}

/// 1 / sqrt(a) from an estimate of 11 bits, y: with e = 1 - a y^2, y (1 - e)^(-1/2) to the fifth order, which leaves 2^-54.
static inline lanes inverse_root(lanes a)
{
    const lanes y = {estimate_inverse_root(a.low), estimate_inverse_root(a.high)};
    const lanes ay = multiply(a, y), one = lanes_of(1.0);
    const lanes e = {_mm256_fnmadd_pd(ay.low, y.low, one.low), _mm256_fnmadd_pd(ay.high, y.high, one.high)};
    lanes series = multiply_add(lanes_of(35.0 / 128.0), e, lanes_of(5.0 / 16.0));
    series = multiply_add(multiply_add(series, e, lanes_of(3.0 / 8.0)), e, lanes_of(0.5));
    return multiply_add(multiply(y, e), series, y);
}

static inline __m256i mask_of(unsigned bits)
{
    const __m256i place = _mm256_setr_epi64x(1, 2, 4, 8);
    return _mm256_cmpeq_epi64(_mm256_and_si256(_mm256_set1_epi64x(bits), place), place);
}
static inline __m256d choose(unsigned bits, __m256d yes, __m256d no)
{
    return _mm256_blendv_pd(no, yes, _mm256_castsi256_pd(mask_of(bits)));
}
static inline lanes choose_lanes(uint8_t mask, lanes yes, lanes no)
{
    return (lanes){choose(mask, yes.low, no.low), choose(mask >> 4, yes.high, no.high)};
}

static inline lanes multiply_add_where(uint8_t mask, lanes a, lanes b, lanes c)
{
    return choose_lanes(mask, multiply_add(a, b, c), c);
}
static inline lanes greatest_where(uint8_t mask, lanes a, lanes b)
{
    const lanes greater = {_mm256_max_pd(b.low, a.low), _mm256_max_pd(b.high, a.high)};
    return choose_lanes(mask, greater, a);
}
static inline lanes least_where(uint8_t mask, lanes a, lanes b)
{
    const lanes lesser = {_mm256_min_pd(b.low, a.low), _mm256_min_pd(b.high, a.high)};
    return choose_lanes(mask, lesser, a);
}
static inline void store_where(uint8_t mask, double *p, lanes a)
{
    _mm256_maskstore_pd(p, mask_of(mask), a.low);
    _mm256_maskstore_pd(p + 4, mask_of(mask >> 4), a.high);
}
/// p = factor a.
static inline void put_where(uint8_t mask, double *p, double factor, lanes a)
{
    store_where(mask, p, multiply(lanes_of(factor), a));
}
/// p += factor a.
static inline void add_where(uint8_t mask, double *p, double factor, lanes a)
{
    store_where(mask, p, multiply_add(lanes_of(factor), a, load(p)));
}
static inline double sum_where(uint8_t mask, lanes a)
{
    double at[8], sum = 0.0;
    _mm256_storeu_pd(at, a.low);
    _mm256_storeu_pd(at + 4, a.high);
    for (int k = 0; k < 8; k++)
        if (mask >> k & 1) sum += at[k];
    return sum;
}
