// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/krylov.h"

#include "base/base_impl.h"

#include <cblas.h>
#include <math.h>
#include <string.h>

enum { B = PDMC_BLOCK, MOST_STEPS = 200 };

// The vectors are blocks, [B, unknowns].
typedef struct {
    const pdmc_affine *model;
    const double *xi;
    double tolerance;
    double *none;          // [B, terms] coefficients of the mean
    double *r, *z, *p, *q; // residual, K_0^-1 r, direction, K p
    double product[B];     // r' z
    double reference[B];   // of the product
    bool running[B];
    double *residual; // [B] of the caller
} iteration;

static pdmc_status iteration_create(iteration *it)
{
    pdmc_status status = PDMC_OK;
    const size_t values = (size_t)B * (size_t)it->model->unknowns;
    PDMC_NEW(it->none, (size_t)B * (size_t)it->model->terms);
    PDMC_NEW(it->r, values);
    PDMC_NEW(it->z, values);
    PDMC_NEW(it->p, values);
    PDMC_NEW(it->q, values);
done:
    return status;
}

static void iteration_clear(iteration *it)
{
    pdmc_free(it->none);
    pdmc_free(it->r);
    pdmc_free(it->z);
    pdmc_free(it->p);
    pdmc_free(it->q);
}

static double *column(const iteration *it, double block[], int s)
{
    return &block[(size_t)s * (size_t)it->model->unknowns];
}

static double dot(const iteration *it, double a[], double b[], int s)
{
    return cblas_ddot(it->model->unknowns, column(it, a, s), 1, column(it, b, s), 1);
}

static void judge(iteration *it, int s)
{
    it->residual[s] = it->reference[s] > 0.0 ? sqrt(it->product[s] / it->reference[s]) : 0.0;
    if (!(it->residual[s] > it->tolerance)) it->running[s] = false;
}

static pdmc_status begin(iteration *it, double x[])
{
    pdmc_status status = PDMC_OK;
    const pdmc_affine *model = it->model;
    const size_t values = (size_t)B * (size_t)model->unknowns;
    PDMC_TRY(model->verbs->multiply(model, 1.0, it->none, x, it->r)); // the load
    PDMC_TRY(model->verbs->multiply(model, 1.0, it->xi, x, it->q));
    for (int s = 0; s < B; s++) it->reference[s] = dot(it, it->r, x, s);
    for (size_t k = 0; k < values; k++) it->r[k] -= it->q[k];
    PDMC_TRY(model->verbs->precondition(model, B, it->r, it->z));
    memcpy(it->p, it->z, values * sizeof *it->p);
    for (int s = 0; s < B; s++) {
        it->product[s] = dot(it, it->r, it->z, s);
        it->reference[s] = fmax(it->reference[s], it->product[s]);
        it->running[s] = true;
        judge(it, s);
    }
done:
    return status;
}

// A column that has stopped keeps its x, whatever becomes of its other vectors.
static void advance(iteration *it, int s, double x[])
{
    const int n = it->model->unknowns;
    const double curvature = dot(it, it->p, it->q, s);
    if (!(curvature > 0.0)) {
        it->running[s] = false;
        it->residual[s] = NAN;
        return;
    }
    const double step = it->product[s] / curvature;
    cblas_daxpy(n, step, column(it, it->p, s), 1, column(it, x, s), 1);
    cblas_daxpy(n, -step, column(it, it->q, s), 1, column(it, it->r, s), 1);
}

static void turn(iteration *it, int s)
{
    const int n = it->model->unknowns;
    const double before = it->product[s];
    it->product[s] = dot(it, it->r, it->z, s);
    judge(it, s);
    cblas_dscal(n, it->product[s] / before, column(it, it->p, s), 1);
    cblas_daxpy(n, 1.0, column(it, it->z, s), 1, column(it, it->p, s), 1);
}

static bool is_running(const iteration *it)
{
    for (int s = 0; s < B; s++)
        if (it->running[s]) return true;
    return false;
}

pdmc_status pdmc_krylov_solve(const pdmc_affine *model, const double xi[], double tolerance, double x[],
                              double residual[PDMC_BLOCK])
{
    pdmc_status status = PDMC_OK;
    iteration it = {.model = model, .xi = xi, .tolerance = tolerance, .residual = residual};
    PDMC_TRY(iteration_create(&it));
    PDMC_TRY(begin(&it, x));
    for (int step = 0; step < MOST_STEPS && is_running(&it); step++) {
        PDMC_TRY(model->verbs->multiply(model, 1.0, xi, it.p, it.q));
        for (int s = 0; s < B; s++)
            if (it.running[s]) advance(&it, s, x);
        PDMC_TRY(model->verbs->precondition(model, B, it.r, it.z));
        for (int s = 0; s < B; s++)
            if (it.running[s]) turn(&it, s);
    }
done:
    iteration_clear(&it);
    return status;
}
