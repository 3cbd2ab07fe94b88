// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A discretised plate, solved at the mean of all uncertain quantities. Every method gives the same things behind these
/// verbs, so that Monte Carlo, plots and comparisons need not know which one ran.

#include "pdmc/affine.h"
#include "pdmc/dynamics.h"
#include "pdmc/results.h"

typedef struct pdmc_discretisation pdmc_discretisation;

typedef struct {
    /// Sizes, rank, condition and residual of the mean solution.
    pdmc_solver_report (*report)(const void *method);
    /// Seconds spent on assembly and on factorisation.
    void (*runtime)(const void *method, double *assembly, double *factorisation);
    /// The mean displacement at x. On a crack the side is chosen by `anchor`, a point close by on the side that is
    /// meant; elsewhere anchor = x.
    pdmc_status (*displacement)(const void *method, const double x[2], const double anchor[2], double u[2]);
    /// Name, position and direction of a tip, with K_I, K_II and T at the mean; NaN where the method does not know
    /// them.
    pdmc_status (*tip)(const void *method, int tip, pdmc_tip *out);
    /// The nodes and the faces of the cracks with their mean displacement.
    pdmc_status (*field)(const void *method, pdmc_displacement_field *field);
    /// The affine model of the problem's uncertain quantities; the method must outlive it.
    pdmc_status (*affine)(const void *method, pdmc_affine *model);
    void (*destroy)(void *method);
    /// The model of the plate's motion for the inertia of pdmc_motion_inertia(); NULL where the method has none.
    pdmc_status (*motion)(const void *method, double inertia, pdmc_motion_model *model);
    /// The rows [2, unknowns] that give the displacement at x, u and v, of a state of that motion; the anchor as above.
    pdmc_status (*motion_rows)(const void *method, const double x[2], const double anchor[2], double row[]);
} pdmc_discretisation_verbs;

struct pdmc_discretisation {
    const pdmc_discretisation_verbs *verbs;
    void *method;
};

/// Discretises a problem by the method it names and solves for its mean loads.
/// @param[in]  problem  kept by reference: it must outlive the discretisation
/// @param[in]  threads  >= 1; the result does not depend on it
/// @param[out] out      destroy with pdmc_discretisation_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_CONFIG (loads out of equilibrium), PDMC_ERR_SINGULAR, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_API PDMC_NODISCARD pdmc_status pdmc_discretise(const pdmc_problem *problem, int threads, pdmc_discretisation *out);

/// A zeroed discretisation is allowed.
PDMC_API void pdmc_discretisation_clear(pdmc_discretisation *discretisation);
