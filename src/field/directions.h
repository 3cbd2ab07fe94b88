// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "field/functions.h"
#include "field/karhunen_loeve.h"

/// The functions psi_k of a normal field of variance 1, g = sum_k z_k psi_k: the `modes` leading pairs sqrt(lambda) phi
/// without functionals. With functionals s_1, ..., s_f the first f are the directions
///     d_1 = C s_1 / sqrt(s_1' C s_1), ...,   orthonormal in the sense that s_i' d_j = 0 for i < j,
/// and the rest the leading modes of what is left of the field of all pairs h = sum_k z_k sqrt(lambda_k) phi_k:
///     h - sum_i d_i (t_i' h),   d_i = C t_i, t_i' C t_j = delta_ij,
/// on which no functional has any effect. A functional that depends on those before it has no direction of its own.
/// @param[in]  pairs   more than `modes` make the rest better
/// @param[out] result  free with pdmc_functions_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_ARG, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status pdmc_directions_create(const pdmc_karhunen_loeve *pairs, const pdmc_covariance *covariance,
                                                  int modes, int functionals, const pdmc_field_functional functional[],
                                                  int threads, pdmc_functions *result);
