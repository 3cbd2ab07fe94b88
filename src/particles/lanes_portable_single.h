// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Eight floats at a time, by the vectors of four that GCC and Clang have for every processor.

#include "particles/hash.h"

#include <math.h>
#include <string.h>

typedef float real;
typedef uint8_t lane_mask;
enum { BLOCKS = 1 };

typedef float quartet __attribute__((vector_size(16)));
typedef int32_t quartet_mask __attribute__((vector_size(16))); // all bits or none

typedef struct {
    quartet low, high;
} lanes;

static inline quartet choose(quartet_mask mask, quartet yes, quartet no)
{
    return (quartet)((mask & (quartet_mask)yes) | (~mask & (quartet_mask)no));
}
static inline quartet_mask mask_of(unsigned bits)
{
    const quartet_mask place = {1, 2, 4, 8}, all = {(int)bits, (int)bits, (int)bits, (int)bits};
    return (all & place) == place;
}
static inline lanes choose_lanes(uint8_t mask, lanes yes, lanes no)
{
    return (lanes){choose(mask_of(mask), yes.low, no.low), choose(mask_of((unsigned)mask >> 4), yes.high, no.high)};
}

static inline quartet four_of(float x)
{
    return (quartet){x, x, x, x};
}
static inline lanes lanes_of(double x)
{
    return (lanes){four_of((float)x), four_of((float)x)};
}
static inline lanes load(const float *p)
{
    lanes out;
    memcpy(&out, p, sizeof out);
    return out;
}
static inline lanes load_double(const double *p)
{
    float at[8];
    for (int k = 0; k < 8; k++) at[k] = (float)p[k];
    return load(at);
}
static inline lanes add(lanes a, lanes b)
{
    return (lanes){a.low + b.low, a.high + b.high};
}
static inline lanes subtract(lanes a, lanes b)
{
    return (lanes){a.low - b.low, a.high - b.high};
}
static inline lanes multiply(lanes a, lanes b)
{
    return (lanes){a.low * b.low, a.high * b.high};
}
static inline lanes divide(lanes a, lanes b)
{
    return (lanes){a.low / b.low, a.high / b.high};
}
static inline lanes multiply_add(lanes a, lanes b, lanes c)
{
    return add(multiply(a, b), c);
}
/// c - a b
static inline lanes subtract_product(lanes c, lanes a, lanes b)
{
    return subtract(c, multiply(a, b));
}
static inline lanes greatest(lanes a, lanes b)
{
    return (lanes){choose(a.low > b.low, a.low, b.low), choose(a.high > b.high, a.high, b.high)};
}
static inline lanes least(lanes a, lanes b)
{
    return (lanes){choose(a.low < b.low, a.low, b.low), choose(a.high < b.high, a.high, b.high)};
}
static inline quartet inverse_roots(quartet a)
{
    return four_of(1.0f) / (quartet){sqrtf(a[0]), sqrtf(a[1]), sqrtf(a[2]), sqrtf(a[3])};
}
/// Rounded twice.
static inline lanes estimate_inverse_root(lanes a)
{
    return (lanes){inverse_roots(a.low), inverse_roots(a.high)};
}
/// (1 - (1 + e)^(-1/2)) / e for |e| < 2^-22: what is left out is 2^-45.
static inline lanes mending_series(lanes e)
{
    (void)e;
    return lanes_of(0.5);
}
static inline uint32_t drawn(const pdmc_hash_key *key, uint32_t i, uint32_t j)
{
    return i < j ? pdmc_hash(i, j, key) : pdmc_hash(j, i, key);
}
/// The entries of a table that fall to the pairs cell, cell + 1, ... with other, other + 1, ..., or with one other.
static inline lanes draw(const double table[], const pdmc_hash_key *key, uint32_t cell, uint32_t other, bool one)
{
    float out[8];
    for (uint32_t k = 0; k < 8; k++) out[k] = (float)table[drawn(key, cell + k, one ? other : other + k)];
    return load(out);
}

static inline unsigned bits_of(quartet_mask is)
{
    return (unsigned)((is[0] & 1) | (is[1] & 2) | (is[2] & 4) | (is[3] & 8));
}
static inline uint8_t less(lanes a, lanes b)
{
    return (uint8_t)(bits_of(a.low < b.low) | bits_of(a.high < b.high) << 4);
}
static inline lanes multiply_add_where(uint8_t mask, lanes a, lanes b, lanes c)
{
    return choose_lanes(mask, multiply_add(a, b, c), c);
}
static inline lanes greatest_where(uint8_t mask, lanes a, lanes b)
{
    return choose_lanes(mask, greatest(b, a), a);
}
static inline lanes least_where(uint8_t mask, lanes a, lanes b)
{
    return choose_lanes(mask, least(b, a), a);
}
static inline void store_where(uint8_t mask, float *p, lanes a)
{
    for (int k = 0; k < 8; k++)
        if (mask >> k & 1) p[k] = k < 4 ? a.low[k] : a.high[k - 4];
}
/// p = factor a.
static inline void put_where(uint8_t mask, double *p, double factor, lanes a)
{
    for (int k = 0; k < 8; k++)
        if (mask >> k & 1) p[k] = factor * (double)(k < 4 ? a.low[k] : a.high[k - 4]);
}
/// p += factor a.
static inline void add_where(uint8_t mask, double *p, double factor, lanes a)
{
    for (int k = 0; k < 8; k++)
        if (mask >> k & 1) p[k] += factor * (double)(k < 4 ? a.low[k] : a.high[k - 4]);
}
static inline double sum_where(uint8_t mask, lanes a)
{
    double sum = 0.0;
    for (int k = 0; k < 8; k++)
        if (mask >> k & 1) sum += (double)(k < 4 ? a.low[k] : a.high[k - 4]);
    return sum;
}
