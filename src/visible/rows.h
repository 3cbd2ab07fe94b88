// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Rows of the collocation system, as blocks of the nodes' displacements.

#include "visible/visible_impl.h"

enum { PDMC_VISIBLE_DEGREE = 10 }; // of the expansion of c(r) in Legendre polynomials

/// Scratch for sums over a disc, for one thread: D = int int f e e^T dr dtheta and int int f e e^T u(x + r e) dr dtheta
/// as sum_k B_k u_k + known, f = 1 in plane 0, P_p(2 r / delta - 1) in plane 1 + p. Blocks are symmetric: xx, xy, yy.
typedef struct {
    const pdmc_visible *visible;
    int planes;
    pdmc_disc_rule rule;
    int *place;       // [nodes] 1 + where in the list, 0 if not
    int count;        // of nodes in the list
    int *list;        // [nodes]
    double *sum;      // [nodes of the list, planes, 3] B
    double *diagonal; // [planes, 3] D
    double known[2];  // from displacements that are prescribed outside the plate
    pdmc_status status;
} pdmc_disc_sum;

/// @param[in] fine  the rule for single points, where the sum is not one row among many
PDMC_NODISCARD pdmc_status pdmc_disc_sum_create(const pdmc_visible *visible, int planes, bool fine, pdmc_disc_sum *sum);
void pdmc_disc_sum_clear(pdmc_disc_sum *sum);

/// Replaces what the sum holds by the disc round a view.
PDMC_NODISCARD pdmc_status pdmc_disc_sum_take(pdmc_disc_sum *sum, const pdmc_view *centre);

/// The equations of a node of the plate, c_0 h (D u - int int e e^T u), and their right-hand side.
PDMC_NODISCARD pdmc_status pdmc_visible_force_row(pdmc_disc_sum *sum, int node, pdmc_block_row *row, double load[2]);

/// An empty row of `count` blocks in each plane; free with pdmc_block_row_clear(), after a failure as well.
PDMC_NODISCARD pdmc_status pdmc_block_row_create(int planes, int count, pdmc_block_row *row);
void pdmc_block_row_clear(pdmc_block_row *row);
