// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "field/functions.h"
#include "field/karhunen_loeve.h"

/// The functions psi_k of a normal field of variance 1: without functionals the `modes` leading pairs sqrt(lambda) phi. With
/// functionals s_1, ..., s_f the first f are the directions d_i = C t_i, t_i' C t_j = delta_ij, where t_1, ..., t_i span
/// s_1, ..., s_i; a functional that depends on those before it has no direction of its own. The rest are those of the
/// covariance that remains, R = C - sum_i d_i d_i': the functions R v / sqrt(v' R v), v the leading eigenvectors of R among
/// the combinations of the pairs. So sum_k psi_k psi_k' is the covariance of the field's expectation given s' g and v' g: it
/// is never more than C, and as R s = 0 no functional is affected by the rest.
/// @param[in]  pairs   more than `modes` make the rest better
/// @param[out] result  free with pdmc_functions_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_ARG, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status pdmc_directions_create(const pdmc_karhunen_loeve *pairs, const pdmc_covariance *covariance,
                                                  int modes, int functionals, const pdmc_field_functional functional[],
                                                  int threads, pdmc_functions *result);
