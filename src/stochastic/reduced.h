// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A reduced model of a symmetric affine model: Galerkin's projection on a few vectors, with bounds of the errors of every
/// sample.
///
/// The basis, orthonormal in the energy of the mean operator K_0, begins with the answers at the mean and is enriched by
/// the preconditioned residuals of training samples, those directions first in which they are largest, until the bounds are
/// met by all of them. So it holds what block conjugate gradients would find for these samples, and others like them.
///
/// The bound. With K(xi) >= alpha K_0, alpha > 0 by the model's verb `coercivity`, the error e of a solution with the
/// residual r has
///     e' K(xi) e <= r' K_0^-1 r / alpha,
/// and r' K_0^-1 r is estimated from above by probes z_k of covariance K_0^-1, independent of the residual: sum_k (z_k' r)^2
/// is that norm times a chi-square variable of as many degrees of freedom as there are probes (Smetana, Zahm & Patera,
/// SIAM J. Sci. Comput. 41 (2019) A900). Divided by the quantile of that variable at 1e-9 it is a bound that fails for a
/// sample with this probability. z_k' r is linear in the reduced solution, so that it costs no more than the solution.
///
/// Stress intensities. A row's adjoint problem K(xi) psi = row has an error e_psi in the same basis, and K(xi) e is
/// orthogonal to the basis, so that
///     |row . e| = |psi' K(xi) e| = |e_psi' K(xi) e| <= |e_psi| |e|,
/// each bounded by the probes (Pierce & Giles, SIAM Rev. 42 (2000) 247; Rozza, Huynh & Patera, Arch. Comput. Methods Eng. 15
/// (2008) 229, section 11): the error goes with the square of what the basis leaves out. Without adjoint problems there is
/// |row . e| <= |row| |e| / sqrt(alpha), |row|^2 = row K_0^-1 row.

#include "pdmc/affine.h"
#include "pdmc/stochastic.h"
#include "stochastic/variables.h"

/// What the bounds of a sample under the mean load have to meet.
typedef struct {
    double error;            // of sqrt(e' K(xi) e); not used where there are intensities
    const double *intensity; // [tips] of the root of (row_I . e)^2 + (row_II . e)^2; NULL: no adjoint problems
} pdmc_reduced_goal;

/// Bounds of the errors of a block.
typedef struct {
    double error[PDMC_BLOCK];      // of sqrt(e' K(xi) e); infinite where K(xi) is not known to be positive
    double coercivity[PDMC_BLOCK]; // alpha of K(xi) >= alpha K_0
    double *intensity;             // [PDMC_BLOCK, 2 tips] of |row . e| of the stress intensities; the caller's
} pdmc_reduced_bound;

/// Displacements that are prescribed must be zero.
/// @param[in]  variables  of a model with the verbs multiply, precondition and color; kept by reference
/// @param[out] reduced    clear before the model; zero on failure
/// @return PDMC_OK (also where the largest basis does not meet the goal: the bounds say so), PDMC_ERR_NOMEM,
/// PDMC_ERR_EXTERN, or the failure of a verb
PDMC_NODISCARD pdmc_status pdmc_reduced_create(const pdmc_variables *variables, const pdmc_reduced_goal *goal,
                                               int threads, pdmc_affine *reduced);

/// Solves K(xi) x = F_1 + sum_l share_l F_(2 + l) for a block.
/// @param[in]  xi     [PDMC_BLOCK, terms]
/// @param[in]  share  [PDMC_BLOCK, cases - 2], or NULL for 0
/// @param[out] x      [PDMC_BLOCK, unknowns]
/// @return PDMC_OK, PDMC_ERR_NOMEM, or the failure of the model's verb
PDMC_NODISCARD pdmc_status pdmc_reduced_solve(const pdmc_affine *reduced, const double xi[], const double share[],
                                              double x[], pdmc_reduced_bound *bound);
