// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/solve.h"

#include "base/base_impl.h"

#include <string.h>

// The free rows: the rows of each column that come before those of prescribed values.
static pdmc_status free_part(const pdmc_form *form, pdmc_sparse_matrix *matrix)
{
    pdmc_status status = PDMC_OK;
    const int n = form->free_count;
    matrix->unknowns = n;
    PDMC_NEW(matrix->start, n + 1);
    PDMC_NEW(matrix->row, form->start[n]);
    PDMC_NEW(matrix->value, form->start[n]);
    for (int j = 0; j < n; j++) {
        int64_t at = matrix->start[j];
        for (int64_t k = form->start[j]; k < form->start[j + 1] && form->row[k] < n; k++, at++) {
            matrix->row[at] = form->row[k];
            matrix->value[at] = form->value[k];
        }
        matrix->start[j + 1] = at;
    }
done:
    return status;
}

pdmc_status pdmc_form_factor(const pdmc_form *form, pdmc_sparse_factor **factor)
{
    pdmc_status status = PDMC_OK;
    const double condition_limit = 1e13; // zero but for the rounding of the pivots
    pdmc_sparse_matrix matrix = {0};
    pdmc_sparse_factor *made = NULL;
    pdmc_blas_prepare();
    PDMC_TRY(free_part(form, &matrix));
    status = pdmc_sparse_factor_create(&matrix, NULL, NULL, &made);
    if (status == PDMC_OK && pdmc_sparse_factor_condition(made) > condition_limit) status = PDMC_ERR_SINGULAR;
    if (status == PDMC_ERR_SINGULAR)
        PDMC_FAIL(status,
                  "the form is not positive definite: some elements are not held by others, as where points inside "
                  "discontinuous elements do not see across an edge");
    PDMC_TRY(status);
    *factor = made;
    made = NULL;
done:
    pdmc_sparse_factor_destroy(&made);
    pdmc_sparse_matrix_clear(&matrix);
    return status;
}

pdmc_status pdmc_form_solve(const pdmc_form *form, const double load[], double u[])
{
    pdmc_status status = PDMC_OK;
    const int n = form->free_count;
    pdmc_sparse_factor *factor = NULL;
    double *rest = NULL;
    PDMC_NEW(rest, n);
    PDMC_TRY(pdmc_form_factor(form, &factor));
    memset(u, 0, (size_t)n * sizeof *u);
    pdmc_form_multiply(form, u, rest); // what the prescribed values do
    for (int i = 0; i < n; i++) rest[i] = load[i] - rest[i];
    PDMC_TRY(pdmc_sparse_factor_solve(factor, 1, rest, u));
done:
    pdmc_sparse_factor_destroy(&factor);
    pdmc_free(rest);
    return status;
}
