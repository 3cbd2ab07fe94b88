// SPDX-License-Identifier: GPL-3.0-or-later

/// The cost of finite elements of a plate: pairs of outer points and triangles, and solutions.

#include "run/cost_impl.h"

#include "galerkin/plate_form.h"
#include "pdmc/affine.h"
#include "pdmc/fracture.h"

#include <gsl/gsl_math.h>
#include <math.h>

// Measured on a thread of a 2023 server core (AMD EPYC) with plates of 5,000 to 45,000 triangles, three to nine to a horizon,
// without planes and with ten.
static const double seconds_per_moment = 0.35e-6;                                  // of an outer point with a triangle
static const double seconds_per_plane = 0.08e-6;                                   // more for every plane
static const double seconds_per_flop = 1.0 / 25e9;                                 // of the factorisation
static const double seconds_per_factor_entry = 1e-9;                               // of a solution
static const double seconds_per_bond_direction = 0.03e-9, seconds_per_draw = 5e-6; // of a sample
static const double response_size = 30.0; // dimension of the response space, as measured
static const double bytes_of_program = 30e6;
static const double outer_points = 7.0;

typedef struct {
    double nodes, values, moments, entries; // entries of the form, in blocks
    double factor_entries, flops;
} sizes;

static sizes count(const pdmc_problem *problem, double spacing)
{
    const pdmc_solver_options *solver = &problem->solver;
    const double ratio = solver->horizon / spacing, parts = solver->outer_parts;
    const double columns = ceil(problem->plate.width / spacing), rows = ceil(problem->plate.height / spacing);
    const double triangles = 2.0 * columns * rows, per_node = solver->space == PDMC_SPACE_DISCONTINUOUS ? 6.0 : 1.0;
    const double reach = 2.0 * M_PI * (ratio + 1.2) * (ratio + 1.2); // triangles that a point looks at
    sizes s = {.nodes = (columns + 1.0) * (rows + 1.0)};
    s.values = per_node * s.nodes;
    s.moments = outer_points * parts * parts * triangles * reach;
    s.entries = 0.5 * s.values * per_node * M_PI * (ratio + 2.0) * (ratio + 2.0);
    s.factor_entries = 58.0 * (ratio + 1.0) * fmax(log2(s.values) - 8.6, 1.0) * s.values;
    s.flops = 480.0 * (ratio + 1.0) * (ratio + 1.0) * pow(s.values, 1.5);
    return s;
}

static double seconds_to_solve(const sizes *s, double planes, int threads)
{
    return s->moments * (seconds_per_moment + planes * seconds_per_plane) / threads + s->flops * seconds_per_flop;
}

pdmc_cost pdmc_galerkin_cost(const pdmc_problem *problem, int threads)
{
    const sizes fine = count(problem, problem->solver.spacing), coarse = count(problem, 1.25 * problem->solver.spacing);
    const pdmc_uncertainty *noise = pdmc_problem_uncertainty(problem, PDMC_QUANTITY_MICROMODULUS);
    const double planes = noise ? fmin(noise->bins, PDMC_PLATE_PLANES) : 0.0, dimension = noise ? response_size : 2.0;
    const double samples = problem->sampling.samples;
    const double directions = problem->energy.tip_count * (double)problem->energy.angles;
    const double bonds = PDMC_CROSSING_BONDS * (problem->energy.line == PDMC_LINE_SEGMENT ? PDMC_LINE_POINTS : 1);
    const double words = noise ? dimension * planes : 0.0; // solutions that the response space is made of
    const double file = 8.0 * pdmc_problem_kept(problem) * (PDMC_MEASURES * directions + (noise ? noise->bins : 0.0));
    const double model =
        words * (seconds_per_factor_entry * fine.factor_entries + 4e-9 * fine.entries * planes) / threads;
    const double plates = pdmc_problem_moves_cracks(problem) ? samples / threads : 0.0;
    double seconds = seconds_to_solve(&fine, planes, threads) + model;
    if (directions > 0.0) seconds += seconds_to_solve(&coarse, 0.0, threads);
    seconds += plates * threads * (seconds_to_solve(&fine, planes, threads) + model);
    seconds += samples * (seconds_per_draw + directions * bonds * dimension * seconds_per_bond_direction) / threads;
    double bytes = 8.0 * (fine.factor_entries + coarse.factor_entries) + 24.0 * fine.entries * fmax(planes, 1.0);
    bytes += 8.0 * directions * bonds * dimension + 2.0 * file;
    bytes += noise ? 8.0 * 4000.0 * 2.0 * fine.values : 0.0; // room for four times the most directions of a response
    return (pdmc_cost){.nodes = (int)fine.nodes,
                       .unknowns = (int)(2.0 * fine.values),
                       .rows = (int)(2.0 * fine.values),
                       .bytes = bytes_of_program + bytes,
                       .seconds = seconds};
}
