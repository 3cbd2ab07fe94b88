// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What the kernel and its two ways to measure bonds share, over the lanes and the kind of neighbour that were defined before.

#include "particles/forces.h"

// In line whatever the compiler thinks of it, with the kind of bonds a constant.
#define INLINE static inline __attribute__((always_inline))

/// Versions of the kernel for what is simple, so that it costs nothing else.
typedef struct {
    bool scattered; // the nodes are off the grid
    bool linear;    // the stretch is that along the reference direction
    bool by_node;   // s_0 differs from node to node
    bool varied;    // c or s_0 differ from bond to bond
    bool joined;    // some bonds are to other bodies
} bond_kind;

typedef struct {
    const pdmc_forces *forces;
    const pdmc_block *block;
    const pdmc_brittle_law *law;
    bond_kind kind;
    lanes place[PDMC_AXES], reference[PDMC_AXES]; // positions or displacements; where the nodes were, off the grid only
    lanes strength;                               // s_0
    lanes enough;                                 // a bond breaks whose reserve is below
    double micromodulus;                          // c over what stiffness_of() says
    size_t joints;                                // row of the body
} place;

/// The pairs of a block's nodes with an entry of its list: what both directions of a bond have in common, and the volume of
/// the neighbour that counts.
typedef struct {
    size_t cell;                  // of the neighbour; of the first of eight on a grid
    const neighbour *neighbour;   // on a grid only
    lane_mask near;               // which of them are neighbours
    lanes xi[PDMC_AXES];          // of nodes off the grid only
    lanes length, inverse_length; // |xi|; the inverse of nodes off the grid only
    lanes weight;                 // volume of the neighbour that counts
    lanes touching;               // 1 / distance below which they repel each other
    lanes slope[PDMC_AXES];       // xi / |xi|^2
    lanes apart[PDMC_AXES];       // xi + eta
    lanes nearness;               // by position 1 / p, by displacement |xi| / p - 1
    lanes stretch;                // of linear stretch only
} pairs;

INLINE bool is_uniform(bond_kind kind)
{
    return !kind.linear && !kind.by_node && !kind.varied;
}

INLINE lanes square_of(const lanes x[PDMC_AXES])
{
    return multiply_add(x[0], x[0], multiply_add(x[1], x[1], multiply(x[2], x[2])));
}

INLINE lanes of_neighbours(const place *at, const real x[], size_t cell)
{
    return at->kind.scattered ? lanes_of(x[cell]) : load(&x[cell]);
}
