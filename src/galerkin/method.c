// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/method.h"

#include "base/base_impl.h"
#include "discretisation/field.h"
#include "galerkin/plate.h"

#include <string.h>

static pdmc_solver_report report(const void *method)
{
    const pdmc_plate_elements *plate = method;
    return (pdmc_solver_report){
        .nodes = plate->mesh.node_count,
        .unknowns = plate->unknowns,
        .rows = plate->unknowns,
        .rank = plate->unknowns,
        .condition = pdmc_sparse_factor_condition(plate->factor),
        .residual = plate->residual,
        .horizon = plate->problem->solver.horizon,
        .spacing = plate->problem->solver.spacing,
    };
}

static void runtime(const void *method, double *assembly, double *factorisation)
{
    const pdmc_plate_elements *plate = method;
    *assembly = plate->assembly_seconds;
    *factorisation = plate->factorisation_seconds;
}

static pdmc_status displacement(const void *method, const double x[2], const double anchor[2], double u[2])
{
    pdmc_plate_displacement(method, x, anchor, u);
    return PDMC_OK;
}

static pdmc_status tip(const void *method, int index, pdmc_tip *out)
{
    return pdmc_plate_tip(method, index, out);
}

// The nodes off the cracks: those on the faces have two displacements, and are given as faces.
static pdmc_status field(const void *method, pdmc_displacement_field *out)
{
    pdmc_status status = PDMC_OK;
    const pdmc_plate_elements *plate = method;
    int count = 0;
    double *nodes = NULL;
    PDMC_NEW(nodes, 2 * (size_t)plate->mesh.node_count);
    for (int n = 0; n < plate->mesh.node_count; n++) {
        const double *x = &plate->mesh.x[2 * (size_t)n];
        if (pdmc_problem_crack_at(plate->problem, x) < 0) memcpy(&nodes[2 * (size_t)count++], x, 2 * sizeof *x);
    }
    PDMC_TRY(pdmc_field_fill(plate->problem, count, nodes, displacement, method, out));
done:
    pdmc_free(nodes);
    return status;
}

static pdmc_status affine(const void *method, pdmc_affine *model)
{
    return pdmc_plate_affine(method, model);
}

static void destroy(void *method)
{
    pdmc_plate_elements *plate = method;
    pdmc_plate_elements_destroy(&plate);
}

pdmc_status pdmc_galerkin_discretise(const pdmc_problem *problem, int threads, pdmc_discretisation *out)
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
    pdmc_plate_elements *plate = NULL;
    const pdmc_status status = pdmc_plate_elements_create(problem, threads, &plate);
    if (status == PDMC_OK) *out = (pdmc_discretisation){&verbs, plate};
    return status;
}
