// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The displacement beyond the sides of the plate: the equations of the ghosts.
///
/// The disc of a node near a side is full, and u goes on outside as an even function with the slope that the side's
/// tractions give it,
///     u(foot + k d) = u(foot - k d) + k (u(foot + d) - u(foot - d)),   sigma(u) n = t at the foot,
/// d the step from one ghost of a column to the next. The slope takes up the derivative along the side; a wave along it
/// shorter than the horizon would come back from outside larger than it is, and the system have eigenvalues in the left
/// half plane. So that derivative is that of a cubic fitted to the nodes within 1.5 horizons, which such waves hardly
/// move.

#include "visible/rows.h"

/// The equations of a ghost next to a side: the side's tractions, or displacements times E / h where they are held.
/// Tractions scale with the effective modulus, to which each plane has its share. The derivative along d is
/// (2 u_1 + 3 u_0 - 6 u_-1 + u_-2) / 6, of the ghost, the foot and two places inside the plate.
/// @param[out] row   free with pdmc_block_row_clear()
/// @param[out] held  [2] right-hand sides of prescribed displacements, 0 where the side is free
/// @return PDMC_OK, PDMC_ERR_SINGULAR, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status pdmc_visible_edge_row(const pdmc_visible *visible, int ghost, pdmc_block_row *row,
                                                 double held[2]);

/// The right-hand sides of the same equations for a case of the loads, 0 where the side is held.
void pdmc_visible_edge_load(const pdmc_visible *visible, int ghost, int index, double load[2]);

/// The equations of a ghost farther out, as above, times E / h; linear from the foot on where a crack hides the place
/// inside.
PDMC_NODISCARD pdmc_status pdmc_visible_extension_row(const pdmc_visible *visible, int ghost, pdmc_block_row *row);

/// The share of P_p(2 r / delta - 1) in the effective modulus, 3 int_0^1 s^2 P_p(2 s - 1) ds.
double pdmc_visible_share(int p);
