// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Eight floats at a time: what AVX2 and AVX-512 have in common.

#include "particles/hash_avx2.h"

typedef float real;
typedef uint8_t lane_mask;
enum { BLOCKS = 1 };

typedef __m256 lanes;

static inline lanes lanes_of(double x)
{
    return _mm256_set1_ps((float)x);
}
static inline lanes load(const float *p)
{
    return _mm256_loadu_ps(p);
}
static inline lanes load_double(const double *p)
{
    return _mm256_set_m128(_mm256_cvtpd_ps(_mm256_loadu_pd(p + 4)), _mm256_cvtpd_ps(_mm256_loadu_pd(p)));
}
static inline lanes add(lanes a, lanes b)
{
    return _mm256_add_ps(a, b);
}
static inline lanes subtract(lanes a, lanes b)
{
    return _mm256_sub_ps(a, b);
}
static inline lanes multiply(lanes a, lanes b)
{
    return _mm256_mul_ps(a, b);
}
static inline lanes divide(lanes a, lanes b)
{
    return _mm256_div_ps(a, b);
}
static inline lanes multiply_add(lanes a, lanes b, lanes c)
{
    return _mm256_fmadd_ps(a, b, c);
}
/// c - a b
static inline lanes subtract_product(lanes c, lanes a, lanes b)
{
    return _mm256_fnmadd_ps(a, b, c);
}
static inline lanes greatest(lanes a, lanes b)
{
    return _mm256_max_ps(a, b);
}
static inline lanes least(lanes a, lanes b)
{
    return _mm256_min_ps(a, b);
}
static inline lanes draw(const double table[], const pdmc_hash_key *key, uint32_t cell, uint32_t other, bool one)
{
    const __m256i at = pdmc_hashes(key, cell, other, one);
    const __m256d low = _mm256_i32gather_pd(table, _mm256_castsi256_si128(at), sizeof *table);
    const __m256d high = _mm256_i32gather_pd(table, _mm256_extracti128_si256(at, 1), sizeof *table);
    return _mm256_set_m128(_mm256_cvtpd_ps(high), _mm256_cvtpd_ps(low));
}
