// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/locate.h"

#include "base/base_impl.h"

#include <math.h>

static const double *corner_of(const pdmc_mesh *mesh, int element, int a)
{
    const size_t d = (size_t)mesh->dimension;
    return &mesh->x[d * (size_t)mesh->corner[(d + 1) * (size_t)element + (size_t)a]];
}

static void place_grid(const pdmc_mesh *mesh, pdmc_mesh_locator *out)
{
    const int most = 1 + (int)pow(mesh->element_count, 1.0 / mesh->dimension);
    for (int d = 0; d < mesh->dimension; d++) {
        double lower = INFINITY, upper = -INFINITY;
        for (int n = 0; n < mesh->node_count; n++) {
            lower = fmin(lower, mesh->x[mesh->dimension * n + d]);
            upper = fmax(upper, mesh->x[mesh->dimension * n + d]);
        }
        out->origin[d] = lower;
        out->count[d] = most;
        out->size[d] = (upper - lower) / most;
    }
}

static int cell_along(const pdmc_mesh_locator *l, int axis, double x)
{
    return (int)fmin(fmax(floor((x - l->origin[axis]) / l->size[axis]), 0.0), l->count[axis] - 1.0);
}

// The cells that the box of an element meets, grown a little for points beyond its edges by rounding.
static void find_cells(const pdmc_mesh_locator *l, int element, int first[2], int last[2])
{
    first[1] = last[1] = 0;
    for (int d = 0; d < l->mesh->dimension; d++) {
        double low = INFINITY, high = -INFINITY;
        for (int a = 0; a <= l->mesh->dimension; a++) {
            low = fmin(low, corner_of(l->mesh, element, a)[d]);
            high = fmax(high, corner_of(l->mesh, element, a)[d]);
        }
        first[d] = cell_along(l, d, low - 1e-6 * l->size[d]);
        last[d] = cell_along(l, d, high + 1e-6 * l->size[d]);
    }
}

// Counts the elements of each cell into at[cell], or writes them from there on, which it moves to their end.
static void visit(const pdmc_mesh_locator *l, int at[], int element[])
{
    for (int e = 0; e < l->mesh->element_count; e++) {
        int first[2], last[2];
        find_cells(l, e, first, last);
        for (int j = first[1]; j <= last[1]; j++)
            for (int i = first[0]; i <= last[0]; i++) {
                const int cell = j * l->count[0] + i;
                if (element) element[at[cell]++] = e;
                else at[cell]++;
            }
    }
}

pdmc_status pdmc_mesh_locator_create(const pdmc_mesh *mesh, pdmc_mesh_locator *out)
{
    pdmc_status status = PDMC_OK;
    pdmc_mesh_locator made = {.mesh = mesh, .count = {1, 1}};
    *out = made;
    place_grid(mesh, &made);
    const int cells = made.count[0] * made.count[1];
    PDMC_NEW(made.start, cells + 2);
    int *next = made.start + 1; // of each cell; its end, the start of the one behind it, once all are placed
    visit(&made, next + 1, NULL);
    for (int c = 1; c <= cells; c++) next[c] += next[c - 1];
    PDMC_NEW(made.element, next[cells]);
    visit(&made, next, made.element);
    *out = made;
    made = (pdmc_mesh_locator){0};
done:
    pdmc_mesh_locator_clear(&made);
    return status;
}

void pdmc_mesh_locator_clear(pdmc_mesh_locator *locator)
{
    pdmc_free(locator->start);
    pdmc_free(locator->element);
    *locator = (pdmc_mesh_locator){0};
}

static double depth_in_interval(const pdmc_mesh *mesh, int element, const double x[])
{
    const double *from = corner_of(mesh, element, 0), *to = corner_of(mesh, element, 1);
    const double along = (*x - *from) / (*to - *from);
    return fmin(along, 1.0 - along);
}

static double depth_in_triangle(const pdmc_mesh *mesh, int element, const double x[])
{
    const double *c[3] = {corner_of(mesh, element, 0), corner_of(mesh, element, 1), corner_of(mesh, element, 2)};
    const double twice = (c[1][0] - c[0][0]) * (c[2][1] - c[0][1]) - (c[1][1] - c[0][1]) * (c[2][0] - c[0][0]);
    double least = INFINITY;
    for (int a = 0; a < 3; a++) {
        const double *p = c[(a + 1) % 3], *q = c[(a + 2) % 3];
        least = fmin(least, ((q[0] - p[0]) * (x[1] - p[1]) - (q[1] - p[1]) * (x[0] - p[0])) / twice);
    }
    return least;
}

int pdmc_mesh_locate(const pdmc_mesh_locator *l, const double x[], double *depth)
{
    const bool is_plane = l->mesh->dimension == 2;
    const int cell = (is_plane ? cell_along(l, 1, x[1]) * l->count[0] : 0) + cell_along(l, 0, x[0]);
    int best = -1;
    double most = -INFINITY;
    for (int k = l->start[cell]; k < l->start[cell + 1]; k++) {
        const int e = l->element[k];
        const double inside = is_plane ? depth_in_triangle(l->mesh, e, x) : depth_in_interval(l->mesh, e, x);
        if (inside > most) {
            most = inside;
            best = e;
        }
    }
    if (depth) *depth = most;
    return best;
}
