// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/study_impl.h"

#include <math.h>

double pdmc_study_half_crack(const pdmc_crack *crack)
{
    return 0.5 * hypot(crack->to[0] - crack->from[0], crack->to[1] - crack->from[1]);
}

double pdmc_study_shortest_half_crack(const pdmc_problem *problem)
{
    double shortest = INFINITY;
    for (int i = 0; i < problem->crack_count; i++)
        shortest = fmin(shortest, pdmc_study_half_crack(&problem->cracks[i]));
    return shortest;
}

static double shorter_side(const pdmc_problem *problem)
{
    return fmin(problem->plate.width, problem->plate.height);
}

static double spacing_of(const pdmc_problem *problem, pdmc_method method)
{
    static const double cells[] = {[PDMC_METHOD_KANSA] = 20.0, [PDMC_METHOD_BOND] = 100.0, [PDMC_METHOD_GALERKIN] = 80.0};
    return shorter_side(problem) / cells[method];
}

double pdmc_study_default_spacing(const pdmc_problem *problem)
{
    return spacing_of(problem, problem->solver.method);
}

double pdmc_study_default_control_spacing(const pdmc_problem *problem)
{
    const pdmc_method method = problem->control.solver.method;
    return method == problem->solver.method ? 2.0 * problem->solver.spacing : spacing_of(problem, method);
}

double pdmc_study_default_horizon(const pdmc_problem *problem)
{
    const pdmc_solver_options *solver = &problem->solver;
    if (solver->method != PDMC_METHOD_KANSA) {
        const double ratio = solver->method == PDMC_METHOD_BOND ? 5.0 : 4.0;
        return (solver->has_horizon_ratio ? solver->horizon_ratio : ratio) * solver->spacing;
    }
    return fmin(pdmc_study_shortest_half_crack(problem) / 5.0, shorter_side(problem) / 50.0);
}

double pdmc_study_default_shape(const pdmc_problem *problem)
{
    // The paper's figure B.2 has psi = 0.16 on an element of side 1; wider functions that end at a crack ruin its solution.
    return (problem->solver.crack_model == PDMC_CRACKS_PAPER ? 0.16 : 6.0) * problem->solver.spacing;
}

double pdmc_study_default_edge_layer(const pdmc_problem *problem)
{
    return problem->solver.horizon / 5.0;
}

double pdmc_study_default_load_layer(const pdmc_problem *problem)
{
    return problem->solver.method == PDMC_METHOD_GALERKIN ? problem->solver.horizon : problem->solver.spacing;
}

double pdmc_study_default_step(const pdmc_problem *problem)
{
    return problem->solver.spacing / (4.0 * pdmc_wave_speed(&problem->material, problem->dynamics.density));
}

double pdmc_study_default_energy_horizon(const pdmc_problem *problem)
{
    return problem->solver.horizon;
}

double pdmc_study_default_extension(const pdmc_problem *problem)
{
    return 0.25 * problem->energy.horizon;
}
