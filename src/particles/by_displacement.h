// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Bonds measured by the displacements of their nodes, in units of the spacing, for single precision: xi is exact, and no digit is
/// lost where eta is small. With t = (2 xi . eta + eta^2) / |xi|^2 the distance is p = |xi| sqrt(1 + t), and all that is needed of
/// it is |xi| / p - 1 = -s / (1 + s): s / p is its negative over |xi|, and s < s_0 is |xi| / p - 1 > -s_0 / (1 + s_0).

#include "particles/forces.h"

typedef pdmc_single_neighbour neighbour;

#include "particles/pairs.h"

INLINE const float *const *places_of(const pdmc_forces *f)
{
    return (const float *const *)f->single->displacement;
}
INLINE const float *const *references_of(const pdmc_forces *f)
{
    return (const float *const *)f->single->reference;
}
INLINE const float *volumes_of(const pdmc_forces *f)
{
    return f->single->node_volume;
}
INLINE const float *factors_of(const pdmc_forces *f)
{
    return f->single->stiffness;
}
INLINE const float *strengths_of(const pdmc_forces *f)
{
    return f->single->strength;
}
INLINE float *next_strengths_of(const pdmc_forces *f)
{
    return f->single->next_strength;
}
INLINE const neighbour *neighbours_of(const pdmc_forces *f)
{
    return f->single->neighbours;
}
INLINE double unit_of_length(const pdmc_forces *f)
{
    return f->single->length;
}
INLINE double unit_of_volume(const pdmc_forces *f)
{
    return f->single->volume;
}

INLINE double unit_of_micromodulus(const pdmc_forces *f)
{
    return f->laws->micromodulus;
}

/// (1 + t)^(-1/2) - 1 from h = t / 2. With an estimate y of the root d = y - 1 is exact, and what is wrong with it is found from
/// d and h alone: e = (1 + t) y^2 - 1 = d (1 + y) + 2 h y^2, of which a series mends y (1 + e)^(-1/2).
INLINE lanes inverse_root_less_one(lanes h)
{
    const lanes one = lanes_of(1.0), a_half = lanes_of(0.5), least = lanes_of(1e-6); // rounding can make 1 + t negative
    const lanes y = estimate_inverse_root(greatest(multiply_add(lanes_of(2.0), h, one), least));
    const lanes d = subtract(y, one);
    const lanes half = multiply_add(d, multiply_add(a_half, y, a_half), multiply(h, multiply(y, y)));
    return subtract_product(d, multiply(y, half), mending_series(half));
}

/// 1 / sqrt(a)
INLINE lanes inverse_root(lanes a)
{
    const lanes y = estimate_inverse_root(a), minus = lanes_of(-0.5);
    const lanes half = multiply_add(multiply(lanes_of(0.5), multiply(a, y)), y, minus);
    return subtract_product(y, multiply(y, half), mending_series(half));
}

INLINE void measure(const place *at, pairs *p)
{
    const bool scattered = at->kind.scattered;
    const lanes half = scattered ? multiply(lanes_of(0.5), multiply(p->inverse_length, p->inverse_length))
                                 : lanes_of(p->neighbour->half_inverse_square);
    lanes h = lanes_of(0.0);
    p->stretch = lanes_of(0.0);
    for (int a = 0; a < PDMC_AXES; a++) {
        const lanes eta = subtract(of_neighbours(at, places_of(at->forces)[a], p->cell), at->place[a]);
        const lanes xi = scattered ? p->xi[a] : lanes_of(p->neighbour->step[a]);
        p->apart[a] = add(xi, eta);
        h = a == 0 ? multiply(eta, multiply_add(eta, half, p->slope[a]))
                   : multiply_add(eta, multiply_add(eta, half, p->slope[a]), h);
        if (at->kind.linear) p->stretch = multiply_add(p->slope[a], eta, p->stretch);
    }
    p->nearness = inverse_root_less_one(h);
}

INLINE lanes inverse_distance(const pairs *p)
{
    return divide(add(lanes_of(1.0), p->nearness), p->length);
}

/// What is larger the nearer two nodes are to each other: |xi| / p - 1 = -s / (1 + s).
INLINE lanes shortening(const pairs *p)
{
    return p->nearness;
}
/// By less than touching nodes have it, so that none is overlooked.
INLINE double shortening_at(double ratio)
{
    return ratio - 1.0 - 1e-5;
}
INLINE lanes stretch_at(lanes shortening)
{
    return divide(subtract(lanes_of(0.0), shortening), add(lanes_of(1.0), shortening));
}

/// s_0 / (1 + s) - s / (1 + s), which falls below 0 = enough.
INLINE lanes reserve_against(lanes s_0, lanes shortening)
{
    return multiply_add(s_0, add(lanes_of(1.0), shortening), shortening);
}
static const double reserve_enough = 0.0;

/// Weight times s / p.
INLINE lanes pull_by_length(const place *at, const pairs *p)
{
    if (at->kind.scattered)
        return multiply(multiply(p->weight, p->inverse_length), subtract(lanes_of(0.0), p->nearness));
    return multiply(lanes_of(p->neighbour->minus_stiffness), p->nearness);
}
