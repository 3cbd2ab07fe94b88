// SPDX-License-Identifier: GPL-3.0-or-later
#include "discretisation/tip.h"

#include "base/base_impl.h"
#include "discretisation/interaction.h"

#include <cblas.h>
#include <math.h>
#include <stdio.h>

pdmc_status pdmc_tip_of(const pdmc_problem *problem, int tip, int unknowns, const double solution[],
                        pdmc_tip_rows *rows, const void *method, pdmc_tip *out)
{
    PDMC_REQUIRE(0 <= tip && tip < 2 * problem->crack_count, "tip %d: there are %d", tip, 2 * problem->crack_count);
    PDMC_REQUIRE(pdmc_problem_is_tip(problem, tip), "end %d of the cracks is no tip", tip);
    pdmc_status status = PDMC_OK;
    const pdmc_tip_frame frame = pdmc_tip_frame_of(problem, tip);
    double *row = NULL; // [2, unknowns]
    PDMC_NEW(row, 2 * unknowns);
    PDMC_TRY(rows(method, tip, row, row + unknowns));
    *out = (pdmc_tip){.position = {frame.position[0], frame.position[1]},
                      .direction = atan2(frame.sine + 0.0, frame.cosine), // no -0, which would be -pi
                      .t_stress = NAN,
                      .stress_intensity_error = {NAN, NAN},
                      .t_stress_error = NAN};
    snprintf(out->name, sizeof out->name, "%s.%s", problem->cracks[tip / 2].name, tip % 2 ? "to" : "from");
    for (int k = 0; k < 2; k++) out->stress_intensity[k] = cblas_ddot(unknowns, row + k * unknowns, 1, solution, 1);
done:
    pdmc_free(row);
    return status;
}

double pdmc_tip_half_length(const pdmc_problem *problem, int tip)
{
    double ends[2][2];
    pdmc_problem_crack_inside(problem, tip / 2, ends);
    return 0.5 * hypot(ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]);
}
