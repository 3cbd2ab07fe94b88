// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/affine.h"

#include "base/base_impl.h"
#include "discretisation/crossings.h"
#include "discretisation/radial.h"
#include "discretisation/response.h"
#include "visible/rows.h"
#include "visible/system.h"
#include "visible/tip.h"

#include <cblas.h>
#include <math.h>
#include <string.h>

// Of the solution's norm: energies to 1e-6. What the expansion of c(r) leaves out is larger, and so would be the space.
static const double tolerance = 1e-6;

// The model's coordinates are those of the response space: u = basis^T y.
typedef struct {
    const pdmc_visible *visible;
    pdmc_response response;
    double *field; // [unknowns of the nodes, dimension] the displacements of each coordinate
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
    const int n = made->visible->unknowns;
    cblas_dgemv(CblasRowMajor, CblasNoTrans, made->response.dimension, n, 1.0, made->response.basis, n, u, 1, 0.0, y,
                1);
}

static pdmc_status solve(const pdmc_affine *model, const double xi[], const double scale[], double x[])
{
    pdmc_status status = PDMC_OK;
    const response_model *made = model->discretisation;
    const pdmc_visible *visible = made->visible;
    pdmc_factor factor = {0};
    const int n = visible->unknowns;
    double *load = NULL;
    PDMC_NEW(load, n);
    for (int l = 0; l < visible->cases; l++) cblas_daxpy(n, scale[l], &visible->load[l * n], 1, load, 1);
    PDMC_TRY(pdmc_visible_factor(visible, xi, &factor));
    PDMC_TRY(pdmc_visible_solve(visible, &factor, load, load));
    project(made, load, x);
done:
    pdmc_free(load);
    pdmc_factor_clear(&factor);
    return status;
}

// out = K_0^-1 K_q v, vector by vector.
static pdmc_status apply(void *context, int q, int count, const double v[], double out[])
{
    const pdmc_visible *visible = context;
    const size_t n = (size_t)visible->unknowns;
    pdmc_status status = PDMC_OK;
#pragma omp parallel for schedule(dynamic) num_threads(visible->threads)
    for (int k = 0; k < count; k++) {
        double *image = &out[(size_t)k * n];
        pdmc_visible_product(visible, q + 1, &v[(size_t)k * n], image);
        const pdmc_status mine = pdmc_visible_solve(visible, &visible->factor, image, image);
        if (mine != PDMC_OK) {
#pragma omp critical(pdmc_visible_affine)
            status = mine;
        }
    }
    return status;
}

static pdmc_status find_response(const pdmc_visible *visible, const pdmc_affine *model, const double size[],
                                 response_model *made)
{
    pdmc_status status = PDMC_OK;
    const int n = visible->unknowns, cases = visible->cases;
    double *start = NULL;
    PDMC_NEW(start, cases * n);
    memcpy(start, visible->solution, (size_t)(cases * n) * sizeof *start);
    const double norm = cblas_dnrm2(n, start, 1) + cblas_dnrm2(n, start + n, 1);
    const pdmc_response_operator operator= {n, model->terms, size, norm, tolerance, apply, (void *)visible};
    PDMC_TRY(pdmc_response_create(&operator, cases, start, &made->response));
    const int r = made->response.dimension;
    PDMC_NEW(made->field, (size_t)r * (size_t)n);
    for (int k = 0; k < r; k++) cblas_dcopy(n, &made->response.basis[(size_t)k * (size_t)n], 1, &made->field[k], r);
done:
    pdmc_free(start);
    return status;
}

static pdmc_status create_model(const pdmc_visible *visible, pdmc_affine *model)
{
    static const pdmc_affine_verbs verbs = {.perturb = perturb, .solve = solve, .destroy = destroy_model};
    pdmc_status status = PDMC_OK;
    const pdmc_uncertainty *noise = pdmc_problem_uncertainty(visible->problem, PDMC_QUANTITY_MICROMODULUS);
    double size[PDMC_VISIBLE_DEGREE + 1];
    response_model *made = NULL;
    PDMC_NEW(made, 1);
    model->discretisation = made;
    model->verbs = &verbs;
    made->visible = visible;
    model->bins = noise ? noise->bins : 1;
    model->terms = model->radial_terms = visible->terms;
    PDMC_TRY(pdmc_radial_weights(model));
    pdmc_radial_sizes(model, noise ? noise->variation : 0.0, size);
    PDMC_TRY(find_response(visible, model, size, made));
    model->unknowns = made->response.dimension;
    model->cases = visible->cases;
    PDMC_NEW(model->solution, model->cases * model->unknowns);
    for (int l = 0; l < model->cases; l++)
        project(made, &visible->solution[l * visible->unknowns], &model->solution[l * model->unknowns]);
done:
    return status;
}

static pdmc_status fill_stress_intensity(const pdmc_visible *visible, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const response_model *made = model->discretisation;
    const int n = visible->unknowns;
    double *row = NULL;
    PDMC_NEW(model->stress_intensity, 2 * model->tips * model->unknowns);
    for (int t = 0; t < model->tips; t++) {
        pdmc_free(row);
        PDMC_NEW(row, 2 * n);
        PDMC_TRY(pdmc_visible_stress_intensity_rows(visible, visible->problem->energy.tips[t], row, row + n));
        for (int k = 0; k < 2; k++)
            project(made, row + k * n, &model->stress_intensity[(size_t)(2 * t + k) * (size_t)model->unknowns]);
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
    const pdmc_visible *visible = made->visible;
    const int r = made->response.dimension;
    const pdmc_view view = {{x[0], x[1]}, -1, 0};
    const pdmc_stencil *stencil = &visible->stencils[pdmc_stencil_owner(&visible->field, &view)];
    double weight[PDMC_STENCIL_NODES];
    pdmc_stencil_evaluate(stencil, x, weight);
    memset(row_u, 0, (size_t)r * sizeof *row_u);
    memset(row_v, 0, (size_t)r * sizeof *row_v);
    for (int k = 0; k < stencil->count; k++) {
        const double *field = &made->field[(size_t)(2 * stencil->node[k]) * (size_t)r];
        cblas_daxpy(r, weight[k], field, 1, row_u, 1);
        cblas_daxpy(r, weight[k], field + r, 1, row_v, 1);
    }
}

// The rows are made in the model's coordinates, for which only the nodes of one stencil are needed.
static pdmc_status fill_crossings(const pdmc_visible *visible, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const int r = model->unknowns;
    const pdmc_displacement_functional displacement = {r, model->discretisation, open_rows, displacement_rows,
                                                       close_rows};
    double *identity = NULL;
    PDMC_NEW(identity, r * r);
    for (int k = 0; k < r; k++) identity[k * r + k] = 1.0;
    PDMC_TRY(pdmc_affine_fill_crossings(visible->problem, &displacement, identity, visible->threads, model));
done:
    pdmc_free(identity);
    return status;
}

pdmc_status pdmc_visible_affine(const pdmc_visible *visible, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const double start = pdmc_seconds();
    const pdmc_energy_request *energy = &visible->problem->energy;
    *model = (pdmc_affine){.tips = energy->tip_count, .angles = energy->angles};
    PDMC_TRY(create_model(visible, model));
    PDMC_TRY(fill_stress_intensity(visible, model));
    const double made = pdmc_seconds();
    PDMC_TRY(fill_crossings(visible, model));
    model->operator_seconds = made - start;
    model->energy_seconds = pdmc_seconds() - made;
done:
    if (status != PDMC_OK) pdmc_affine_clear(model);
    return status;
}
