// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The sparse system of all nodes.

#include "visible/visible_impl.h"

/// out = plane p of K times u.
/// @param[in]  u    [unknowns]
/// @param[out] out  [unknowns]
void pdmc_visible_product(const pdmc_visible *visible, int plane, const double u[], double out[]);

/// Factors K(xi). Where rigid motions are free, each brings a multiplier: a body force that takes up what the
/// collocation leaves of the loads' resultant, and a row that fixes the mean of the motion over the ghosts.
/// @param[in]  xi      [terms], or NULL for the mean
/// @param[out] factor  free with pdmc_factor_clear(); zero on failure
PDMC_NODISCARD pdmc_status pdmc_visible_factor(const pdmc_visible *visible, const double xi[], pdmc_factor *factor);

/// The displacements that belong to a right-hand side.
/// @param[in]  load  [unknowns]
/// @param[out] u     [unknowns]
PDMC_NODISCARD pdmc_status pdmc_visible_solve(const pdmc_visible *visible, const pdmc_factor *factor,
                                              const double load[], double u[]);
