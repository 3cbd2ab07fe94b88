// SPDX-License-Identifier: GPL-3.0-or-later
#include "sparse/factor.h"

#include <cholmod.h>
#include <omp.h>
#include <string.h>

struct pdmc_sparse_factor {
    cholmod_common common;
    cholmod_factor *factor;
};

static void prepare(cholmod_common *common)
{
    cholmod_l_start(common);
    common->supernodal = CHOLMOD_SUPERNODAL; // of matrices this size ten times as fast as the other; always L L'
    common->print = 0;
}

static pdmc_status failure(const cholmod_common *common, const char *what)
{
    switch (common->status) {
    case CHOLMOD_OK: return PDMC_OK;
    case CHOLMOD_NOT_POSDEF:
        return pdmc_raise(PDMC_ERR_SINGULAR,
                          "the stiffness of the bonds is not positive definite: a part of the plate is not held by "
                          "bonds, or too many bonds have a negative micromodulus");
    case CHOLMOD_OUT_OF_MEMORY: return pdmc_raise(PDMC_ERR_NOMEM, "out of memory: %s", what);
    default: return pdmc_raise(PDMC_ERR_EXTERN, "%s returned %d", what, common->status);
    }
}

// CHOLMOD 3 starts four threads of its own in small loops, whatever it is told; on a busy machine they wait for each other
// most of the time. Inside our own parallel loops it cannot.
static int forbid_threads(void)
{
    const int levels = omp_get_max_active_levels();
    if (!omp_in_parallel()) omp_set_max_active_levels(0);
    return levels;
}

static void allow_threads(int levels)
{
    if (!omp_in_parallel()) omp_set_max_active_levels(levels);
}

// A view of our matrix as theirs; nothing is copied.
static cholmod_sparse view_of(const pdmc_sparse_matrix *matrix)
{
    return (cholmod_sparse){
        .nrow = (size_t)matrix->unknowns,
        .ncol = (size_t)matrix->unknowns,
        .nzmax = (size_t)matrix->start[matrix->unknowns],
        .p = matrix->start,
        .i = matrix->row,
        .x = matrix->value,
        .stype = -1,
        .itype = CHOLMOD_LONG,
        .xtype = CHOLMOD_REAL,
        .dtype = CHOLMOD_DOUBLE,
        .sorted = 1,
        .packed = 1,
    };
}

// An empty factor with the ordering and the pattern of another one.
static cholmod_factor *symbolic_copy(cholmod_factor *pattern, cholmod_common *common)
{
    cholmod_factor *copy = cholmod_l_copy_factor(pattern, common);
    if (copy && !cholmod_l_change_factor(CHOLMOD_PATTERN, 1, 1, 1, 1, copy, common))
        cholmod_l_free_factor(&copy, common);
    return copy;
}

pdmc_status pdmc_sparse_factor_create(const pdmc_sparse_matrix *matrix, const pdmc_sparse_factor *pattern,
                                      int64_t order[], pdmc_sparse_factor **factor)
{
    pdmc_status status = PDMC_OK;
    cholmod_sparse view = view_of(matrix);
    pdmc_sparse_factor *made = NULL;
    PDMC_NEW(made, 1);
    prepare(&made->common);
    if (order) { // that one, and no other is tried
        made->common.nmethods = 1;
        made->common.method[0].ordering = CHOLMOD_GIVEN;
    }
    made->factor = pattern ? symbolic_copy(pattern->factor, &made->common)
                           : cholmod_l_analyze_p(&view, order, NULL, 0, &made->common);
    PDMC_TRY(failure(&made->common, "cholmod_analyze"));
    const int levels = forbid_threads();
    cholmod_l_factorize(&view, made->factor, &made->common);
    allow_threads(levels);
    PDMC_TRY(failure(&made->common, "cholmod_factorize"));
    *factor = made;
    made = NULL;
done:
    pdmc_sparse_factor_destroy(&made);
    return status;
}

void pdmc_sparse_factor_destroy(pdmc_sparse_factor **factor)
{
    pdmc_sparse_factor *old = *factor;
    if (!old) return;
    cholmod_l_free_factor(&old->factor, &old->common);
    cholmod_l_finish(&old->common);
    pdmc_free(old);
    *factor = NULL;
}

static cholmod_dense dense_view(size_t rows, size_t columns, double values[])
{
    return (cholmod_dense){.nrow = rows,
                           .ncol = columns,
                           .nzmax = rows * columns,
                           .d = rows,
                           .x = values,
                           .xtype = CHOLMOD_REAL,
                           .dtype = CHOLMOD_DOUBLE};
}

// Solves with each of the parts in turn; x may be b.
static pdmc_status solve_parts(const pdmc_sparse_factor *factor, int count, const int parts[], int columns,
                               const double b[], double x[])
{
    pdmc_status status = PDMC_OK;
    const size_t n = factor->factor->n, values = n * (size_t)columns;
    cholmod_common common; // the factor is shared by threads, what they work with is not
    prepare(&common);
    if (x != b) memcpy(x, b, values * sizeof *x);
    for (int k = 0; k < count && status == PDMC_OK; k++) {
        cholmod_dense loads = dense_view(n, (size_t)columns, x);
        cholmod_dense *solution = cholmod_l_solve(parts[k], factor->factor, &loads, &common);
        status = failure(&common, "cholmod_solve");
        if (status == PDMC_OK) memcpy(x, solution->x, values * sizeof *x);
        cholmod_l_free_dense(&solution, &common);
    }
    cholmod_l_finish(&common);
    return status;
}

pdmc_status pdmc_sparse_factor_solve(const pdmc_sparse_factor *factor, int columns, const double b[], double x[])
{
    const int whole[1] = {CHOLMOD_A};
    return solve_parts(factor, 1, whole, columns, b, x);
}

pdmc_status pdmc_sparse_factor_color(const pdmc_sparse_factor *factor, int columns, const double b[], double x[])
{
    const int parts[2] = {CHOLMOD_Lt, CHOLMOD_Pt};
    return solve_parts(factor, 2, parts, columns, b, x);
}

double pdmc_sparse_factor_condition(const pdmc_sparse_factor *factor)
{
    cholmod_common common;
    prepare(&common);
    const double reciprocal = cholmod_l_rcond(factor->factor, &common);
    cholmod_l_finish(&common);
    return 1.0 / reciprocal;
}
