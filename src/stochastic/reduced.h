// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A reduced model of a symmetric affine model: Galerkin's projection on a few vectors, with a bound of the error of every
/// sample.
///
/// The basis, orthonormal in the energy of the mean operator K_0, begins with the answers at the mean and is enriched by
/// the preconditioned residuals of training samples, those directions first in which they are largest, until the bound is
/// met by all of them. So it holds what block conjugate gradients would find for these samples, and others like them.
///
/// The bound. With K(xi) >= alpha K_0, alpha > 0 by the model's verb `coercivity`, the error e of a solution with the
/// residual r has
///     e' K(xi) e <= r' K_0^-1 r / alpha,
/// and r' K_0^-1 r is estimated from above by probes z_k of covariance K_0^-1, independent of the residual: sum_k (z_k' r)^2
/// is that norm times a chi-square variable of as many degrees of freedom as there are probes (Smetana, Zahm & Patera,
/// SIAM J. Sci. Comput. 41 (2019) A900). Divided by the quantile of that variable at 1e-9 it is a bound that fails for a
/// sample with this probability. z_k' r is linear in the reduced solution, so that it costs no more than the solution.

#include "pdmc/affine.h"
#include "pdmc/stochastic.h"
#include "stochastic/variables.h"

/// Displacements that are prescribed must be zero.
/// @param[in]  variables  of a model with the verbs multiply, precondition and color; kept by reference
/// @param[in]  tolerance  of the bound of sqrt(e' K(xi) e) at the mean load
/// @param[out] reduced    clear before the model; zero on failure
/// @return PDMC_OK (also where the largest basis does not meet the tolerance: the bounds say so), PDMC_ERR_NOMEM,
/// PDMC_ERR_EXTERN, or the failure of a verb
PDMC_NODISCARD pdmc_status pdmc_reduced_create(const pdmc_variables *variables, double tolerance, int threads,
                                               pdmc_affine *reduced);

/// Solves K(xi) x = F_1 for a block.
/// @param[in]  xi     [PDMC_BLOCK, terms]
/// @param[out] x      [PDMC_BLOCK, unknowns]
/// @param[out] error  [PDMC_BLOCK] bound of sqrt(e' K(xi) e); infinite where K(xi) is not known to be positive
/// @return PDMC_OK or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_reduced_solve(const pdmc_affine *reduced, const double xi[], double x[],
                                              double error[PDMC_BLOCK]);

/// alpha of K(xi) >= alpha K_0 of a block, by the full model.
/// @param[in]  xi     [PDMC_BLOCK, terms]
/// @param[out] alpha  [PDMC_BLOCK]
/// @return PDMC_OK or the failure of the model's verb
PDMC_NODISCARD pdmc_status pdmc_reduced_coercivity(const pdmc_affine *reduced, const double xi[],
                                                   double alpha[PDMC_BLOCK]);
