// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bond/bond.h"

/// K_I and K_II of a tip by the interaction integral on a circle of half a horizon, for a stiffness that varies in space: it
/// varies little inside the circle, so that an average of it tells what the tip feels. There the field is not that of local
/// elasticity, but that of the tip still: combinations of the two integrals are K_I and K_II as the circle beyond the
/// horizon has them, exactly of two states that are solved for, one pulled apart across the crack and one
/// sheared; and then in size of the mean.
/// @param[in]     far   [2, unknowns] of pdmc_bond_stress_intensity_rows()
/// @param[in,out] near  [2, unknowns] zero on entry
/// @return PDMC_OK, PDMC_ERR_SINGULAR, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status pdmc_bond_near_rows(const pdmc_bond *bond, int tip, const double far[], double near[]);
