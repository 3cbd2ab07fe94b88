// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bond/stiffness.h"

/// A stiffness that varies from node to node. A bond has the mean of its two nodes' factors f on top of its own stiffness k
/// (arithmetic pairing, the one that is linear in f),
///     (K_f u)_i = sum_j k_ij (f_i + f_j) / 2 e e . (u_i - u_j),
/// and so v' K_f u = sum_i f_i E_i(u, v), with the energies
///     E_i(u, v) = 1/2 sum_j k_ij (e . (u_i - u_j)) (e . (v_i - v_j)).

/// Y = K_f X for PDMC_BLOCK columns, f = mean + sum_k xi_k psi_k in each column; otherwise as pdmc_bond_multiply().
/// @param[in]  psi     [nodes, terms]
/// @param[in]  stride  of xi, >= terms
/// @param[in]  xi      [PDMC_BLOCK, stride] of which the first `terms` of a column count
/// @return PDMC_OK or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_bond_nodal_multiply(const pdmc_bond_plate *plate, int threads, int terms,
                                                    const double psi[], double mean, int stride, const double xi[],
                                                    const double x[], double y[]);

/// u_i' K_f v_j with f = psi_k, for every term k and all pairs of vectors, whose held unknowns count.
/// @param[in]  psi  [nodes, terms]
/// @param[in]  u    [u_count, unknowns]
/// @param[in]  v    [v_count, unknowns]
/// @param[out] out  [terms, u_count, v_count]
/// @return PDMC_OK or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_bond_nodal_project(const pdmc_bond_plate *plate, int threads, int terms,
                                                   const double psi[], int u_count, const double u[], int v_count,
                                                   const double v[], double out[]);

/// E_i(u, v) of every node.
/// @param[in]  u, v    [unknowns]
/// @param[out] energy  [nodes]
void pdmc_bond_nodal_energy(const pdmc_bond_plate *plate, const double u[], const double v[], double energy[]);
