// SPDX-License-Identifier: GPL-3.0-or-later

/// The cost of a study: its samples, those of a control, and the points of rare growth.

#include "pdmc/run.h"

#include "run/control.h"
#include "run/cost_impl.h"

#include <math.h>

// Of rare growth, as measured with P from 1e-3 to 1e-6, times the square of the coefficient of variation that is asked for.
static const double points_by_importance = 6.0, points_by_subsets = 300.0;
static const double steps_of_a_search = 5.0; // for a design point

static pdmc_cost cost_of_samples(const pdmc_problem *problem, int threads)
{
    switch (problem->solver.method) {
    case PDMC_METHOD_KANSA: break;
    case PDMC_METHOD_BOND: return pdmc_bond_cost(problem, threads);
    case PDMC_METHOD_GALERKIN: return pdmc_galerkin_cost(problem, threads);
    }
    return pdmc_collocation_cost(problem, threads);
}

static double count_variables(const pdmc_problem *problem)
{
    double count = 0.0;
    for (int i = 0; i < problem->uncertainty_count; i++) {
        const pdmc_uncertainty *u = &problem->uncertainties[i];
        const bool is_noise = u->quantity == PDMC_QUANTITY_MICROMODULUS && u->model == PDMC_RADIAL_NOISE;
        if (u->quantity < PDMC_FIRST_SCALAR) count += is_noise ? u->bins : u->modes;
        else count += u->quantity == PDMC_QUANTITY_FRACTURE_ENERGY && u->has_length ? problem->energy.tip_count : 1.0;
    }
    return count;
}

// Each step of a search is a gradient by central differences and a line of points; another search begins on the axes.
static double count_points(const pdmc_problem *problem)
{
    const pdmc_reliability_request *request = &problem->reliability;
    const double variables = count_variables(problem), squared = request->variation * request->variation;
    const double search = problem->energy.tip_count * (steps_of_a_search * (2.0 * variables + 13.0) + 2.0 * variables);
    double points = request->sensitivity * (problem->uncertainty_count + 2.0);
    if (request->method == PDMC_RARE_IMPORTANCE || request->method == PDMC_RARE_BOTH)
        points += search + fmin(request->evaluations, points_by_importance / squared);
    if (request->method == PDMC_RARE_SUBSET || request->method == PDMC_RARE_BOTH)
        points += fmin(request->evaluations, points_by_subsets / squared);
    return points;
}

// Of samples that are neither kept nor of a design, beyond those of one block.
static double seconds_of_points(const pdmc_problem *problem, double points, int threads)
{
    pdmc_problem many = *problem;
    many.sampling.design = PDMC_DESIGN_MONTE_CARLO;
    many.sampling.keep = 1;
    many.sampling.samples = PDMC_BLOCK;
    const double block = cost_of_samples(&many, threads).seconds;
    many.sampling.samples *= 2;
    return points / PDMC_BLOCK * fmax(cost_of_samples(&many, threads).seconds - block, 0.0);
}

static void add_control(const pdmc_problem *problem, int threads, pdmc_cost *cost)
{
    const pdmc_problem cheaper = pdmc_control_problem(problem, problem->sampling.samples);
    const pdmc_cost control = cost_of_samples(&cheaper, threads);
    cost->bytes += control.bytes; // beside the samples that it is the control of
    cost->seconds += control.seconds;
}

pdmc_cost pdmc_run_cost(const pdmc_problem *problem, int threads)
{
    pdmc_cost cost = cost_of_samples(problem, threads);
    const double of_samples = cost.seconds;
    cost.most_seconds = of_samples;
    if (problem->sampling.target != PDMC_TARGET_NONE) {
        pdmc_problem most = *problem;
        most.sampling.samples = problem->sampling.most_samples;
        cost.most_seconds = fmax(of_samples, cost_of_samples(&most, threads).seconds);
    }
    if (problem->kind == PDMC_STATIC) cost.seconds += seconds_of_points(problem, count_points(problem), threads);
    if (problem->kind == PDMC_STATIC && problem->control.samples > 0) add_control(problem, threads, &cost);
    cost.most_seconds += cost.seconds - of_samples;
    return cost;
}
