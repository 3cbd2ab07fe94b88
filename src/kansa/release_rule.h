// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kansa/kansa_impl.h"

/// A tip that moves along its crack, and the part of the plate that moves with it: all of it up to `inner`, none beyond
/// `outer`.
typedef struct {
    double at[2], along[2]; // the unit vector of its growth
    double room;            // distance to the other tip, the nearest side and the nearest crack
    double inner, outer;    // of what moves, parts of it
} pdmc_moving_tip;

/// @param[in] tip  number of the tip in the problem's request
pdmc_moving_tip pdmc_moving_tip_of(const pdmc_problem *problem, int tip);

/// q, 1 near the tip and 0 far from it with one continuous derivative, and its derivative along the crack.
double pdmc_moving_tip_velocity(const pdmc_moving_tip *tip, const double x[2], double *derivative);

/// A rule over the plate that resolves derivatives of energies to the tip's position, which go with r^-2 and cancel over
/// the circle: rings of Gauss points round the tip, graded to it, and that of the weak form elsewhere, with a smooth share
/// of each in between.
/// @param[in]  length  on which the stiffness varies: its correlation length
/// @param[out] rule    free with pdmc_area_rule_clear()
PDMC_NODISCARD pdmc_status pdmc_release_rule(const pdmc_kansa *kansa, const pdmc_moving_tip *tip, double length,
                                             pdmc_area_rule *rule);
