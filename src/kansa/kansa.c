// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/kansa.h"

#include "base/base_impl.h"
#include "kansa/assembly.h"

#include <cblas.h>
#include <float.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

// E_eff = (pi / 3) int c r^2 dr, which the rings integrate exactly.
static void share_modulus(pdmc_kansa *kansa)
{
    const pdmc_ring_rule *rings = &kansa->rings;
    double modulus = 0.0;
    for (int q = 0; q < rings->rings; q++) modulus += rings->mean[q] * rings->radius[q] * rings->radius[q];
    for (int q = 0; q < rings->rings; q++) kansa->share[q] = rings->radius[q] * rings->radius[q] / modulus;
}

enum { MOMENTS = 2 }; // orders of the crack fields' moments where the stiffness varies

static pdmc_status prepare(pdmc_kansa *kansa)
{
    pdmc_status status = PDMC_OK;
    const pdmc_problem *problem = kansa->problem;
    const pdmc_solver_options *options = &problem->solver;
    const pdmc_uncertainty *noise = pdmc_problem_uncertainty(problem, PDMC_QUANTITY_MICROMODULUS);
    pdmc_basis *basis = &kansa->basis;
    basis->shape = options->shape;
    basis->degree = options->polynomial_degree;
    basis->scale = 0.5 * fmin(problem->plate.width, problem->plate.height);
    basis->orders = options->crack_orders;
    basis->moments = pdmc_problem_uncertainty(problem, PDMC_QUANTITY_STIFFNESS) ? MOMENTS : 0;
    basis->shear_modulus =
        0.5 * problem->material.youngs_modulus / (1.0 + pdmc_poissons_ratio(problem->material.assumption));
    kansa->spacing = options->spacing;

    PDMC_TRY(pdmc_kansa_nodes(problem, options->spacing, basis));
    PDMC_TRY(pdmc_basis_complete(basis, problem->crack_count, problem->cracks));
    PDMC_TRY(pdmc_collocation_create(problem, options->spacing, basis, &kansa->points));
    PDMC_TRY(
        pdmc_ring_rule_create(options->radial_points, noise ? noise->bins : 1, 2, options->horizon, &kansa->rings));
    share_modulus(kansa);

    int motions;
    double motion[3][3];
    PDMC_TRY(pdmc_problem_free_motions(problem, &motions, motion));
    kansa->unknowns = basis->unknowns;
    kansa->rows = 2 * (kansa->points.interior_count + kansa->points.boundary_count) + motions + 2 * basis->monomials;
    if (kansa->rows < kansa->unknowns)
        PDMC_FAIL(PDMC_ERR_SINGULAR, "%d rows for %d unknowns: the nodes are too coarse for this basis", kansa->rows,
                  kansa->unknowns);
    const size_t n = (size_t)kansa->unknowns, m = (size_t)kansa->rows;
    PDMC_NEW(kansa->ring_rows, (size_t)kansa->rings.rings * 2 * (size_t)kansa->points.interior_count * n);
    PDMC_NEW(kansa->is_traction, 2 * kansa->points.boundary_count);
    PDMC_NEW(kansa->q, m * n);
    PDMC_NEW(kansa->r, n * n);
    PDMC_TRY(pdmc_load_cases_create(problem, &kansa->loads));
    kansa->cases = 1 + kansa->loads.count;
    PDMC_NEW(kansa->load, (size_t)kansa->cases * m);
    PDMC_NEW(kansa->whitened, (size_t)kansa->cases * n);
    PDMC_NEW(kansa->coefficients, n);
done:
    return status;
}

// |R_jj| over its largest: a column that the ones before it nearly span leaves a small one.
static int numerical_rank(int n, const double r[])
{
    double largest = 0.0;
    int rank = 0;
    for (int j = 0; j < n; j++) largest = fmax(largest, fabs(r[(size_t)j * (size_t)(n + 1)]));
    for (int j = 0; j < n; j++) rank += fabs(r[(size_t)j * (size_t)(n + 1)]) > DBL_EPSILON * largest;
    return rank;
}

// q holds A_0 column-major on entry and Q on exit. The columns are scaled to length 1 for the factorisation and its
// condition number, and the scale is then folded into R.
static pdmc_status factor(pdmc_kansa *kansa)
{
    pdmc_status status = PDMC_OK;
    const int m = kansa->rows, n = kansa->unknowns;
    double *tau = NULL, *norm = NULL;
    PDMC_NEW(tau, n);
    PDMC_NEW(norm, n);
    for (int j = 0; j < n; j++) {
        double *column = &kansa->q[(size_t)j * (size_t)m];
        norm[j] = cblas_dnrm2(m, column, 1);
        if (!(norm[j] > 0.0 && isfinite(norm[j]))) PDMC_FAIL(PDMC_ERR_SINGULAR, "unknown %d has no finite row", j);
        cblas_dscal(m, 1.0 / norm[j], column, 1);
    }
    int info = LAPACKE_dgeqrf(LAPACK_COL_MAJOR, m, n, kansa->q, m, tau);
    if (info != 0) PDMC_FAIL(PDMC_ERR_EXTERN, "LAPACKE_dgeqrf returned %d", info);
    for (int j = 0; j < n; j++)
        memcpy(&kansa->r[(size_t)j * (size_t)n], &kansa->q[(size_t)j * (size_t)m], (size_t)(j + 1) * sizeof(double));
    kansa->rank = numerical_rank(n, kansa->r);
    double reciprocal;
    info = LAPACKE_dtrcon(LAPACK_COL_MAJOR, '1', 'U', 'N', n, kansa->r, n, &reciprocal);
    if (info != 0) PDMC_FAIL(PDMC_ERR_EXTERN, "LAPACKE_dtrcon returned %d", info);
    kansa->condition = 1.0 / reciprocal;
    if (kansa->rank < n || reciprocal < 4.0 * DBL_EPSILON) // rounding keeps a singular matrix near 1 / DBL_EPSILON
        PDMC_FAIL(
            PDMC_ERR_SINGULAR,
            "the collocation matrix has rank %d of %d and condition %.1e: take a smaller solver.shape or a larger "
            "solver.spacing",
            kansa->rank, n, kansa->condition);
    for (int j = 0; j < n; j++) cblas_dscal(j + 1, norm[j], &kansa->r[(size_t)j * (size_t)n], 1);
    info = LAPACKE_dorgqr(LAPACK_COL_MAJOR, m, n, n, kansa->q, m, tau);
    if (info != 0) PDMC_FAIL(PDMC_ERR_EXTERN, "LAPACKE_dorgqr returned %d", info);
done:
    pdmc_free(tau);
    pdmc_free(norm);
    return status;
}

// The mean solution, and the largest row of A_0 x - F over the rows of equations; Q Q^T F - F is the same without
// error.
static pdmc_status solve_mean(pdmc_kansa *kansa)
{
    pdmc_status status = PDMC_OK;
    const int m = kansa->rows, n = kansa->unknowns;
    double *residual = NULL, *y = kansa->coefficients;
    PDMC_NEW(residual, m);
    for (int l = 0; l < kansa->cases; l++) {
        const double *load = &kansa->load[(size_t)l * (size_t)m];
        double *whitened = &kansa->whitened[(size_t)l * (size_t)n];
        cblas_dgemv(CblasColMajor, CblasTrans, m, n, 1.0, kansa->q, m, load, 1, 0.0, whitened, 1);
        if (l > 1) continue;
        cblas_daxpy(n, 1.0, whitened, 1, y, 1);
        cblas_daxpy(m, 1.0, load, 1, residual, 1);
    }
    cblas_dgemv(CblasColMajor, CblasNoTrans, m, n, 1.0, kansa->q, m, y, 1, -1.0, residual, 1);
    kansa->residual = fabs(residual[cblas_idamax(m, residual, 1)]);
    pdmc_kansa_unwhiten(kansa, 1, y);
done:
    pdmc_free(residual);
    return status;
}

void pdmc_kansa_whiten(const pdmc_kansa *kansa, int count, double row[])
{
    const int n = kansa->unknowns;
    cblas_dtrsm(CblasColMajor, CblasLeft, CblasUpper, CblasTrans, CblasNonUnit, n, count, 1.0, kansa->r, n, row, n);
}

void pdmc_kansa_unwhiten(const pdmc_kansa *kansa, int count, double v[])
{
    const int n = kansa->unknowns;
    cblas_dtrsm(CblasColMajor, CblasLeft, CblasUpper, CblasNoTrans, CblasNonUnit, n, count, 1.0, kansa->r, n, v, n);
}

static pdmc_status assemble_and_factor(pdmc_kansa *kansa, const pdmc_kansa_data *data)
{
    pdmc_status status = PDMC_OK;
    double *matrix = NULL;
    const double start = pdmc_seconds();
    PDMC_NEW(matrix, (size_t)kansa->rows * (size_t)kansa->unknowns);
    PDMC_TRY(pdmc_kansa_assemble(kansa, data, matrix));
    const double assembled = pdmc_seconds();
    cblas_domatcopy(CblasRowMajor, CblasTrans, kansa->rows, kansa->unknowns, 1.0, matrix, kansa->unknowns, kansa->q,
                    kansa->rows);
    PDMC_TRY(factor(kansa));
    PDMC_TRY(solve_mean(kansa));
    kansa->assembly_seconds = assembled - start;
    kansa->factorisation_seconds = pdmc_seconds() - assembled;
done:
    pdmc_free(matrix);
    return status;
}

pdmc_status pdmc_kansa_create(const pdmc_problem *problem, const pdmc_kansa_data *data, int threads, pdmc_kansa **kansa)
{
    PDMC_REQUIRE(threads >= 1, "%d threads: at least one is needed", threads);
    pdmc_status status = PDMC_OK;
    pdmc_kansa *made = NULL;
    pdmc_blas_prepare();
    if (!data || !data->traction) PDMC_TRY(pdmc_problem_check_equilibrium(problem));
    PDMC_NEW(made, 1);
    made->problem = problem;
    made->threads = threads;
    PDMC_TRY(prepare(made));
    PDMC_TRY(assemble_and_factor(made, data));
    *kansa = made;
    made = NULL;
done:
    pdmc_kansa_destroy(&made);
    return status;
}

void pdmc_kansa_destroy(pdmc_kansa **kansa)
{
    pdmc_kansa *old = *kansa;
    if (!old) return;
    pdmc_basis_clear(&old->basis);
    pdmc_collocation_clear(&old->points);
    pdmc_ring_rule_clear(&old->rings);
    pdmc_free(old->ring_rows);
    pdmc_free(old->is_traction);
    pdmc_free(old->q);
    pdmc_free(old->r);
    pdmc_load_cases_clear(&old->loads);
    pdmc_free(old->load);
    pdmc_free(old->whitened);
    pdmc_free(old->coefficients);
    pdmc_free(old);
    *kansa = NULL;
}
