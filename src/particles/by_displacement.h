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

/// (1 + t)^(-1/2) - 1. With an estimate y of the root d = y - 1 is exact, and what is wrong with it is found from d and t
/// alone: e = (1 + t) y^2 - 1 = d (1 + y) + t y^2, of which a series mends y (1 + e)^(-1/2).
INLINE lanes inverse_root_less_one(lanes t)
{
    const lanes one = lanes_of(1.0), least = lanes_of(1e-6); // rounding can make 1 + t negative
    const lanes y = estimate_inverse_root(greatest(add(one, t), least));
    const lanes d = subtract(y, one);
    const lanes e = multiply_add(d, add(one, y), multiply(t, multiply(y, y)));
    return subtract_product(d, multiply(y, e), mending_series(e));
}

/// 1 / sqrt(a)
INLINE lanes inverse_root(lanes a)
{
    const lanes y = estimate_inverse_root(a);
    const lanes e = multiply_add(multiply(a, y), y, lanes_of(-1.0));
    return subtract_product(y, multiply(y, e), mending_series(e));
}

/// (2 xi + eta) . eta / |xi|^2
INLINE lanes relative_square(const place *at, const pairs *p, const lanes eta[PDMC_AXES])
{
    const bool scattered = at->kind.scattered;
    const lanes inverse_square =
        scattered ? multiply(p->inverse_length, p->inverse_length) : lanes_of(p->neighbour->inverse_square);
    lanes t = lanes_of(0.0);
    for (int a = 0; a < PDMC_AXES; a++) {
        const lanes twice = scattered ? add(p->slope[a], p->slope[a]) : lanes_of(p->neighbour->twice_slope[a]);
        const lanes along = multiply_add(eta[a], inverse_square, twice);
        t = a == 0 ? multiply(eta[a], along) : multiply_add(eta[a], along, t);
    }
    return t;
}

INLINE void measure(const place *at, pairs *p)
{
    lanes eta[PDMC_AXES];
    p->stretch = lanes_of(0.0);
    for (int a = 0; a < PDMC_AXES; a++) {
        eta[a] = subtract(of_neighbours(at, places_of(at->forces)[a], p->cell), at->place[a]);
        p->apart[a] = add(at->kind.scattered ? p->xi[a] : lanes_of(p->neighbour->step[a]), eta[a]);
        if (at->kind.linear) p->stretch = multiply_add(p->slope[a], eta[a], p->stretch);
    }
    p->nearness = inverse_root_less_one(relative_square(at, p, eta));
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
INLINE double shortening_at(double ratio)
{
    return ratio - 1.0;
}
/// By how much less it is looked for than nodes have it that touch, so that rounding overlooks none.
static const double shortening_slack = 1e-5;
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
