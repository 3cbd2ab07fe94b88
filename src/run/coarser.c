// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/coarser.h"

#include <math.h>

static int greatest_common_divisor(int a, int b)
{
    return b == 0 ? a : greatest_common_divisor(b, a % b);
}

static bool make_grid_coarser(pdmc_problem *problem)
{
    pdmc_solver_options *solver = &problem->solver;
    const int columns = (int)lround(problem->plate.width / solver->spacing);
    const int rows = (int)lround(problem->plate.height / solver->spacing);
    const int common = greatest_common_divisor(columns, rows); // the plate is that many squares of cells wide
    int coarse = (int)(0.8 * common + 0.5);
    if ((common - coarse) % 2 != 0) coarse--;
    const double layers = round(solver->load_layer / solver->spacing);
    if (coarse < 1 || coarse < common / 2) return false;
    solver->spacing *= (double)common / coarse;
    solver->load_layer = layers * solver->spacing;
    return solver->spacing <= solver->horizon;
}

bool pdmc_make_coarser(pdmc_problem *problem)
{
    pdmc_solver_options *solver = &problem->solver;
    problem->uncertainty_count = 0; // the error is that of the mean
    if (solver->method == PDMC_METHOD_BOND) return make_grid_coarser(problem);
    solver->spacing *= 1.25;
    solver->shape *= 1.25;
    solver->refinement = (int)fmax(0.8 * solver->refinement, 2.0);
    return true;
}
