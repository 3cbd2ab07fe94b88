// SPDX-License-Identifier: GPL-3.0-or-later

/// Cracks whose length, angle and place are random.

#include "pdmc/problem.h"

#include "pdmc/geometry.h"

#include <gsl/gsl_math.h>
#include <math.h>

static double length_of(const pdmc_crack *crack)
{
    return hypot(crack->to[0] - crack->from[0], crack->to[1] - crack->from[1]);
}

bool pdmc_problem_moves_cracks(const pdmc_problem *problem)
{
    for (int i = 0; i < problem->uncertainty_count; i++)
        if (problem->uncertainties[i].quantity >= PDMC_FIRST_OF_CRACK) return true;
    return false;
}

// The value of a quantity that is random and of this crack.
static double value_of(const pdmc_problem *problem, int crack, pdmc_quantity quantity, const double value[],
                       double otherwise)
{
    const pdmc_uncertainty *uncertainty = pdmc_problem_uncertainty(problem, quantity);
    return uncertainty && uncertainty->crack == crack ? value[quantity - PDMC_FIRST_SCALAR] : otherwise;
}

double pdmc_problem_turn(const pdmc_problem *problem, int crack, const double value[])
{
    return value_of(problem, crack, PDMC_QUANTITY_CRACK_ANGLE, value, 0.0) * M_PI / 180.0;
}

static bool is_moved(const pdmc_problem *problem, int crack)
{
    for (int i = 0; i < problem->uncertainty_count; i++) {
        const pdmc_uncertainty *uncertainty = &problem->uncertainties[i];
        if (uncertainty->quantity >= PDMC_FIRST_OF_CRACK && uncertainty->crack == crack) return true;
    }
    return false;
}

static void place(const pdmc_problem *problem, int index, const double value[], pdmc_crack *crack)
{
    const double length = length_of(crack), turn = pdmc_problem_turn(problem, index, value);
    const double growth = fmax(value_of(problem, index, PDMC_QUANTITY_CRACK_LENGTH, value, length), 0.0) / length;
    const double half[2] = {0.5 * growth * (crack->to[0] - crack->from[0]),
                            0.5 * growth * (crack->to[1] - crack->from[1])};
    const double turned[2] = {cos(turn) * half[0] - sin(turn) * half[1], sin(turn) * half[0] + cos(turn) * half[1]};
    for (int k = 0; k < 2; k++) {
        const double shift = value_of(problem, index, k ? PDMC_QUANTITY_CRACK_Y : PDMC_QUANTITY_CRACK_X, value, 0.0);
        const double middle = 0.5 * (crack->from[k] + crack->to[k]) + shift;
        crack->from[k] = middle - turned[k];
        crack->to[k] = middle + turned[k];
    }
}

void pdmc_problem_place_cracks(const pdmc_problem *problem, const double value[], pdmc_crack cracks[])
{
    for (int c = 0; c < problem->crack_count; c++) {
        cracks[c] = problem->cracks[c];
        if (is_moved(problem, c)) place(problem, c, value, &cracks[c]);
    }
}

double pdmc_problem_least_half_crack(const pdmc_problem *problem)
{
    if (problem->solver.method != PDMC_METHOD_KANSA) return problem->solver.spacing;
    switch (problem->solver.crack_model) {
    case PDMC_CRACKS_ANALYTIC: return 2.0 * problem->solver.horizon;
    case PDMC_CRACKS_VISIBLE: return problem->solver.horizon;
    case PDMC_CRACKS_PAPER: break;
    }
    return 0.0;
}

// What a computed length may miss.
static bool is_at_least(double x, double bound)
{
    return x >= bound * (1.0 - 1e-9);
}

static double edge_distance(const pdmc_plate *plate, const double x[2])
{
    return fmin(0.5 * plate->width - fabs(x[0]), 0.5 * plate->height - fabs(x[1]));
}

static double crack_distance(const pdmc_crack *a, const pdmc_crack *b)
{
    if (pdmc_segments_cross(a->from, a->to, b->from, b->to)) return 0.0;
    return fmin(
        fmin(pdmc_point_segment_distance(a->from, b->from, b->to), pdmc_point_segment_distance(a->to, b->from, b->to)),
        fmin(pdmc_point_segment_distance(b->from, a->from, a->to), pdmc_point_segment_distance(b->to, a->from, a->to)));
}

// An end outside the plate stays there, so that the crack has its mouth.
static bool end_fits(const pdmc_problem *problem, double clearance, const double from[2], const double to[2])
{
    const double before = edge_distance(&problem->plate, from), after = edge_distance(&problem->plate, to);
    if (before <= 0.0) return after <= 0.0;
    return after > 0.0 && is_at_least(after, fmin(clearance, before));
}

bool pdmc_problem_cracks_fit(const pdmc_problem *problem, const pdmc_crack cracks[])
{
    const double clearance = fmax(problem->solver.horizon, problem->solver.spacing);
    const double least = pdmc_problem_least_half_crack(problem);
    for (int c = 0; c < problem->crack_count; c++) {
        const pdmc_crack *old = &problem->cracks[c], *now = &cracks[c];
        const double half = 0.5 * length_of(now);
        if (!(half > 0.0) || !is_at_least(half, fmin(least, 0.5 * length_of(old)))) return false;
        if (!end_fits(problem, clearance, old->from, now->from) || !end_fits(problem, clearance, old->to, now->to))
            return false;
        for (int d = 0; d < c; d++)
            if (!is_at_least(crack_distance(now, &cracks[d]),
                             fmin(clearance, crack_distance(old, &problem->cracks[d]))))
                return false;
    }
    return true;
}
