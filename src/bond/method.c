// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/method.h"

#include "bond/bond.h"
#include "discretisation/field.h"

static pdmc_solver_report report(const void *method)
{
    const pdmc_bond *bond = method;
    return (pdmc_solver_report){
        .nodes = bond->plate.grid.nodes,
        .unknowns = bond->unknowns,
        .rows = bond->unknowns,
        .rank = bond->unknowns,
        .condition = pdmc_bond_factor_condition(bond->factor),
        .residual = bond->residual,
        .horizon = bond->problem->solver.horizon,
        .spacing = bond->problem->solver.spacing,
    };
}

static void runtime(const void *method, double *assembly, double *factorisation)
{
    const pdmc_bond *bond = method;
    *assembly = bond->assembly_seconds;
    *factorisation = bond->factorisation_seconds;
}

static pdmc_status displacement(const void *method, const double x[2], const double anchor[2], double u[2])
{
    return pdmc_bond_displacement(method, x, anchor, u);
}

static pdmc_status tip(const void *method, int index, pdmc_tip *out)
{
    return pdmc_bond_tip(method, index, out);
}

static pdmc_status field(const void *method, pdmc_displacement_field *out)
{
    pdmc_status status = PDMC_OK;
    const pdmc_bond *bond = method;
    const int count = bond->plate.grid.nodes;
    double *nodes = NULL;
    PDMC_NEW(nodes, 2 * count);
    for (int k = 0; k < count; k++) pdmc_bond_grid_node(&bond->plate.grid, k, &nodes[2 * k]);
    PDMC_TRY(pdmc_field_fill(bond->problem, count, nodes, displacement, bond, out));
done:
    pdmc_free(nodes);
    return status;
}

static pdmc_status affine(const void *method, pdmc_affine *model)
{
    return pdmc_bond_affine(method, model);
}

static void destroy(void *method)
{
    pdmc_bond *bond = method;
    pdmc_bond_destroy(&bond);
}

pdmc_status pdmc_bond_discretise(const pdmc_problem *problem, int threads, pdmc_discretisation *out)
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
    pdmc_bond *bond = NULL;
    const pdmc_status status = pdmc_bond_create(problem, threads, &bond);
    if (status == PDMC_OK) *out = (pdmc_discretisation){&verbs, bond};
    return status;
}
