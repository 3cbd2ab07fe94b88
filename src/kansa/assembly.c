// SPDX-License-Identifier: GPL-3.0-or-later
#include "kansa/assembly.h"

#include "base/base_impl.h"

#include <math.h>

// Index of the first element of a row of an array with `unknowns` columns.
static size_t row_start(const pdmc_kansa *kansa, int row)
{
    return (size_t)row * (size_t)kansa->unknowns;
}

static double *load_row(pdmc_kansa *kansa, int l)
{
    return &kansa->load[(size_t)l * (size_t)kansa->rows];
}

// c_0 spacing F(r_q) at each interior point, and their weighted sum over the rings.
static void assemble_interior_point(pdmc_kansa *kansa, pdmc_row_builder *builder, int i, double matrix[])
{
    const pdmc_interior_point *point = &kansa->points.interior[i];
    const double factor = pdmc_micromodulus(&kansa->problem->material, kansa->problem->solver.horizon) * point->spacing;
    const int unknowns = kansa->unknowns, points = kansa->points.interior_count;
    double *mean = &matrix[row_start(kansa, 2 * i)];
    for (int q = 0; q < kansa->rings.rings; q++) {
        double *row = &kansa->ring_rows[row_start(kansa, 2 * (q * points + i))];
        pdmc_ring_rows(builder, point->x, kansa->rings.radius[q], point->clearance, row, row + unknowns);
        for (int k = 0; k < 2 * unknowns; k++) {
            row[k] *= factor;
            mean[k] += kansa->rings.mean[q] * row[k];
        }
    }
}

static const pdmc_support *support_of(const pdmc_problem *problem, int side, int component)
{
    for (int s = 0; s < problem->support_count; s++)
        if ((int)problem->supports[s].side == side && problem->supports[s].held[component])
            return &problem->supports[s];
    return NULL;
}

static void prescribed_traction(const pdmc_kansa *kansa, const pdmc_kansa_data *data,
                                const pdmc_boundary_point *point, int index, double t[2])
{
    t[0] = t[1] = 0.0;
    if (point->side < 0) return; // faces of cracks are free
    if (data && data->traction) data->traction(point->x, point->normal, t);
    else pdmc_load_traction(&kansa->loads, index, (pdmc_side)point->side, point->x, t);
}

// A component that is held gets a row E / h u = E / h u_0, in units of stress like the others.
static void hold_component(pdmc_kansa *kansa, const pdmc_kansa_data *data, const pdmc_boundary_point *point,
                           const pdmc_support *support, int component, int row, double values[])
{
    const double weight = kansa->problem->material.youngs_modulus / kansa->spacing;
    double u[2] = {support->displacement[0], support->displacement[1]};
    if (data && data->displacement) data->displacement(point->x, u);
    for (int k = 0; k < kansa->unknowns; k++) values[k] *= weight;
    load_row(kansa, 0)[row] = weight * u[component];
}

static void load_component(pdmc_kansa *kansa, const pdmc_kansa_data *data, const pdmc_boundary_point *point,
                           int component, int row, double values[])
{
    for (int k = 0; k < kansa->unknowns; k++) values[k] *= point->weight;
    for (int l = 0; l < kansa->loads.count; l++) {
        double t[2];
        prescribed_traction(kansa, data, point, l, t);
        load_row(kansa, 1 + l)[row] = point->weight * t[component];
    }
}

static void assemble_boundary_point(pdmc_kansa *kansa, const pdmc_kansa_data *data, pdmc_row_builder *builder,
                                    double scratch[], int j, double matrix[])
{
    const pdmc_boundary_point *point = &kansa->points.boundary[j];
    const int first = 2 * (kansa->points.interior_count + j), unknowns = kansa->unknowns;
    double *values = &matrix[row_start(kansa, first)];
    pdmc_traction_rows(builder, point->x, point->anchor, point->normal, values, values + unknowns);
    pdmc_displacement_rows(builder, point->x, point->anchor, scratch, scratch + unknowns);
    for (int component = 0; component < 2; component++, values += unknowns, scratch += unknowns) {
        const pdmc_support *support = support_of(kansa->problem, point->side, component);
        kansa->is_traction[2 * j + component] = !support;
        if (support) {
            for (int k = 0; k < unknowns; k++) values[k] = scratch[k];
            hold_component(kansa, data, point, support, component, first + component, values);
        } else {
            load_component(kansa, data, point, component, first + component, values);
        }
    }
}

// The mean over the points on the sides of each rigid motion that nothing holds is zero.
static void assemble_gauge(pdmc_kansa *kansa, pdmc_row_builder *builder, double scratch[], int motions,
                           double motion[3][3], double matrix[])
{
    const int unknowns = kansa->unknowns, count = kansa->points.side_count;
    const int first = 2 * (kansa->points.interior_count + kansa->points.boundary_count);
    const double weight = kansa->problem->material.youngs_modulus /
                          (fmax(kansa->problem->plate.width, kansa->problem->plate.height) * count);
    for (int j = 0; j < count; j++) {
        const pdmc_boundary_point *point = &kansa->points.boundary[j];
        pdmc_displacement_rows(builder, point->x, point->anchor, scratch, scratch + unknowns);
        for (int m = 0; m < motions; m++) {
            const double u = weight * (motion[m][0] - motion[m][2] * point->x[1]);
            const double v = weight * (motion[m][1] + motion[m][2] * point->x[0]);
            double *row = &matrix[row_start(kansa, first + m)];
            for (int k = 0; k < unknowns; k++) row[k] += u * scratch[k] + v * scratch[unknowns + k];
        }
    }
}

// sum_k a_k q_j(x_k) = 0 and the same for d (eq. B.2, where both sums are over d in print).
static pdmc_status assemble_side_conditions(pdmc_kansa *kansa, double matrix[])
{
    const pdmc_basis *basis = &kansa->basis;
    const int first = kansa->rows - 2 * basis->monomials;
    const double weight = kansa->problem->material.youngs_modulus / (basis->scale * basis->node_count);
    pdmc_basis_values at;
    const pdmc_status status = pdmc_basis_values_create(basis, &at);
    if (status != PDMC_OK) return status;
    for (int k = 0; k < basis->node_count; k++) {
        const double x[2] = {basis->node_x[k], basis->node_y[k]};
        pdmc_basis_evaluate(basis, x, x, &at);
        for (int j = 0; j < basis->monomials; j++) {
            const double value = weight * at.scalar[basis->node_count + j];
            matrix[row_start(kansa, first + j) + (size_t)k] = value;
            matrix[row_start(kansa, first + basis->monomials + j) + (size_t)(basis->scalars + k)] = value;
        }
    }
    pdmc_basis_values_clear(&at);
    return PDMC_OK;
}

static pdmc_status assemble_points(pdmc_kansa *kansa, const pdmc_kansa_data *data, double matrix[])
{
    pdmc_status status = PDMC_OK;
    const int interior = kansa->points.interior_count, total = interior + kansa->points.boundary_count;
#pragma omp parallel num_threads(kansa->threads)
    {
        pdmc_row_builder builder;
        double *scratch = pdmc_calloc(2 * (size_t)kansa->unknowns, sizeof *scratch);
        pdmc_status mine = pdmc_row_builder_create(&kansa->basis, &builder);
        if (!scratch) mine = PDMC_ERR_NOMEM;
#pragma omp for schedule(dynamic, 8)
        for (int i = 0; i < total; i++) {
            if (mine != PDMC_OK) continue;
            if (i < interior) assemble_interior_point(kansa, &builder, i, matrix);
            else assemble_boundary_point(kansa, data, &builder, scratch, i - interior, matrix);
        }
        if (mine != PDMC_OK) {
#pragma omp critical
            status = mine;
        }
        pdmc_row_builder_clear(&builder);
        pdmc_free(scratch);
    }
    return status;
}

static void load_interior(pdmc_kansa *kansa, const pdmc_kansa_data *data)
{
    if (!data || !data->body_force) return;
    for (int i = 0; i < kansa->points.interior_count; i++) {
        const pdmc_interior_point *point = &kansa->points.interior[i];
        double b[2];
        data->body_force(point->x, b);
        for (int k = 0; k < 2; k++) load_row(kansa, 1)[2 * i + k] = point->spacing * b[k];
    }
}

pdmc_status pdmc_kansa_assemble(pdmc_kansa *kansa, const pdmc_kansa_data *data, double matrix[])
{
    pdmc_status status = PDMC_OK;
    pdmc_row_builder builder = {0};
    double *scratch = NULL, motion[3][3];
    int motions;
    PDMC_TRY(pdmc_problem_free_motions(kansa->problem, &motions, motion));
    PDMC_TRY(pdmc_row_builder_create(&kansa->basis, &builder));
    PDMC_NEW(scratch, 2 * (size_t)kansa->unknowns);
    PDMC_TRY(assemble_points(kansa, data, matrix));
    load_interior(kansa, data);
    assemble_gauge(kansa, &builder, scratch, motions, motion, matrix);
    PDMC_TRY(assemble_side_conditions(kansa, matrix));
done:
    pdmc_free(scratch);
    pdmc_row_builder_clear(&builder);
    return status;
}
