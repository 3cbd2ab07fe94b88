// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The bond-based plate with its finite horizon and bonds that the cracks really cut, by collocation:
///     int int c(r) e e^T [u(x) - u(x + r e)] dr dtheta = 0   over the part of the disc that x sees,
/// e = (cos theta, sin theta), at every node, those on the faces of the cracks included (Evangelatos & Spanos 2011, eq.
/// 24 with the truncation of section 4.2); u between the nodes by stencils of visible nodes, which jump across the
/// cracks. Beyond the plate's sides the stencils extrapolate: rings of ghost nodes outside them take up the
/// conditions sigma(u) n = t or u = u_0 there. No condition is needed on the faces. The system is square, sparse and
/// unsymmetric.

#include "pdmc/affine.h"
#include "pdmc/results.h"

typedef struct pdmc_visible pdmc_visible;

/// What a test may ask for beyond a problem; without `outside` the problem's loads hold.
typedef struct {
    void (*outside)(const double x[2], double u[2]); // displacements outside the plate, in place of its loads
    bool is_blind; // stencils of the nearest nodes, seen or not, none of them on faces: to show what visibility is for
} pdmc_visible_data;

/// Assembles and factors the mean operator and solves for the problem's mean loads.
/// @param[in]  problem  kept by reference: it must outlive the model
/// @param[in]  data     NULL for the problem's own
/// @param[in]  threads  >= 1; the result does not depend on it
/// @param[out] visible  destroy with pdmc_visible_destroy()
/// @return PDMC_OK, PDMC_ERR_CONFIG (loads out of equilibrium), PDMC_ERR_SINGULAR, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status pdmc_visible_create(const pdmc_problem *problem, const pdmc_visible_data *data, int threads,
                                               pdmc_visible **visible);

/// NULL is allowed; sets the pointer to NULL.
void pdmc_visible_destroy(pdmc_visible **visible);

/// The condition is that of UMFPACK's pivots.
pdmc_solver_report pdmc_visible_report(const pdmc_visible *visible);
void pdmc_visible_runtime(const pdmc_visible *visible, double *assembly, double *factorisation);

/// The mean displacement. On the face of a crack, the one that `anchor` lies on, it is that of the equation itself,
///     u = (int int c e e^T)^-1 int int c e e^T u(x + r e),
/// since the stencils, made for nodes at a distance, miss a fifth of the opening near a tip.
PDMC_NODISCARD pdmc_status pdmc_visible_displacement(const pdmc_visible *visible, const double x[2],
                                                     const double anchor[2], double u[2]);
PDMC_NODISCARD pdmc_status pdmc_visible_field(const pdmc_visible *visible, pdmc_displacement_field *field);

/// Name, position, direction, K_I and K_II of a tip at the mean; T is not known, NaN. The stress intensity factors are
/// those of the field beyond the horizon, by the interaction integral; see tip.h.
/// @param[in] tip  2 * crack for "from", 2 * crack + 1 for "to"
PDMC_NODISCARD pdmc_status pdmc_visible_tip(const pdmc_visible *visible, int tip, pdmc_tip *out);

/// The affine model of the problem's uncertain quantities. c(r) = c_0 (1 + eta(r)) with its deviation eta expanded in
/// Legendre polynomials of r / delta; in coordinates of the space in which the answers lie.
/// @param[in]  visible  must outlive the model
/// @param[out] model    free with pdmc_affine_clear(); zero on failure
PDMC_NODISCARD pdmc_status pdmc_visible_affine(const pdmc_visible *visible, pdmc_affine *model);
