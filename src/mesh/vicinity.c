// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/vicinity.h"

#include "base/base_impl.h"

#include <math.h>

static int bin_along(const pdmc_vicinity *vicinity, int axis, double x)
{
    const double bin = floor((x - vicinity->origin[axis]) / vicinity->size);
    return (int)fmin(fmax(bin, 0.0), vicinity->count[axis] - 1.0);
}

static int bin_of(const pdmc_vicinity *vicinity, const double x[])
{
    int bin = 0;
    for (int a = vicinity->dimension - 1; a >= 0; a--) bin = bin * vicinity->count[a] + bin_along(vicinity, a, x[a]);
    return bin;
}

// Returns the number of bins.
static int place_bins(int points, pdmc_vicinity *vicinity)
{
    const int d = vicinity->dimension;
    double extent[PDMC_MESH_AXES], content = 1.0;
    int bins = 1;
    for (int a = 0; a < d; a++) {
        double low = INFINITY, high = -INFINITY;
        for (int i = 0; i < points; i++)
            low = fmin(low, vicinity->x[d * i + a]), high = fmax(high, vicinity->x[d * i + a]);
        vicinity->origin[a] = low;
        extent[a] = high - low;
        content *= extent[a];
    }
    vicinity->size = pow(content / points, 1.0 / d);
    for (int a = 0; a < d; a++) bins *= vicinity->count[a] = 1 + (int)(extent[a] / vicinity->size);
    return bins;
}

pdmc_status pdmc_vicinity_create(int dimension, int points, const double x[], pdmc_vicinity *vicinity)
{
    pdmc_status status = PDMC_OK;
    pdmc_vicinity made = {.dimension = dimension, .x = x, .count = {1, 1, 1}};
    *vicinity = (pdmc_vicinity){0};
    const int bins = place_bins(points, &made);
    PDMC_NEW(made.start, bins + 1);
    PDMC_NEW(made.point, points);
    PDMC_NEW(made.found, points);
    for (int i = 0; i < points; i++) made.start[bin_of(&made, &x[dimension * i])]++;
    for (int b = 1; b <= bins; b++) made.start[b] += made.start[b - 1]; // where each bin ends
    for (int i = points - 1; i >= 0; i--) made.point[--made.start[bin_of(&made, &x[dimension * i])]] = i;
    *vicinity = made;
    made = (pdmc_vicinity){0};
done:
    pdmc_vicinity_clear(&made);
    return status;
}

static int find_in_bin(pdmc_vicinity *vicinity, int bin, const double middle[], double distance, int count)
{
    for (int i = vicinity->start[bin]; i < vicinity->start[bin + 1]; i++)
        if (pdmc_mesh_distance(vicinity->dimension, middle, &vicinity->x[vicinity->dimension * vicinity->point[i]]) <=
            distance)
            vicinity->found[count++] = vicinity->point[i];
    return count;
}

int pdmc_vicinity_find(pdmc_vicinity *vicinity, const double middle[], double distance)
{
    int low[PDMC_MESH_AXES] = {0}, high[PDMC_MESH_AXES] = {0}, count = 0;
    for (int a = 0; a < vicinity->dimension; a++) {
        low[a] = bin_along(vicinity, a, middle[a] - distance);
        high[a] = bin_along(vicinity, a, middle[a] + distance);
    }
    for (int k = low[2]; k <= high[2]; k++)
        for (int j = low[1]; j <= high[1]; j++)
            for (int i = low[0]; i <= high[0]; i++) {
                const int bin = (k * vicinity->count[1] + j) * vicinity->count[0] + i;
                count = find_in_bin(vicinity, bin, middle, distance, count);
            }
    return count;
}

void pdmc_vicinity_clear(pdmc_vicinity *vicinity)
{
    pdmc_free(vicinity->start);
    pdmc_free(vicinity->point);
    pdmc_free(vicinity->found);
    *vicinity = (pdmc_vicinity){0};
}
