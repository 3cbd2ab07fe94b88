// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/base_impl.h"

/// The lower triangle of a symmetric matrix by columns.
typedef struct {
    int unknowns;
    int64_t *start; // [unknowns + 1]
    int64_t *row;   // [start[unknowns]] ascending in each column, from the diagonal
    double *value;
} pdmc_sparse_matrix;

/// A zeroed matrix is allowed.
void pdmc_sparse_matrix_clear(pdmc_sparse_matrix *matrix);
