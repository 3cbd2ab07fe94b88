// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Stress intensity factors by the interaction integral, for any method that gives the gradient of its displacement as
/// functionals of its nodes.
///
/// On a circle of radius r round the tip, with its outward normal n and with x straight ahead,
///     K = E' / 2 int [sigma(u) : grad a n_x - (sigma(u) n) . a_x - (sigma(a) n) . u_x] r dtheta,
/// a the field of a crack in an infinite plane with K_I = 1 or K_II = 1, E' the modulus of plane problems (Yau, Wang &
/// Corten, J. Appl. Mech. 47 (1980) 335-341). Hooke's law of a bond-based material, lambda = mu.

#include "pdmc/problem.h"

/// A tip: the direction is straight ahead, away from its crack.
typedef struct {
    double position[2]; // length
    double cosine, sine;
} pdmc_tip_frame;

/// The gradient of the displacement at a point, d u / dx = sum_k by_x[k] u_k, d u / dy = sum_k by_y[k] u_k over `count`
/// nodes. A point on the line of a crack is never asked for.
typedef struct {
    int most_nodes; // the largest count
    const void *method;
    /// @param[out] count         of nodes
    /// @param[out] node          [count]
    /// @param[out] by_x, by_y    [count] 1 / length
    pdmc_status (*gradient)(const void *method, const double x[2], int *count, int node[], double by_x[],
                            double by_y[]);
} pdmc_gradient_functional;

/// @param[in] tip  2 * crack for "from", 2 * crack + 1 for "to"
pdmc_tip_frame pdmc_tip_frame_of(const pdmc_problem *problem, int tip);

/// The largest radius up to `wanted` of a circle round a tip that is clear of the sides, of the other cracks and of the
/// crack's other end: at most 0.8 of the distance to the nearest of them.
double pdmc_interaction_radius(const pdmc_problem *problem, int tip, double wanted);

/// K_I and K_II of a tip as functionals of the nodes' displacements, u_0, v_0, u_1, v_1, ..
/// @param[in]     radius        of the circle
/// @param[in,out] row_1, row_2  [2 nodes] added to
/// @return PDMC_OK, PDMC_ERR_NOMEM, or the failure of gradient()
PDMC_NODISCARD pdmc_status pdmc_interaction_rows(const pdmc_problem *problem, int tip, double radius,
                                                 const pdmc_gradient_functional *functional, double row_1[],
                                                 double row_2[]);
