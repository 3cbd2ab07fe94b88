// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What a region of straight edges gives to a point at the origin through bonds of unit micromodulus, which pull with
/// r^-3 xi xi^T (u' - u) for each area: the moments of r^-3.
typedef struct {
    double second[3], third[4], fourth[5]; // int r^-3 x^(m - k) y^k, k = 0 .. m, of degree m: length^(m - 1)
} pdmc_bond_moments;

enum { PDMC_POLYGON_CORNERS = 64 }; // three, and two more for every crack that hides a part of a triangle

/// Adds the moments of a polygon's parts in equal bins of [0, horizon] of the radius. By the edges: each has a wedge with the
/// origin, counted with the sign of its turn. Up to the edge the integral is one of s^k / r^3 along it, beyond a circle one
/// over the angle; both are in closed form.
/// @param[in]     corner   [corners] counter-clockwise
/// @param[in,out] moments  [bins]
void pdmc_polygon_bond_moments(double horizon, int bins, int corners, double corner[][2], pdmc_bond_moments moments[]);
