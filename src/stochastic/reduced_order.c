// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/reduced_impl.h"

#include <cblas.h>
#include <lapacke.h>
#include <string.h>

enum { CAPACITY = PDMC_REDUCED_CAPACITY, PROBES = PDMC_PROBES, PANEL = 512 }; // numbers of every vector at a time

// The principal directions of answers that may be off by `allowed`, by rows. [r, r]
static pdmc_status find_directions(const pdmc_reduced_builder *b, const double y[], double direction[])
{
    pdmc_status status = PDMC_OK;
    const int r = b->system->dimension, sides = b->system->sides, rows = PDMC_TRAINING * sides;
    double *answer = NULL, *size = NULL, *superdiagonal = NULL, none[1];
    PDMC_NEW(answer, (size_t)rows * (size_t)r);
    PDMC_NEW(size, r);
    PDMC_NEW(superdiagonal, r);
    for (int k = 0; k < rows; k++) cblas_daxpy(r, 1.0 / b->allowed[k % sides], &y[k * r], 1, &answer[k * r], 1);
    const int info =
        LAPACKE_dgesvd(LAPACK_ROW_MAJOR, 'N', 'A', rows, r, answer, r, size, none, 1, direction, r, superdiagonal);
    if (info != 0) PDMC_FAIL(PDMC_ERR_EXTERN, "LAPACKE_dgesvd returned %d", info);
done:
    pdmc_free(answer);
    pdmc_free(size);
    pdmc_free(superdiagonal);
    return status;
}

// X = Q X, [r, columns] with a stride, a panel of columns at a time.
static pdmc_status turn(const pdmc_reduced_builder *b, const double direction[], size_t columns, double x[])
{
    pdmc_status status = PDMC_OK;
    const size_t r = (size_t)b->system->dimension;
#pragma omp parallel for schedule(dynamic) num_threads(b->threads)
    for (size_t first = 0; first < columns; first += PANEL) {
        const size_t width = columns - first < PANEL ? columns - first : PANEL;
        double *turned = pdmc_calloc(r * width, sizeof *turned);
        if (turned) {
            cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, (int)r, (int)width, (int)r, 1.0, direction, (int)r,
                        &x[first], (int)columns, 0.0, turned, (int)width);
            for (size_t j = 0; j < r; j++) memcpy(&x[j * columns + first], &turned[j * width], width * sizeof *turned);
        } else {
#pragma omp critical(pdmc_reduced_order)
            status = PDMC_ERR_NOMEM;
        }
        pdmc_free(turned);
    }
    return status;
}

// Q A Q' of one term in packed form. whole, half: scratch, [r, r]
static void turn_matrix(int r, const double direction[], double packed[], double whole[], double half[])
{
    for (int j = 0; j < r; j++)
        for (int i = 0; i <= j; i++)
            whole[i * r + j] = whole[j * r + i] = packed[pdmc_triangle_column((size_t)j) + (size_t)i];
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, r, r, r, 1.0, direction, r, whole, r, 0.0, half, r);
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, r, r, r, 1.0, half, r, direction, r, 0.0, whole, r);
    for (int j = 0; j < r; j++)
        memcpy(&packed[pdmc_triangle_column((size_t)j)], &whole[j * r], (size_t)(j + 1) * sizeof *packed);
}

// The matrix of the mean stays the identity.
static pdmc_status turn_system(const pdmc_reduced_builder *b, const double direction[])
{
    pdmc_status status = PDMC_OK;
    pdmc_reduced_system *system = b->system;
    const int r = system->dimension;
    double *whole = NULL, *half = NULL, *load = NULL;
    PDMC_NEW(whole, (size_t)r * (size_t)r);
    PDMC_NEW(half, (size_t)r * (size_t)r);
    PDMC_NEW(load, r);
    for (size_t m = 1; m <= (size_t)system->terms; m++)
        turn_matrix(r, direction, &system->matrix[m * PDMC_REDUCED_TRIANGLE], whole, half);
    for (size_t m = 0; m <= (size_t)system->terms; m++)
        PDMC_TRY(turn(b, direction, PROBES, &system->probe_matrix[m * CAPACITY * PROBES]));
    for (int k = 0; k < system->sides + system->added; k++) {
        memcpy(load, &system->load[k * CAPACITY], (size_t)r * sizeof *load);
        cblas_dgemv(CblasRowMajor, CblasNoTrans, r, r, 1.0, direction, r, load, 1, 0.0, &system->load[k * CAPACITY], 1);
    }
done:
    pdmc_free(whole);
    pdmc_free(half);
    pdmc_free(load);
    return status;
}

pdmc_status pdmc_reduced_order(pdmc_reduced_builder *b, const double y[])
{
    pdmc_status status = PDMC_OK;
    const size_t r = (size_t)b->system->dimension;
    double *direction = NULL;
    PDMC_NEW(direction, r * r);
    PDMC_TRY(find_directions(b, y, direction));
    PDMC_TRY(turn_system(b, direction));
    PDMC_TRY(turn(b, direction, (size_t)b->n, b->basis));
    PDMC_TRY(turn(b, direction, (size_t)b->n, b->image));
    b->system->is_ordered = true;
done:
    pdmc_free(direction);
    return status;
}
