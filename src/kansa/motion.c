// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "kansa/weak_form.h"

#include <cblas.h>
#include <lapacke.h>
#include <string.h>

// Newmark's step solves (kappa M + K) y = kappa M p + fixed + f load.
typedef struct {
    int unknowns;
    double inertia;
    pdmc_weak_form form;
    double *factor;  // [unknowns, unknowns] Cholesky factor of kappa M + K, lower triangle
    double *product; // [unknowns]
} weak_motion;

static void destroy(void *method)
{
    weak_motion *motion = method;
    pdmc_weak_form_clear(&motion->form);
    pdmc_free(motion->factor);
    pdmc_free(motion->product);
    pdmc_free(motion);
}

static pdmc_status solve(const void *method, const double predicted[], double factor, double x[])
{
    const weak_motion *motion = method;
    const int n = motion->unknowns;
    memcpy(x, motion->form.fixed, (size_t)n * sizeof *x);
    cblas_daxpy(n, factor, motion->form.load, 1, x, 1);
    cblas_dsymv(CblasColMajor, CblasLower, n, motion->inertia, motion->form.mass, n, predicted, 1, 1.0, x, 1);
    const int info = LAPACKE_dpotrs(LAPACK_COL_MAJOR, 'L', n, 1, motion->factor, n, x, n);
    return info == 0 ? PDMC_OK : pdmc_raise(PDMC_ERR_EXTERN, "LAPACKE_dpotrs returned %d", info);
}

static double product(const weak_motion *motion, const double matrix[], const double x[], const double y[])
{
    const int n = motion->unknowns;
    cblas_dsymv(CblasColMajor, CblasLower, n, 1.0, matrix, n, y, 1, 0.0, motion->product, 1);
    return cblas_ddot(n, x, 1, motion->product, 1);
}

static double mass(const void *method, const double x[], const double y[])
{
    const weak_motion *motion = method;
    return product(motion, motion->form.mass, x, y);
}

static double stiffness(const void *method, const double x[], const double y[])
{
    const weak_motion *motion = method;
    return product(motion, motion->form.stiffness, x, y);
}

static double work(const void *method, const double x[])
{
    const weak_motion *motion = method;
    return cblas_ddot(motion->unknowns, motion->form.load, 1, x, 1);
}

pdmc_status pdmc_kansa_motion_rows(const pdmc_kansa *kansa, const double x[2], const double anchor[2], double row[])
{
    pdmc_row_builder builder;
    const pdmc_status status = pdmc_row_builder_create(&kansa->basis, &builder);
    if (status != PDMC_OK) return status;
    pdmc_displacement_rows(&builder, x, anchor, row, row + kansa->unknowns);
    pdmc_kansa_whiten(kansa, 2, row);
    pdmc_row_builder_clear(&builder);
    return PDMC_OK;
}

pdmc_status pdmc_kansa_motion(const pdmc_kansa *kansa, double inertia, pdmc_motion_model *model)
{
    pdmc_status status = PDMC_OK;
    const int n = kansa->unknowns;
    const size_t size = (size_t)n * (size_t)n;
    weak_motion *motion = NULL;
    *model = (pdmc_motion_model){0};
    PDMC_REQUIRE(inertia > 0.0, "inertia %g is not positive", inertia);
    PDMC_NEW(motion, 1);
    *model = (pdmc_motion_model){n, solve, mass, stiffness, work, destroy, motion};
    motion->unknowns = n;
    motion->inertia = inertia;
    PDMC_NEW(motion->factor, size);
    PDMC_NEW(motion->product, n);
    PDMC_TRY(pdmc_weak_form_create(kansa, &motion->form));
    memcpy(motion->factor, motion->form.stiffness, size * sizeof(double));
    for (size_t i = 0; i < size; i++) motion->factor[i] += inertia * motion->form.mass[i];
    const int info = LAPACKE_dpotrf(LAPACK_COL_MAJOR, 'L', n, motion->factor, n);
    if (info != 0) PDMC_FAIL(PDMC_ERR_SINGULAR, "the operator of a time step is not positive definite (row %d)", info);
done:
    if (status != PDMC_OK) pdmc_motion_model_clear(model);
    return status;
}
