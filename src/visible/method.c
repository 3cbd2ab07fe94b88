// SPDX-License-Identifier: GPL-3.0-or-later
#include "visible/method.h"

#include "visible/visible.h"

static pdmc_solver_report report(const void *method)
{
    return pdmc_visible_report(method);
}

static void runtime(const void *method, double *assembly, double *factorisation)
{
    pdmc_visible_runtime(method, assembly, factorisation);
}

static pdmc_status displacement(const void *method, const double x[2], const double anchor[2], double u[2])
{
    return pdmc_visible_displacement(method, x, anchor, u);
}

static pdmc_status tip(const void *method, int index, pdmc_tip *out)
{
    return pdmc_visible_tip(method, index, out);
}

static pdmc_status field(const void *method, pdmc_displacement_field *out)
{
    return pdmc_visible_field(method, out);
}

static pdmc_status affine(const void *method, pdmc_affine *model)
{
    return pdmc_visible_affine(method, model);
}

static void destroy(void *method)
{
    pdmc_visible *visible = method;
    pdmc_visible_destroy(&visible);
}

pdmc_status pdmc_visible_discretise(const pdmc_problem *problem, int threads, pdmc_discretisation *out)
{
    static const pdmc_discretisation_verbs verbs = {
        .report = report,
        .runtime = runtime,
        .displacement = displacement,
        .tip = tip,
        .field = field,
        .affine = affine,
        .destroy = destroy,
    };
    pdmc_visible *visible = NULL;
    const pdmc_status status = pdmc_visible_create(problem, NULL, threads, &visible);
    if (status == PDMC_OK) *out = (pdmc_discretisation){&verbs, visible};
    return status;
}
