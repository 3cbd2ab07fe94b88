// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/bins.h"

#include "base/base_impl.h"

#include <math.h>
#include <string.h>

pdmc_status pdmc_bins_create(int points, pdmc_bins *bins)
{
    pdmc_status status = PDMC_OK;
    *bins = (pdmc_bins){.points = points, .most = 4 * points + 64};
    PDMC_NEW(bins->bin, points);
    PDMC_NEW(bins->start, bins->most + 1);
    PDMC_NEW(bins->sorted, points);
    for (int a = 0; a < PDMC_AXES; a++) PDMC_NEW(bins->x[a], points);
done:
    return status;
}

void pdmc_bins_clear(pdmc_bins *bins)
{
    pdmc_free(bins->bin);
    pdmc_free(bins->start);
    pdmc_free(bins->sorted);
    for (int a = 0; a < PDMC_AXES; a++) pdmc_free(bins->x[a]);
    *bins = (pdmc_bins){0};
}

/// The points' box, without what is more than four standard deviations from their middle.
static void find_box(const pdmc_bins *bins, double *const x[], double low[], double high[])
{
    for (int a = 0; a < PDMC_AXES; a++) {
        double sum = 0.0, squares = 0.0, least = INFINITY, most = -INFINITY;
        for (int k = 0; k < bins->points; k++) sum += x[a][k];
        const double mean = sum / bins->points;
        for (int k = 0; k < bins->points; k++) {
            squares += (x[a][k] - mean) * (x[a][k] - mean);
            least = fmin(least, x[a][k]), most = fmax(most, x[a][k]);
        }
        const double spread = 4.0 * sqrt(squares / bins->points);
        low[a] = fmax(least, mean - spread), high[a] = fmin(most, mean + spread);
    }
}

static void choose_width(pdmc_bins *bins, const double high[], double width)
{
    for (;; width *= 1.25) {
        double total = 1.0;
        for (int a = 0; a < PDMC_AXES; a++) total *= floor((high[a] - bins->low[a]) / width) + 1.0;
        if (total <= bins->most) break;
    }
    bins->width = width;
    for (int a = 0; a < PDMC_AXES; a++) bins->count[a] = (int)floor((high[a] - bins->low[a]) / width) + 1;
}

void pdmc_bins_place(const pdmc_bins *bins, const double x[PDMC_AXES], int place[PDMC_AXES])
{
    for (int a = 0; a < PDMC_AXES; a++)
        place[a] = (int)fmin(fmax(floor((x[a] - bins->low[a]) / bins->width), 0.0), bins->count[a] - 1.0);
}

static int bin_of(const pdmc_bins *bins, double *const x[], int k)
{
    int place[PDMC_AXES];
    pdmc_bins_place(bins, (double[]){x[0][k], x[1][k], x[2][k]}, place);
    return (place[2] * bins->count[1] + place[1]) * bins->count[0] + place[0];
}

void pdmc_bins_fill(pdmc_bins *bins, double *const x[PDMC_AXES], double width)
{
    double high[PDMC_AXES];
    find_box(bins, x, bins->low, high);
    choose_width(bins, high, width);
    const int total = bins->count[0] * bins->count[1] * bins->count[2];
    memset(bins->start, 0, (size_t)(total + 1) * sizeof *bins->start);
    for (int k = 0; k < bins->points; k++) {
        bins->bin[k] = bin_of(bins, x, k);
        bins->start[bins->bin[k] + 1]++;
    }
    for (int b = 0; b < total; b++) bins->start[b + 1] += bins->start[b];
    for (int k = 0; k < bins->points; k++) bins->sorted[bins->start[bins->bin[k]]++] = k;
    for (int b = total; b > 0; b--) bins->start[b] = bins->start[b - 1];
    bins->start[0] = 0;
    for (int k = 0; k < bins->points; k++)
        for (int a = 0; a < PDMC_AXES; a++) bins->x[a][k] = x[a][bins->sorted[k]];
}

int pdmc_bins_near(const pdmc_bins *bins, int bin, int near[27])
{
    const int nx = bins->count[0], ny = bins->count[1], nz = bins->count[2];
    const int x = bin % nx, y = bin / nx % ny, z = bin / nx / ny;
    int found = 0;
    for (int k = z > 0 ? z - 1 : 0; k <= z + 1 && k < nz; k++)
        for (int j = y > 0 ? y - 1 : 0; j <= y + 1 && j < ny; j++)
            for (int i = x > 0 ? x - 1 : 0; i <= x + 1 && i < nx; i++) near[found++] = (k * ny + j) * nx + i;
    return found;
}
