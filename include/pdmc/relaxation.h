// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Dynamic relaxation: rest as the end of a damped motion with masses that are made for it (Underwood, in: Computational
/// Methods for Transient Analysis, 1983; Yu 2011, eq. 4.53-4.70). It needs nothing of a body but its forces.

#include "pdmc/base.h"

#include <stdbool.h>
#include <stddef.h>

/// What is brought to rest.
typedef struct {
    size_t unknowns;
    /// The forces at x, which are zero at rest.
    /// @param[in]  x      [unknowns]
    /// @param[out] force  [unknowns]
    pdmc_status (*force)(void *context, const double x[], double force[]);
    void *context;
    /// [unknowns] fictitious masses for a step of 1: at least a quarter of the sum of |k_ij| of the row, with some
    /// room, is stable (Gerschgorin, eq. 4.59). INFINITY holds an unknown.
    const double *mass;
} pdmc_relaxation_model;

typedef struct {
    double scale;     // > 0: the norm of forces to which the tolerance is relative
    double tolerance; // of the norm of the forces of unknowns that are not held, > 0
    int max_steps;
    double damping; // constant, in [0, 2); negative: found anew at every step from Rayleigh's quotient
} pdmc_relaxation_options;

typedef struct {
    int steps;
    double residual; // the norm of the forces over the scale
    double damping;  // of the last step
} pdmc_relaxation_state;

/// Steps of central differences until the forces are small. With adaptive damping c = 0.8 x 2 w, where
///     w^2 = -sum v (f^n - f^(n-1)) / sum m v^2,
/// Rayleigh's quotient of the motion v^(n-1/2): nearly critical for the mode in which the body moves;
/// and where the body moves against its forces, sum v f < 0, it begins anew from a standstill. (Eq. 4.68-4.70 take
/// the displacement in place of v, with a stiffness of every unknown by a division by its velocity.)
/// Sums are taken in the order of the unknowns: nothing depends on the number of threads.
/// @param[in,out] x        [unknowns] start and result
/// @param[in]     observe  called at the start and after every step; NULL is allowed; false stops with PDMC_ERR_INTERRUPTED
/// @param[out]    state    of the end, whatever the status
/// @return PDMC_OK; PDMC_ERR_ARG; PDMC_ERR_SINGULAR if the forces are not small after the steps allowed or not finite; PDMC_ERR_NOMEM;
///         or the failure of `force`
PDMC_API PDMC_NODISCARD pdmc_status pdmc_relax(const pdmc_relaxation_model *model,
                                               const pdmc_relaxation_options *options, double x[],
                                               bool (*observe)(void *context, const pdmc_relaxation_state *state),
                                               void *context, pdmc_relaxation_state *state);
