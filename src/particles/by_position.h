// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Bonds measured by the positions of their nodes. 1 / p is all that is needed of the distance p: s / p = 1 / |xi| - 1 / p, and
/// s < s_0 is |xi| / p > 1 / (1 + s_0).

#include "particles/forces.h"

typedef pdmc_neighbour neighbour;

#include "particles/pairs.h"

INLINE const double *const *places_of(const pdmc_forces *f)
{
    return f->position;
}
INLINE const double *const *references_of(const pdmc_forces *f)
{
    return (const double *const *)f->nodes->reference;
}
INLINE const double *volumes_of(const pdmc_forces *f)
{
    return f->nodes->volume;
}
INLINE const double *factors_of(const pdmc_forces *f)
{
    return f->stiffness;
}
INLINE const double *strengths_of(const pdmc_forces *f)
{
    return f->strength;
}
INLINE double *next_strengths_of(const pdmc_forces *f)
{
    return f->next_strength;
}
INLINE const neighbour *neighbours_of(const pdmc_forces *f)
{
    return f->nodes->neighbours;
}
INLINE double unit_of_length(const pdmc_forces *f)
{
    (void)f;
    return 1.0;
}
INLINE double unit_of_volume(const pdmc_forces *f)
{
    (void)f;
    return 1.0;
}

INLINE double unit_of_micromodulus(const pdmc_forces *f)
{
    (void)f;
    return 1.0;
}

INLINE void measure(const place *at, pairs *p)
{
    for (int a = 0; a < PDMC_AXES; a++)
        p->apart[a] = subtract(of_neighbours(at, places_of(at->forces)[a], p->cell), at->place[a]);
    p->nearness = inverse_root(square_of(p->apart));
    p->stretch = lanes_of(-1.0); // (xi + eta) . xi / |xi|^2 - 1
    for (int a = 0; a < PDMC_AXES && at->kind.linear; a++)
        p->stretch = multiply_add(p->slope[a], p->apart[a], p->stretch);
}

INLINE lanes inverse_distance(const pairs *p)
{
    return p->nearness;
}

/// What is larger the nearer two nodes are to each other: |xi| / p = 1 / (1 + s).
INLINE lanes shortening(const pairs *p)
{
    return multiply(p->length, p->nearness);
}
INLINE double shortening_at(double ratio)
{
    return ratio;
}
static const double shortening_slack = 0.0;
INLINE lanes stretch_at(lanes shortening)
{
    return subtract(divide(lanes_of(1.0), shortening), lanes_of(1.0));
}

/// (1 + s_0) / (1 + s), which falls below 1 = enough.
INLINE lanes reserve_against(lanes s_0, lanes shortening)
{
    return multiply_add(shortening, s_0, shortening);
}
static const double reserve_enough = 1.0;

/// Weight times s / p.
INLINE lanes pull_by_length(const place *at, const pairs *p)
{
    if (at->kind.scattered) return multiply(p->weight, subtract(p->inverse_length, p->nearness));
    return subtract_product(lanes_of(p->neighbour->stiffness), p->weight, p->nearness);
}
