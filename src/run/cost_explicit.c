// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/run.h"

#include <math.h>

// Of a thread of a 2024 server core with AVX-512, as measured on studies/plate_pulse and studies/sphere_block.
static const double seconds_per_bond = 1.8e-9; // and step
static const double steps_per_record = 3.5; // energies, damage and pieces are asked for: a look at every bond each
static const double bytes_per_node = 260.0, bytes_per_bond = 0.25; // of the engine
static const double bytes_of_program = 15e6;

pdmc_explicit_cost pdmc_run_explicit_cost(const pdmc_explicit *study, int threads)
{
    const pdmc_explicit_amounts amounts = pdmc_explicit_count(study);
    const double records = fmin(amounts.steps, study->duration / study->interval);
    const double states = 60.0 * (fmin(study->snapshots, amounts.steps) + 1.0); // u, v, damage and piece of a node
    const double cells = 17.0 + 28.0;                                           // what else the file has of it
    return (pdmc_explicit_cost){
        .nodes = amounts.nodes,
        .bonds = amounts.bonds,
        .steps = amounts.steps,
        .bytes = bytes_of_program + amounts.nodes * (bytes_per_node + 2.0 * (states + cells)) +
                 amounts.bonds * bytes_per_bond,
        .seconds = (amounts.steps + steps_per_record * records) * amounts.bonds * seconds_per_bond / fmax(1.0, threads),
    };
}
