// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/run.h"

#include <math.h>

// What one thread of a 2023 server core does in matrix products of this size, and in bonds of the basis.
static const double nominal_flops = 30e9;
static const double seconds_per_value = 3e-9;

// Operations of the parts that are worth counting; n unknowns, m rows, q rings.
static double operations(const pdmc_problem *problem, double n, double m, double q, double interior)
{
    const double directions = problem->energy.tip_count * (double)problem->energy.angles;
    const double samples = problem->sampling.samples, width = 25.0; // dimension of a crossing, as measured
    const double factor = 4.0 * m * n * n, project = q * (2.0 * interior * n * n + 2.0 * interior * n * n);
    const double rows = directions * 4.0 * 1024.0 * width * n;
    const double direct = 2.0 * m * n * n, expansion = problem->sampling.order * 2.0 * q * n * n;
    const double solve = problem->sampling.inverse == PDMC_INVERSE_DIRECT ? direct : expansion;
    return factor + project + rows + samples * (solve + directions * 2.0 * width * (n + 1024.0));
}

pdmc_cost pdmc_run_cost(const pdmc_problem *problem, int threads)
{
    const double h = problem->kansa.spacing;
    const double nx = fmax(1.0, round(problem->plate.width / h)), ny = fmax(1.0, round(problem->plate.height / h));
    const int degree = problem->kansa.polynomial_degree;
    const double monomials = 0.5 * (degree + 1) * (degree + 2), nodes = (nx + 1.0) * (ny + 1.0);
    const double n = 2.0 * ((nx + 3.0) * (ny + 3.0) + monomials) + 4.0 * problem->kansa.crack_orders * problem->crack_count;
    const double interior = 2.0 * (nodes + 192.0 * problem->crack_count);
    const double boundary = 2.0 * (4.0 * (nx + ny + 4.0) + 80.0 * problem->crack_count);
    const double m = interior + boundary + 2.0 * monomials;
    const bool is_random = pdmc_problem_uncertainty(problem, PDMC_QUANTITY_MICROMODULUS) != NULL;
    const double rings = problem->kansa.radial_points, q = is_random ? rings : 0.0;
    const double directions = problem->energy.tip_count * (double)problem->energy.angles;

    const double values = interior * rings * 12.0 * n / 4.0 + directions * 1024.0 * n;
    const double seconds = seconds_per_value * values + operations(problem, n, m, q, interior) / nominal_flops;
    const double samples = problem->sampling.samples, bins = is_random ? rings : 1.0;
    const double matrices = rings * interior * n + q * (interior * n + n * n) + 2.0 * m * n + n * n;
    const double direct = problem->sampling.inverse == PDMC_INVERSE_DIRECT ? threads * m * n : 0.0;
    const double work = threads * (3072.0 * n + 64.0 * n * (3.0 + q));
    const double numbers = matrices + direct + work + directions * 25.0 * (n + 1024.0) + samples * (2.0 * directions + bins);
    return (pdmc_cost){
        .nodes = (int)nodes,
        .unknowns = (int)n,
        .rows = (int)m,
        .bytes = 8.0 * numbers,
        .seconds = seconds / threads,
    };
}
