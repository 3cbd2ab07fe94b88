// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/reduced_impl.h"

#include <cblas.h>
#include <gsl/gsl_cdf.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

enum { B = PDMC_BLOCK, CAPACITY = PDMC_REDUCED_CAPACITY };

static const double failure_probability = 1e-9; // of the bound of one sample

pdmc_status pdmc_reduced_system_create(const pdmc_affine *full, pdmc_reduced_system **system)
{
    pdmc_status status = PDMC_OK;
    const int terms = full->terms;
    pdmc_reduced_system *made = NULL;
    PDMC_NEW(made, 1);
    made->full = full;
    made->terms = terms;
    made->quantile = gsl_cdf_chisq_Pinv(failure_probability, PDMC_PROBES);
    PDMC_NEW(made->matrix, (size_t)terms * CAPACITY * CAPACITY);
    PDMC_NEW(made->load, CAPACITY);
    PDMC_NEW(made->probe_matrix, (size_t)(1 + terms) * CAPACITY * PDMC_PROBES);
    PDMC_NEW(made->probe_load, PDMC_PROBES);
    *system = made;
    made = NULL;
done:
    pdmc_reduced_system_destroy(made);
    return status;
}

void pdmc_reduced_system_destroy(void *system)
{
    pdmc_reduced_system *old = system;
    if (!old) return;
    pdmc_free(old->matrix);
    pdmc_free(old->load);
    pdmc_free(old->probe_matrix);
    pdmc_free(old->probe_load);
    pdmc_free(old);
}

// A = I + sum_m xi_m A_m, its lower triangle by columns; x = A^-1 f in place. False where A is not positive definite.
static bool solve_one(const pdmc_reduced_system *system, const double xi[], double A[], double x[])
{
    const int r = system->dimension;
    memset(A, 0, (size_t)r * (size_t)r * sizeof *A);
    for (int j = 0; j < r; j++) {
        double *column = &A[(size_t)j * (size_t)r];
        column[j] = 1.0;
        for (int m = 0; m < system->terms; m++)
            cblas_daxpy(r - j, xi[m], &system->matrix[((size_t)m * CAPACITY + (size_t)j) * CAPACITY + (size_t)j], 1,
                        &column[j], 1);
    }
    if (LAPACKE_dpotrf(LAPACK_COL_MAJOR, 'L', r, A, r) != 0) return false;
    return LAPACKE_dpotrs(LAPACK_COL_MAJOR, 'L', r, 1, A, r, x, r) == 0;
}

// |sum_m (1, xi)_m (z' K_m V) x - z' F|^2, of all probes and columns at once.
static pdmc_status probe_residuals(const pdmc_reduced_system *system, const double xi[], const double x[],
                                   double sum[B])
{
    pdmc_status status = PDMC_OK;
    const int r = system->dimension, terms = system->terms;
    double *weighted = NULL, *residual = NULL;
    PDMC_NEW(weighted, B * r);
    PDMC_NEW(residual, B * PDMC_PROBES);
    for (int s = 0; s < B; s++) cblas_daxpy(PDMC_PROBES, -1.0, system->probe_load, 1, &residual[s * PDMC_PROBES], 1);
    for (int m = 0; m <= terms; m++) {
        for (int s = 0; s < B; s++)
            for (int j = 0; j < r; j++) weighted[s * r + j] = (m == 0 ? 1.0 : xi[s * terms + m - 1]) * x[s * r + j];
        cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, B, PDMC_PROBES, r, 1.0, weighted, r,
                    &system->probe_matrix[(size_t)m * CAPACITY * PDMC_PROBES], PDMC_PROBES, 1.0, residual, PDMC_PROBES);
    }
    for (int s = 0; s < B; s++) {
        const double *values = &residual[s * PDMC_PROBES];
        sum[s] = cblas_ddot(PDMC_PROBES, values, 1, values, 1);
    }
done:
    pdmc_free(weighted);
    pdmc_free(residual);
    return status;
}

pdmc_status pdmc_reduced_system_coercivity(const pdmc_reduced_system *system, const double xi[], double alpha[B])
{
    const pdmc_affine *full = system->full;
    if (full->verbs->coercivity) return full->verbs->coercivity(full, xi, alpha);
    for (int s = 0; s < B; s++) {
        double least = 0.0;
        for (int m = 0; m < full->terms; m++) least = fmin(least, xi[s * full->terms + m]);
        alpha[s] = 1.0 + least;
    }
    return PDMC_OK;
}

pdmc_status pdmc_reduced_system_solve(const pdmc_reduced_system *system, const double xi[], double x[], double error[B])
{
    pdmc_status status = PDMC_OK;
    const int r = system->dimension, terms = system->terms;
    double *A = NULL, sum[B], alpha[B];
    bool is_solved[B];
    PDMC_NEW(A, (size_t)r * (size_t)r);
    for (int s = 0; s < B; s++) {
        memcpy(&x[s * r], system->load, (size_t)r * sizeof *x);
        is_solved[s] = solve_one(system, &xi[s * terms], A, &x[s * r]);
    }
    PDMC_TRY(probe_residuals(system, xi, x, sum));
    PDMC_TRY(pdmc_reduced_system_coercivity(system, xi, alpha));
    for (int s = 0; s < B; s++) {
        const bool is_bounded = is_solved[s] && alpha[s] > 0.0;
        error[s] = is_bounded ? sqrt(sum[s] / (system->quantile * alpha[s])) : INFINITY;
    }
done:
    pdmc_free(A);
    return status;
}
