// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Sparse LU factors by UMFPACK.

#include "pdmc/base.h"

/// Entries of a square matrix; entries of one place are added.
typedef struct {
    int size, count, capacity;
    int *row, *column;
    double *value;
} pdmc_triplets;

PDMC_NODISCARD pdmc_status pdmc_triplets_create(int size, int capacity, pdmc_triplets *triplets);
void pdmc_triplets_clear(pdmc_triplets *triplets);
void pdmc_triplets_add(pdmc_triplets *triplets, int row, int column, double value);

typedef struct {
    int size;
    int *start, *row; // compressed columns, [size + 1], [start[size]]
    double *value;
    void *numeric;
    double reciprocal_condition; // UMFPACK's estimate, smallest over largest pivot
} pdmc_factor;

/// @param[out] factor  free with pdmc_factor_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_SINGULAR, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status pdmc_factor_create(const pdmc_triplets *triplets, pdmc_factor *factor);
void pdmc_factor_clear(pdmc_factor *factor);

/// Solves A x = b; may be called from several threads at once.
/// @param[in]  b  [size]
/// @param[out] x  [size]
PDMC_NODISCARD pdmc_status pdmc_factor_solve(const pdmc_factor *factor, const double b[], double x[]);
