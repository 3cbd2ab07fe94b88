// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/reduced_impl.h"

#include <cblas.h>
#include <gsl/gsl_cdf.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

// The operators of a panel of samples are made at once: enough to read the terms seldom, few enough for little memory.
enum { B = PDMC_BLOCK, CAPACITY = PDMC_REDUCED_CAPACITY, PROBES = PDMC_PROBES, PANEL = 16 };

static const double failure_probability = 1e-9; // of the bound of one sample

pdmc_status pdmc_reduced_system_create(const pdmc_affine *full, int sides, pdmc_reduced_system **system)
{
    pdmc_status status = PDMC_OK;
    const size_t operators = 1 + (size_t)full->terms;
    pdmc_reduced_system *made = NULL;
    PDMC_NEW(made, 1);
    made->full = full;
    made->terms = full->terms;
    made->sides = sides;
    made->quantile = gsl_cdf_chisq_Pinv(failure_probability, PROBES);
    PDMC_NEW(made->matrix, operators * PDMC_REDUCED_TRIANGLE);
    PDMC_NEW(made->load, (size_t)sides * CAPACITY);
    PDMC_NEW(made->probe_matrix, operators * CAPACITY * PROBES);
    PDMC_NEW(made->probe_load, (size_t)sides * PROBES);
    for (size_t j = 0; j < CAPACITY; j++) made->matrix[pdmc_triangle_column(j) + j] = 1.0;
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

// What a panel is solved with.
typedef struct {
    double *coefficient; // [PANEL, 1 + terms] 1 and xi
    double *triangle;    // [PANEL, r (r + 1) / 2] A = V' K(xi) V
    double *probes;      // [PANEL, r, PROBES] z' K(xi) V
    double *factor;      // [r, r] of one sample
    double *residual;    // [sides, PROBES] of one sample
} workspace;

static pdmc_status workspace_create(const pdmc_reduced_system *system, workspace *work)
{
    pdmc_status status = PDMC_OK;
    const size_t r = (size_t)system->dimension;
    *work = (workspace){0};
    PDMC_NEW(work->coefficient, PANEL * (1 + system->terms));
    PDMC_NEW(work->triangle, PANEL * pdmc_triangle_column(r));
    PDMC_NEW(work->probes, PANEL * r * PROBES);
    PDMC_NEW(work->factor, r * r);
    PDMC_NEW(work->residual, system->sides * PROBES);
done:
    return status;
}

static void workspace_clear(workspace *work)
{
    pdmc_free(work->coefficient);
    pdmc_free(work->triangle);
    pdmc_free(work->probes);
    pdmc_free(work->factor);
    pdmc_free(work->residual);
}

// The operators of a panel: sums over the terms, for all entries at once.
static void assemble(const pdmc_reduced_system *system, const double xi[], workspace *work)
{
    const int r = system->dimension, terms = system->terms, operators = 1 + terms;
    const int entries = (int)pdmc_triangle_column((size_t)r), products = r * PROBES;
    for (int s = 0; s < PANEL; s++) {
        work->coefficient[s * operators] = 1.0;
        memcpy(&work->coefficient[s * operators + 1], &xi[s * terms], (size_t)terms * sizeof *xi);
    }
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, PANEL, entries, operators, 1.0, work->coefficient, operators,
                system->matrix, PDMC_REDUCED_TRIANGLE, 0.0, work->triangle, entries);
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, PANEL, products, operators, 1.0, work->coefficient,
                operators, system->probe_matrix, CAPACITY * PROBES, 0.0, work->probes, products);
}

// y = A^-1 f for all right-hand sides, [sides, r]. False where A is not positive definite.
static bool solve_one(const pdmc_reduced_system *system, const double triangle[], double factor[], double y[])
{
    const int r = system->dimension;
    for (int j = 0; j < r; j++)
        memcpy(&factor[(size_t)j * (size_t)r], &triangle[pdmc_triangle_column((size_t)j)],
               (size_t)(j + 1) * sizeof *factor);
    for (int k = 0; k < system->sides; k++) memcpy(&y[k * r], &system->load[k * CAPACITY], (size_t)r * sizeof *y);
    if (LAPACKE_dpotrf_work(LAPACK_COL_MAJOR, 'U', r, factor, r) != 0) return false;
    return LAPACKE_dpotrs_work(LAPACK_COL_MAJOR, 'U', r, system->sides, factor, r, y, r) == 0;
}

// |z' K(xi) V y - z' F| of every right-hand side.
static void probe_residuals(const pdmc_reduced_system *system, const double probes[], const double y[],
                            double residual[], double norm[])
{
    const int r = system->dimension, sides = system->sides;
    memcpy(residual, system->probe_load, (size_t)(sides * PROBES) * sizeof *residual);
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, sides, PROBES, r, 1.0, y, r, probes, PROBES, -1.0, residual,
                PROBES);
    for (int k = 0; k < sides; k++) norm[k] = cblas_dnrm2(PROBES, &residual[k * PROBES], 1);
}

static void solve_panel(const pdmc_reduced_system *system, const double xi[], workspace *work, double y[],
                        double error[])
{
    const int r = system->dimension, sides = system->sides;
    const size_t entries = pdmc_triangle_column((size_t)r);
    assemble(system, xi, work);
    for (int s = 0; s < PANEL; s++) {
        double *answer = &y[s * sides * r];
        if (solve_one(system, &work->triangle[(size_t)s * entries], work->factor, answer)) {
            probe_residuals(system, &work->probes[s * r * PROBES], answer, work->residual, &error[s * sides]);
        } else {
            for (int k = 0; k < sides; k++) error[s * sides + k] = INFINITY;
        }
    }
}

static pdmc_status find_coercivity(const pdmc_reduced_system *system, const double xi[], double alpha[B])
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

pdmc_status pdmc_reduced_system_solve(const pdmc_reduced_system *system, const double xi[], double y[], double error[],
                                      double alpha[B])
{
    pdmc_status status = PDMC_OK;
    const int r = system->dimension, sides = system->sides;
    workspace work;
    PDMC_TRY(workspace_create(system, &work));
    for (int s = 0; s < B; s += PANEL)
        solve_panel(system, &xi[s * system->terms], &work, &y[s * sides * r], &error[s * sides]);
    PDMC_TRY(find_coercivity(system, xi, alpha));
    for (int k = 0; k < B * sides; k++) {
        const bool is_bounded = alpha[k / sides] > 0.0 && isfinite(error[k]);
        error[k] = is_bounded ? error[k] / sqrt(system->quantile * alpha[k / sides]) : INFINITY;
    }
done:
    workspace_clear(&work);
    return status;
}
