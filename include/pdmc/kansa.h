// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Least-squares Kansa collocation with analytic crack fields: the local limit (horizon -> 0) of the peridynamic plate.
///
/// Trial functions: inverse multiquadrics on a grid of nodes (Evangelatos & Spanos 2011, eq. 25-26), monomials, and for
/// each straight crack the fields w^m, w = (z - sqrt(z - a) sqrt(z + a)) / a, of Muskhelishvili's potentials, which
/// hold the tip enrichment of eq. 38 in a closed form valid at both tips.
/// Rows, in units of stress, more than there are unknowns:
///  - the bond-based equation (eq. 24) with the full horizon at the nodes and on rings round each crack,
///  - sigma(u) n = t, or prescribed displacements, on the sides, and sigma(u) n = 0 on the faces of the cracks,
///  - no rigid motion where nothing holds the plate, and sum_k a_k q_j(x_k) = 0 (eq. B.2, corrected).
/// Solved by Householder QR after scaling the columns; the condition number is some 1e11, so there are no normal
/// equations.

#include "pdmc/affine.h"
#include "pdmc/dynamics.h"
#include "pdmc/results.h"

typedef struct pdmc_kansa pdmc_kansa;

/// Data other than the problem's own loads and supports, for manufactured solutions. A NULL function means the
/// problem's own. `problem->supports` still says which components are held on which side.
typedef struct {
    void (*body_force)(const double x[2], double b[2]);                           // force / volume
    void (*traction)(const double x[2], const double normal[2], double t[2]);     // force / length^2
    void (*displacement)(const double x[2], double u[2]);                         // length
} pdmc_kansa_data;

/// Assembles and factors the mean operator and solves for the problem's mean loads.
/// @param[in]  problem  kept by reference: it must outlive the model
/// @param[in]  data     NULL for the problem's own
/// @param[in]  threads  >= 1; the result does not depend on it
/// @param[out] kansa    destroy with pdmc_kansa_destroy()
/// @return PDMC_OK, PDMC_ERR_CONFIG (loads out of equilibrium), PDMC_ERR_SINGULAR, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_API PDMC_NODISCARD pdmc_status pdmc_kansa_create(const pdmc_problem *problem, const pdmc_kansa_data *data,
                                                      int threads, pdmc_kansa **kansa);

/// NULL is allowed; sets the pointer to NULL.
PDMC_API void pdmc_kansa_destroy(pdmc_kansa **kansa);

/// Sizes, rank, condition and residual of the mean solution.
PDMC_API pdmc_solver_report pdmc_kansa_report(const pdmc_kansa *kansa);

/// Seconds spent on assembly and on factorisation.
PDMC_API void pdmc_kansa_runtime(const pdmc_kansa *kansa, double *assembly, double *factorisation);

/// The mean displacement at x. On a crack the sheet is chosen by `anchor`, a point close by on the side that is meant;
/// elsewhere anchor = x.
/// @param[out] u  [2] length
PDMC_API PDMC_NODISCARD pdmc_status pdmc_kansa_displacement(const pdmc_kansa *kansa, const double x[2],
                                                            const double anchor[2], double u[2]);

/// The mean stress, by Hooke's law of the local limit.
/// @param[out] stress  [3] sigma_x, sigma_y, tau, force / length^2
PDMC_API PDMC_NODISCARD pdmc_status pdmc_kansa_stress(const pdmc_kansa *kansa, const double x[2],
                                                      const double anchor[2], double stress[3]);

/// Name, position, direction, K_I, K_II and T of a tip at the mean.
/// K_I - i K_II = -2 sqrt(pi / a) sum_m m p_m, with (-1)^(m+1) at "from", from the crack fields' own coefficients; T is
/// the mean of the stress along the two faces, extrapolated to the tip.
/// @param[in] tip  2 * crack for "from", 2 * crack + 1 for "to"
PDMC_API PDMC_NODISCARD pdmc_status pdmc_kansa_tip(const pdmc_kansa *kansa, int tip, pdmc_tip *out);

/// The affine model of the problem's uncertain quantities, in coordinates of the space in which its answers lie, where
/// the mean operator is the identity; direct solves are made in full and projected.
/// @param[in]  kansa  must outlive the model
/// @param[out] model  free with pdmc_affine_clear(); zero on failure
PDMC_API PDMC_NODISCARD pdmc_status pdmc_kansa_affine(const pdmc_kansa *kansa, pdmc_affine *model);

/// The weak form of the plate in the same trial functions, for a stiffness that varies in space, E(x) = E M(x): the strain
/// energy at the points of a rule graded to the tips, so that M needs no gradient. (The rows of the collocation hold it,
/// and fail: 7 % of K for a wave of four half lengths.) Prescribed displacements by a penalty of 1e4 E / h.
typedef struct pdmc_kansa_form pdmc_kansa_form;

/// @param[in]  kansa  must outlive the form
/// @param[out] form   destroy with pdmc_kansa_form_destroy()
/// @return PDMC_OK, PDMC_ERR_SINGULAR, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_API PDMC_NODISCARD pdmc_status pdmc_kansa_form_create(const pdmc_kansa *kansa, pdmc_kansa_form **form);

/// NULL is allowed; sets the pointer to NULL.
PDMC_API void pdmc_kansa_form_destroy(pdmc_kansa_form **form);

/// The derivative of ln G to ln M at the mean, of each of the problem's tips, where G = (K_I^2 + K_II^2) / (E M_tip):
///     d ln G = sum_j weight_j d ln M(x_j),
/// from one adjoint solution: -epsilon(adjoint) : C : epsilon(u) at the points of the rule, and 1 at the tip itself, the
/// last point. The weights add to -1 where there are tractions alone; they are 0 but for the tip where K is.
/// @return [tips] the form's own
PDMC_API const pdmc_field_functional *pdmc_kansa_field_sensitivity(const pdmc_kansa_form *form);

/// The affine model of a plate whose stiffness is a random field, in coordinates in which the mean operator is the
/// identity. c(r) acts by the effective modulus alone. A stress intensity factor of a sample is the row times the solution
/// times M at the tip.
/// @param[in]  form, field  must outlive the model
/// @param[out] model        free with pdmc_affine_clear(); zero on failure
PDMC_API PDMC_NODISCARD pdmc_status pdmc_kansa_field_affine(const pdmc_kansa_form *form, const pdmc_field *field,
                                                            pdmc_affine *model);

/// The plate as the integration of its motion sees it: the weak form in the same trial functions, in which mass and
/// stiffness are symmetric and energy is conserved. (The rows of the collocation, with inertia added, have eigenvalues
/// in the left half plane, and the motion explodes.) Local stresses, as in the traction rows; prescribed displacements
/// by a penalty of 1e4 E / h.
/// @param[in]  inertia  kappa of pdmc_motion_inertia()
/// @param[out] model    free with pdmc_motion_model_clear(); zero on failure
PDMC_API PDMC_NODISCARD pdmc_status pdmc_kansa_motion(const pdmc_kansa *kansa, double inertia,
                                                      pdmc_motion_model *model);

/// The rows that give the displacement at x, u and v, of a state of the model's motion.
/// @param[in]  anchor  the side of a crack that is meant; x elsewhere
/// @param[out] row     [2, unknowns]
PDMC_API PDMC_NODISCARD pdmc_status pdmc_kansa_motion_rows(const pdmc_kansa *kansa, const double x[2],
                                                           const double anchor[2], double row[]);
