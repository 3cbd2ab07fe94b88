// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/reduced_impl.h"

#include <cblas.h>
#include <lapacke.h>
#include <string.h>

enum { CAPACITY = PDMC_REDUCED_CAPACITY, PROBES = PDMC_PROBES };

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

// The term's part of the system; the matrix of the mean stays the identity.
static pdmc_status turn_term(const pdmc_reduced_builder *b, size_t m)
{
    pdmc_status status = PDMC_OK;
    pdmc_reduced_system *system = b->system;
    const int r = system->dimension;
    const size_t products = (size_t)r * PROBES, square = (size_t)r * (size_t)r;
    double *probes = &system->probe_matrix[m * CAPACITY * PROBES];
    double *whole = NULL, *half = NULL;
    PDMC_NEW(whole, square);
    PDMC_NEW(half, square > products ? square : products);
    if (m > 0) turn_matrix(r, b->direction, &system->matrix[m * PDMC_REDUCED_TRIANGLE], whole, half);
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, r, PROBES, r, 1.0, b->direction, r, probes, PROBES, 0.0,
                half, PROBES);
    memcpy(probes, half, products * sizeof *probes);
done:
    pdmc_free(whole);
    pdmc_free(half);
    return status;
}

static pdmc_status turn_terms(const pdmc_reduced_builder *b)
{
    pdmc_status status = PDMC_OK;
#pragma omp parallel for schedule(dynamic) num_threads(b->threads)
    for (size_t m = 0; m <= (size_t)b->system->terms; m++) {
        const pdmc_status mine = turn_term(b, m);
        if (mine != PDMC_OK) {
#pragma omp critical(pdmc_reduced_order)
            status = mine;
        }
    }
    return status;
}

static pdmc_status turn_loads(const pdmc_reduced_builder *b)
{
    pdmc_status status = PDMC_OK;
    pdmc_reduced_system *system = b->system;
    const int r = system->dimension;
    double *load = NULL;
    PDMC_NEW(load, r);
    for (int k = 0; k < system->sides + system->added; k++) {
        memcpy(load, &system->load[k * CAPACITY], (size_t)r * sizeof *load);
        cblas_dgemv(CblasRowMajor, CblasNoTrans, r, r, 1.0, b->direction, r, load, 1, 0.0, &system->load[k * CAPACITY],
                    1);
    }
done:
    pdmc_free(load);
    return status;
}

pdmc_status pdmc_reduced_order(pdmc_reduced_builder *b, const double y[])
{
    pdmc_status status = PDMC_OK;
    PDMC_TRY(find_directions(b, y, b->direction));
    PDMC_TRY(turn_terms(b));
    PDMC_TRY(turn_loads(b));
    b->system->is_ordered = true;
done:
    return status;
}

pdmc_status pdmc_reduced_turn(const pdmc_reduced_builder *b, int rows, double x[])
{
    pdmc_status status = PDMC_OK;
    const int r = b->system->dimension;
    const size_t values = (size_t)rows * (size_t)r;
    double *turned = NULL;
    PDMC_NEW(turned, values);
    if (rows > 0)
        cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, rows, r, r, 1.0, x, r, b->direction, r, 0.0, turned, r);
    memcpy(x, turned, values * sizeof *x);
done:
    pdmc_free(turned);
    return status;
}
