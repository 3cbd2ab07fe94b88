// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/scalar.h"

#include "base/base_impl.h"

#include <gsl/gsl_math.h>
#include <math.h>

void pdmc_scalar_clear(pdmc_scalar *problem)
{
    pdmc_free(problem->weights);
    *problem = (pdmc_scalar){0};
}

pdmc_scalar_level pdmc_scalar_level_of(const pdmc_scalar *problem, int level)
{
    const bool is_finer = problem->vary == PDMC_VARY_SPACING;
    const int cells = (int)fmin(INT32_MAX, ldexp(problem->cells, is_finer ? level : 0));
    const double across = problem->dimension == 2 ? round(cells * problem->height / problem->width) : 1.0;
    return (pdmc_scalar_level){
        .cells = {cells, (int)fmin(INT32_MAX, fmax(1.0, across))},
        .horizon = ldexp(problem->horizon, is_finer ? 0 : -level),
    };
}

// Of a thread of a 2024 server core: a pair of an outer point and an element, and an operation of the factor.
static const double seconds_per_pair = 4e-7, seconds_per_operation = 2e-10;

pdmc_scalar_cost pdmc_scalar_cost_of(const pdmc_scalar *problem, int level, int threads)
{
    const pdmc_scalar_level at = pdmc_scalar_level_of(problem, level);
    const int d = problem->dimension;
    const double h = problem->width / at.cells[0], reach = at.horizon + 2.0 * h, extra = 2.0 * at.horizon;
    const double extent = (problem->width + extra) * (d == 2 ? problem->height + extra : 1.0);
    const double elements = d * extent / pow(h, d);
    const double neighbours = d == 2 ? 2.0 * M_PI * gsl_pow_2(reach / h) : 2.0 * reach / h;
    const double own = problem->space == PDMC_SPACE_CONTINUOUS ? 0.5 * (3 - d) + 0.25 : d + 1.0; // values of an element
    const double values = elements * own, entries = 0.5 * values * neighbours * own;
    const double points = (d == 2 ? 7.0 : 3.0) * pow(problem->parts, d);
    const double fill = d == 2 ? values * sqrt(values) * reach / h * own : entries; // of a band, or of its dissection
    return (pdmc_scalar_cost){
        .elements = elements,
        .entries = entries,
        .bytes = 15e6 + 32.0 * entries + 8.0 * fill + 4.0 * elements * neighbours,
        .seconds = elements * neighbours * points * seconds_per_pair / fmax(1.0, threads) +
                   fill * fill / values * seconds_per_operation,
    };
}
