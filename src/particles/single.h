// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What the kernels of single precision read, in units of the spacing and of its cube: displacements, not positions, so that
/// a stretch is as exact as a displacement is, relative to itself.

#include "particles/nodes.h"

/// A neighbour on a grid, as pdmc_neighbour.
typedef struct {
    ptrdiff_t shift;
    float step[PDMC_AXES]; // xi
    float weight, length;  // ...
    float minus_stiffness; // - weight / |xi|
    float inverse_square;  // 1 / |xi|^2
    float twice_slope[PDMC_AXES];
    float slope[PDMC_AXES]; // xi / |xi|^2
    float touching;         // 1 / distance; infinite: never
} pdmc_single_neighbour;

typedef struct {
    double length, volume;             // the units; length 0: nothing is kept in single precision
    pdmc_single_neighbour *neighbours; // of a grid
    float *displacement[PDMC_AXES];    // [cells]; very large in empty cells
    float *reference[PDMC_AXES];       // [cells] of nodes off the grid; NULL on a grid
    float *node_volume;                // [cells]
    float *stiffness;                  // [cells] factors of c, NULL: 1
    float *strength, *next_strength;   // [cells] s_0
} pdmc_single;

/// Room for the arrays, and what does not change. Nodes are where they were, and their s_0 is unset.
/// @param[in]  stiffness  [cells] factors of c, or NULL
/// @param[out] single     clear with pdmc_single_clear(), whatever is returned
/// @return PDMC_OK; PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_single_create(const pdmc_nodes *nodes, const double stiffness[], pdmc_single *single);
void pdmc_single_clear(pdmc_single *single);

/// Takes the displacements of a block's nodes from their positions.
static inline void pdmc_single_follow(pdmc_single *single, const pdmc_nodes *nodes, const pdmc_block *block,
                                      double *const position[PDMC_AXES])
{
    const double per_unit = 1.0 / single->length;
    const bool full = block->occupied == 0xff;
    for (int a = 0; a < PDMC_AXES; a++) {
        const double *x = &position[a][block->cell], *first = &nodes->reference[a][block->cell];
        float *u = &single->displacement[a][block->cell];
        for (int k = 0; k < PDMC_LANES; k++)
            if (full || block->occupied >> k & 1) u[k] = (float)((x[k] - first[k]) * per_unit);
    }
}

/// What the kernel found for the next step becomes the nodes' s_0.
void pdmc_single_strengthen(pdmc_single *single);
