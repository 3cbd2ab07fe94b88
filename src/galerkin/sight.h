// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "galerkin/bond_moments.h"
#include "pdmc/problem.h"

/// The cracks near a point, relative to it; the point sees each turn counter-clockwise from end[0] to end[1].
typedef struct {
    int count;
    double end[PDMC_GALERKIN_CRACKS][2][2];
} pdmc_sight;

/// @param[in] reach  of the bonds
/// @param[in] count  of cracks, <= PDMC_GALERKIN_CRACKS
pdmc_sight pdmc_sight_from(const double x[2], double reach, int count, const pdmc_crack cracks[]);

/// Adds the moments of the part of a triangle that the point sees: bonds that a crack crosses are broken. No crack may pass
/// through the triangle, so that what a crack hides of it is a range of angles: its corners are clipped by the directions
/// of the crack's ends.
/// @param[in]     corner   relative to the point, counter-clockwise
/// @param[in,out] moments  [bins] of pdmc_polygon_bond_moments()
void pdmc_sight_moments(const pdmc_sight *sight, double horizon, int bins, double corner[3][2],
                        pdmc_bond_moments moments[]);
