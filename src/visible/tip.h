// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "visible/visible_impl.h"

/// K_I and K_II of a tip as functionals of the nodes' displacements, at the mean effective modulus.
///
/// The interaction integral on a circle round the tip, of radius a, half the crack's length, or 2 horizons if that is
/// more: there the field is that of local elasticity, while at the tip itself it has no singularity. K_I exceeds the
/// local limit by 0.25, 0.75 and 2 % at delta / a = 0.1, 0.3 and 0.6, whatever the radius to 0.3 % (0.5 % at 0.6). K_II
/// is not known as well, since the circle ends in the layers of the faces, where bonds carry shear: at delta / a = 0.3
/// it exceeds the local limit by 2.6, 2.1 and 1.0 % on radii of 0.75, 1 and 1.5 a. Openings behind the tip would give
/// too much: at a distance of a / 5 they exceed the local limit by 5.6 %.
/// @param[out] row_1, row_2  [unknowns] zero on entry
/// @return PDMC_OK, PDMC_ERR_SINGULAR, or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_visible_stress_intensity_rows(const pdmc_visible *visible, int tip, double row_1[],
                                                              double row_2[]);
