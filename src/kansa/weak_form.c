// SPDX-License-Identifier: GPL-3.0-or-later
#include "kansa/weak_form.h"

#include "base/base_impl.h"

#include <cblas.h>
#include <math.h>
#include <string.h>

enum {
    CHUNK = 256,      // points whose rows are held at a time
    PANEL = 64,       // rows or columns of a task, the same for any number of threads
    SIDE_POINTS = 48, // Gauss points along a side
    STRAIN_ROWS = 3,
    DISPLACEMENT_ROWS = 2,
};
static const double penalty = 1e4; // of prescribed displacements, in E / h

void pdmc_weak_form_clear(pdmc_weak_form *form)
{
    pdmc_free(form->mass);
    pdmc_free(form->stiffness);
    pdmc_free(form->fixed);
    pdmc_free(form->load);
    *form = (pdmc_weak_form){0};
}

// Three rows whose squares add to sigma : epsilon = (3 s_x^2 - 2 s_x s_y + 3 s_y^2) / (8 mu) + tau^2 / mu (lambda =
// mu).
static void strain_rows(pdmc_row_builder *builder, const double x[2], double weight, double scratch[], double row[])
{
    const int n = builder->basis->unknowns;
    const double mu = builder->basis->shear_modulus, along[2] = {1.0, 0.0}, across[2] = {0.0, 1.0};
    const double a = sqrt(3.0 * weight / (8.0 * mu)), b = sqrt(weight / (3.0 * mu)), c = sqrt(weight / mu);
    double *sx = row, *tau = row + 2 * n, *sy = row + n;
    pdmc_traction_rows(builder, x, x, along, sx, tau);
    pdmc_traction_rows(builder, x, x, across, scratch, sy);
    for (int k = 0; k < n; k++) {
        sx[k] = a * (sx[k] - sy[k] / 3.0);
        sy[k] *= b;
        tau[k] *= c;
    }
}

static void displacement_rows(pdmc_row_builder *builder, const double x[2], double weight, double row[])
{
    const int n = builder->basis->unknowns;
    pdmc_displacement_rows(builder, x, x, row, row + n);
    cblas_dscal(2 * n, sqrt(weight), row, 1);
}

// gram += rows^T rows, by panels of columns.
static void add_gram(const pdmc_kansa *kansa, int count, const double rows[], double gram[])
{
    const int n = kansa->unknowns;
#pragma omp parallel for schedule(dynamic) num_threads(kansa->threads)
    for (int first = 0; first < n; first += PANEL)
        cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, n, n - first < PANEL ? n - first : PANEL, count, 1.0, rows,
                    n, rows + first, n, 1.0, &gram[(size_t)first * (size_t)n], n);
}

static void whiten(const pdmc_kansa *kansa, int count, double rows[])
{
#pragma omp parallel for schedule(dynamic) num_threads(kansa->threads)
    for (int first = 0; first < count; first += PANEL)
        pdmc_kansa_whiten(kansa, count - first < PANEL ? count - first : PANEL,
                          &rows[(size_t)first * (size_t)kansa->unknowns]);
}

// Rows of some points of the plate.
static pdmc_status fill_rows(const pdmc_kansa *kansa, const pdmc_area_rule *rule, int first, int count, double strain[],
                             double displacement[])
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)kansa->unknowns;
#pragma omp parallel num_threads(kansa->threads)
    {
        pdmc_row_builder builder;
        double *scratch = pdmc_calloc(n, sizeof *scratch);
        pdmc_status mine = pdmc_row_builder_create(&kansa->basis, &builder);
        if (!scratch) mine = PDMC_ERR_NOMEM;
#pragma omp for schedule(dynamic, 8)
        for (int i = 0; i < count; i++) {
            if (mine != PDMC_OK) continue;
            const double *x = &rule->x[2 * (first + i)], weight = rule->weight[first + i];
            double *e = &strain[STRAIN_ROWS * (size_t)i * n], *u = &displacement[DISPLACEMENT_ROWS * (size_t)i * n];
            strain_rows(&builder, x, weight, scratch, e);
            displacement_rows(&builder, x, weight, u);
        }
        if (mine != PDMC_OK) {
#pragma omp critical(pdmc_weak_form)
            status = mine;
        }
        pdmc_row_builder_clear(&builder);
        pdmc_free(scratch);
    }
    return status;
}

static pdmc_status integrate_plate(const pdmc_kansa *kansa, const pdmc_area_rule *rule, pdmc_weak_form *form)
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)kansa->unknowns;
    double *strain = NULL, *displacement = NULL;
    PDMC_NEW(strain, CHUNK * STRAIN_ROWS * n);
    PDMC_NEW(displacement, CHUNK * DISPLACEMENT_ROWS * n);
    for (int first = 0; first < rule->count; first += CHUNK) {
        const int count = rule->count - first < CHUNK ? rule->count - first : CHUNK;
        PDMC_TRY(fill_rows(kansa, rule, first, count, strain, displacement));
        whiten(kansa, STRAIN_ROWS * count, strain);
        whiten(kansa, DISPLACEMENT_ROWS * count, displacement);
        add_gram(kansa, STRAIN_ROWS * count, strain, form->stiffness);
        add_gram(kansa, DISPLACEMENT_ROWS * count, displacement, form->mass);
    }
done:
    pdmc_free(strain);
    pdmc_free(displacement);
    return status;
}

// What the problem prescribes on a side: the sum of its tractions, and the supports.
typedef struct {
    double traction[2], displacement[2];
    bool held[2];
} side_data;

static side_data data_of(const pdmc_problem *problem, int side)
{
    side_data data = {0};
    for (int l = 0; l < problem->load_count; l++)
        for (int k = 0; k < 2; k++)
            if ((int)problem->loads[l].side == side) data.traction[k] += problem->loads[l].traction[k];
    for (int s = 0; s < problem->support_count; s++) {
        const pdmc_support *support = &problem->supports[s];
        for (int k = 0; k < 2; k++) {
            if ((int)support->side != side || !support->held[k]) continue;
            data.held[k] = true;
            data.displacement[k] = support->displacement[k];
        }
    }
    return data;
}

static pdmc_status integrate_side(const pdmc_kansa *kansa, int side, pdmc_row_builder *builder, double row[],
                                  pdmc_weak_form *form)
{
    const pdmc_plate *plate = &kansa->problem->plate;
    const double size[2] = {plate->width, plate->height};
    const int axis = side == PDMC_SIDE_LEFT || side == PDMC_SIDE_RIGHT ? 0 : 1, n = kansa->unknowns;
    const double sign = side == PDMC_SIDE_LEFT || side == PDMC_SIDE_BOTTOM ? -0.5 : 0.5;
    const double stiffness = penalty * kansa->problem->material.youngs_modulus / kansa->spacing;
    const side_data data = data_of(kansa->problem, side);
    double t[SIDE_POINTS], w[SIDE_POINTS];
    const pdmc_status status = pdmc_gauss_legendre(SIDE_POINTS, -0.5 * size[1 - axis], 0.5 * size[1 - axis], t, w);
    for (int i = 0; i < SIDE_POINTS && status == PDMC_OK; i++) {
        double x[2];
        x[axis] = sign * size[axis];
        x[1 - axis] = t[i];
        pdmc_displacement_rows(builder, x, x, row, row + n);
        pdmc_kansa_whiten(kansa, 2, row);
        for (int k = 0; k < 2; k++) {
            cblas_daxpy(n, w[i] * data.traction[k], row + k * n, 1, form->load, 1);
            if (!data.held[k]) continue;
            cblas_dger(CblasColMajor, n, n, w[i] * stiffness, row + k * n, 1, row + k * n, 1, form->stiffness, n);
            cblas_daxpy(n, w[i] * stiffness * data.displacement[k], row + k * n, 1, form->fixed, 1);
        }
    }
    return status;
}

static pdmc_status integrate_sides(const pdmc_kansa *kansa, pdmc_weak_form *form)
{
    pdmc_status status = PDMC_OK;
    pdmc_row_builder builder = {0};
    double *row = NULL;
    PDMC_TRY(pdmc_row_builder_create(&kansa->basis, &builder));
    PDMC_NEW(row, 2 * kansa->unknowns);
    for (int side = 0; side < 4; side++) PDMC_TRY(integrate_side(kansa, side, &builder, row, form));
done:
    pdmc_free(row);
    pdmc_row_builder_clear(&builder);
    return status;
}

static pdmc_status make_rule(const pdmc_kansa *kansa, pdmc_area_rule *rule)
{
    pdmc_status status = PDMC_OK;
    const pdmc_problem *problem = kansa->problem;
    double *segment = NULL;
    PDMC_NEW(segment, 4 * problem->crack_count);
    for (int c = 0; c < problem->crack_count; c++) {
        memcpy(&segment[4 * c], problem->cracks[c].from, 2 * sizeof(double));
        memcpy(&segment[4 * c + 2], problem->cracks[c].to, 2 * sizeof(double));
    }
    // Sums of radial functions vary from node to node, whatever their shape: about seven points to a node. A quarter
    // of that leaves fields without energy, and waves that stand still.
    PDMC_TRY(pdmc_area_rule_create(problem->plate.width, problem->plate.height, problem->crack_count, segment,
                                   3.0 * kansa->spacing, rule));
done:
    pdmc_free(segment);
    return status;
}

pdmc_status pdmc_weak_form_create(const pdmc_kansa *kansa, pdmc_weak_form *form)
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)kansa->unknowns;
    pdmc_area_rule rule = {0};
    *form = (pdmc_weak_form){0};
    PDMC_NEW(form->mass, n * n);
    PDMC_NEW(form->stiffness, n * n);
    PDMC_NEW(form->fixed, n);
    PDMC_NEW(form->load, n);
    PDMC_TRY(make_rule(kansa, &rule));
    PDMC_TRY(integrate_plate(kansa, &rule, form));
    PDMC_TRY(integrate_sides(kansa, form));
done:
    pdmc_area_rule_clear(&rule);
    if (status != PDMC_OK) pdmc_weak_form_clear(form);
    return status;
}
