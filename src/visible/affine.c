// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/affine.h"

#include "base/base_impl.h"
#include "discretisation/radial.h"
#include "discretisation/response_affine.h"
#include "visible/rows.h"
#include "visible/system.h"
#include "visible/tip.h"

#include <cblas.h>
#include <string.h>

static pdmc_status apply(const void *method, int q, const double v[], double out[])
{
    const pdmc_visible *visible = method;
    pdmc_visible_product(visible, q + 1, v, out);
    return pdmc_visible_solve(visible, &visible->factor, out, out);
}

static pdmc_status solve(const void *method, const double xi[], const double scale[], double u[])
{
    pdmc_status status = PDMC_OK;
    const pdmc_visible *visible = method;
    const int n = visible->unknowns;
    pdmc_factor factor = {0};
    memset(u, 0, (size_t)n * sizeof *u);
    for (int l = 0; l < visible->cases; l++) cblas_daxpy(n, scale[l], &visible->load[l * n], 1, u, 1);
    PDMC_TRY(pdmc_visible_factor(visible, xi, &factor));
    PDMC_TRY(pdmc_visible_solve(visible, &factor, u, u));
done:
    pdmc_factor_clear(&factor);
    return status;
}

static pdmc_status intensity(const void *method, int tip, double row_1[], double row_2[])
{
    return pdmc_visible_stress_intensity_rows(method, tip, row_1, row_2);
}

static int point(const void *method, const double x[2], int node[], double weight[])
{
    const pdmc_visible *visible = method;
    const pdmc_view view = {{x[0], x[1]}, -1, 0};
    const pdmc_stencil *stencil = &visible->stencils[pdmc_stencil_owner(&visible->field, &view)];
    pdmc_stencil_evaluate(stencil, x, weight);
    memcpy(node, stencil->node, (size_t)stencil->count * sizeof *node);
    return stencil->count;
}

pdmc_status pdmc_visible_affine(const pdmc_visible *visible, pdmc_affine *model)
{
    _Static_assert((int)PDMC_STENCIL_NODES <= (int)PDMC_POINT_NODES, "a stencil has too many nodes");
    pdmc_status status = PDMC_OK;
    const pdmc_energy_request *energy = &visible->problem->energy;
    const pdmc_uncertainty *noise = pdmc_problem_uncertainty(visible->problem, PDMC_QUANTITY_MICROMODULUS);
    const pdmc_nodal_method nodal = {.problem = visible->problem,
                                     .unknowns = visible->unknowns,
                                     .cases = visible->cases,
                                     .threads = visible->threads,
                                     .solution = visible->solution,
                                     .method = visible,
                                     .apply = apply,
                                     .solve = solve,
                                     .intensity = intensity,
                                     .point = point};
    double size[PDMC_VISIBLE_DEGREE + 1];
    *model = (pdmc_affine){.tips = energy->tip_count, .angles = energy->angles, .bins = noise ? noise->bins : 1};
    model->terms = model->radial_terms = visible->terms;
    PDMC_TRY(pdmc_radial_weights(model));
    pdmc_radial_sizes(model, noise ? noise->variation : 0.0, size);
    PDMC_TRY(pdmc_response_affine(&nodal, size, model));
done:
    if (status != PDMC_OK) pdmc_affine_clear(model);
    return status;
}
