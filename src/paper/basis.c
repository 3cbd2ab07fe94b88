// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/basis.h"

#include "base/base_impl.h"
#include "pdmc/geometry.h"

#include <gsl/gsl_math.h>
#include <math.h>

static void fill_tip(const pdmc_crack *crack, int end, pdmc_paper_tip_frame *tip)
{
    const double *at = end ? crack->to : crack->from, *other = end ? crack->from : crack->to;
    const double length = hypot(at[0] - other[0], at[1] - other[1]);
    *tip = (pdmc_paper_tip_frame){{at[0], at[1]}, (at[0] - other[0]) / length, (at[1] - other[1]) / length};
}

pdmc_status pdmc_paper_basis_create(const pdmc_problem *problem, pdmc_paper_basis *basis)
{
    pdmc_status status = PDMC_OK;
    *basis = (pdmc_paper_basis){.problem = problem};
    basis->scale = 0.5 * fmin(problem->plate.width, problem->plate.height);
    if (problem->solver.tip_functions == PDMC_ON) basis->tip_count = 2 * problem->crack_count;
    PDMC_TRY(pdmc_paper_nodes_create(problem, &basis->nodes));
    PDMC_NEW(basis->tip, basis->tip_count);
    for (int t = 0; t < basis->tip_count; t++) fill_tip(&problem->cracks[t / 2], t % 2, &basis->tip[t]);
    basis->scalars = basis->nodes.count + PDMC_PAPER_MONOMIALS + PDMC_PAPER_TIP_FUNCTIONS * basis->tip_count;
done:
    if (status != PDMC_OK) pdmc_paper_basis_clear(basis);
    return status;
}

void pdmc_paper_basis_clear(pdmc_paper_basis *basis)
{
    pdmc_paper_nodes_clear(&basis->nodes);
    pdmc_free(basis->tip);
    *basis = (pdmc_paper_basis){0};
}

// On a grid many segments between nodes pass through a tip, where rounding would decide: a tip hides nothing.
bool pdmc_paper_visible(const pdmc_problem *problem, const double p[2], const double q[2])
{
    const double shorter = 1e-9;
    for (int c = 0; c < problem->crack_count; c++) {
        const double *from = problem->cracks[c].from, *to = problem->cracks[c].to;
        const double d[2] = {shorter * (to[0] - from[0]), shorter * (to[1] - from[1])};
        const double a[2] = {from[0] + d[0], from[1] + d[1]}, b[2] = {to[0] - d[0], to[1] - d[1]};
        if (pdmc_segments_cross(p, q, a, b)) return false;
    }
    return true;
}

static double offset(const pdmc_paper_tip_frame *tip, const double x[2])
{
    return tip->cosine * (x[1] - tip->position[1]) - tip->sine * (x[0] - tip->position[0]);
}

// t at x; behind the tip on its axis, where t jumps, the anchor's side decides, and `side` is 0 where the anchor has none.
static double polar_angle(const pdmc_paper_tip_frame *tip, const double x[2], const double anchor[2], double r,
                          int *side)
{
    const double tolerance = 1e-12 * r;
    const double along = tip->cosine * (x[0] - tip->position[0]) + tip->sine * (x[1] - tip->position[1]);
    const double y = offset(tip, x), anchor_y = offset(tip, anchor);
    *side = 1;
    if (along > 0.0 || fabs(y) > tolerance) return atan2(y, along);
    *side = (anchor_y > tolerance) - (anchor_y < -tolerance);
    return *side * M_PI;
}

static void tip_values(const pdmc_paper_tip_frame *tip, double scale, const double x[2], const double anchor[2],
                       double value[])
{
    int side;
    const double r = hypot(x[0] - tip->position[0], x[1] - tip->position[1]);
    const double t = polar_angle(tip, x, anchor, r, &side),
                 root = side ? sqrt(r / scale) : 0.0; // the mean of both sides
    value[0] = root * cos(0.5 * t);
    value[1] = root * sin(0.5 * t);
    value[2] = value[1] * sin(t);
    value[3] = value[0] * sin(t);
}

void pdmc_paper_q_values(const pdmc_paper_basis *basis, const double x[2], const double anchor[2], double value[])
{
    const double xs = x[0] / basis->scale, ys = x[1] / basis->scale;
    value[0] = 1.0;
    value[1] = xs;
    value[2] = ys;
    value[3] = xs * ys;
    for (int t = 0; t < basis->tip_count; t++)
        tip_values(&basis->tip[t], basis->scale, x, anchor,
                   &value[PDMC_PAPER_MONOMIALS + PDMC_PAPER_TIP_FUNCTIONS * t]);
}

void pdmc_paper_values(const pdmc_paper_basis *basis, const double x[2], const double anchor[2], double value[])
{
    const pdmc_problem *problem = basis->problem;
    const double shape = problem->solver.shape;
    for (int k = 0; k < basis->nodes.count; k++) {
        const double *node = &basis->nodes.x[2 * k];
        const double dx = x[0] - node[0], dy = x[1] - node[1];
        const bool sees = pdmc_paper_visible(problem, node, anchor);
        value[k] = sees ? shape / sqrt(dx * dx + dy * dy + shape * shape) : 0.0;
    }
    pdmc_paper_q_values(basis, x, anchor, &value[basis->nodes.count]);
}
