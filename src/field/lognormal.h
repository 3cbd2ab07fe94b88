// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "field/functions.h"

/// The exponential M = exp(s g - s^2 var g / 2) of a normal field g of K functions, expanded by Karhunen & Loeve in turn:
/// its mean is 1 and its covariance exp(s^2 Cov g) - 1, so that its best functions are known without samples. The
/// coefficients of a sample are projections, by a Gauss rule of `points` points.
typedef struct {
    int modes, terms, points;
    double *mode;          // [modes, points] s psi
    double *half_variance; // [points] s^2 var g / 2
    double *projection;    // [points, terms]
} pdmc_lognormal;

/// @param[in]  normal     of g; it has variance <= 1
/// @param[in]  variation  > 0, of M
/// @param[in]  error      the root mean square that the terms may leave out
/// @param[out] terms      free with pdmc_functions_clear(); zero on failure
/// @param[out] result     free with pdmc_lognormal_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status pdmc_lognormal_create(const pdmc_functions *normal, double variation, double error,
                                                 int threads, pdmc_functions *terms, pdmc_lognormal *result);

/// @param[in]  z   [count, modes]
/// @param[out] xi  [count, terms]
/// @return PDMC_OK or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_lognormal_coefficients(const pdmc_lognormal *lognormal, int count, const double z[],
                                                       double xi[]);

/// A zeroed one is allowed.
void pdmc_lognormal_clear(pdmc_lognormal *lognormal);
