// SPDX-License-Identifier: GPL-3.0-or-later

/// The cost of a grid of bonds: its Cholesky factor, and the solutions with it.

#include "run/cost_impl.h"

#include "pdmc/affine.h"

#include <math.h>

// Measured with CHOLMOD and METIS on square grids of 2,500 to 40,000 nodes with horizons of 3 to 12 spacings, on a thread
// of a 2023 server core (AMD EPYC).
static const double seconds_per_flop = 1.0 / 25e9;        // of the factorisation
static const double seconds_per_entry_analysed = 0.15e-6; // of the matrix
static const double seconds_per_factor_entry = 0.22e-9;   // of a solution, in blocks, both triangles
static const double seconds_per_bond_product = 0.4e-9;    // of K times a vector, each bond from both its ends
static const double seconds_of_a_reduced_sample = 0.5e-3; // with some 200 unknowns
// Of a random stiffness with 20 to 200 modes, whose reduced model has a term for each, on 2,500 and 6,400 nodes.
static const double seconds_per_trained_bond = 6e-6, seconds_per_mode_of_a_bond = 0.4e-6;
static const double seconds_of_a_reduced_field = 2.5e-6; // of a sample, times the modes to the power 3/2
static const double seconds_per_direction = 30e-6;       // of a sample's energies
static const double seconds_per_covariance = 17e-9;      // of two points of a random stiffness
static const double seconds_per_distribution = 1.7e-3;   // intervals of a histogram
static const double bytes_of_program = 30e6;

typedef struct {
    double nodes, bonds;   // bonds counted from both ends
    double entries, flops; // of the factor
} sizes;

static sizes count(const pdmc_problem *problem, double spacing)
{
    const double horizon = problem->solver.horizon, ratio = horizon / spacing;
    double extent[2] = {problem->plate.width, problem->plate.height};
    for (int s = 0; s < problem->support_count; s++) {
        const pdmc_support *support = &problem->supports[s];
        if (!support->held[0] && !support->held[1]) continue;
        const int across = support->side == PDMC_SIDE_LEFT || support->side == PDMC_SIDE_RIGHT ? 0 : 1;
        extent[across] += spacing * ceil(ratio - 1e-9);
    }
    sizes s = {.nodes = round(extent[0] / spacing) * round(extent[1] / spacing)};
    s.bonds = 3.2 * (ratio + 0.5) * (ratio + 0.5) * s.nodes;
    s.entries = 58.0 * ratio * fmax(log2(s.nodes) - 8.6, 1.0) * s.nodes;
    s.flops = 480.0 * ratio * ratio * pow(s.nodes, 1.5);
    return s;
}

static double seconds_to_factor(const sizes *s)
{
    return seconds_per_entry_analysed * 2.0 * s->bonds + seconds_per_flop * s->flops;
}

// One after another; the threads share them.
static double seconds_of_a_sample(const pdmc_problem *problem, const sizes *s)
{
    const pdmc_uncertainty *stiffness = pdmc_problem_uncertainty(problem, PDMC_QUANTITY_STIFFNESS);
    const double step = seconds_per_factor_entry * s->entries + seconds_per_bond_product * s->bonds;
    const double steps_of_iteration = 12.0; // for a variation of 20 %, to 1e-8
    switch (problem->sampling.inverse) {
    case PDMC_INVERSE_DIRECT: return seconds_per_flop * s->flops;
    case PDMC_INVERSE_NEUMANN: return problem->sampling.order * step;
    case PDMC_INVERSE_KRYLOV: return steps_of_iteration * step;
    case PDMC_INVERSE_REDUCED:
        return stiffness ? seconds_of_a_reduced_field * pow(stiffness->modes, 1.5) : seconds_of_a_reduced_sample;
    }
    return 0.0;
}

// Of a random stiffness: two more plates a tip, covariances of the nodes with squares of a tenth of its length, and the basis of
// a reduced model.
static double seconds_of_field(const pdmc_problem *problem, const pdmc_uncertainty *stiffness, const sizes *s,
                               int threads)
{
    const double side = fmax(floor(0.1 * stiffness->covariance.length / problem->solver.spacing), 1.0);
    const double squares = s->nodes / (side * side);
    const bool is_reduced = problem->sampling.inverse == PDMC_INVERSE_REDUCED;
    const double training = seconds_per_trained_bond + seconds_per_mode_of_a_bond * stiffness->modes;
    return 2.0 * problem->energy.tip_count * seconds_to_factor(s) +
           (seconds_per_covariance * squares * (squares + s->nodes) + (is_reduced ? training * s->bonds : 0.0)) /
               threads;
}

pdmc_cost pdmc_bond_cost(const pdmc_problem *problem, int threads)
{
    const sizes fine = count(problem, problem->solver.spacing), coarse = count(problem, 1.25 * problem->solver.spacing);
    const pdmc_uncertainty *noise = pdmc_problem_uncertainty(problem, PDMC_QUANTITY_MICROMODULUS);
    const pdmc_uncertainty *stiffness = pdmc_problem_uncertainty(problem, PDMC_QUANTITY_STIFFNESS);
    const double samples = problem->sampling.samples, unknowns = 2.0 * fine.nodes;
    const double directions = problem->energy.tip_count * (double)problem->energy.angles;
    const double file = 8.0 * pdmc_problem_kept(problem) * (PDMC_MEASURES * directions + (noise ? noise->bins : 0.0));
    double seconds = seconds_to_factor(&fine) + (directions > 0.0 ? seconds_to_factor(&coarse) : 0.0);
    const double plates = pdmc_problem_moves_cracks(problem) ? samples : 0.0; // each with a block of its own
    const double columns = plates > 0.0 ? PDMC_BLOCK : 1.0;
    if (stiffness) seconds += seconds_of_field(problem, stiffness, &fine, threads);
    seconds += plates * seconds_to_factor(&fine) / threads;
    seconds += columns * samples *
               ((noise || stiffness ? seconds_of_a_sample(problem, &fine) : 0.0) + directions * seconds_per_direction) /
               threads;
    seconds += PDMC_MEASURES * directions * seconds_per_distribution / threads;
    double bytes = 8.0 * (fine.entries + coarse.entries) + 26.0 * fine.bonds + 2.0 * file;
    bytes += 8.0 * PDMC_BLOCK * unknowns * 6.0 * threads;
    bytes += stiffness ? 8.0 * stiffness->modes * fine.nodes : 0.0;
    return (pdmc_cost){.nodes = (int)fine.nodes,
                       .unknowns = (int)unknowns,
                       .rows = (int)unknowns,
                       .bytes = bytes_of_program + bytes,
                       .seconds = seconds};
}
