// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/method.h"

#include "bond/random_stiffness.h"
#include "discretisation/field.h"

/// A plate, and the field where its stiffness varies in space.
typedef struct {
    pdmc_bond *bond;
    pdmc_bond_random_stiffness random; // zero where the stiffness is the same everywhere
} bond_method;

static const pdmc_bond *bond_of(const void *method)
{
    return ((const bond_method *)method)->bond;
}

static pdmc_solver_report report(const void *method)
{
    const pdmc_bond *bond = bond_of(method);
    return (pdmc_solver_report){
        .nodes = bond->plate.grid.nodes,
        .unknowns = bond->unknowns,
        .rows = bond->unknowns,
        .rank = bond->unknowns,
        .condition = pdmc_sparse_factor_condition(bond->factor),
        .residual = bond->residual,
        .horizon = bond->problem->solver.horizon,
        .spacing = bond->problem->solver.spacing,
    };
}

static void runtime(const void *method, double *assembly, double *factorisation)
{
    const pdmc_bond *bond = bond_of(method);
    *assembly = bond->assembly_seconds;
    *factorisation = bond->factorisation_seconds;
}

static pdmc_status displacement(const void *method, const double x[2], const double anchor[2], double u[2])
{
    return pdmc_bond_displacement(bond_of(method), x, anchor, u);
}

static pdmc_status tip(const void *method, int index, pdmc_tip *out)
{
    return pdmc_bond_tip(bond_of(method), index, out);
}

static pdmc_status field(const void *method, pdmc_displacement_field *out)
{
    pdmc_status status = PDMC_OK;
    const pdmc_bond *bond = bond_of(method);
    const int count = bond->plate.grid.nodes;
    double *nodes = NULL;
    PDMC_TRY(pdmc_bond_grid_nodes(&bond->plate.grid, &nodes));
    PDMC_TRY(pdmc_field_fill(bond->problem, count, nodes, displacement, method, out));
done:
    pdmc_free(nodes);
    return status;
}

static pdmc_status affine(const void *method, pdmc_affine *model)
{
    const bond_method *plate = method;
    const pdmc_field *field = plate->random.field;
    const pdmc_status status = pdmc_bond_affine(plate->bond, field ? &plate->random.stiffness : NULL, model);
    if (status == PDMC_OK) model->field = field;
    return status;
}

static void destroy(void *method)
{
    bond_method *plate = method;
    if (!plate) return;
    pdmc_bond_random_stiffness_clear(&plate->random);
    pdmc_bond_destroy(&plate->bond);
    pdmc_free(plate);
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
    pdmc_status status = PDMC_OK;
    bond_method *plate = NULL;
    PDMC_NEW(plate, 1);
    PDMC_TRY(pdmc_bond_create(problem, threads, &plate->bond));
    PDMC_TRY(pdmc_bond_random_stiffness_create(plate->bond, &plate->random));
    *out = (pdmc_discretisation){&verbs, plate};
    plate = NULL;
done:
    destroy(plate);
    return status;
}
