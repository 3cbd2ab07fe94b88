// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "discretisation/crossings.h"
#include "discretisation/radial.h"
#include "discretisation/response.h"
#include "paper/paper_impl.h"

#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

// The operators of this model are not nearly multiples of one another: at 1e-13 the space is that of all forces on nodes.
static const double response_tolerance = 1e-6;

// K(xi) = K_0 + sum_p xi_p K_p. In y = K_0 x, forces, the mean operator is the identity and the others K_p K_0^-1; the
// model's coordinates z are those of the response space in it, y = basis z.
typedef struct {
    const pdmc_paper *paper;
    pdmc_response response;
    double *coefficients; // [dimension, unknowns] x of each coordinate
} expanded_operator;

static void destroy_operator(void *discretisation)
{
    expanded_operator *expansion = discretisation;
    pdmc_response_clear(&expansion->response);
    pdmc_free(expansion->coefficients);
    pdmc_free(expansion);
}

static pdmc_status perturb(const pdmc_affine *model, const double xi[], const double x[], double y[])
{
    const expanded_operator *expansion = model->discretisation;
    return pdmc_response_perturb(&expansion->response, model->terms, PDMC_BLOCK, xi, x, y);
}

static pdmc_status solve(const pdmc_affine *model, const double xi[], const double scale[], double x[])
{
    pdmc_status status = PDMC_OK;
    const expanded_operator *expansion = model->discretisation;
    const pdmc_paper *paper = expansion->paper;
    const int n = paper->unknowns;
    const size_t values = (size_t)n * (size_t)n, moved = (size_t)paper->rows_of_nodes * (size_t)n;
    double *matrix = NULL, *solution = NULL, *force = NULL;
    int *pivot = NULL;
    PDMC_NEW(matrix, values);
    PDMC_NEW(solution, n);
    PDMC_NEW(force, n);
    PDMC_NEW(pivot, n);
    memcpy(matrix, paper->matrix, values * sizeof *matrix);
    for (int p = 0; p < model->terms; p++)
        for (size_t k = 0; k < moved; k++) matrix[k] += xi[p] * paper->term[(size_t)p * moved + k];
    for (int l = 0; l < paper->cases; l++) cblas_daxpy(n, scale[l], &paper->load[l * n], 1, solution, 1);
    int info = LAPACKE_dgetrf(LAPACK_COL_MAJOR, n, n, matrix, n, pivot); // of the transpose
    if (info > 0) PDMC_FAIL(PDMC_ERR_SINGULAR, "the sample's system is singular");
    if (info == 0) info = LAPACKE_dgetrs(LAPACK_COL_MAJOR, 'T', n, 1, matrix, n, pivot, solution, n);
    if (info < 0) PDMC_FAIL(PDMC_ERR_EXTERN, "LAPACKE_dgetrf or dgetrs returned %d", info);
    cblas_dgemv(CblasRowMajor, CblasNoTrans, n, n, 1.0, paper->matrix, n, solution, 1, 0.0, force, 1);
    cblas_dgemv(CblasRowMajor, CblasNoTrans, model->unknowns, n, 1.0, expansion->response.basis, n, force, 1, 0.0, x,
                1);
done:
    pdmc_free(matrix);
    pdmc_free(solution);
    pdmc_free(force);
    pdmc_free(pivot);
    return status;
}

static pdmc_status apply_term(void *context, int term, int count, const double v[], double out[])
{
    pdmc_status status = PDMC_OK;
    const pdmc_paper *paper = ((const expanded_operator *)context)->paper;
    const int n = paper->unknowns, m = paper->rows_of_nodes;
    const size_t values = (size_t)count * (size_t)n;
    double *x = NULL;
    PDMC_NEW(x, values);
    memcpy(x, v, values * sizeof *x);
    PDMC_TRY(pdmc_paper_solve(paper, count, x));
    memset(out, 0, values * sizeof *out);
    cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, m, count, n, 1.0,
                &paper->term[(size_t)term * (size_t)m * (size_t)n], n, x, n, 0.0, out, n);
done:
    pdmc_free(x);
    return status;
}

static pdmc_status find_response(const pdmc_affine *model, double variation, expanded_operator *expansion)
{
    pdmc_status status = PDMC_OK;
    const pdmc_paper *paper = expansion->paper;
    const size_t n = (size_t)paper->unknowns;
    double *start = NULL, size[PDMC_PAPER_TERMS], norm = 0.0;
    PDMC_NEW(start, (size_t)paper->cases * n);
    memcpy(start, paper->load, (size_t)paper->cases * n * sizeof *start);
    for (size_t l = 0; l < 2; l++) norm += cblas_dnrm2((int)n, &paper->load[l * n], 1);
    pdmc_radial_sizes(model, variation, size);
    const pdmc_response_operator operator= {paper->unknowns,    model->terms, size,     norm,
                                            response_tolerance, apply_term,   expansion};
    PDMC_TRY(pdmc_response_create(&operator, paper->cases, start, &expansion->response));
    const size_t values = (size_t)expansion->response.dimension * n;
    PDMC_NEW(expansion->coefficients, values);
    memcpy(expansion->coefficients, expansion->response.basis, values * sizeof(double));
    PDMC_TRY(pdmc_paper_solve(paper, expansion->response.dimension, expansion->coefficients));
done:
    pdmc_free(start);
    return status;
}

static pdmc_status create_operator(const pdmc_paper *paper, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    static const pdmc_affine_verbs verbs = {.perturb = perturb, .solve = solve, .destroy = destroy_operator};
    const pdmc_uncertainty *noise = pdmc_problem_uncertainty(paper->problem, PDMC_QUANTITY_MICROMODULUS);
    expanded_operator *expansion = NULL;
    PDMC_NEW(expansion, 1);
    model->discretisation = expansion;
    model->verbs = &verbs;
    model->bins = noise ? noise->bins : 1;
    model->terms = model->radial_terms = noise ? paper->terms : 0;
    expansion->paper = paper;
    PDMC_TRY(pdmc_radial_weights(model));
    PDMC_TRY(find_response(model, noise ? noise->variation : 0.0, expansion));
    model->unknowns = expansion->response.dimension;
    model->cases = paper->cases;
    PDMC_NEW(model->solution, model->cases * model->unknowns);
    for (int l = 0; l < model->cases; l++)
        cblas_dgemv(CblasRowMajor, CblasNoTrans, model->unknowns, paper->unknowns, 1.0, expansion->response.basis,
                    paper->unknowns, &paper->load[l * paper->unknowns], 1, 0.0, &model->solution[l * model->unknowns], 1);
done:
    return status;
}

static pdmc_status fill_stress_intensity(const pdmc_paper *paper, const double coefficients[], pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const int n = paper->unknowns, count = 2 * model->tips;
    double *row = NULL;
    PDMC_NEW(row, (size_t)count * (size_t)n);
    PDMC_NEW(model->stress_intensity, count * model->unknowns);
    for (int t = 0; t < model->tips; t++) {
        double *first = &row[(size_t)(2 * t) * (size_t)n];
        PDMC_TRY(pdmc_paper_stress_intensity_rows(paper, paper->problem->energy.tips[t], first, first + n));
    }
    if (count > 0)
        cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, count, model->unknowns, n, 1.0, row, n, coefficients, n,
                    0.0, model->stress_intensity, model->unknowns);
done:
    pdmc_free(row);
    return status;
}

static pdmc_status open_rows(const void *method, void **context)
{
    pdmc_status status = PDMC_OK;
    const pdmc_paper **shared = NULL;
    PDMC_NEW(shared, 1);
    *shared = method;
    *context = shared;
done:
    return status;
}

static void displacement_rows(void *context, const double x[2], double row_u[], double row_v[])
{
    const pdmc_paper *paper = *(const pdmc_paper **)context;
    const size_t n = (size_t)paper->unknowns, scalars = (size_t)paper->basis.scalars;
    memset(row_u, 0, n * sizeof *row_u);
    memset(row_v, 0, n * sizeof *row_v);
    pdmc_paper_values(&paper->basis, x, x, row_u);
    memcpy(row_v + scalars, row_u, scalars * sizeof *row_v);
}

pdmc_status pdmc_paper_affine(const pdmc_paper *paper, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const double start = pdmc_seconds();
    const pdmc_displacement_functional displacement = {paper->unknowns, paper, open_rows, displacement_rows, pdmc_free};
    *model = (pdmc_affine){.tips = paper->problem->energy.tip_count, .angles = paper->problem->energy.angles};
    PDMC_TRY(create_operator(paper, model));
    const expanded_operator *expansion = model->discretisation;
    PDMC_TRY(fill_stress_intensity(paper, expansion->coefficients, model));
    const double made = pdmc_seconds();
    PDMC_TRY(pdmc_affine_fill_crossings(paper->problem, &displacement, expansion->coefficients, paper->threads, model));
    model->operator_seconds = made - start;
    model->energy_seconds = pdmc_seconds() - made;
done:
    if (status != PDMC_OK) pdmc_affine_clear(model);
    return status;
}
