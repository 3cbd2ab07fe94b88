// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Eight doubles at a time, in plain C.

#include "particles/hash.h"

#include <math.h>

typedef struct {
    double at[8];
} lanes;

#define EACH(expression)                                                                                               \
    lanes out;                                                                                                         \
    for (int k = 0; k < 8; k++) out.at[k] = (expression);                                                              \
    return out

static inline lanes lanes_of(double x)
{
    EACH(x);
}
static inline lanes load(const double *p)
{
    EACH(p[k]);
}
static inline lanes add(lanes a, lanes b)
{
    EACH(a.at[k] + b.at[k]);
}
static inline lanes subtract(lanes a, lanes b)
{
    EACH(a.at[k] - b.at[k]);
}
static inline lanes multiply(lanes a, lanes b)
{
    EACH(a.at[k] * b.at[k]);
}
static inline lanes divide(lanes a, lanes b)
{
    EACH(a.at[k] / b.at[k]);
}
static inline lanes multiply_add(lanes a, lanes b, lanes c)
{
    EACH(a.at[k] * b.at[k] + c.at[k]);
}
static inline lanes greatest(lanes a, lanes b)
{
    EACH(a.at[k] > b.at[k] ? a.at[k] : b.at[k]);
}
static inline lanes least(lanes a, lanes b)
{
    EACH(a.at[k] < b.at[k] ? a.at[k] : b.at[k]);
}
static inline uint32_t drawn(const pdmc_hash_key *key, uint32_t i, uint32_t j)
{
    return i < j ? pdmc_hash(i, j, key) : pdmc_hash(j, i, key);
}
/// The entries of a table that fall to the pairs cell, cell + 1, ... with other, other + 1, ..., or with one other.
static inline lanes draw(const double table[], const pdmc_hash_key *key, uint32_t cell, uint32_t other, bool one)
{
    EACH(table[drawn(key, cell + (uint32_t)k, one ? other : other + (uint32_t)k)]);
}
static inline lanes inverse_root(lanes a)
{
    EACH(1.0 / sqrt(a.at[k]));
}

static inline uint8_t less(lanes a, lanes b)
{
    unsigned bits = 0;
    for (int k = 0; k < 8; k++) bits |= (unsigned)(a.at[k] < b.at[k]) << k;
    return (uint8_t)bits;
}

/// a b + c in the lanes of a mask, c in the others.
static inline lanes multiply_add_where(uint8_t mask, lanes a, lanes b, lanes c)
{
    EACH(mask >> k & 1 ? a.at[k] * b.at[k] + c.at[k] : c.at[k]);
}

static inline lanes greatest_where(uint8_t mask, lanes a, lanes b)
{
    EACH((mask >> k & 1) && b.at[k] > a.at[k] ? b.at[k] : a.at[k]);
}

static inline lanes least_where(uint8_t mask, lanes a, lanes b)
{
    EACH((mask >> k & 1) && b.at[k] < a.at[k] ? b.at[k] : a.at[k]);
}

static inline void store_where(uint8_t mask, double *p, lanes a)
{
    for (int k = 0; k < 8; k++)
        if (mask >> k & 1) p[k] = a.at[k];
}

static inline double sum_where(uint8_t mask, lanes a)
{
    double sum = 0.0;
    for (int k = 0; k < 8; k++)
        if (mask >> k & 1) sum += a.at[k];
    return sum;
}

#undef EACH
