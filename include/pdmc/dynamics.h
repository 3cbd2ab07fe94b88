// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Motion of a discretised plate, M x'' + d M x' + K x = f(t) F (Evangelatos & Spanos 2011, eq. 35), by Newmark's
/// method.

#include "pdmc/base.h"

/// A load factor that is linear between points in time and constant outside them.
typedef struct {
    int count;
    const double *time;   // [count] ascending
    const double *factor; // [count]
} pdmc_history;

typedef struct {
    double density; // rho, mass / length^3, the mass in force time^2 / length
    double damping; // d, 1 / time: a force -rho d u' on every point
    double step;    // of time
    int steps;
    pdmc_history history; // of all tractions; prescribed displacements are constant
} pdmc_motion_options;

/// What the integration knows of a discretisation: M and K symmetric, M positive, K not negative.
typedef struct {
    int unknowns;
    /// Solves kappa M (x - p) + K x = fixed + factor F, for the inertia kappa that the model was made for.
    /// @param[in]  predicted  [unknowns] p
    /// @param[out] x          [unknowns]
    pdmc_status (*solve)(const void *method, const double predicted[], double factor, double x[]);
    /// x^T M y at density 1, x^T K y, and F^T x: per unit of thickness.
    double (*mass)(const void *method, const double x[], const double y[]);
    double (*stiffness)(const void *method, const double x[], const double y[]);
    double (*work)(const void *method, const double x[]);
    void (*destroy)(void *method); // frees `method`
    void *method;
} pdmc_motion_model;

/// The state of the plate at the end of a step; energies per unit of thickness, in force.
typedef struct {
    double time;
    const double *x, *velocity, *acceleration; // [unknowns]
    double kinetic;    // 1/2 rho x'^T M x'
    double elastic;    // 1/2 x^T K x
    double dissipated; // int rho d x'^T M x' dt
    double work;       // int f F^T x' dt
} pdmc_motion_state;

/// Frees what the model owns; a zeroed model is allowed.
PDMC_API void pdmc_motion_model_clear(pdmc_motion_model *model);

/// The inertia kappa = rho (1 + d dt / 2) 4 / dt^2 for which the model has to be made.
PDMC_API double pdmc_motion_inertia(const pdmc_motion_options *options);

/// Integrates with Newmark's average acceleration (beta = 1/4, gamma = 1/2): second order, unconditionally stable, and
/// without numerical damping: without damping and prescribed motion, work = kinetic + elastic to rounding at every
/// step.
///
/// At the start the plate is at rest, undisplaced and without acceleration: a history that does not start at zero is a
/// load that rises within the first step.
/// @param[in] observe  called for the start and after every step; NULL is allowed; false stops the integration
/// @return PDMC_OK, PDMC_ERR_ARG, PDMC_ERR_NOMEM, or the failure of `solve`
PDMC_API PDMC_NODISCARD pdmc_status pdmc_motion_run(const pdmc_motion_model *model, const pdmc_motion_options *options,
                                                    bool (*observe)(void *context, const pdmc_motion_state *state),
                                                    void *context);

/// The factor of a history at a time.
PDMC_API double pdmc_history_at(const pdmc_history *history, double time);
