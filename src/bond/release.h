// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bond/bond.h"

/// The derivative of ln G of a tip to the stiffness at every node, at the mean. G is the energy that the plate gives up when
/// the tip moves from one spacing before its place to one beyond, and the derivative of its potential energy Pi to the
/// stiffness of a node is the strain energy of the node, half of every bond's:
///     d ln G / d M_i = (e_i(longer) - e_i(shorter)) / (Pi(longer) - Pi(shorter)),   e_i = 1/2 E_i(u, u),
/// exactly, with the fields of the mean alone. Under tractions they sum to -1. All are 0 where no energy is released.
/// @param[in]  number       of the tip: 2 crack for "from", 2 crack + 1 for "to"
/// @param[out] sensitivity  [nodes]
/// @return that of pdmc_bond_create()
PDMC_NODISCARD pdmc_status pdmc_bond_release(const pdmc_bond *bond, int number, double sensitivity[]);

/// Weights of the average M_tip of the stiffness that a tip feels: the one with which G = (K_I^2 + K_II^2) / (E' M_tip),
/// K = M_tip row . x, has the derivatives of the release. The rows' own are those of the adjoint problem, d (row . x) =
/// -sum_i dM_i E_i(K_0^-1 row, x).
/// @param[in]  release  [nodes]
/// @param[in]  row      [2, unknowns] of K_I and K_II of the tip
/// @param[out] weight   [nodes]
/// @return PDMC_OK, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status pdmc_bond_tip_weights(const pdmc_bond *bond, const double release[], const double row[],
                                                 double weight[]);
