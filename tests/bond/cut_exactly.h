// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Which bonds a crack cuts, in whole numbers: points on a lattice, signs of areas in 64 bits.

#include <stdbool.h>
#include <stdint.h>

typedef struct {
    int64_t x, y;
} lattice_point;

/// Twice the area of the triangle abc: positive where c lies to the left of a -> b.
static inline int64_t lattice_left(lattice_point a, lattice_point b, lattice_point c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// One end on the right of the crack, the other on its line or to the left, and the crack's ends not both on the same
/// side of the bond.
static inline bool cut_exactly(lattice_point from, lattice_point to, lattice_point a, lattice_point b)
{
    if ((lattice_left(from, to, a) < 0) == (lattice_left(from, to, b) < 0)) return false;
    const int64_t p = lattice_left(a, b, from), q = lattice_left(a, b, to);
    return !((p > 0 && q > 0) || (p < 0 && q < 0));
}
