// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Eight doubles at a time, by the vectors of two that GCC and Clang have for every processor: loops over arrays of eight take the
/// compiler minutes.

#include "particles/hash.h"

#include <math.h>
#include <string.h>

typedef double real;
typedef uint8_t lane_mask;
enum { BLOCKS = 1 };

typedef double duo __attribute__((vector_size(16)));
typedef int64_t duo_mask __attribute__((vector_size(16))); // all bits or none

typedef struct {
    duo at[4];
} lanes;

// Of k = 0 .. 3; and of the eight doubles in them.
#define EACH(of) ((lanes){{of(0), of(1), of(2), of(3)}})
#define EVERY(of) ((lanes){{{of(0), of(1)}, {of(2), of(3)}, {of(4), of(5)}, {of(6), of(7)}}})
#define EIGHTH(a, k) ((a).at[(k) / 2][(k) % 2])

static inline duo choose(duo_mask mask, duo yes, duo no)
{
    return (duo)((mask & (duo_mask)yes) | (~mask & (duo_mask)no));
}
static inline duo_mask mask_of(unsigned bits)
{
    return (duo_mask){-(int64_t)(bits & 1), -(int64_t)(bits >> 1 & 1)};
}

static inline lanes lanes_of(double x)
{
#define OF(k) ((duo){x, x})
    return EACH(OF);
#undef OF
}
static inline lanes load(const double *p)
{
    lanes out;
    memcpy(&out, p, sizeof out);
    return out;
}
static inline lanes load_double(const double *p)
{
    return load(p);
}
static inline lanes add(lanes a, lanes b)
{
#define OF(k) (a.at[k] + b.at[k])
    return EACH(OF);
#undef OF
}
static inline lanes subtract(lanes a, lanes b)
{
#define OF(k) (a.at[k] - b.at[k])
    return EACH(OF);
#undef OF
}
static inline lanes multiply(lanes a, lanes b)
{
#define OF(k) (a.at[k] * b.at[k])
    return EACH(OF);
#undef OF
}
static inline lanes divide(lanes a, lanes b)
{
#define OF(k) (a.at[k] / b.at[k])
    return EACH(OF);
#undef OF
}
static inline lanes multiply_add(lanes a, lanes b, lanes c)
{
#define OF(k) (a.at[k] * b.at[k] + c.at[k])
    return EACH(OF);
#undef OF
}
/// c - a b
static inline lanes subtract_product(lanes c, lanes a, lanes b)
{
    return subtract(c, multiply(a, b));
}
static inline lanes greatest(lanes a, lanes b)
{
#define OF(k) (choose(a.at[k] > b.at[k], a.at[k], b.at[k]))
    return EACH(OF);
#undef OF
}
static inline lanes least(lanes a, lanes b)
{
#define OF(k) (choose(a.at[k] < b.at[k], a.at[k], b.at[k]))
    return EACH(OF);
#undef OF
}
static inline lanes inverse_root(lanes a)
{
#define OF(k) (1.0 / sqrt(EIGHTH(a, k)))
    return EVERY(OF);
#undef OF
}
static inline uint32_t drawn(const pdmc_hash_key *key, uint32_t i, uint32_t j)
{
    return i < j ? pdmc_hash(i, j, key) : pdmc_hash(j, i, key);
}
/// The entries of a table that fall to the pairs cell, cell + 1, ... with other, other + 1, ..., or with one other.
static inline lanes draw(const double table[], const pdmc_hash_key *key, uint32_t cell, uint32_t other, bool one)
{
    double out[8];
    for (uint32_t k = 0; k < 8; k++) out[k] = table[drawn(key, cell + k, one ? other : other + k)];
    return load(out);
}

static inline uint8_t less(lanes a, lanes b)
{
    unsigned bits = 0;
    for (int k = 0; k < 4; k++) {
        const duo_mask is = a.at[k] < b.at[k];
        bits |= (unsigned)((is[0] & 1) | (is[1] & 2)) << 2 * k;
    }
    return (uint8_t)bits;
}

/// a b + c in the lanes of a mask, c in the others.
static inline lanes multiply_add_where(uint8_t mask, lanes a, lanes b, lanes c)
{
#define OF(k) (choose(mask_of((unsigned)mask >> 2 * (k)), a.at[k] * b.at[k] + c.at[k], c.at[k]))
    return EACH(OF);
#undef OF
}

static inline lanes greatest_where(uint8_t mask, lanes a, lanes b)
{
#define OF(k) (choose(mask_of((unsigned)mask >> 2 * (k)) & (b.at[k] > a.at[k]), b.at[k], a.at[k]))
    return EACH(OF);
#undef OF
}

static inline lanes least_where(uint8_t mask, lanes a, lanes b)
{
#define OF(k) (choose(mask_of((unsigned)mask >> 2 * (k)) & (b.at[k] < a.at[k]), b.at[k], a.at[k]))
    return EACH(OF);
#undef OF
}

static inline void store_where(uint8_t mask, double *p, lanes a)
{
    for (int k = 0; k < 8; k++)
        if (mask >> k & 1) p[k] = EIGHTH(a, k);
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
    double sum = 0.0;
    for (int k = 0; k < 8; k++)
        if (mask >> k & 1) sum += EIGHTH(a, k);
    return sum;
}

#undef EACH
#undef EVERY
