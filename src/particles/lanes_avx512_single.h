// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Eight floats at a time, by AVX2 with the masks and the estimate of AVX-512 (F, DQ and VL).

#include "particles/lanes_single.h"

static inline uint8_t less(lanes a, lanes b)
{
    return _mm256_cmp_ps_mask(a, b, _CMP_LT_OQ);
}

/// To 14 bits.
static inline lanes estimate_inverse_root(lanes a)
{
    return _mm256_rsqrt14_ps(a);
}
/// (1 - (1 + e)^(-1/2)) / e for |e| < 2^-13: what is left out is 2^-40.
static inline lanes mending_series(lanes e)
{
    return subtract_product(lanes_of(0.5), lanes_of(3.0 / 8.0), e);
}

static inline lanes multiply_add_where(uint8_t mask, lanes a, lanes b, lanes c)
{
    return _mm256_mask3_fmadd_ps(a, b, c, mask);
}
static inline lanes greatest_where(uint8_t mask, lanes a, lanes b)
{
    return _mm256_mask_max_ps(a, mask, b, a);
}
static inline lanes least_where(uint8_t mask, lanes a, lanes b)
{
    return _mm256_mask_min_ps(a, mask, b, a);
}
static inline void store_where(uint8_t mask, float *p, lanes a)
{
    _mm256_mask_storeu_ps(p, mask, a);
}
/// p = factor a.
static inline void put_where(uint8_t mask, double *p, double factor, lanes a)
{
    _mm512_mask_storeu_pd(p, mask, _mm512_mul_pd(_mm512_set1_pd(factor), _mm512_cvtps_pd(a)));
}
/// p += factor a.
static inline void add_where(uint8_t mask, double *p, double factor, lanes a)
{
    const __m512d sum = _mm512_fmadd_pd(_mm512_set1_pd(factor), _mm512_cvtps_pd(a), _mm512_loadu_pd(p));
    _mm512_mask_storeu_pd(p, mask, sum);
}
static inline double sum_where(uint8_t mask, lanes a)
{
    return _mm512_mask_reduce_add_pd(mask, _mm512_cvtps_pd(a));
}
