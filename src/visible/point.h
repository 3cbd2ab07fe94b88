// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The displacement at a point as a functional of the nodes' displacements.

#include "visible/rows.h"

/// u(x) = sum_k block_k u_k + known: by the stencil of the nearest visible node, and on a face by the equation itself.
/// @param[in]  sum    a fine one
/// @param[out] row    one plane; free with pdmc_block_row_clear(); zero on failure
/// @param[out] known  [2]
PDMC_NODISCARD pdmc_status pdmc_visible_point(pdmc_disc_sum *sum, const pdmc_view *view, pdmc_block_row *row,
                                              double known[2]);

/// Applies a row to displacements of the nodes.
/// @param[in]     u      [unknowns]
/// @param[in,out] value  [2] added to
void pdmc_block_row_apply(const pdmc_block_row *row, const double u[], double value[2]);
