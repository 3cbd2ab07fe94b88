// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/elastic.h"

#include "base/base_impl.h"

#include <gsl/gsl_math.h>

void pdmc_elastic_clear(pdmc_elastic *problem)
{
    pdmc_free(problem->conditions);
    *problem = (pdmc_elastic){0};
}

pdmc_solid_options pdmc_elastic_body(const pdmc_elastic *problem, int threads)
{
    const double *e = problem->strain;
    pdmc_solid_options body = {
        .spacing = problem->spacing,
        .horizon = problem->horizon,
        .youngs_modulus = problem->youngs_modulus,
        .rule = problem->rule,
        .gauss_points = problem->gauss_points,
        .support = problem->support,
        .compensation = problem->compensation,
        .strain = {{e[0], e[5], e[4]}, {e[5], e[1], e[3]}, {e[4], e[3], e[2]}},
        .threads = threads,
    };
    for (int k = 0; k < 3; k++) body.nodes[k] = problem->nodes[k];
    for (int i = 0; i < problem->condition_count; i++) {
        const pdmc_elastic_condition *condition = &problem->conditions[i];
        body.layers[condition->face] = condition->layers;
        body.load[condition->face] = condition->load;
    }
    return body;
}

// Of a thread of a 2024 server core: a bond of a node in one evaluation of forces, a term of an interpolation, and the
// shape functions of a point.
static const double seconds_per_bond = 2e-9, seconds_per_term = 1e-9, seconds_per_shape = 3e-5;

pdmc_elastic_cost pdmc_elastic_cost_of(const pdmc_elastic *problem, int threads)
{
    const double nodes = (double)problem->nodes[0] * problem->nodes[1] * problem->nodes[2];
    const bool gauss = problem->rule == PDMC_SOLID_GAUSS;
    const double points = gauss ? gsl_pow_3(problem->gauss_points) : 1.0;
    const double bonds = 4.0 / 3.0 * M_PI * gsl_pow_3(problem->horizon / problem->spacing + 0.3) * points;
    const double terms = gauss ? 4.0 / 3.0 * M_PI * gsl_pow_3(problem->support / problem->spacing) * points : 0.0;
    const double longest = fmax(problem->nodes[0], fmax(problem->nodes[1], problem->nodes[2]));
    const double rounds = problem->method == PDMC_ELASTIC_DAMPED ? problem->steps : 4.0 * longest;
    const double classes = gauss ? gsl_pow_3(2.0 * problem->support / problem->spacing + 1.0) : 0.0;
    return (pdmc_elastic_cost){
        .nodes = nodes,
        .bonds = bonds,
        .bytes = 15e6 + nodes * 8.0 * (30.0 + 3.0 * points) + classes * terms * 20.0,
        .seconds = rounds * nodes * (bonds * seconds_per_bond + terms * seconds_per_term) / fmax(1.0, threads) +
                   classes * points * seconds_per_shape,
    };
}
