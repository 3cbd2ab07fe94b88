// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/fall_back.h"

#include "base/base_impl.h"

#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

enum { B = PDMC_BLOCK };

// A = I + K_0^-1 K'(xi), column by column, by the verb that the expansion uses too.
static pdmc_status fill_columns(const pdmc_affine *model, const double xi[], double column[])
{
    pdmc_status status = PDMC_OK;
    const int n = model->unknowns;
    double *all_xi = NULL, *unit = NULL, *image = NULL;
    PDMC_NEW(all_xi, B * model->terms);
    PDMC_NEW(unit, (size_t)B * (size_t)n);
    PDMC_NEW(image, (size_t)B * (size_t)n);
    for (int s = 0; s < B; s++) memcpy(&all_xi[s * model->terms], xi, (size_t)model->terms * sizeof *xi);
    for (int first = 0; first < n; first += B) {
        const int count = n - first < B ? n - first : B;
        memset(unit, 0, (size_t)B * (size_t)n * sizeof *unit);
        for (int k = 0; k < count; k++) unit[(size_t)k * (size_t)n + (size_t)(first + k)] = 1.0;
        PDMC_TRY(model->verbs->perturb(model, all_xi, unit, image));
        for (int k = 0; k < count; k++) image[(size_t)k * (size_t)n + (size_t)(first + k)] += 1.0;
        memcpy(&column[(size_t)first * (size_t)n], image, (size_t)count * (size_t)n * sizeof *image);
    }
done:
    pdmc_free(all_xi);
    pdmc_free(unit);
    pdmc_free(image);
    return status;
}

// What the expansion stands for: (I + K_0^-1 K') x = K_0^-1 F, whether it contracts or not.
static pdmc_status solve_in_space(pdmc_block *block, int s)
{
    pdmc_status status = PDMC_OK;
    const pdmc_affine *model = block->model;
    const int n = model->unknowns;
    double *matrix = NULL, *x = &block->x[s * n];
    lapack_int *pivot = NULL;
    PDMC_NEW(matrix, (size_t)n * (size_t)n);
    PDMC_NEW(pivot, n);
    PDMC_TRY(fill_columns(model, block->drawn.draw[s].xi, matrix));
    memset(x, 0, (size_t)n * sizeof *x);
    for (int l = 0; l < model->cases; l++)
        cblas_daxpy(n, pdmc_draw_scale(&block->drawn.draw[s], l), pdmc_affine_solution(model, l), 1, x, 1);
    const int info = LAPACKE_dgesv(LAPACK_COL_MAJOR, n, 1, matrix, n, pivot, x, n);
    block->failure[s] = info == 0 ? PDMC_SAMPLE_OK : PDMC_SAMPLE_SINGULAR;
    block->solver[s] = PDMC_SOLVED_IN_SPACE;
done:
    pdmc_free(matrix);
    pdmc_free(pivot);
    return status;
}

// Conjugate gradients on the whole block, whose other columns are kept as they were.
static pdmc_status solve_by_krylov(pdmc_block *block, int count, const bool wanted[B])
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)block->model->unknowns;
    pdmc_sample_failure before[B];
    double residual[B], *x = NULL;
    PDMC_NEW(x, B * n);
    memcpy(x, block->x, B * n * sizeof *x);
    memcpy(before, block->failure, sizeof before);
    memcpy(residual, block->residual, sizeof residual);
    for (int s = 0; s < B; s++)
        if (wanted[s]) block->failure[s] = PDMC_SAMPLE_OK;
    PDMC_TRY(pdmc_block_solve_by(block, PDMC_INVERSE_KRYLOV, count));
    for (int s = 0; s < B; s++) {
        if (wanted[s]) block->solver[s] = PDMC_SOLVED_BY_KRYLOV;
        if (wanted[s]) continue;
        memcpy(&block->x[(size_t)s * n], &x[(size_t)s * n], n * sizeof *x);
        block->failure[s] = before[s];
        block->residual[s] = residual[s];
    }
done:
    pdmc_free(x);
    return status;
}

static int find_diverged(const pdmc_block *block, int count, bool wanted[B])
{
    int found = 0;
    for (int s = 0; s < B; s++) {
        wanted[s] = s < count && block->failure[s] == PDMC_SAMPLE_DIVERGED;
        found += wanted[s];
    }
    return found;
}

pdmc_status pdmc_block_fall_back(pdmc_block *block, int count)
{
    pdmc_status status = PDMC_OK;
    const bool is_symmetric = block->model->verbs->multiply != NULL;
    const bool was_krylov = block->problem->sampling.inverse == PDMC_INVERSE_KRYLOV;
    bool wanted[B];
    if (find_diverged(block, count, wanted) == 0) return PDMC_OK;
    for (int s = 0; s < count && !is_symmetric; s++)
        if (wanted[s]) PDMC_TRY(solve_in_space(block, s));
    if (is_symmetric && !was_krylov) PDMC_TRY(solve_by_krylov(block, count, wanted));
    find_diverged(block, count, wanted);
    for (int s = 0; s < count; s++)
        if (wanted[s]) PDMC_TRY(pdmc_block_solve_directly(block, s));
done:
    return status;
}
