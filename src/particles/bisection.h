// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// An order of points in which those that follow one another are near one another in space.

#include "pdmc/particles.h"

/// Recursive coordinate bisection (Berger & Bokhari, IEEE Transactions on Computers 36 (1987) 570-580): the points' box is
/// halved across its longest side, at a whole number of groups, until each group of `size` points is alone. The groups, all
/// full but the last, are about as wide as high, and so are groups of groups: the order fills space as Hilbert's curve does.
/// @param[in]     x      [points] of every axis
/// @param[in,out] order  [count] points
/// @return PDMC_OK or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_bisect(const double *const x[PDMC_AXES], int count, int size, int order[]);
