// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bond/stiffness.h"

/// An order of the unknowns in which the stiffness has a sparse factor: nested dissection (George, SIAM J. Numer. Anal. 10
/// (1973) 345-363). A strip of nodes as wide as the longest bond is taken out of the middle of the grid and comes last, after
/// the two parts that no bond connects any more, which are halved in their turn.
/// @param[out] order  [unknowns] the unknown that comes first, second, ...
void pdmc_bond_dissection(const pdmc_bond_plate *plate, int64_t order[]);
