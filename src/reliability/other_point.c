// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "pdmc/reliability.h"

#include <cblas.h>
#include <math.h>
#include <string.h>

static const double notable = 0.1;  // units of z by which a start must be nearer to the event than the planes say
static const double distinct = 0.5; // distance of another point from those that are known

// g at z by the plane through a point whose direction is that of its normal.
static double plane_of(const pdmc_first_order *point, const double z[])
{
    const double beta = point->index;
    return point->slope * (cblas_ddot(point->dimension, point->z, 1, z, 1) / beta - beta);
}

static double by_planes(int count, const pdmc_first_order known[], const double z[])
{
    double largest = -INFINITY;
    for (int k = 0; k < count; k++) largest = fmax(largest, plane_of(&known[k], z));
    return largest;
}

static double least_index(int count, const pdmc_first_order known[])
{
    double least = INFINITY;
    for (int k = 0; k < count; k++) least = fmin(least, known[k].index);
    return least;
}

// The points of both sides of every axis, as far from the origin as the nearest of those known.
static void fill_axes(int n, double radius, double z[])
{
    for (int k = 0; k < 2 * n; k++) z[k * n + k / 2] = k % 2 ? -radius : radius;
}

static double nearest_distance(int count, const pdmc_first_order known[], const double z[])
{
    double least = INFINITY;
    for (int k = 0; k < count; k++) {
        double square = 0.0;
        for (int i = 0; i < known[k].dimension; i++) square += pow(z[i] - known[k].z[i], 2.0);
        least = fmin(least, sqrt(square));
    }
    return least;
}

// Beside the known points, by 60 degrees or more, and nearer to the event than their planes say.
static bool is_start(int count, const pdmc_first_order known[], double radius, const double z[], double g)
{
    return nearest_distance(count, known, z) > radius && g > by_planes(count, known, z) + notable * known[0].slope;
}

static pdmc_status find_start(const pdmc_limit_state *limit, int count, const pdmc_first_order known[], double start[],
                              bool *found)
{
    pdmc_status status = PDMC_OK;
    const int n = limit->dimension;
    const double radius = least_index(count, known);
    double *z = NULL, *g = NULL, most = -INFINITY;
    *found = false;
    PDMC_NEW(z, (size_t)(2 * n) * (size_t)n);
    PDMC_NEW(g, 2 * n);
    fill_axes(n, radius, z);
    PDMC_TRY(limit->evaluate(limit->context, 2 * n, z, g));
    for (int k = 0; k < 2 * n; k++) {
        if (!(g[k] > most) || !is_start(count, known, radius, &z[k * n], g[k])) continue; // never of NaN
        most = g[k];
        *found = true;
        memcpy(start, &z[k * n], (size_t)n * sizeof *start);
    }
done:
    pdmc_free(z);
    pdmc_free(g);
    return status;
}

pdmc_status pdmc_first_order_find_other(const pdmc_limit_state *limit, const pdmc_first_order_options *options,
                                        int count, const pdmc_first_order known[], pdmc_first_order *point)
{
    pdmc_status status = PDMC_OK;
    double *start = NULL;
    bool found;
    *point = (pdmc_first_order){.dimension = limit->dimension, .residual = NAN};
    PDMC_REQUIRE(count >= 1, "%d known points are not enough", count);
    for (int k = 0; k < count; k++)
        PDMC_REQUIRE(known[k].converged && known[k].index > 0.0, "point %d has no plane that the event is beyond", k);
    PDMC_NEW(start, limit->dimension);
    PDMC_TRY(find_start(limit, count, known, start, &found));
    if (found) {
        pdmc_first_order_options from = *options;
        from.start = start;
        PDMC_TRY(pdmc_first_order_find(limit, &from, point));
        if (nearest_distance(count, known, point->z) <= distinct) {
            point->converged = false;
            point->residual = NAN;
        }
    }
    point->evaluations += 2 * limit->dimension;
done:
    pdmc_free(start);
    return status;
}
