// SPDX-License-Identifier: GPL-3.0-or-later
#include "kansa/method.h"

#include "base/base_impl.h"
#include "discretisation/field.h"
#include "kansa/kansa_impl.h"
#include "kansa/stiffness_release.h"

/// A plate, and where its stiffness varies in space the weak form and the field, of which samples are made.
typedef struct {
    pdmc_kansa *kansa;
    pdmc_kansa_form *form;          // NULL where the stiffness is the same everywhere
    pdmc_field_functional *release; // [tips] what ln G of each tip depends on
    pdmc_field *field;
} kansa_method;

static const pdmc_kansa *kansa_of(const void *method)
{
    return ((const kansa_method *)method)->kansa;
}

static pdmc_solver_report report(const void *method)
{
    return pdmc_kansa_report(kansa_of(method));
}

static void runtime(const void *method, double *assembly, double *factorisation)
{
    pdmc_kansa_runtime(kansa_of(method), assembly, factorisation);
}

static pdmc_status displacement(const void *method, const double x[2], const double anchor[2], double u[2])
{
    return pdmc_kansa_displacement(kansa_of(method), x, anchor, u);
}

static pdmc_status tip(const void *method, int index, pdmc_tip *out)
{
    return pdmc_kansa_tip(kansa_of(method), index, out);
}

static pdmc_status field(const void *method, pdmc_displacement_field *out)
{
    pdmc_status status = PDMC_OK;
    const pdmc_kansa *kansa = kansa_of(method);
    const pdmc_collocation *points = &kansa->points;
    const int count = points->columns * points->rows;
    double *nodes = NULL;
    PDMC_NEW(nodes, 2 * count);
    for (int k = 0; k < count; k++) {
        nodes[2 * k] = (k % points->columns) * points->spacing[0] - 0.5 * kansa->problem->plate.width;
        nodes[2 * k + 1] = (k / points->columns) * points->spacing[1] - 0.5 * kansa->problem->plate.height;
    }
    PDMC_TRY(pdmc_field_fill(kansa->problem, count, nodes, displacement, method, out));
done:
    pdmc_free(nodes);
    return status;
}

static pdmc_status affine(const void *method, pdmc_affine *model)
{
    const kansa_method *plate = method;
    if (!plate->form) return pdmc_kansa_affine(plate->kansa, model);
    pdmc_status status = pdmc_kansa_field_affine(plate->form, plate->field, model);
    const pdmc_stiffness_terms terms = pdmc_stiffness_terms_of(plate->field);
    if (status == PDMC_OK) status = pdmc_kansa_correct_tips(plate->form, &terms, plate->release, model);
    if (status != PDMC_OK) pdmc_affine_clear(model);
    return status;
}

static pdmc_status motion(const void *method, double inertia, pdmc_motion_model *model)
{
    return pdmc_kansa_motion(kansa_of(method), inertia, model);
}

static pdmc_status motion_rows(const void *method, const double x[2], const double anchor[2], double row[])
{
    return pdmc_kansa_motion_rows(kansa_of(method), x, anchor, row);
}

static void destroy(void *method)
{
    kansa_method *plate = method;
    if (!plate) return;
    for (int t = 0; plate->release && t < plate->kansa->problem->energy.tip_count; t++) {
        pdmc_free((double *)plate->release[t].x);
        pdmc_free((double *)plate->release[t].weight);
    }
    pdmc_free(plate->release);
    pdmc_field_destroy(&plate->field);
    pdmc_kansa_form_destroy(&plate->form);
    pdmc_kansa_destroy(&plate->kansa);
    pdmc_free(plate);
}

// The field's modes begin with those that the energies at the tips depend on.
static pdmc_status make_stiffness(const pdmc_problem *problem, int threads, kansa_method *plate)
{
    pdmc_status status = PDMC_OK;
    const pdmc_uncertainty *stiffness = pdmc_problem_uncertainty(problem, PDMC_QUANTITY_STIFFNESS);
    if (!stiffness) return PDMC_OK;
    const pdmc_field_request request = {.covariance = stiffness->covariance,
                                        .distribution = stiffness->distribution,
                                        .variation = stiffness->variation,
                                        .modes = stiffness->modes};
    PDMC_TRY(pdmc_kansa_form_create(plate->kansa, &plate->form));
    PDMC_NEW(plate->release, problem->energy.tip_count);
    for (int t = 0; t < problem->energy.tip_count; t++)
        PDMC_TRY(pdmc_kansa_release_sensitivity(plate->kansa, t, stiffness->covariance.length, &plate->release[t]));
    PDMC_TRY(pdmc_field_create(&request, problem->plate.width, problem->plate.height, problem->energy.tip_count,
                               plate->release, threads, &plate->field));
done:
    return status;
}

pdmc_status pdmc_kansa_discretise(const pdmc_problem *problem, int threads, pdmc_discretisation *out)
{
    static const pdmc_discretisation_verbs verbs = {
        .report = report,
        .runtime = runtime,
        .displacement = displacement,
        .tip = tip,
        .field = field,
        .affine = affine,
        .destroy = destroy,
        .motion = motion,
        .motion_rows = motion_rows,
    };
    pdmc_status status = PDMC_OK;
    kansa_method *plate = NULL;
    PDMC_NEW(plate, 1);
    PDMC_TRY(pdmc_kansa_create(problem, NULL, threads, &plate->kansa));
    PDMC_TRY(make_stiffness(problem, threads, plate));
    *out = (pdmc_discretisation){&verbs, plate};
    plate = NULL;
done:
    destroy(plate);
    return status;
}
