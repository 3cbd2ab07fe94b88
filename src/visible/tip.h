// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "visible/visible_impl.h"

/// K_I and K_II of a tip as functionals of the nodes' displacements, at the mean effective modulus.
///
/// The interaction integral with the fields of K_I = 1 and of K_II = 1 (Yau, Wang & Corten, J. Appl. Mech. 47 (1980)
/// 335-341) on a circle round the tip, of radius 3/4 of the crack's half length or 2 horizons if that is more: there the
/// field is that of local elasticity, while at the tip itself it has no singularity. It does not depend on the radius to
/// 0.3 % (0.5 % at delta / a = 0.6), and exceeds the local limit by 0.2, 0.7 and 2 % at delta / a = 0.1, 0.3 and 0.6. Openings behind the tip would
/// give too much: at a distance of a / 5 they exceed the local limit by 5.6 % at delta / a = 0.3.
/// @param[out] row_1, row_2  [unknowns] zero on entry
/// @return PDMC_OK, PDMC_ERR_SINGULAR, or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_visible_stress_intensity_rows(const pdmc_visible *visible, int tip, double row_1[],
                                                              double row_2[]);
