// SPDX-License-Identifier: GPL-3.0-or-later
#include "discretisation/response_affine.h"

#include "base/base_impl.h"
#include "discretisation/crossings.h"
#include "discretisation/response.h"

#include <cblas.h>
#include <string.h>

// Of the solution's norm: energies to 1e-6. What the expansion of c(r) leaves out is larger, and so would be the space.
static const double tolerance = 1e-6;

typedef struct {
    pdmc_nodal_method nodal;
    pdmc_response response;
    double *field; // [unknowns, dimension] the displacements of each coordinate
} response_model;

static void destroy_model(void *discretisation)
{
    response_model *made = discretisation;
    pdmc_response_clear(&made->response);
    pdmc_free(made->field);
    pdmc_free(made);
}

static pdmc_status perturb(const pdmc_affine *model, const double xi[], const double x[], double y[])
{
    const response_model *made = model->discretisation;
    return pdmc_response_perturb(&made->response, model->terms, PDMC_BLOCK, xi, x, y);
}

static void project(const response_model *made, const double u[], double y[])
{
    const int n = made->nodal.unknowns;
    cblas_dgemv(CblasRowMajor, CblasNoTrans, made->response.dimension, n, 1.0, made->response.basis, n, u, 1, 0.0, y,
                1);
}

static pdmc_status solve(const pdmc_affine *model, const double xi[], const double scale[], double x[])
{
    pdmc_status status = PDMC_OK;
    const response_model *made = model->discretisation;
    double *u = NULL;
    PDMC_NEW(u, made->nodal.unknowns);
    PDMC_TRY(made->nodal.solve(made->nodal.method, xi, scale, u));
    project(made, u, x);
done:
    pdmc_free(u);
    return status;
}

static pdmc_status apply(void *context, int q, int count, const double v[], double out[])
{
    const pdmc_nodal_method *nodal = context;
    const size_t n = (size_t)nodal->unknowns;
    pdmc_status status = PDMC_OK;
#pragma omp parallel for schedule(dynamic) num_threads(nodal->threads)
    for (int k = 0; k < count; k++) {
        const pdmc_status mine = nodal->apply(nodal->method, q, &v[(size_t)k * n], &out[(size_t)k * n]);
        if (mine != PDMC_OK) {
#pragma omp critical(pdmc_response_affine)
            status = mine;
        }
    }
    return status;
}

static pdmc_status find_response(const pdmc_affine *model, const double size[], response_model *made)
{
    pdmc_status status = PDMC_OK;
    const int n = made->nodal.unknowns, cases = made->nodal.cases;
    const size_t values = (size_t)cases * (size_t)n;
    double *start = NULL, norm = 0.0;
    PDMC_NEW(start, values);
    memcpy(start, made->nodal.solution, values * sizeof *start);
    for (int l = 0; l < 2; l++) norm += cblas_dnrm2(n, start + l * n, 1);
    const pdmc_response_operator operator= {n, model->terms, size, norm, tolerance, apply, &made->nodal};
    PDMC_TRY(pdmc_response_create(&operator, cases, start, &made->response));
    const int r = made->response.dimension;
    PDMC_NEW(made->field, (size_t)r * (size_t)n);
    for (int k = 0; k < r; k++) cblas_dcopy(n, &made->response.basis[(size_t)k * (size_t)n], 1, &made->field[k], r);
done:
    pdmc_free(start);
    return status;
}

static pdmc_status create_model(const pdmc_nodal_method *nodal, const double size[], pdmc_affine *model)
{
    static const pdmc_affine_verbs verbs = {.perturb = perturb, .solve = solve, .destroy = destroy_model};
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)nodal->unknowns;
    response_model *made = NULL;
    PDMC_NEW(made, 1);
    model->discretisation = made;
    model->verbs = &verbs;
    made->nodal = *nodal;
    PDMC_TRY(find_response(model, size, made));
    model->unknowns = made->response.dimension;
    model->cases = nodal->cases;
    PDMC_NEW(model->solution, model->cases * model->unknowns);
    for (int l = 0; l < model->cases; l++)
        project(made, &nodal->solution[(size_t)l * n], &model->solution[l * model->unknowns]);
done:
    return status;
}

static pdmc_status fill_stress_intensity(pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const response_model *made = model->discretisation;
    const pdmc_nodal_method *nodal = &made->nodal;
    const size_t n = (size_t)nodal->unknowns;
    double *row = NULL;
    PDMC_NEW(model->stress_intensity, 2 * model->tips * model->unknowns);
    PDMC_NEW(row, 2 * n);
    for (int t = 0; t < model->tips; t++) {
        memset(row, 0, 2 * n * sizeof *row);
        PDMC_TRY(nodal->intensity(nodal->method, nodal->problem->energy.tips[t], row, row + n));
        for (size_t k = 0; k < 2; k++)
            project(made, row + k * n, &model->stress_intensity[(2 * (size_t)t + k) * (size_t)model->unknowns]);
    }
done:
    pdmc_free(row);
    return status;
}

static pdmc_status open_rows(const void *method, void **context)
{
    *context = (void *)method; // needs no scratch
    return PDMC_OK;
}

static void close_rows(void *context)
{
    (void)context;
}

static void displacement_rows(void *context, const double x[2], double row_u[], double row_v[])
{
    const response_model *made = context;
    const int r = made->response.dimension;
    int node[PDMC_POINT_NODES];
    double weight[PDMC_POINT_NODES];
    const int count = made->nodal.point(made->nodal.method, x, node, weight);
    memset(row_u, 0, (size_t)r * sizeof *row_u);
    memset(row_v, 0, (size_t)r * sizeof *row_v);
    for (int k = 0; k < count; k++) {
        const double *field = &made->field[2 * (size_t)node[k] * (size_t)r];
        cblas_daxpy(r, weight[k], field, 1, row_u, 1);
        cblas_daxpy(r, weight[k], field + r, 1, row_v, 1);
    }
}

// The rows are made in the model's coordinates, for which only the nodes about a point are needed.
static pdmc_status fill_crossings(const pdmc_nodal_method *nodal, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const int r = model->unknowns;
    const pdmc_displacement_functional displacement = {r, model->discretisation, open_rows, displacement_rows,
                                                       close_rows};
    double *identity = NULL;
    PDMC_NEW(identity, r * r);
    for (int k = 0; k < r; k++) identity[k * r + k] = 1.0;
    PDMC_TRY(pdmc_affine_fill_crossings(nodal->problem, &displacement, identity, nodal->threads, model));
done:
    pdmc_free(identity);
    return status;
}

pdmc_status pdmc_response_affine(const pdmc_nodal_method *nodal, const double size[], pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const double start = pdmc_seconds();
    PDMC_TRY(create_model(nodal, size, model));
    PDMC_TRY(fill_stress_intensity(model));
    const double made = pdmc_seconds();
    PDMC_TRY(fill_crossings(nodal, model));
    model->operator_seconds = made - start;
    model->energy_seconds = pdmc_seconds() - made;
done:
    return status;
}
