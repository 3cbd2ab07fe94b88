// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/affine.h"

#include "base/base_impl.h"
#include "kansa/energy.h"
#include "kansa/rings.h"
#include "kansa/weights.h"

#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

// The model's coordinates are those of the response space: x = basis y.
typedef struct {
    const pdmc_kansa *kansa;
    pdmc_response response;
    double *coefficients; // [dimension, unknowns of the collocation] of the space's basis
    double *ring_rows;    // [terms, 2 interior, unknowns of the collocation] in y, for direct solves only
} sampled_operator;

static void destroy_operator(void *discretisation)
{
    sampled_operator *rings = discretisation;
    pdmc_response_clear(&rings->response);
    pdmc_free(rings->coefficients);
    pdmc_free(rings->ring_rows);
    pdmc_free(rings);
}

static pdmc_status perturb(const pdmc_affine *model, const double xi[], const double x[], double y[])
{
    const sampled_operator *rings = model->discretisation;
    return pdmc_response_perturb(&rings->response, model->terms, PDMC_BLOCK, xi, x, y);
}

// Turns a row of the mean, Q, into that of A(xi) R^-1.
static void add_rings(const sampled_operator *rings, int terms, const double xi[], int row, double values[])
{
    const pdmc_kansa *kansa = rings->kansa;
    const int n = kansa->unknowns, interior = 2 * kansa->points.interior_count;
    const int boundary = row - interior;
    if (row < interior) {
        for (int q = 0; q < terms; q++)
            cblas_daxpy(n, xi[q], &rings->ring_rows[(size_t)(q * interior + row) * (size_t)n], 1, values, 1);
    } else if (boundary < 2 * kansa->points.boundary_count && kansa->is_traction[boundary]) {
        double modulus = 1.0;
        for (int q = 0; q < terms; q++) modulus += xi[q] * kansa->share[q];
        cblas_dscal(n, modulus, values, 1);
    }
}

static pdmc_status solve(const pdmc_affine *model, const double xi[], const double scale[], double x[])
{
    pdmc_status status = PDMC_OK;
    const sampled_operator *rings = model->discretisation;
    const pdmc_kansa *kansa = rings->kansa;
    const int n = kansa->unknowns, m = kansa->rows;
    double *transposed = NULL, *load = NULL; // [unknowns, rows] column-major
    PDMC_REQUIRE(rings->ring_rows, "the model was made without direct solves");
    PDMC_NEW(transposed, (size_t)n * (size_t)m);
    PDMC_NEW(load, m);
    cblas_domatcopy(CblasColMajor, CblasTrans, m, n, 1.0, kansa->q, m, transposed, n);
    for (int row = 0; row < m; row++) add_rings(rings, model->terms, xi, row, &transposed[(size_t)row * (size_t)n]);
    cblas_dgemv(CblasRowMajor, CblasTrans, kansa->cases, m, 1.0, kansa->load, m, scale, 1, 0.0, load, 1);
    const int info = LAPACKE_dgels(LAPACK_COL_MAJOR, 'T', n, m, 1, transposed, n, load, m);
    if (info > 0) PDMC_FAIL(PDMC_ERR_SINGULAR, "the sample's system is rank deficient");
    if (info < 0) PDMC_FAIL(PDMC_ERR_EXTERN, "LAPACKE_dgels returned %d", info);
    cblas_dgemv(CblasRowMajor, CblasNoTrans, model->unknowns, n, 1.0, rings->response.basis, n, load, 1, 0.0, x, 1);
done:
    pdmc_free(transposed);
    pdmc_free(load);
    return status;
}

enum { PANEL = 64 }; // rows of a task, the same for any number of threads

static pdmc_status whiten_rings(const pdmc_kansa *kansa, int terms, sampled_operator *rings)
{
    pdmc_status status = PDMC_OK;
    const int n = kansa->unknowns, count = terms * 2 * kansa->points.interior_count;
    PDMC_NEW(rings->ring_rows, (size_t)count * (size_t)n);
    memcpy(rings->ring_rows, kansa->ring_rows, (size_t)count * (size_t)n * sizeof(double));
#pragma omp parallel for schedule(dynamic) num_threads(kansa->threads)
    for (int first = 0; first < count; first += PANEL)
        pdmc_kansa_whiten(kansa, count - first < PANEL ? count - first : PANEL,
                          &rings->ring_rows[(size_t)first * (size_t)n]);
done:
    return status;
}

// Five standard deviations of each ring's weight.
static void expected_sizes(const pdmc_kansa *kansa, double variation, double size[PDMC_MAX_RINGS])
{
    const pdmc_ring_rule *rings = &kansa->rings;
    for (int q = 0; q < rings->rings; q++) {
        double sum = 0.0;
        for (int b = 0; b < rings->bins; b++) {
            const double weight = rings->weight[b * rings->rings + q];
            sum += weight * weight;
        }
        size[q] = 5.0 * variation * sqrt(sum);
    }
}

// The span of the words that start from the mean solutions and from the directions of the least squares.
static pdmc_status find_response(const pdmc_kansa *kansa, int terms, const double size[], sampled_operator *rings)
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)kansa->unknowns;
    pdmc_ring_operator operators = {0};
    double *start = NULL, norm = 0.0;
    int count = 0;
    PDMC_TRY(pdmc_ring_operator_create(kansa, &operators));
    PDMC_NEW(start, (size_t)(kansa->cases * (terms + 1)) * n);
    for (int l = 0; l < kansa->cases; l++) {
        const double *mean = &kansa->whitened[(size_t)l * n];
        if (l < 2) norm += cblas_dnrm2((int)n, mean, 1);
        memcpy(&start[(size_t)count++ * n], mean, n * sizeof *start);
        for (int q = 0; q < terms; q++) {
            double *direction = &start[(size_t)count++ * n];
            pdmc_ring_operator_residual(&operators, q, l, direction);
            cblas_dscal((int)n, size[q], direction, 1);
        }
    }
    const pdmc_response_operator operator= {kansa->unknowns,          terms,     size, norm, 1e-13,
                                            pdmc_ring_operator_apply, &operators};
    PDMC_TRY(pdmc_response_create(&operator, count, start, &rings->response));
    PDMC_NEW(rings->coefficients, (size_t)rings->response.dimension * n);
    memcpy(rings->coefficients, rings->response.basis, (size_t)rings->response.dimension * n * sizeof(double));
    pdmc_kansa_unwhiten(kansa, rings->response.dimension, rings->coefficients);
done:
    pdmc_free(start);
    pdmc_ring_operator_clear(&operators);
    return status;
}

static pdmc_status create_operator(const pdmc_kansa *kansa, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    static const pdmc_affine_verbs verbs = {.perturb = perturb, .solve = solve, .destroy = destroy_operator};
    const pdmc_uncertainty *noise = pdmc_problem_uncertainty(kansa->problem, PDMC_QUANTITY_MICROMODULUS);
    sampled_operator *rings = NULL;
    double size[PDMC_MAX_RINGS];
    PDMC_NEW(rings, 1);
    model->discretisation = rings;
    model->verbs = &verbs;
    model->bins = kansa->rings.bins;
    model->terms = model->radial_terms = noise ? kansa->rings.rings : 0;
    rings->kansa = kansa;
    expected_sizes(kansa, noise ? noise->variation : 0.0, size);
    PDMC_TRY(find_response(kansa, model->terms, size, rings));
    if (kansa->problem->sampling.inverse == PDMC_INVERSE_DIRECT) PDMC_TRY(whiten_rings(kansa, model->terms, rings));
    model->unknowns = rings->response.dimension;
    model->cases = kansa->cases;
    PDMC_NEW(model->solution, model->cases * model->unknowns);
    for (int l = 0; l < model->cases; l++)
        cblas_dgemv(CblasRowMajor, CblasNoTrans, model->unknowns, kansa->unknowns, 1.0, rings->response.basis,
                    kansa->unknowns, &kansa->whitened[(size_t)l * (size_t)kansa->unknowns], 1, 0.0,
                    &model->solution[l * model->unknowns], 1);
done:
    return status;
}

static pdmc_status fill_stress_intensity(const pdmc_kansa *kansa, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const sampled_operator *rings = model->discretisation;
    const int n = kansa->unknowns, count = 2 * model->tips;
    double *row = NULL;
    PDMC_NEW(row, (size_t)count * (size_t)n);
    PDMC_NEW(model->stress_intensity, count * model->unknowns);
    for (int t = 0; t < model->tips; t++)
        pdmc_kansa_stress_intensity_rows(kansa, kansa->problem->energy.tips[t], &row[(size_t)(2 * t) * (size_t)n],
                                         &row[(size_t)(2 * t + 1) * (size_t)n]);
    if (count > 0)
        cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, count, model->unknowns, n, 1.0, row, n,
                    rings->coefficients, n, 0.0, model->stress_intensity, model->unknowns);
done:
    pdmc_free(row);
    return status;
}

pdmc_status pdmc_kansa_affine(const pdmc_kansa *kansa, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const double start = pdmc_seconds();
    *model = (pdmc_affine){.tips = kansa->problem->energy.tip_count, .angles = kansa->problem->energy.angles};
    PDMC_TRY(create_operator(kansa, model));
    PDMC_TRY(pdmc_kansa_weights(kansa, model));
    PDMC_TRY(fill_stress_intensity(kansa, model));
    const double made = pdmc_seconds();
    const sampled_operator *rings = model->discretisation;
    PDMC_TRY(pdmc_kansa_energy(kansa, rings->coefficients, model));
    model->operator_seconds = made - start;
    model->energy_seconds = pdmc_seconds() - made;
done:
    if (status != PDMC_OK) pdmc_affine_clear(model);
    return status;
}
