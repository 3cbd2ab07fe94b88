// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Layers of nodes in which forces or the motion are prescribed.

#include "particles/damping.h"

typedef struct {
    pdmc_layer_condition condition; // with a history of its own
    double *time, *factor;          // of that
    int count;
    size_t *cell;              // [count] nodes of the layer
    double *density;           // [count] rho
    double exerted[PDMC_AXES]; // the whole force of the condition on its nodes when it last acted
} pdmc_layer;

/// The nodes' motion at a time t between two steps.
typedef struct {
    double time, step;
    const double *position[PDMC_AXES]; // [cells] at t
    const double *velocity[PDMC_AXES]; // [cells] at t - step / 2
    double *force[PDMC_AXES];          // [cells] at t, on a unit of volume
    const pdmc_damping *damping;
} pdmc_layer_motion;

/// Work from t - step / 2 to t, and from t to t + step / 2: what a force does at the velocities on either side, so that with
/// a kinetic energy of the product of both the sum of energies is that of a linear system to rounding.
typedef struct {
    double before, after;
} pdmc_step_work;

/// @param[in]  density  [materials] rho
/// @param[out] layer    clear with pdmc_layer_clear(), whatever is returned
/// @return PDMC_OK or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_layer_create(const pdmc_layer_condition *condition, const pdmc_nodes *nodes,
                                             const double density[], pdmc_layer *layer);
void pdmc_layer_clear(pdmc_layer *layer);

/// Whether the condition is of the motion, and not a force.
bool pdmc_layer_holds(const pdmc_layer *layer);

/// What is prescribed at the layer's k-th node along an axis, at the time of a factor of the history.
double pdmc_layer_value(const pdmc_layer *layer, const pdmc_nodes *nodes, int k, int axis, double factor);
double pdmc_layer_factor(const pdmc_layer *layer, double time);

/// Adds the prescribed forces.
void pdmc_layer_push(pdmc_layer *layer, const pdmc_nodes *nodes, const pdmc_layer_motion *motion);

/// Sets the forces to what makes the velocities those prescribed at t + step / 2, or those that lead to the displacements
/// prescribed at t + step.
/// @return the work of the condition, where no later condition is of the same motion
pdmc_step_work pdmc_layer_hold(pdmc_layer *layer, const pdmc_nodes *nodes, const pdmc_layer_motion *motion);

/// The work of prescribed forces over the same time, when all forces are known.
pdmc_step_work pdmc_layer_work(const pdmc_layer *layer, const pdmc_nodes *nodes, const pdmc_layer_motion *motion);
