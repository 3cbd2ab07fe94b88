// SPDX-License-Identifier: GPL-3.0-or-later
#include "visible/tip.h"

#include "base/base_impl.h"
#include "discretisation/interaction.h"

#include <cblas.h>
#include <math.h>
#include <stdio.h>
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
    const pdmc_cut *cut = &visible->cuts.cut[tip / 2];
    const double half_length = 0.5 * (cut->high - cut->low);
    const double wanted = fmax(half_length, 2.0 * problem->solver.horizon);
    return pdmc_interaction_rows(problem, tip, pdmc_interaction_radius(problem, tip, wanted), &functional, row_1,
                                 row_2);
}

pdmc_status pdmc_visible_tip(const pdmc_visible *visible, int tip, pdmc_tip *out)
{
    const pdmc_problem *problem = visible->problem;
    PDMC_REQUIRE(0 <= tip && tip < 2 * problem->crack_count, "tip %d: there are %d", tip, 2 * problem->crack_count);
    PDMC_REQUIRE(pdmc_problem_is_tip(problem, tip), "end %d of the cracks is no tip", tip);
    pdmc_status status = PDMC_OK;
    const int n = visible->unknowns;
    const pdmc_tip_frame frame = pdmc_tip_frame_of(problem, tip);
    double *row = NULL;
    PDMC_NEW(row, 2 * n);
    PDMC_TRY(pdmc_visible_stress_intensity_rows(visible, tip, row, row + n));
    snprintf(out->name, sizeof out->name, "%s.%s", problem->cracks[tip / 2].name, tip % 2 ? "to" : "from");
    for (int k = 0; k < 2; k++) {
        out->position[k] = frame.position[k];
        out->stress_intensity[k] = cblas_ddot(n, row + k * n, 1, visible->mean, 1);
    }
    out->direction = atan2(frame.sine + 0.0, frame.cosine); // no -0, which would be -pi
    out->t_stress = NAN;
done:
    pdmc_free(row);
    return status;
}
