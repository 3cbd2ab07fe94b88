// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/run.h"

#include <math.h>

// Of a thread of a 2024 server core with AVX-512, as measured on studies/plate_pulse and studies/sphere_block.
static const double seconds_per_bond = 1.8e-9; // and step
static const double steps_per_record = 3.5;    // energies, damage and pieces are asked for: a look at every bond each
static const double bytes_per_node = 260.0, bytes_per_bond = 0.25; // of the engine
static const double scattered_seconds = 2.3;                       // of a bond off the grid, over those of one on it
static const double scattered_bytes_per_bond = 3.1;
static const double bytes_of_program = 15e6;
static const double most_modes = 400.0; // of a fracture energy in space

double pdmc_run_quadrature_bytes(const pdmc_horizon_study *study)
{
    const double bytes_per_point = 4.0 * 8.0 * 3.0, ratio = study->ratios[study->ratio_count - 1] + 1.0; // while it grows
    const double points = study->dimension == 3 ? 64.0 * 4.2 * ratio * ratio * ratio : 16.0 * 3.2 * ratio * ratio;
    return bytes_of_program + points * bytes_per_point;
}

// A square of N nodes took 3.3 sqrt(N) steps to 1e-6 of its reactions from load to load where no bond broke; every breakage costs
// as much again, and how many there will be nobody knows before.
static double steps_to_rest(const pdmc_explicit *study, double nodes)
{
    return 3.3 * pow(nodes, 1.0 / study->dimension) * fmax(1.0, log10(1.0 / study->rest_tolerance)) / 6.0;
}

static bool is_scattered(const pdmc_explicit *study)
{
    for (int b = 0; b < study->body_count; b++)
        if (pdmc_shape_has_nodes(study->bodies[b].body.shape.kind)) return true;
    return false;
}

pdmc_explicit_cost pdmc_run_explicit_cost(const pdmc_explicit *study, int threads)
{
    const pdmc_explicit_amounts amounts = pdmc_explicit_count(study);
    const bool rests = study->load_steps > 0, scattered = is_scattered(study);
    const double of_bond = scattered ? scattered_seconds * seconds_per_bond : seconds_per_bond;
    const double records = rests ? amounts.steps : fmin(amounts.steps, study->duration / study->interval);
    const double steps = rests ? steps_to_rest(study, amounts.nodes) * amounts.steps : amounts.steps;
    const double states = 60.0 * (fmin(study->snapshots, amounts.steps) + 1.0); // u, v, damage and piece of a node
    const double cells = 17.0 + 28.0;                                           // what else the file has of it
    return (pdmc_explicit_cost){
        .nodes = amounts.nodes,
        .bonds = amounts.bonds,
        .steps = amounts.steps,
        .bytes = bytes_of_program + amounts.nodes * (bytes_per_node + 2.0 * (states + cells)) +
                 amounts.bonds * (scattered ? scattered_bytes_per_bond : bytes_per_bond),
        .seconds = (steps + steps_per_record * records) * amounts.bonds * of_bond / fmax(1.0, threads),
    };
}

pdmc_explicit_cost pdmc_run_ensemble_cost(const pdmc_study *study, int threads)
{
    const pdmc_problem *problem = &study->problem;
    pdmc_explicit_cost cost = pdmc_run_explicit_cost(&study->motion, threads);
    if (problem->uncertainty_count == 0) return cost;
    pdmc_explicit one = study->motion;
    one.snapshots = 1;
    const double samples = problem->sampling.samples, at_once = samples >= threads ? fmax(1.0, threads) : 1.0;
    const pdmc_explicit_cost of_sample = pdmc_run_explicit_cost(&one, 1);
    const pdmc_uncertainty *stiffness = pdmc_problem_uncertainty(problem, PDMC_QUANTITY_STIFFNESS);
    const double modes =
        (stiffness ? stiffness->modes : 0) + (pdmc_problem_varies_toughness(problem) ? most_modes : 0.0);
    cost.seconds += samples * of_sample.seconds / fmax(1.0, threads);
    cost.bytes += at_once * (of_sample.bytes - bytes_of_program) + 8.0 * modes * cost.nodes;
    return cost;
}
