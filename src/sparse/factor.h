// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sparse/matrix.h"

/// The Cholesky factor of a symmetric positive definite matrix (CHOLMOD, supernodal).
typedef struct pdmc_sparse_factor pdmc_sparse_factor;

/// @param[in]  pattern  a factor of a matrix of the same pattern, whose ordering is used again; NULL for none
/// @param[in]  order    [unknowns] where there is no pattern: the unknown that comes first, second, ...; NULL for one that
///                      CHOLMOD finds, which several threads must not ask for at a time
/// @param[out] factor   destroy with pdmc_sparse_factor_destroy()
/// @return PDMC_OK, PDMC_ERR_SINGULAR (not positive definite), PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status pdmc_sparse_factor_create(const pdmc_sparse_matrix *matrix,
                                                     const pdmc_sparse_factor *pattern, int64_t order[],
                                                     pdmc_sparse_factor **factor);

/// NULL is allowed; sets the pointer to NULL.
void pdmc_sparse_factor_destroy(pdmc_sparse_factor **factor);

/// x = K^-1 b, column by column. May be called from several threads at once.
/// @param[in]  b  [columns, unknowns]
/// @param[out] x  [columns, unknowns], may be b
/// @return PDMC_OK, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status pdmc_sparse_factor_solve(const pdmc_sparse_factor *factor, int columns, const double b[],
                                                    double x[]);

/// x = P' L'^-1 b with P K P' = L L', column by column: if the entries of b are independent with variance 1, those of x
/// have the covariance K^-1.
PDMC_NODISCARD pdmc_status pdmc_sparse_factor_color(const pdmc_sparse_factor *factor, int columns, const double b[],
                                                    double x[]);

/// An estimate of the condition number, from the diagonal of the factor.
double pdmc_sparse_factor_condition(const pdmc_sparse_factor *factor);
