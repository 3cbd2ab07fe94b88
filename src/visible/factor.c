// SPDX-License-Identifier: GPL-3.0-or-later
#include "visible/factor.h"

#include "base/base_impl.h"

#include <umfpack.h>

pdmc_status pdmc_triplets_create(int size, int capacity, pdmc_triplets *triplets)
{
    pdmc_status status = PDMC_OK;
    *triplets = (pdmc_triplets){.size = size, .capacity = capacity};
    PDMC_NEW(triplets->row, capacity);
    PDMC_NEW(triplets->column, capacity);
    PDMC_NEW(triplets->value, capacity);
done:
    if (status != PDMC_OK) pdmc_triplets_clear(triplets);
    return status;
}

void pdmc_triplets_clear(pdmc_triplets *triplets)
{
    pdmc_free(triplets->row);
    pdmc_free(triplets->column);
    pdmc_free(triplets->value);
    *triplets = (pdmc_triplets){0};
}

void pdmc_triplets_add(pdmc_triplets *triplets, int row, int column, double value)
{
    const int k = triplets->count++;
    triplets->row[k] = row;
    triplets->column[k] = column;
    triplets->value[k] = value;
}

static pdmc_status check(int code, const char *what)
{
    switch (code) {
    case UMFPACK_OK: return PDMC_OK;
    case UMFPACK_WARNING_singular_matrix: return pdmc_raise(PDMC_ERR_SINGULAR, "the collocation matrix is singular");
    case UMFPACK_ERROR_out_of_memory: return pdmc_raise(PDMC_ERR_NOMEM, "out of memory: %s", what);
    default: return pdmc_raise(PDMC_ERR_EXTERN, "%s returned %d", what, code);
    }
}

static pdmc_status compress(const pdmc_triplets *t, pdmc_factor *factor)
{
    pdmc_status status = PDMC_OK;
    PDMC_NEW(factor->start, t->size + 1);
    PDMC_NEW(factor->row, t->count);
    PDMC_NEW(factor->value, t->count);
    const int code = umfpack_di_triplet_to_col(t->size, t->size, t->count, t->row, t->column, t->value, factor->start,
                                               factor->row, factor->value, NULL);
    status = check(code, "umfpack_di_triplet_to_col");
done:
    return status;
}

pdmc_status pdmc_factor_create(const pdmc_triplets *triplets, pdmc_factor *factor)
{
    pdmc_status status = PDMC_OK;
    const int n = triplets->size;
    double control[UMFPACK_CONTROL], info[UMFPACK_INFO];
    void *symbolic = NULL;
    umfpack_di_defaults(control);
    *factor = (pdmc_factor){.size = n};
    PDMC_TRY(compress(triplets, factor));
    int code = umfpack_di_symbolic(n, n, factor->start, factor->row, factor->value, &symbolic, control, info);
    PDMC_TRY(check(code, "umfpack_di_symbolic"));
    code = umfpack_di_numeric(factor->start, factor->row, factor->value, symbolic, &factor->numeric, control, info);
    PDMC_TRY(check(code, "umfpack_di_numeric"));
    factor->reciprocal_condition = info[UMFPACK_RCOND];
done:
    umfpack_di_free_symbolic(&symbolic);
    if (status != PDMC_OK) pdmc_factor_clear(factor);
    return status;
}

void pdmc_factor_clear(pdmc_factor *factor)
{
    if (factor->numeric) umfpack_di_free_numeric(&factor->numeric);
    pdmc_free(factor->start);
    pdmc_free(factor->row);
    pdmc_free(factor->value);
    *factor = (pdmc_factor){0};
}

pdmc_status pdmc_factor_solve(const pdmc_factor *factor, const double b[], double x[])
{
    double control[UMFPACK_CONTROL];
    umfpack_di_defaults(control);
    control[UMFPACK_IRSTEP] = 0; // the factors are exact to rounding: refinement would triple the cost
    const int code =
        umfpack_di_solve(UMFPACK_A, factor->start, factor->row, factor->value, x, b, factor->numeric, control, NULL);
    return check(code, "umfpack_di_solve");
}
