// SPDX-License-Identifier: GPL-3.0-or-later
#include "sparse/matrix.h"

void pdmc_sparse_matrix_clear(pdmc_sparse_matrix *matrix)
{
    pdmc_free(matrix->start);
    pdmc_free(matrix->row);
    pdmc_free(matrix->value);
    *matrix = (pdmc_sparse_matrix){0};
}
