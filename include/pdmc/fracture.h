// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What belongs to a crack's tip whatever the discretisation.

#include "pdmc/problem.h"
#include "pdmc/quadrature.h"

/// The bonds that cross a potential fracture line at one point: quadrature points of
///     G_E(phi) = 1/2 int_0^delta dr int_0^pi dtheta int_0^1 dlambda r sin(theta) c(r)
///                [e . (u(x_t + (1 - lambda) r e) - u(x_t - lambda r e))]^2,   e at angle phi + theta,
/// the symmetric form of Evangelatos & Spanos 2011, eq. 45 (which is one-sided in print and has lost the factor c / 2
/// of eq. 42). For a uniform stretch s it is c s^2 delta^4 / 4.
typedef struct {
    double start[2], end[2]; // length
    double direction[2];     // e
    double weight;           // of sin(theta) dtheta dlambda
    int ring;                // index of the radius r
} pdmc_crossing_bond;

enum { PDMC_CROSSING_RINGS = 8, PDMC_CROSSING_BONDS = 8 * 8 * 16 };

/// Points of the Gauss rule over a line of growth, where the bonds that cross it anywhere are counted.
enum { PDMC_LINE_POINTS = 4 };

/// Bonds that an existing crack cuts, or that end outside the plate, are left out.
/// @param[in]  x_t    the point, length
/// @param[in]  phi    direction of the fracture line
/// @param[in]  rings  PDMC_CROSSING_RINGS radii of power 3
/// @param[out] count  number of bonds, <= PDMC_CROSSING_BONDS
/// @param[out] bonds  [PDMC_CROSSING_BONDS] in the order of their rings
/// @return PDMC_OK, PDMC_ERR_ARG, or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_crossing_bonds(const pdmc_problem *problem, const double x_t[2], double phi,
                                                        const pdmc_ring_rule *rings, int *count,
                                                        pdmc_crossing_bond bonds[]);

/// F of k = F K, the stress intensity factors at the tip of a vanishing kink.
///
/// Amestoy & Leblond, Int. J. Solids Struct. 29 (1992) 465-501: expansions to the 20th power of kink / pi, used up to
/// +-2 pi / 3. Beyond that they are of no use, and Nuismer's first approximation (Int. J. Fract. 11 (1975) 245-250),
/// scaled to be continuous, takes F to 0 at +-pi; growth into such directions is never decisive.
/// @param[in]  kink  angle from straight-ahead growth, reduced to [-pi, pi]
/// @param[out] F     [2, 2]
PDMC_API void pdmc_kink_factors(double kink, double F[4]);

/// k = F(kink) K.
/// @param[in]  K  [2] K_I, K_II
/// @param[out] k  [2] k_I, k_II
PDMC_API void pdmc_kinked_stress_intensity(double kink, const double K[2], double k[2]);

/// Griffith's energy release rate of a vanishing kink, (max(k_I, 0)^2 + k_II^2) / E': a kink that is pressed shut
/// releases nothing by k_I. Where K_I itself is negative the faces of the crack are in contact, which the model does
/// not know.
/// @param[in] plane_modulus  E' = E in plane stress, E / (1 - nu^2) in plane strain, force / length^2
/// @return force / length
PDMC_API double pdmc_griffith_energy(double kink, const double K[2], double plane_modulus);

/// The angle of maximum tangential stress (Erdogan & Sih 1963), the usual estimate of the direction of growth.
PDMC_API double pdmc_tangential_stress_direction(const double K[2]);
