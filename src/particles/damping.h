// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Linear viscous damping (Yu, Kansas State University 2011, eq. 3.63-3.65): of the nodes' own velocities, and of those by
/// which the ends of whole bonds part.

#include "particles/variation.h"

typedef struct {
    double absolute, relative; // C, c_v
    double *force[PDMC_AXES];  // [cells] on a unit of volume; NULL without damping
    double *share;             // [blocks] room for sums
    double dissipated, after;  // until half a step after the time; what is after the time of it
} pdmc_damping;

/// What moves.
typedef struct {
    const pdmc_nodes *nodes;
    const pdmc_brittle_law *laws;         // [materials]
    const pdmc_variation *variation;
    const double *density;             // [materials]
    const double *position[PDMC_AXES]; // [cells]
    const double *velocity[PDMC_AXES]; // [cells]
    int threads;
} pdmc_motion_of_nodes;

/// @param[out] damping  clear with pdmc_damping_clear(), whatever is returned
PDMC_NODISCARD pdmc_status pdmc_damping_create(const pdmc_particles_options *options, const pdmc_nodes *nodes,
                                               pdmc_damping *damping);
void pdmc_damping_clear(pdmc_damping *damping);
bool pdmc_damping_is_on(const pdmc_damping *damping);

/// The damping forces. A node's own velocity is the one at the time, v + duration f / rho with f the whole force, so that
/// the formula is of second order and stable for any C; that of bonds is v as it is.
/// @param[in] force     [cells] of every axis, all others on a unit of volume
/// @param[in] duration  from the velocities to the time
void pdmc_damping_find(const pdmc_damping *damping, const pdmc_motion_of_nodes *motion, double *const force[PDMC_AXES],
                       double duration);

/// force += sign times the damping forces. @param[in,out] force  [cells] of every axis
void pdmc_damping_add(const pdmc_damping *damping, const pdmc_motion_of_nodes *motion, double sign,
                      double *const force[PDMC_AXES]);

/// Puts the damping right where the motion is prescribed, after pdmc_damping_find() and pdmc_damping_add() for the middle of
/// a step: what the node's own velocity is was not yet known there.
/// @param[in]     before after  velocity half a step before and after the time
/// @param[in,out] force         all forces on the node along the axis, damping included
void pdmc_damping_correct(const pdmc_damping *damping, size_t cell, int axis, double density, double step,
                          double before, double after, double *force);

/// Counts what the damping forces take from half a step before the time, at the velocities there, to half a step after it. @param[in] force  [cells] of every axis: all of them, damping included
void pdmc_damping_count(pdmc_damping *damping, const pdmc_motion_of_nodes *motion, double *const force[PDMC_AXES],
                        double step);

/// The largest stable step with the damping of bonds, from the one without it and B = 2 c c_v sum_p V_p / rho.
double pdmc_damping_stable_step(double undamped, double rate);
