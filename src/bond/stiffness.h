// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bond/grid.h"
#include "sparse/matrix.h"

/// What a grid of bonds is made of.
typedef struct {
    pdmc_bond_grid grid;
    pdmc_bond_horizon horizon;
    pdmc_bond_families families;
} pdmc_bond_plate;

/// Y = K X for PDMC_BLOCK columns, K = h^2 L with the sign that makes it positive: force / thickness of the free
/// unknowns, and 0 of the held ones, whose displacement in X counts. The columns are independent and each sum has a
/// fixed order.
/// @param[in]  threads  >= 1; one is used where the call itself is made by one of several threads
/// @param[in]  factor  [PDMC_BLOCK, shells] of each shell's mean stiffness
/// @param[in]  x       [PDMC_BLOCK, unknowns]
/// @param[out] y       [PDMC_BLOCK, unknowns]
/// @return PDMC_OK or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_bond_multiply(const pdmc_bond_plate *plate, int threads, const double factor[],
                                              const double x[], double y[]);

/// u_i' K_m v_j of every shell m at its mean stiffness, in one pass over the bonds. Held unknowns of v do not count.
/// @param[in]  u    [u_count, unknowns]
/// @param[in]  v    [v_count, unknowns]
/// @param[out] out  [shells, u_count, v_count]
/// @return PDMC_OK or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_bond_shell_project(const pdmc_bond_plate *plate, int threads, int u_count,
                                                   const double u[], int v_count, const double v[], double out[]);

/// What the mean stiffness of a bond is multiplied by: shell[m] + (node[i] + node[j]) / 2.
typedef struct {
    const double *shell; // [shells]
    const double *node;  // [nodes], or NULL for 0
} pdmc_bond_moduli;

/// The lower triangle of K for moduli of the bonds; held unknowns have a 1 on the diagonal and nothing else, and what they do to
/// the free ones is left to pdmc_bond_multiply().
/// @param[out] out  free with pdmc_sparse_matrix_clear(); zero on failure
PDMC_NODISCARD pdmc_status pdmc_bond_matrix_create(const pdmc_bond_plate *plate, const pdmc_bond_moduli *moduli,
                                                   pdmc_sparse_matrix *out);
/// New values on the same pattern.
void pdmc_bond_matrix_fill(const pdmc_bond_plate *plate, const pdmc_bond_moduli *moduli, pdmc_sparse_matrix *matrix);
