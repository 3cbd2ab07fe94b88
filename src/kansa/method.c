// SPDX-License-Identifier: GPL-3.0-or-later
#include "kansa/method.h"

#include "pdmc/kansa.h"

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

static pdmc_status field(const void *method, pdmc_field *out)
{
    return pdmc_kansa_field(method, out);
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
