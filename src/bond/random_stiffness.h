// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bond/bond.h"

/// The problem's random stiffness on a grid.
typedef struct {
    pdmc_field *field; // NULL where the stiffness is certain
    pdmc_bond_stiffness stiffness;
} pdmc_bond_random_stiffness;

/// Makes the field, whose modes begin with those that the energies at the tips depend on, and its terms at the nodes; those
/// of the layer beyond a held side have the values of the nearest point of the plate.
/// @param[out] out  free with pdmc_bond_random_stiffness_clear(); zero where the problem has none, and on failure
/// @return PDMC_OK, that of pdmc_bond_create(), or that of pdmc_field_create()
PDMC_NODISCARD pdmc_status pdmc_bond_random_stiffness_create(const pdmc_bond *bond, pdmc_bond_random_stiffness *out);

/// A zeroed one is allowed.
void pdmc_bond_random_stiffness_clear(pdmc_bond_random_stiffness *random);
