// SPDX-License-Identifier: GPL-3.0-or-later
#include "visible/view.h"

#include "base/base_impl.h"

#include <float.h>
#include <math.h>

// The stretch of the line centre + s (cosine, sine) that is inside the plate, within low <= s <= high.
static void clip(const pdmc_plate *plate, pdmc_cut *cut)
{
    const double half[2] = {0.5 * plate->width, 0.5 * plate->height}, direction[2] = {cut->cosine, cut->sine};
    for (int k = 0; k < 2; k++) {
        if (fabs(direction[k]) < DBL_EPSILON) continue;
        const double middle = -cut->centre[k] / direction[k], reach = half[k] / fabs(direction[k]);
        cut->low = fmax(cut->low, middle - reach);
        cut->high = fmin(cut->high, middle + reach);
    }
}

static pdmc_cut cut_of(const pdmc_problem *problem, int c)
{
    const double *from = problem->cracks[c].from, *to = problem->cracks[c].to;
    const double length = hypot(to[0] - from[0], to[1] - from[1]);
    const double outside = problem->plate.width + problem->plate.height;
    pdmc_cut cut = {.cosine = (to[0] - from[0]) / length, .sine = (to[1] - from[1]) / length};
    double end[2] = {0.0, length}; // from "from"
    for (int t = 0; t < 2; t++) {
        cut.has_tip[t] = pdmc_problem_is_tip(problem, 2 * c + t);
        if (!cut.has_tip[t]) end[t] += t == 0 ? -outside : outside;
    }
    cut.half_length = 0.5 * (end[1] - end[0]);
    const double middle = 0.5 * (end[0] + end[1]);
    cut.centre[0] = from[0] + middle * cut.cosine;
    cut.centre[1] = from[1] + middle * cut.sine;
    cut.low = -cut.half_length;
    cut.high = cut.half_length;
    clip(&problem->plate, &cut);
    return cut;
}

pdmc_status pdmc_cuts_create(const pdmc_problem *problem, pdmc_cuts *cuts)
{
    pdmc_status status = PDMC_OK;
    *cuts = (pdmc_cuts){.count = problem->crack_count};
    PDMC_NEW(cuts->cut, cuts->count);
    for (int c = 0; c < cuts->count; c++) cuts->cut[c] = cut_of(problem, c);
done:
    return status;
}

void pdmc_cuts_clear(pdmc_cuts *cuts)
{
    pdmc_free(cuts->cut);
    *cuts = (pdmc_cuts){0};
}

void pdmc_cut_local(const pdmc_cut *cut, const double x[2], double local[2])
{
    const double dx = x[0] - cut->centre[0], dy = x[1] - cut->centre[1];
    local[0] = cut->cosine * dx + cut->sine * dy;
    local[1] = cut->cosine * dy - cut->sine * dx;
}

void pdmc_cut_global(const pdmc_cut *cut, double along, double across, double x[2])
{
    x[0] = cut->centre[0] + cut->cosine * along - cut->sine * across;
    x[1] = cut->centre[1] + cut->sine * along + cut->cosine * across;
}

double pdmc_cuts_distance(const pdmc_cuts *cuts, const double x[2])
{
    double distance = INFINITY;
    for (int c = 0; c < cuts->count; c++) {
        double local[2];
        pdmc_cut_local(&cuts->cut[c], x, local);
        const double beyond = fmax(fabs(local[0]) - cuts->cut[c].half_length, 0.0);
        distance = fmin(distance, sqrt(beyond * beyond + local[1] * local[1]));
    }
    return distance;
}

static int side_of(double across)
{
    return across >= 0.0 ? 1 : -1;
}

static bool sees_past(const pdmc_cut *cut, int c, const pdmc_view *a, const pdmc_view *b)
{
    double p[2], q[2];
    pdmc_cut_local(cut, a->x, p);
    pdmc_cut_local(cut, b->x, q);
    if (a->crack == c || b->crack == c)
        return (a->crack == c ? a->side : side_of(p[1])) == (b->crack == c ? b->side : side_of(q[1]));
    if (side_of(p[1]) == side_of(q[1])) return true;
    return fabs(p[0] + (q[0] - p[0]) * p[1] / (p[1] - q[1])) >= cut->half_length;
}

bool pdmc_view_sees(const pdmc_cuts *cuts, const pdmc_view *a, const pdmc_view *b)
{
    for (int c = 0; c < cuts->count; c++)
        if (!sees_past(&cuts->cut[c], c, a, b)) return false;
    return true;
}

pdmc_view pdmc_view_at(const pdmc_cuts *cuts, const double x[2], const double anchor[2])
{
    for (int c = 0; c < cuts->count; c++) {
        const pdmc_cut *cut = &cuts->cut[c];
        double local[2], side[2];
        pdmc_cut_local(cut, x, local);
        pdmc_cut_local(cut, anchor, side);
        if (fabs(local[0]) < cut->half_length && fabs(local[1]) < 1e-9 * cut->half_length)
            return (pdmc_view){{x[0], x[1]}, c, side_of(side[1])};
    }
    return (pdmc_view){{x[0], x[1]}, -1, 0};
}
