// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Layers of nodes in which forces or velocities are prescribed.

#include "particles/lattice.h"

typedef struct {
    pdmc_layer_condition condition; // with a history of its own
    double *time, *factor;          // of that
    int count;
    size_t *cell;    // [count] nodes of the layer
    double *density; // [count] rho
} pdmc_layer;

/// @param[in]  density  [materials] rho
/// @param[out] layer    clear with pdmc_layer_clear(), whatever is returned
/// @return PDMC_OK; PDMC_ERR_ARG where the layer holds no node; PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_layer_create(const pdmc_layer_condition *condition, const pdmc_lattice *lattice,
                                             const double density[], pdmc_layer *layer);
void pdmc_layer_clear(pdmc_layer *layer);

/// What a condition does at a time t between two steps, to the forces on the layer's nodes: adds the prescribed ones, or sets
/// them to what makes the velocities those prescribed at t + step / 2.
/// @param[in]  velocity  [cells] of every axis, at t - step / 2
/// @param[out] force     [cells] of every axis, at t
/// @return the work of the condition from t - step / 2 to t + step / 2, where no other condition acts on these components
double pdmc_layer_act(const pdmc_layer *layer, double time, double step, double volume,
                      double *const velocity[PDMC_AXES], double *const force[PDMC_AXES]);
