// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "field/field_impl.h"
#include "field/overlap.h"
#include "field/polynomials.h"

#include <cblas.h>
#include <gsl/gsl_math.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double TAIL = 1e-8;          // of the variance, in the two highest degrees
static const double SINGULAR_PART = 1e-3; // of the correlation length, in which the kink may be under-resolved

struct pdmc_process {
    double length, retained;
    int modes, degree;
    double *coefficient; // [modes, degree + 1] of v sqrt(lambda_k) phi_k in Legendre polynomials of norm 1
};

/// The eigenproblem of the polynomials that are even or odd.
typedef struct {
    int parity, size;
    double *matrix; // [size, size], then the eigenvectors, one a row
    double *value;  // [size] ascending
} parity_class;

typedef struct {
    double lambda;
    const parity_class *class;
    int index;
} eigenpair;

static pdmc_status solve_class(const pdmc_covariance *covariance, const pdmc_overlap *overlap, parity_class *class)
{
    pdmc_status status = PDMC_OK;
    double *kernel = NULL;
    class->size = pdmc_parity_count(overlap->degree, class->parity);
    const int pairs = class->size * class->size;
    PDMC_NEW(kernel, overlap->count);
    PDMC_NEW(class->matrix, pairs);
    PDMC_NEW(class->value, class->size);
    for (int i = 0; i < overlap->count; i++) kernel[i] = pdmc_covariance_at(covariance, overlap->r[i]);
    cblas_dgemv(CblasRowMajor, CblasNoTrans, pairs, overlap->count, 1.0, overlap->overlap[class->parity],
                overlap->count, kernel, 1, 0.0, class->matrix, 1);
    const int info = LAPACKE_dsyevd(LAPACK_COL_MAJOR, 'V', 'L', class->size, class->matrix, class->size, class->value);
    if (info) PDMC_FAIL(PDMC_ERR_EXTERN, "LAPACKE_dsyevd returned %d", info);
done:
    pdmc_free(kernel);
    return status;
}

static int descending(const void *left, const void *right)
{
    const eigenpair *a = left, *b = right;
    return a->lambda != b->lambda ? (a->lambda < b->lambda ? 1 : -1) : a->class->parity - b->class->parity;
}

static void expand(const eigenpair *pair, double scale, double coefficient[])
{
    const parity_class *class = pair->class;
    const double *vector = &class->matrix[(size_t)pair->index * (size_t) class->size];
    const double sign = pdmc_field_sign(class->size, vector);
    for (int i = 0; i < class->size; i++) coefficient[class->parity + 2 * i] = scale * sign * vector[i];
}

/// The modes of both classes, the largest first.
static pdmc_status gather(const parity_class class[2], double variation, pdmc_process *process)
{
    pdmc_status status = PDMC_OK;
    const int n = process->degree + 1;
    eigenpair *pair = NULL;
    int filled = 0;
    PDMC_NEW(pair, n);
    PDMC_NEW(process->coefficient, (size_t)process->modes * (size_t)n);
    for (int e = 0; e < 2; e++)
        for (int i = 0; i < class[e].size; i++)
            pair[filled++] = (eigenpair){fmax(class[e].value[i], 0.0), &class[e], i};
    qsort(pair, (size_t)n, sizeof *pair, descending);
    process->retained = 0.0;
    for (int k = 0; k < process->modes; k++) {
        expand(&pair[k], variation * sqrt(pair[k].lambda), &process->coefficient[(size_t)k * (size_t)n]);
        process->retained += pair[k].lambda / process->length;
    }
done:
    pdmc_free(pair);
    return status;
}

static pdmc_status solve(const pdmc_covariance *covariance, double variation, pdmc_process *process)
{
    pdmc_status status = PDMC_OK;
    parity_class class[2] = {{.parity = 0}, {.parity = 1}};
    pdmc_overlap overlap = {0};
    const double finest = SINGULAR_PART * fmin(covariance->length, process->length);
    PDMC_TRY(pdmc_overlap_create(process->length, process->degree, finest, &overlap));
    for (int e = 0; e < 2; e++) PDMC_TRY(solve_class(covariance, &overlap, &class[e]));
    PDMC_TRY(gather(class, variation, process));
done:
    for (int e = 0; e < 2; e++) {
        pdmc_free(class[e].matrix);
        pdmc_free(class[e].value);
    }
    pdmc_overlap_clear(&overlap);
    return status;
}

/// The share of the modes' variance in the two highest degrees.
static double tail_of(const pdmc_process *process)
{
    const int n = process->degree + 1;
    double all = 0.0, tail = 0.0;
    for (int k = 0; k < process->modes; k++) {
        const double *row = &process->coefficient[(size_t)k * (size_t)n];
        all += cblas_ddot(n, row, 1, row, 1);
        tail += cblas_ddot(2, &row[n - 2], 1, &row[n - 2], 1);
    }
    return all > 0.0 ? tail / all : 0.0;
}

pdmc_status pdmc_process_create(const pdmc_covariance *covariance, double length, double variation, int modes,
                                pdmc_process **process)
{
    pdmc_status status = pdmc_covariance_check(covariance);
    if (status) return status;
    PDMC_REQUIRE(length > 0.0 && isfinite(length), "a length of %g", length);
    PDMC_REQUIRE(variation >= 0.0 && modes >= 1, "%d modes of the variation %g", modes, variation);
    pdmc_process *made = NULL;
    pdmc_blas_prepare();
    PDMC_NEW(made, 1);
    made->length = length;
    made->modes = modes;
    made->degree =
        12 + (int)ceil(M_PI_2 * modes); // half a wave needs pi / 2 degrees, and the ends of the interval some more
    for (;;) {
        if (made->degree > PDMC_HIGHEST_DEGREE)
            PDMC_FAIL(PDMC_ERR_ARG, "%d modes of this covariance need polynomials up to the degree %d", modes,
                      made->degree);
        PDMC_TRY(solve(covariance, variation, made));
        if (tail_of(made) <= TAIL) break;
        made->degree += 2 + made->degree / 4;
        pdmc_free(made->coefficient);
        made->coefficient = NULL;
    }
    *process = made;
    made = NULL;
done:
    pdmc_process_destroy(&made);
    return status;
}

void pdmc_process_destroy(pdmc_process **process)
{
    if (!*process) return;
    pdmc_free((*process)->coefficient);
    pdmc_free(*process);
    *process = NULL;
}

double pdmc_process_retained(const pdmc_process *process)
{
    return process->retained;
}

double pdmc_process_mode(const pdmc_process *process, int mode, double x)
{
    const int n = process->degree + 1;
    double value[PDMC_HIGHEST_DEGREE + 1];
    pdmc_legendre(process->degree, process->length, x, value);
    return cblas_ddot(n, value, 1, &process->coefficient[(size_t)mode * (size_t)n], 1);
}
