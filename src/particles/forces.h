// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The forces of bonds and of short-range repulsion between nodes that are neighbours in the reference configuration.
///
/// A node sums its own bonds, in the order of the neighbours: nothing is scattered, so that no result depends on threads, and
/// both directions of a bond are computed from the same numbers and agree to the bit.

#include "particles/hash.h"
#include "particles/joints.h"
#include "particles/nodes.h"
#include "particles/single.h"

typedef struct {
    const pdmc_nodes *nodes;
    const pdmc_brittle_law *laws;         // [materials]
    const pdmc_joints *joints;         // of bodies
    double repulsion;                  // force / length^7: of two nodes, by distance and by both nodes' volumes
    bool energies;                     // whether elastic and contact are wanted, instead of the forces
    bool unbreakable;                  // whether no bond breaks now
    bool linear;                       // whether the stretch is that along the reference direction
    bool by_node;                      // whether s_0 differs between nodes for another reason than strengthening
    const double *position[PDMC_AXES]; // [cells]
    const double *velocity[PDMC_AXES]; // [cells] half a step before
    const pdmc_single *single;         // instead of positions, stiffness and strengths, for kernels of single precision
    double step;                       // of time
    const double *stiffness;           // [cells] factors of c, whose mean of two nodes is that of their bond; NULL: 1
    const double *first_strength;      // [cells] s_0 without strengthening; NULL: that of the laws
    const double *relative_strength;   // [cells] factors of the s_0 of interfaces; NULL: 1
    const double *strength;            // [cells] s_0, of which the less of two nodes is that of their bond
    double *next_strength;             // [cells] of the next step, written where there is strengthening
    pdmc_hash_key key;                 // of the strengths of single bonds
    double *force[PDMC_AXES];          // [cells] on a unit of volume
    double *fracture; // [blocks] to which the energies of bonds that break are added: a half for each direction
    double *elastic, *contact; // [blocks]
} pdmc_forces;

/// Nodes, as bits, of which a bond is to break, or whose neighbours are near enough to touch.
typedef struct {
    uint16_t breaking, touching;
} pdmc_alarms;

/// Computes the forces of blocks first .. last - 1, and breaks the bonds that are stretched beyond s_0: from the next step on.
typedef void pdmc_forces_kernel(const pdmc_forces *forces, int first, int last);

pdmc_forces_kernel pdmc_forces_portable, pdmc_forces_portable_single;
#ifdef PDMC_HAVE_X86
pdmc_forces_kernel pdmc_forces_avx2, pdmc_forces_avx2_single;
pdmc_forces_kernel pdmc_forces_avx512, pdmc_forces_avx512_single;
#endif

/// The forces of blocks b and b + 1 in one, where they lie side by side on a grid and have the same neighbours and law, and what is
/// left to do. Of kinds of bonds that are neither linear nor joined.
typedef pdmc_alarms pdmc_forces_of_two(const pdmc_forces *forces, int b, bool by_node, bool varied);

#ifdef PDMC_HAVE_X86
pdmc_forces_of_two pdmc_forces_avx512_single_two;
#endif

/// The kernels of a kind of processor.
typedef struct {
    const char *name;
    pdmc_forces_kernel *in_double, *in_single;
} pdmc_forces_kernels;

/// The fastest kernels of this machine.
pdmc_forces_kernels pdmc_forces_choose(void);
