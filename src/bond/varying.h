// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bond/bond.h"

/// What the samples of an affine model are solved with.
typedef struct {
    const pdmc_bond *bond;
    const pdmc_bond_stiffness *stiffness; // NULL where it is the same everywhere
} pdmc_bond_operator;

/// Sets the stiffness that the tips feel, and that of the energy's bonds in each direction: its average over the bonds that
/// cross there, weighted by their energies at the mean, with which the energy is right to first order.
/// @param[in,out] model  with its crossings and rows of stress intensities
PDMC_NODISCARD pdmc_status pdmc_bond_fill_local_stiffness(const pdmc_bond *bond, const pdmc_bond_stiffness *stiffness,
                                                          pdmc_affine *model);

/// The verb `coercivity`: a bond has at least the least of the nodes' factors, and at least that of its shell.
PDMC_NODISCARD pdmc_status pdmc_bond_coercivity(const pdmc_affine *model, const double xi[], double alpha[]);
