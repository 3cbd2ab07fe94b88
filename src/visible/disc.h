// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Quadrature over the part of a disc that is visible from its centre,
///     int dtheta int dr f(r, theta), 0 < r < min(radius, distance to the first crack).

#include "visible/view.h"

/// A point of the rule: y = x + r (cosine, sine).
typedef struct {
    double y[2], r, cosine, sine;
    double weight; // of dr dtheta, length
} pdmc_disc_point;

typedef void (*pdmc_disc_visitor)(void *context, const pdmc_disc_point *point);

/// Panels of theta every 30 degrees, with breaks at tips and where a crack leaves the disc, and halved again and again
/// towards tips and towards the directions of a crack, where the field changes within a small angle; r ends at a crack,
/// and is split at the distance of a tip that is seen close to its direction.
typedef struct {
    const pdmc_cuts *cuts;
    const pdmc_plate *edge; // where not NULL, r is split at the plate's edge too
    double radius;
    int radial_points, angular_points; // Gauss points of a panel
    double *node_r, *weight_r;         // [radial_points] on [0, 1]
    double *node_t, *weight_t;         // [angular_points] on [0, 1]
    double *breaks;                    // scratch of visits, for one thread
    double *splits;
} pdmc_disc_rule;

/// @param[out] rule  for one thread; free with pdmc_disc_rule_clear(); zero on failure
PDMC_NODISCARD pdmc_status pdmc_disc_rule_create(const pdmc_cuts *cuts, const pdmc_plate *edge, double radius,
                                                 int radial_points, int angular_points, pdmc_disc_rule *rule);
void pdmc_disc_rule_clear(pdmc_disc_rule *rule);

/// Calls `visit` for every point of the disc round a view; from a face the half disc on its side.
void pdmc_disc_visit(pdmc_disc_rule *rule, const pdmc_view *centre, pdmc_disc_visitor visit, void *context);
