// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "paper/paper_impl.h"

#include <cblas.h>
#include <float.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

static pdmc_status prepare(pdmc_paper *paper)
{
    pdmc_status status = PDMC_OK;
    const pdmc_problem *problem = paper->problem;
    const bool is_random = pdmc_problem_uncertainty(problem, PDMC_QUANTITY_MICROMODULUS);
    PDMC_TRY(pdmc_problem_check_equilibrium(problem));
    PDMC_TRY(pdmc_problem_free_motions(problem, &paper->motions, paper->motion));
    PDMC_TRY(pdmc_paper_basis_create(problem, &paper->basis));
    paper->terms = is_random ? PDMC_PAPER_TERMS : 1;
    paper->rows_of_nodes = 2 * paper->basis.nodes.count;
    paper->unknowns = 2 * paper->basis.scalars + paper->motions;
    const size_t n = (size_t)paper->unknowns;
    PDMC_NEW(paper->matrix, n * n);
    PDMC_NEW(paper->factor, n * n);
    PDMC_NEW(paper->pivot, n);
    PDMC_NEW(paper->scale, n);
    PDMC_TRY(pdmc_load_cases_create(problem, &paper->loads));
    paper->cases = 1 + paper->loads.count;
    PDMC_NEW(paper->load, (size_t)paper->cases * n);
    PDMC_NEW(paper->coefficients, n);
    if (is_random) PDMC_NEW(paper->term, (size_t)paper->terms * (size_t)paper->rows_of_nodes * n);
done:
    return status;
}

// Every unknown is scaled to a largest entry of 1, so that the condition number does not depend on units.
static pdmc_status scale_unknowns(pdmc_paper *paper)
{
    const int n = paper->unknowns;
    memcpy(paper->factor, paper->matrix, (size_t)n * (size_t)n * sizeof *paper->factor);
    for (int j = 0; j < n; j++) {
        const double largest = fabs(paper->matrix[j + (int64_t)n * (int64_t)cblas_idamax(n, &paper->matrix[j], n)]);
        if (!(largest > 0.0 && isfinite(largest)))
            return pdmc_raise(PDMC_ERR_SINGULAR, "unknown %d has no finite row", j);
        paper->scale[j] = 1.0 / largest;
        cblas_dscal(n, paper->scale[j], &paper->factor[j], n);
    }
    return PDMC_OK;
}

// The matrix by rows is its transpose by columns.
static pdmc_status factor(pdmc_paper *paper)
{
    pdmc_status status = PDMC_OK;
    const int n = paper->unknowns;
    double reciprocal;
    PDMC_TRY(scale_unknowns(paper));
    const double norm = LAPACKE_dlange(LAPACK_COL_MAJOR, 'I', n, n, paper->factor, n);
    int info = LAPACKE_dgetrf(LAPACK_COL_MAJOR, n, n, paper->factor, n, paper->pivot);
    if (info < 0) PDMC_FAIL(PDMC_ERR_EXTERN, "LAPACKE_dgetrf returned %d", info);
    if (info > 0) PDMC_FAIL(PDMC_ERR_SINGULAR, "the collocation matrix is singular at unknown %d", info - 1);
    info = LAPACKE_dgecon(LAPACK_COL_MAJOR, 'I', n, paper->factor, n, norm, &reciprocal);
    if (info != 0) PDMC_FAIL(PDMC_ERR_EXTERN, "LAPACKE_dgecon returned %d", info);
    paper->condition = 1.0 / reciprocal;
    if (!(reciprocal > 4.0 * DBL_EPSILON)) // rounding keeps a singular matrix near 1 / DBL_EPSILON
        PDMC_FAIL(PDMC_ERR_SINGULAR,
                  "the collocation matrix has condition %.1e: take a smaller solver.shape or a larger solver.spacing",
                  paper->condition);
done:
    return status;
}

pdmc_status pdmc_paper_solve(const pdmc_paper *paper, int count, double v[])
{
    const int n = paper->unknowns;
    const int info = LAPACKE_dgetrs(LAPACK_COL_MAJOR, 'T', n, count, paper->factor, n, paper->pivot, v, n);
    if (info != 0) return pdmc_raise(PDMC_ERR_EXTERN, "LAPACKE_dgetrs returned %d", info);
    for (int s = 0; s < count; s++)
        for (int j = 0; j < n; j++) v[(size_t)s * (size_t)n + (size_t)j] *= paper->scale[j];
    return PDMC_OK;
}

// The mean solution, and the largest row of the equations that is out of balance without the balancing unknowns.
static pdmc_status solve_mean(pdmc_paper *paper)
{
    pdmc_status status = PDMC_OK;
    const int n = paper->unknowns, fields = 2 * paper->basis.scalars;
    double *x = paper->coefficients, *residual = NULL;
    PDMC_NEW(residual, n);
    for (int l = 0; l < 2; l++) cblas_daxpy(n, 1.0, &paper->load[l * n], 1, x, 1);
    memcpy(residual, x, (size_t)n * sizeof *residual);
    PDMC_TRY(pdmc_paper_solve(paper, 1, x));
    cblas_dgemv(CblasRowMajor, CblasNoTrans, n, fields, 1.0, paper->matrix, n, x, 1, -1.0, residual, 1);
    paper->residual = fabs(residual[cblas_idamax(n, residual, 1)]);
done:
    pdmc_free(residual);
    return status;
}

pdmc_status pdmc_paper_create(const pdmc_problem *problem, int threads, pdmc_paper **paper)
{
    PDMC_REQUIRE(threads >= 1, "%d threads: at least one is needed", threads);
    PDMC_REQUIRE(problem->solver.edge_layer > 0.0, "edge layer %g is not positive", problem->solver.edge_layer);
    pdmc_status status = PDMC_OK;
    pdmc_paper *made = NULL;
    pdmc_blas_prepare();
    PDMC_NEW(made, 1);
    made->problem = problem;
    made->threads = threads;
    const double start = pdmc_seconds();
    PDMC_TRY(prepare(made));
    PDMC_TRY(pdmc_paper_assemble(made));
    const double assembled = pdmc_seconds();
    PDMC_TRY(factor(made));
    PDMC_TRY(solve_mean(made));
    made->assembly_seconds = assembled - start;
    made->factorisation_seconds = pdmc_seconds() - assembled;
    *paper = made;
    made = NULL;
done:
    pdmc_paper_destroy(&made);
    return status;
}

void pdmc_paper_destroy(pdmc_paper **paper)
{
    pdmc_paper *old = *paper;
    if (!old) return;
    pdmc_paper_basis_clear(&old->basis);
    pdmc_free(old->matrix);
    pdmc_free(old->term);
    pdmc_free(old->factor);
    pdmc_free(old->pivot);
    pdmc_free(old->scale);
    pdmc_load_cases_clear(&old->loads);
    pdmc_free(old->load);
    pdmc_free(old->coefficients);
    pdmc_free(old);
    *paper = NULL;
}
