// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bond/bond.h"

/// The energy release rate on a grid: the energy of the bonds that cross the straight line from the tip to its extension
/// delta_alpha (cos phi, sin phi), for a unit of its length,
///     G_E(phi) = 1 / (delta_alpha R(phi)) sum_bonds w 1/2 c area h^2 [e . (u' - u)]^2 / |xi|,
/// w the share of a strip about the line, one spacing h wide, that the bond crosses between the strip's ends: the mean of
/// the indicator of crossing over the line's shifts across itself. It makes G_E smooth in phi, and does not let the line
/// begin behind the tip. The rows of a bond give its term as a square.
///
/// R(phi) is what a uniform isotropic stretch s gives on an unbounded grid, averaged over all places of the line, in units
/// of G_0 = c s^2 delta^4 / 4: the bias of the grid with the direction, which it takes out.
/// @param[in,out] crossing  its arrays belong to the model
PDMC_NODISCARD pdmc_status pdmc_bond_crossing_create(const pdmc_bond *bond, int tip, double phi,
                                                     pdmc_crossing *crossing);

/// R(phi).
double pdmc_bond_crossing_bias(const pdmc_problem *problem, const pdmc_bond_horizon *horizon, double phi);
