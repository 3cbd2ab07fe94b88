// SPDX-License-Identifier: GPL-3.0-or-later
#include "kansa/method.h"

#include "base/base_impl.h"
#include "discretisation/field.h"
#include "kansa/kansa_impl.h"

static pdmc_solver_report report(const void *method)
{
    return pdmc_kansa_report(method);
}

static void runtime(const void *method, double *assembly, double *factorisation)
{
    pdmc_kansa_runtime(method, assembly, factorisation);
}

static pdmc_status displacement(const void *method, const double x[2], const double anchor[2], double u[2])
{
    return pdmc_kansa_displacement(method, x, anchor, u);
}

static pdmc_status tip(const void *method, int index, pdmc_tip *out)
{
    return pdmc_kansa_tip(method, index, out);
}

static pdmc_status field(const void *method, pdmc_displacement_field *out)
{
    pdmc_status status = PDMC_OK;
    const pdmc_kansa *kansa = method;
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
    return pdmc_kansa_affine(method, model);
}

static pdmc_status motion(const void *method, double inertia, pdmc_motion_model *model)
{
    return pdmc_kansa_motion(method, inertia, model);
}

static pdmc_status motion_rows(const void *method, const double x[2], const double anchor[2], double row[])
{
    return pdmc_kansa_motion_rows(method, x, anchor, row);
}

static void destroy(void *method)
{
    pdmc_kansa *kansa = method;
    pdmc_kansa_destroy(&kansa);
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
    pdmc_kansa *kansa = NULL;
    const pdmc_status status = pdmc_kansa_create(problem, NULL, threads, &kansa);
    if (status == PDMC_OK) *out = (pdmc_discretisation){&verbs, kansa};
    return status;
}
