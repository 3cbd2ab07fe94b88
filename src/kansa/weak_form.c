// SPDX-License-Identifier: GPL-3.0-or-later
#include "kansa/weak_form.h"

#include "base/base_impl.h"
#include "kansa/weak_rows.h"

#include <cblas.h>

enum {
    CHUNK = 256,      // points whose rows are held at a time
    SIDE_POINTS = 48,   // Gauss points along a side
    NOISY_POINTS = 256, // ... where a load has noise, whose waves may be short
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

static pdmc_status integrate_plate(const pdmc_kansa *kansa, const pdmc_area_rule *rule, pdmc_weak_form *form)
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)kansa->unknowns;
    double *strain = NULL, *displacement = NULL;
    PDMC_NEW(strain, CHUNK * PDMC_STRAIN_ROWS * n);
    PDMC_NEW(displacement, CHUNK * PDMC_DISPLACEMENT_ROWS * n);
    for (int first = 0; first < rule->count; first += CHUNK) {
        const int count = rule->count - first < CHUNK ? rule->count - first : CHUNK;
        PDMC_TRY(pdmc_weak_fill_rows(kansa, rule, first, count, strain, displacement));
        pdmc_weak_add_gram(kansa, PDMC_STRAIN_ROWS * count, strain, form->stiffness);
        pdmc_weak_add_gram(kansa, PDMC_DISPLACEMENT_ROWS * count, displacement, form->mass);
    }
done:
    pdmc_free(strain);
    pdmc_free(displacement);
    return status;
}

// What the supports prescribe on a side.
typedef struct {
    double displacement[2];
    bool held[2];
} side_data;

static side_data data_of(const pdmc_problem *problem, int side)
{
    side_data data = {0};
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

static void add_tractions(const pdmc_kansa *kansa, pdmc_side side, const double x[2], double weight,
                          const double row[], pdmc_weak_form *form)
{
    const int n = kansa->unknowns;
    for (int l = 0; l < kansa->loads.count; l++) {
        double traction[2];
        pdmc_load_traction(&kansa->loads, l, side, x, traction);
        for (int k = 0; k < 2; k++)
            cblas_daxpy(n, weight * traction[k], row + k * n, 1, &form->load[(size_t)l * (size_t)n], 1);
    }
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
    const int points = kansa->loads.noise[side] ? NOISY_POINTS : SIDE_POINTS;
    double t[NOISY_POINTS], w[NOISY_POINTS];
    const pdmc_status status = pdmc_gauss_legendre(points, -0.5 * size[1 - axis], 0.5 * size[1 - axis], t, w);
    for (int i = 0; i < points && status == PDMC_OK; i++) {
        double x[2];
        x[axis] = sign * size[axis];
        x[1 - axis] = t[i];
        pdmc_displacement_rows(builder, x, x, row, row + n);
        pdmc_kansa_whiten(kansa, 2, row);
        add_tractions(kansa, (pdmc_side)side, x, w[i], row, form);
        for (int k = 0; k < 2; k++) {
            if (!data.held[k]) continue;
            cblas_dger(CblasColMajor, n, n, w[i] * stiffness, row + k * n, 1, row + k * n, 1, form->stiffness, n);
            cblas_daxpy(n, w[i] * stiffness * data.displacement[k], row + k * n, 1, form->fixed, 1);
        }
    }
    return status;
}

pdmc_status pdmc_weak_form_add_sides(const pdmc_kansa *kansa, pdmc_weak_form *form)
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

pdmc_status pdmc_weak_form_create(const pdmc_kansa *kansa, pdmc_weak_form *form)
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)kansa->unknowns;
    pdmc_area_rule rule = {0};
    *form = (pdmc_weak_form){0};
    PDMC_NEW(form->mass, n * n);
    PDMC_NEW(form->stiffness, n * n);
    PDMC_NEW(form->fixed, n);
    PDMC_NEW(form->load, (size_t)kansa->loads.count * n);
    PDMC_TRY(pdmc_weak_rule(kansa, &rule));
    PDMC_TRY(integrate_plate(kansa, &rule, form));
    PDMC_TRY(pdmc_weak_form_add_sides(kansa, form));
done:
    pdmc_area_rule_clear(&rule);
    if (status != PDMC_OK) pdmc_weak_form_clear(form);
    return status;
}
