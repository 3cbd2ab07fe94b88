// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/scalar.h"

#include "base/base_impl.h"

#include <gsl/gsl_math.h>
#include <math.h>

void pdmc_scalar_clear(pdmc_scalar *problem)
{
    pdmc_free(problem->weights);
    pdmc_free(problem->holes);
    pdmc_free(problem->file);
    pdmc_mesh_clear(&problem->first);
    pdmc_given_clear(&problem->source);
    pdmc_given_clear(&problem->prescribed);
    pdmc_free(problem->open);
    *problem = (pdmc_scalar){0};
}

bool pdmc_scalar_holds(const pdmc_scalar *problem, int side)
{
    for (int i = 0; i < problem->open_count; i++)
        if (problem->open[i].side == side) return false;
    return true;
}

pdmc_mesh_plate pdmc_scalar_plate(const pdmc_scalar *problem)
{
    return (pdmc_mesh_plate){.width = problem->width,
                             .height = problem->height,
                             .layer = problem->horizon,
                             .spacing = problem->spacing,
                             .fine_spacing = problem->hole_spacing,
                             .near = problem->near,
                             .hole_count = problem->hole_count,
                             .holes = problem->holes};
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
static const double assemblies_of_newton = 12.0; // forces and tangents of five iterations, and the linear start

// With the layer.
static double extent_of(const pdmc_scalar *problem)
{
    const double layer = 2.0 * problem->horizon;
    return (problem->width + layer) * (problem->dimension == 2 ? problem->height + layer : 1.0);
}

// Regular triangles, and those by which there are more near holes: at a distance t from a hole the spacing is f up to `near`,
// and then f + (t - near) / 4, so that the integral of 1 / spacing^2 over t is near / f^2 + 4 / f, on either side.
static double count_triangles(const pdmc_scalar *problem)
{
    const double of_one = 0.25 * sqrt(3.0), f = problem->hole_spacing;
    double count = extent_of(problem) / gsl_pow_2(problem->spacing);
    for (int i = 0; i < problem->hole_count && f < problem->spacing; i++)
        count += 4.0 * M_PI * problem->holes[i].radius * (problem->near / gsl_pow_2(f) + 4.0 / f);
    return count / of_one;
}

// At the first level; h: the length of edges.
static double count_elements(const pdmc_scalar *problem, double *h)
{
    const int d = problem->dimension;
    switch (problem->mesh) {
    case PDMC_ELEMENTS_TRIANGLES: *h = problem->spacing; return count_triangles(problem);
    case PDMC_ELEMENTS_FILE: *h = pdmc_mesh_spacing(&problem->first); return problem->first.element_count;
    case PDMC_ELEMENTS_CELLS: break;
    }
    *h = problem->width / problem->cells;
    return d * extent_of(problem) / pow(*h, d);
}

pdmc_scalar_cost pdmc_scalar_cost_of(const pdmc_scalar *problem, int level, int threads)
{
    const pdmc_scalar_level at = pdmc_scalar_level_of(problem, level);
    const int d = problem->dimension, halvings = problem->vary == PDMC_VARY_SPACING ? level : 0;
    double first;
    const double elements = count_elements(problem, &first) * ldexp(1.0, d * halvings), h = ldexp(first, -halvings);
    const double density = elements / extent_of(problem), reach = at.horizon + 2.0 * h;
    const double neighbours = density * (d == 2 ? M_PI * gsl_pow_2(reach) : 2.0 * reach);
    const double own = problem->space == PDMC_SPACE_CONTINUOUS ? 0.5 * (3 - d) + 0.25 : d + 1.0; // values of an element
    const double values = elements * own, entries = 0.5 * values * neighbours * own;
    const double points = (d == 2 ? 7.0 : 3.0) * pow(problem->parts, d);
    const double assemblies = problem->law.kind == PDMC_LAW_LINEAR ? 1.0 : assemblies_of_newton;
    const double fill = d == 2 ? values * sqrt(values) * reach / h * own : entries; // of a band, or of its dissection
    return (pdmc_scalar_cost){
        .elements = elements,
        .entries = entries,
        .bytes = 15e6 + 32.0 * entries + 8.0 * fill + 4.0 * elements * neighbours,
        .seconds = assemblies * elements * neighbours * points * seconds_per_pair / fmax(1.0, threads) +
                   fill * fill / values * seconds_per_operation,
    };
}
