// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Eight doubles at a time, by AVX-512 (F and DQ).

#include "particles/hash_avx2.h"

typedef double real;
typedef uint8_t lane_mask;
enum { BLOCKS = 1 };

typedef __m512d lanes;

static inline lanes lanes_of(double x)
{
    return _mm512_set1_pd(x);
}
static inline lanes load(const double *p)
{
    return _mm512_loadu_pd(p);
}
static inline lanes load_double(const double *p)
{
    return load(p);
}
static inline lanes add(lanes a, lanes b)
{
    return _mm512_add_pd(a, b);
}
static inline lanes subtract(lanes a, lanes b)
{
    return _mm512_sub_pd(a, b);
}
static inline lanes multiply(lanes a, lanes b)
{
    return _mm512_mul_pd(a, b);
}
static inline lanes divide(lanes a, lanes b)
{
    return _mm512_div_pd(a, b);
}
static inline lanes multiply_add(lanes a, lanes b, lanes c)
{
    return _mm512_fmadd_pd(a, b, c);
}
/// c - a b
static inline lanes subtract_product(lanes c, lanes a, lanes b)
{
    return _mm512_fnmadd_pd(a, b, c);
}
static inline lanes greatest(lanes a, lanes b)
{
    return _mm512_max_pd(a, b);
}
static inline lanes least(lanes a, lanes b)
{
    return _mm512_min_pd(a, b);
}
static inline lanes draw(const double table[], const pdmc_hash_key *key, uint32_t cell, uint32_t other, bool one)
{
    return _mm512_i32gather_pd(pdmc_hashes(key, cell, other, one), table, sizeof *table);
}
static inline uint8_t less(lanes a, lanes b)
{
    return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ);
}

/// 1 / sqrt(a) from the estimate of 14 bits, y: with e = 1 - a y^2, y (1 - e)^(-1/2) to the fourth order, which leaves 2^-56.
static inline lanes inverse_root(lanes a)
{
    const lanes y = _mm512_rsqrt14_pd(a);
    const lanes e = _mm512_fnmadd_pd(multiply(a, y), y, lanes_of(1.0));
    const lanes series = multiply_add(multiply_add(lanes_of(5.0 / 16.0), e, lanes_of(3.0 / 8.0)), e, lanes_of(0.5));
    return multiply_add(multiply(y, e), series, y);
}

static inline lanes multiply_add_where(uint8_t mask, lanes a, lanes b, lanes c)
{
    return _mm512_mask3_fmadd_pd(a, b, c, mask);
}
static inline lanes greatest_where(uint8_t mask, lanes a, lanes b)
{
    return _mm512_mask_max_pd(a, mask, b, a);
}
static inline lanes least_where(uint8_t mask, lanes a, lanes b)
{
    return _mm512_mask_min_pd(a, mask, b, a);
}
static inline void store_where(uint8_t mask, double *p, lanes a)
{
    _mm512_mask_storeu_pd(p, mask, a);
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
    return _mm512_mask_reduce_add_pd(mask, a);
}
