// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "field/polynomials.h"
#include "pdmc/field.h"

/// The leading eigenpairs of an isotropic covariance over a rectangle,
///     integral C(|x - x'|) phi(x') dx' = lambda phi(x),
/// by Galerkin's method in polynomials.
typedef struct {
    pdmc_polynomials space;
    int modes;
    double *lambda;      // [modes] descending, >= 0
    double *coefficient; // [modes, polynomials] of phi, of norm 1
    double tail;         // share of the modes' variance that lies in the two highest degrees of either direction
} pdmc_karhunen_loeve;

/// @param[in]  modes    >= 1
/// @param[in]  wanted   <= modes: the leading ones, for which the degree is raised until their tail is below a
///                      tolerance; the rest are as good as this degree makes them
/// @param[out] result   free with pdmc_karhunen_loeve_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_ARG where there are too many modes, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status pdmc_karhunen_loeve_create(const pdmc_covariance *covariance, double width, double height,
                                                      int wanted, int modes, int threads, pdmc_karhunen_loeve *result);

/// A zeroed one is allowed.
void pdmc_karhunen_loeve_clear(pdmc_karhunen_loeve *result);
