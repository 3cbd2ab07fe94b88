// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/plate.h"

#include "base/base_impl.h"
#include "discretisation/crossings.h"
#include "discretisation/response.h"

#include <cblas.h>
#include <math.h>
#include <string.h>

static const double tolerance = 1e-6; // of the solution's norm: energies to 1e-6

// The model's coordinates are those of the response space: u = basis^T y.
typedef struct {
    const pdmc_plate_elements *plate;
    pdmc_response response;
    double *field; // [unknowns of the plate, dimension] the displacements of each coordinate
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
    const int n = made->plate->unknowns;
    cblas_dgemv(CblasRowMajor, CblasNoTrans, made->response.dimension, n, 1.0, made->response.basis, n, u, 1, 0.0, y,
                1);
}

static pdmc_status solve(const pdmc_affine *model, const double xi[], const double scale[], double x[])
{
    pdmc_status status = PDMC_OK;
    const response_model *made = model->discretisation;
    const pdmc_plate_elements *plate = made->plate;
    double weight[PDMC_PLATE_PLANES], *u = NULL;
    pdmc_bond_matrix matrix = {0};
    pdmc_bond_factor *factor = NULL;
    for (int p = 0; p < plate->form.planes; p++) weight[p] = 1.0 + (p < model->terms ? xi[p] : 0.0);
    PDMC_NEW(u, plate->unknowns);
    PDMC_TRY(pdmc_plate_form_matrix(&plate->form, weight, plate->held, &matrix));
    PDMC_TRY(pdmc_bond_factor_create(&matrix, plate->factor, NULL, &factor));
    PDMC_TRY(pdmc_plate_elements_solve(plate, factor, weight, scale, u));
    project(made, u, x);
done:
    pdmc_bond_factor_destroy(&factor);
    pdmc_bond_matrix_clear(&matrix);
    pdmc_free(u);
    return status;
}

// out = K_0^-1 K_q v on the unknowns that are not held, vector by vector.
static pdmc_status apply_one(const pdmc_plate_elements *plate, int q, const double v[], double out[])
{
    double weight[PDMC_PLATE_PLANES] = {0.0};
    weight[q] = 1.0;
    pdmc_plate_form_multiply(&plate->form, weight, v, out);
    for (int k = 0; k < plate->unknowns; k++)
        if (plate->held[k / 2] & (1U << (k % 2))) out[k] = 0.0;
    return pdmc_bond_factor_solve(plate->factor, 1, out, out);
}

static pdmc_status apply(void *context, int q, int count, const double v[], double out[])
{
    const pdmc_plate_elements *plate = context;
    const size_t n = (size_t)plate->unknowns;
    pdmc_status status = PDMC_OK;
#pragma omp parallel for schedule(dynamic) num_threads(plate->threads)
    for (int k = 0; k < count; k++) {
        const pdmc_status mine = apply_one(plate, q, &v[(size_t)k * n], &out[(size_t)k * n]);
        if (mine != PDMC_OK) {
#pragma omp critical(pdmc_plate_affine)
            status = mine;
        }
    }
    return status;
}

// A plane's deviation is the mean of those of its bins with the weight r^2, as in the effective modulus
// E_eff = (pi / 3) int c r^2 dr.
static pdmc_status fill_weights(const pdmc_plate_elements *plate, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const int bins = model->bins, terms = model->terms;
    PDMC_NEW(model->term_weight, bins * terms);
    PDMC_NEW(model->modulus_weight, bins);
    for (int b = 0; b < bins; b++) {
        const double from = (double)b / bins, to = (double)(b + 1) / bins;
        model->modulus_weight[b] = to * to * to - from * from * from;
        for (int p = 0; p < terms; p++) {
            const double inner = (double)p / terms, outer = (double)(p + 1) / terms;
            const double low = fmax(from, inner), high = fmin(to, outer);
            if (low < high)
                model->term_weight[b * terms + p] =
                    (high * high * high - low * low * low) / (outer * outer * outer - inner * inner * inner);
        }
    }
    (void)plate;
done:
    return status;
}

// The size that is to be expected of each coefficient: five standard deviations.
static void expected_sizes(const pdmc_affine *model, double variation, double size[])
{
    for (int p = 0; p < model->terms; p++)
        size[p] = 5.0 * variation * cblas_dnrm2(model->bins, &model->term_weight[p], model->terms);
}

static pdmc_status find_response(const pdmc_plate_elements *plate, const pdmc_affine *model, const double size[],
                                 response_model *made)
{
    pdmc_status status = PDMC_OK;
    const int n = plate->unknowns, cases = model->cases;
    double *start = NULL;
    PDMC_NEW(start, (size_t)cases * (size_t)n);
    memcpy(start, plate->solution, (size_t)cases * (size_t)n * sizeof *start);
    const double norm = cblas_dnrm2(n, start, 1) + cblas_dnrm2(n, start + n, 1);
    const pdmc_response_operator operator= {n, model->terms, size, norm, tolerance, apply, (void *)plate};
    PDMC_TRY(pdmc_response_create(&operator, cases, start, &made->response));
    const int r = made->response.dimension;
    PDMC_NEW(made->field, (size_t)r * (size_t)n);
    for (int k = 0; k < r; k++) cblas_dcopy(n, &made->response.basis[(size_t)k * (size_t)n], 1, &made->field[k], r);
done:
    pdmc_free(start);
    return status;
}

static pdmc_status create_model(const pdmc_plate_elements *plate, pdmc_affine *model)
{
    static const pdmc_affine_verbs verbs = {.perturb = perturb, .solve = solve, .destroy = destroy_model};
    pdmc_status status = PDMC_OK;
    const pdmc_uncertainty *noise = pdmc_problem_uncertainty(plate->problem, PDMC_QUANTITY_MICROMODULUS);
    double size[PDMC_PLATE_PLANES];
    response_model *made = NULL;
    PDMC_NEW(made, 1);
    model->discretisation = made;
    model->verbs = &verbs;
    made->plate = plate;
    model->bins = noise ? noise->bins : 1;
    model->terms = model->radial_terms = noise ? plate->form.planes : 0;
    model->cases = 1 + plate->loads.count;
    PDMC_TRY(fill_weights(plate, model));
    expected_sizes(model, noise ? noise->variation : 0.0, size);
    PDMC_TRY(find_response(plate, model, size, made));
    model->unknowns = made->response.dimension;
    PDMC_NEW(model->solution, model->cases * model->unknowns);
    for (int l = 0; l < model->cases; l++)
        project(made, &plate->solution[(size_t)l * (size_t)plate->unknowns], &model->solution[l * model->unknowns]);
done:
    return status;
}

static pdmc_status fill_intensities(const pdmc_plate_elements *plate, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const response_model *made = model->discretisation;
    const size_t n = (size_t)plate->unknowns;
    double *row = NULL;
    PDMC_NEW(model->stress_intensity, 2 * model->tips * model->unknowns);
    PDMC_NEW(row, 2 * n);
    for (int t = 0; t < model->tips; t++) {
        memset(row, 0, 2 * n * sizeof *row);
        PDMC_TRY(pdmc_plate_intensity_rows(plate, plate->problem->energy.tips[t], row, row + n));
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
    const pdmc_plate_point point = pdmc_plate_point_at(made->plate, x, x);
    memset(row_u, 0, (size_t)r * sizeof *row_u);
    memset(row_v, 0, (size_t)r * sizeof *row_v);
    for (int a = 0; a < 3; a++) {
        const double *field = &made->field[2 * (size_t)point.value[a] * (size_t)r];
        cblas_daxpy(r, point.weight[a], field, 1, row_u, 1);
        cblas_daxpy(r, point.weight[a], field + r, 1, row_v, 1);
    }
}

// The rows are made in the model's coordinates, for which only the values of one element are needed.
static pdmc_status fill_crossings(const pdmc_plate_elements *plate, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const int r = model->unknowns;
    const pdmc_displacement_functional displacement = {r, model->discretisation, open_rows, displacement_rows,
                                                       close_rows};
    double *identity = NULL;
    PDMC_NEW(identity, r * r);
    for (int k = 0; k < r; k++) identity[k * r + k] = 1.0;
    PDMC_TRY(pdmc_affine_fill_crossings(plate->problem, &displacement, identity, plate->threads, model));
done:
    pdmc_free(identity);
    return status;
}

pdmc_status pdmc_plate_affine(const pdmc_plate_elements *plate, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const double start = pdmc_seconds();
    const pdmc_energy_request *energy = &plate->problem->energy;
    *model = (pdmc_affine){.tips = energy->tip_count, .angles = energy->angles};
    PDMC_TRY(create_model(plate, model));
    PDMC_TRY(fill_intensities(plate, model));
    const double made = pdmc_seconds();
    PDMC_TRY(fill_crossings(plate, model));
    model->operator_seconds = made - start;
    model->energy_seconds = pdmc_seconds() - made;
done:
    if (status != PDMC_OK) pdmc_affine_clear(model);
    return status;
}
