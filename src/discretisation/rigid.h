// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Rigid motions that the supports leave free, for methods whose unknowns 2 k and 2 k + 1 are u and v of point k.

#include "pdmc/problem.h"

enum { PDMC_RIGID_CANDIDATES = 4 };

/// Holds as many unknowns as there are rigid motions that nothing else holds, at points where they stop them best. The
/// loads are in equilibrium, so that it takes no force to hold them.
/// @param[in]     x          [points, 2]
/// @param[in]     candidate  points that may be held, far from each other
/// @param[in,out] held       [points] bits: 1 where u is held, 2 where v is
/// @return PDMC_OK or PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status pdmc_rigid_hold(const pdmc_problem *problem, const double x[],
                                           const int candidate[PDMC_RIGID_CANDIDATES], uint8_t held[]);

/// Takes out of a solution the rigid motions that nothing holds: their mean over some points becomes zero.
/// @param[in]     x     [points, 2]
/// @param[in]     some  [points] 1 for those that the mean is over
/// @param[in,out] u     [points, 2]
/// @return PDMC_OK or PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status pdmc_rigid_take_out(const pdmc_problem *problem, int points, const double x[],
                                               const uint8_t some[], double u[]);
