// SPDX-License-Identifier: GPL-3.0-or-later
#include "visible/tip.h"

#include "base/base_impl.h"
#include "discretisation/interaction.h"
#include "discretisation/tip.h"

#include <math.h>
#include <string.h>

// The gradient of the stencil that a point belongs to.
static pdmc_status gradient_at(const void *method, const double x[2], int *count, int node[], double by_x[],
                               double by_y[])
{
    const pdmc_visible *visible = method;
    const pdmc_view view = {{x[0], x[1]}, -1, 0};
    const int owner = pdmc_stencil_owner(&visible->field, &view);
    if (owner < 0) return pdmc_raise(PDMC_ERR_SINGULAR, "no node is visible from (%g, %g)", x[0], x[1]);
    const pdmc_stencil *stencil = &visible->stencils[owner];
    *count = stencil->count;
    memcpy(node, stencil->node, (size_t)stencil->count * sizeof *node);
    pdmc_stencil_gradient(stencil, x, by_x, by_y);
    return PDMC_OK;
}

pdmc_status pdmc_visible_stress_intensity_rows(const pdmc_visible *visible, int tip, double row_1[], double row_2[])
{
    const pdmc_problem *problem = visible->problem;
    const pdmc_gradient_functional functional = {PDMC_STENCIL_NODES, visible, gradient_at};
    const double wanted = fmax(pdmc_tip_half_length(problem, tip), 2.0 * problem->solver.horizon);
    return pdmc_interaction_rows(problem, tip, pdmc_interaction_radius(problem, tip, wanted), &functional, row_1,
                                 row_2);
}

static pdmc_status tip_rows(const void *method, int tip, double row_1[], double row_2[])
{
    return pdmc_visible_stress_intensity_rows(method, tip, row_1, row_2);
}

pdmc_status pdmc_visible_tip(const pdmc_visible *visible, int tip, pdmc_tip *out)
{
    return pdmc_tip_of(visible->problem, tip, visible->unknowns, visible->mean, tip_rows, visible, out);
}
