// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/functions.h"

#include "base/base_impl.h"
#include "pdmc/affine.h"

#include <cblas.h>
#include <math.h>
#include <omp.h>
#include <string.h>

void pdmc_covariance_sum(const pdmc_covariance *covariance, int sources, const double source[], int columns,
                         const double weight[], const double x[2], double value[])
{
    memset(value, 0, sizeof *value * (size_t)columns);
    for (int j = 0; j < sources; j++) {
        const double dx = x[0] - source[2 * j], dy = x[1] - source[2 * j + 1];
        const double c = pdmc_covariance_at(covariance, sqrt(dx * dx + dy * dy));
        for (int d = 0; d < columns; d++) value[d] += c * weight[(size_t)j * (size_t)columns + (size_t)d];
    }
}

/// Buffers of one thread.
typedef struct {
    double *polynomial; // [PDMC_BLOCK, polynomials]
    double *direction;  // [PDMC_BLOCK, directions]
    double *value;      // [PDMC_BLOCK, count]
} workspace;

static size_t workspace_size(const pdmc_functions *functions)
{
    return (size_t)PDMC_BLOCK *
           (size_t)(pdmc_polynomials_count(&functions->space) + functions->directions + functions->count);
}

static workspace workspace_of(const pdmc_functions *functions, double memory[])
{
    double *direction = &memory[PDMC_BLOCK * pdmc_polynomials_count(&functions->space)];
    return (workspace){memory, direction, &direction[PDMC_BLOCK * functions->directions]};
}

/// At most PDMC_BLOCK points; the products always have that many rows, so that a value does not depend on the call.
static void block_at(const pdmc_functions *functions, int points, const double x[], workspace own, double value[])
{
    const int n = pdmc_polynomials_count(&functions->space), count = functions->count, f = functions->directions;
    pdmc_polynomials_at(&functions->space, points, x, own.polynomial);
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, PDMC_BLOCK, count, n, 1.0, own.polynomial, n,
                functions->coefficient, n, 0.0, own.value, count);
    for (int i = 0; i < points && f > 0; i++)
        pdmc_covariance_sum(&functions->covariance, functions->sources, functions->source, f, functions->weight,
                            &x[2 * i], &own.direction[i * f]);
    if (f > 0)
        cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, PDMC_BLOCK, count, f, 1.0, own.direction, f,
                    functions->mix, f, 1.0, own.value, count);
    memcpy(value, own.value, sizeof *value * (size_t)points * (size_t)count);
}

pdmc_status pdmc_functions_at(const pdmc_functions *functions, int points, const double x[], int threads,
                              double value[])
{
    pdmc_status status = PDMC_OK;
    const size_t size = workspace_size(functions);
    const int blocks = (points + PDMC_BLOCK - 1) / PDMC_BLOCK;
    double *memory = NULL;
    PDMC_NEW(memory, size * (size_t)threads);
#pragma omp parallel for num_threads(threads) schedule(static)
    for (int b = 0; b < blocks; b++) {
        const int first = b * PDMC_BLOCK, left = points - first;
        block_at(functions, left < PDMC_BLOCK ? left : PDMC_BLOCK, &x[2 * first],
                 workspace_of(functions, &memory[size * (size_t)omp_get_thread_num()]),
                 &value[(size_t)first * (size_t)functions->count]);
    }
done:
    pdmc_free(memory);
    return status;
}

void pdmc_functions_clear(pdmc_functions *functions)
{
    pdmc_free(functions->coefficient);
    pdmc_free(functions->source);
    pdmc_free(functions->weight);
    pdmc_free(functions->mix);
    *functions = (pdmc_functions){0};
}
