// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/base_impl.h"
#include "pdmc/problem.h"

/// The bond of a node to a neighbour on an unbounded grid; that of the opposite neighbour is its mirror image.
typedef struct {
    int column, row;     // of the neighbour, counted from the node
    double direction[2]; // e
    double length;       // |xi|, to the node
    double area;         // of the cell as it counts, length^2
    double stiffness;    // b = stiffness e e . (u' - u), force / length^4
    int shell;           // of the bonds that symmetry makes equal
} pdmc_bond_neighbour;

/// All bonds of a node inside the horizon. The force density of a node is
///     L u (x) = sum_k c_k area_k e_k e_k . (u(x_k) - u(x)) / |xi_k|,
/// the midpoint rule of Silling & Askari 2005, eq. 36, with the areas of pdmc_bond_area, and c_k the micromodulus of
/// the shell. Cells count in full, where the node is inside; in part, min(1, 1/2 + (delta - |xi|) / h) of them, those
/// whose node is outside included (Yu 2011, eq. 2.16, but there nodes end at |xi| = delta, and so every horizon is too
/// small); or by the exact area inside. With centroids the energy of a bond at stretch s is c s^2 / 2 times the
/// distance of the centroid of that part, instead of |xi|. Its direction is that of the node all the same, whose
/// displacement it has: otherwise a rotation would cost energy.
/// In a sample the stiffness of a shell is (1 + sum_bins eta_bin share[bin][shell]) times its mean, eta the relative
/// deviations of c(r) in equal bins of [0, horizon]: the share of each bin in the part of the cell inside the horizon,
/// or 1 in the bin of the node. Of a cell that counts in full, the part beyond the horizon is in the last bin, as is a
/// node beyond it.
typedef struct {
    int count;
    pdmc_bond_neighbour *neighbour; // [count] by row, then column; count - 1 - k is opposite to k
    int shells;
    double *shell_length; // [shells] ascending, length
    int bins;
    double *share; // [bins, shells] summing to 1 over the bins
} pdmc_bond_horizon;

/// @param[in]  bins  >= 1
/// @param[out] out   free with pdmc_bond_horizon_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_ARG for no bins or more than 100 spacings a horizon, or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_bond_horizon_create(const pdmc_problem *problem, int bins, pdmc_bond_horizon *out);

/// A zeroed horizon is allowed.
void pdmc_bond_horizon_clear(pdmc_bond_horizon *horizon);
