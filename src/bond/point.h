// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bond/stiffness.h"

enum { PDMC_BOND_POINT_NODES = 64 };

/// The field at a point from the nodes around it: the polynomial of degree 2, or 1 where there are few nodes, that fits
/// those within 2.6 spacings that no crack hides from the anchor, weighted by (1 - d^2 / R^2)^2 of the distance d.
typedef struct {
    int count;
    int node[PDMC_BOND_POINT_NODES];
    double value[PDMC_BOND_POINT_NODES];                             // of u(x) = sum_k value[k] u_k
    double by_x[PDMC_BOND_POINT_NODES], by_y[PDMC_BOND_POINT_NODES]; // of its gradient, 1 / length
} pdmc_bond_point;

/// @param[in] anchor  on the side of a crack that is meant; x where there is no doubt
/// @return PDMC_OK, PDMC_ERR_SINGULAR where fewer than three nodes are seen, or PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status pdmc_bond_point_at(const pdmc_problem *problem, const pdmc_bond_grid *grid,
                                              const double x[2], const double anchor[2], pdmc_bond_point *out);
