// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/method.h"

#include "discretisation/field.h"
#include "paper/paper_impl.h"

static pdmc_solver_report report(const void *method)
{
    const pdmc_paper *paper = method;
    return (pdmc_solver_report){
        .nodes = paper->basis.nodes.count,
        .unknowns = paper->unknowns,
        .rows = paper->unknowns,
        .rank = paper->unknowns,
        .condition = paper->condition,
        .residual = paper->residual,
        .horizon = paper->problem->solver.horizon,
        .spacing = paper->problem->solver.spacing,
    };
}

static void runtime(const void *method, double *assembly, double *factorisation)
{
    const pdmc_paper *paper = method;
    *assembly = paper->assembly_seconds;
    *factorisation = paper->factorisation_seconds;
}

static pdmc_status displacement(const void *method, const double x[2], const double anchor[2], double u[2])
{
    return pdmc_paper_displacement(method, x, anchor, u);
}

static pdmc_status tip(const void *method, int index, pdmc_tip *out)
{
    return pdmc_paper_tip(method, index, out);
}

static pdmc_status field(const void *method, pdmc_displacement_field *out)
{
    const pdmc_paper *paper = method;
    const pdmc_paper_nodes *nodes = &paper->basis.nodes;
    return pdmc_field_fill(paper->problem, nodes->count, nodes->x, displacement, method, out);
}

static pdmc_status affine(const void *method, pdmc_affine *model)
{
    return pdmc_paper_affine(method, model);
}

static void destroy(void *method)
{
    pdmc_paper *paper = method;
    pdmc_paper_destroy(&paper);
}

pdmc_status pdmc_paper_discretise(const pdmc_problem *problem, int threads, pdmc_discretisation *out)
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
    pdmc_paper *paper = NULL;
    const pdmc_status status = pdmc_paper_create(problem, threads, &paper);
    if (status == PDMC_OK) *out = (pdmc_discretisation){&verbs, paper};
    return status;
}
