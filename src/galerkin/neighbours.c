// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/neighbours.h"

#include "base/base_impl.h"
#include "galerkin/element.h"

#include <math.h>
#include <stdlib.h>

// Elements in square bins, by their middles. Bins are no smaller than what two elements can be apart.
typedef struct {
    double origin[2], size;
    int count[2];
    int *first; // [bins] of a chain of elements, or -1
    int *next;  // [elements]
    double (*middle)[2];
    double *radius;
} bins;

static int bin_along(const bins *b, int axis, double x)
{
    const int i = (int)((x - b->origin[axis]) / b->size);
    return i < 0 ? 0 : i >= b->count[axis] ? b->count[axis] - 1 : i;
}

static void bins_clear(bins *b)
{
    pdmc_free(b->first);
    pdmc_free(b->next);
    pdmc_free(b->middle);
    pdmc_free(b->radius);
}

// No more bins than elements along each axis: what is beyond the last is in the last.
static void place_bins(int elements, double reach, bins *b)
{
    double upper[2] = {-INFINITY, -INFINITY}, largest = 0.0;
    for (int d = 0; d < 2; d++) b->origin[d] = INFINITY;
    for (int e = 0; e < elements; e++) {
        largest = fmax(largest, b->radius[e]);
        for (int d = 0; d < 2; d++) {
            b->origin[d] = fmin(b->origin[d], b->middle[e][d]);
            upper[d] = fmax(upper[d], b->middle[e][d]);
        }
    }
    b->size = reach + 2.0 * largest;
    for (int d = 0; d < 2; d++) b->count[d] = 1 + (int)fmin(4096.0, (upper[d] - b->origin[d]) / b->size);
}

static pdmc_status bins_create(const pdmc_mesh *mesh, double reach, bins *b)
{
    pdmc_status status = PDMC_OK;
    PDMC_NEW(b->middle, mesh->element_count);
    PDMC_NEW(b->radius, mesh->element_count);
    PDMC_NEW(b->next, mesh->element_count);
    for (int e = 0; e < mesh->element_count; e++) {
        const pdmc_element element = pdmc_element_of(mesh, e);
        for (int d = 0; d < 2; d++) b->middle[e][d] = element.middle[d];
        b->radius[e] = element.radius;
    }
    place_bins(mesh->element_count, reach, b);
    const int count = b->count[0] * b->count[1];
    PDMC_NEW(b->first, count);
    for (int i = 0; i < count; i++) b->first[i] = -1;
    for (int e = 0; e < mesh->element_count; e++) {
        const int bin = bin_along(b, 1, b->middle[e][1]) * b->count[0] + bin_along(b, 0, b->middle[e][0]);
        b->next[e] = b->first[bin];
        b->first[bin] = e;
    }
done:
    return status;
}

static bool is_near(const bins *b, double reach, int e, int other)
{
    const double distance = hypot(b->middle[e][0] - b->middle[other][0], b->middle[e][1] - b->middle[other][1]);
    return e == other || distance < reach + b->radius[e] + b->radius[other];
}

// Returns their number; writes them where there is room given.
static int64_t find_of(const bins *b, double reach, int e, int found[])
{
    int64_t count = 0;
    const int i = bin_along(b, 0, b->middle[e][0]), j = bin_along(b, 1, b->middle[e][1]);
    for (int y = j > 0 ? j - 1 : 0; y <= j + 1 && y < b->count[1]; y++)
        for (int x = i > 0 ? i - 1 : 0; x <= i + 1 && x < b->count[0]; x++)
            for (int other = b->first[y * b->count[0] + x]; other >= 0; other = b->next[other]) {
                if (!is_near(b, reach, e, other)) continue;
                if (found) found[count] = other;
                count++;
            }
    return count;
}

static int compare(const void *a, const void *b)
{
    const int i = *(const int *)a, j = *(const int *)b;
    return (i > j) - (i < j);
}

static void find_selves(int elements, pdmc_neighbours *n)
{
    for (int e = 0; e < elements; e++) {
        n->start[e + 1] = e + 1;
        n->element[e] = e;
    }
}

pdmc_status pdmc_neighbours_create(const pdmc_mesh *mesh, double reach, pdmc_neighbours *neighbours)
{
    pdmc_status status = PDMC_OK;
    bins b = {0};
    pdmc_neighbours made = {0};
    const int elements = mesh->element_count;
    *neighbours = made;
    PDMC_NEW(made.start, elements + 1);
    if (reach > 0.0) PDMC_TRY(bins_create(mesh, reach, &b));
    for (int e = 0; e < elements && reach > 0.0; e++) made.start[e + 1] = made.start[e] + find_of(&b, reach, e, NULL);
    PDMC_NEW(made.element, reach > 0.0 ? made.start[elements] : elements);
    if (reach == 0.0) find_selves(elements, &made);
    for (int e = 0; e < elements && reach > 0.0; e++) {
        int *found = &made.element[made.start[e]];
        qsort(found, (size_t)find_of(&b, reach, e, found), sizeof *found, compare);
    }
    *neighbours = made;
    made = (pdmc_neighbours){0};
done:
    bins_clear(&b);
    pdmc_neighbours_clear(&made);
    return status;
}

void pdmc_neighbours_clear(pdmc_neighbours *neighbours)
{
    pdmc_free(neighbours->start);
    pdmc_free(neighbours->element);
    *neighbours = (pdmc_neighbours){0};
}
