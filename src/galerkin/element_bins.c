// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/element_bins.h"

#include "base/base_impl.h"
#include "galerkin/element.h"

#include <math.h>

int pdmc_element_bin(const pdmc_element_bins *b, int axis, double x)
{
    const int i = (int)((x - b->origin[axis]) / b->size);
    return i < 0 ? 0 : i >= b->count[axis] ? b->count[axis] - 1 : i;
}

void pdmc_element_bins_clear(pdmc_element_bins *b)
{
    pdmc_free(b->first);
    pdmc_free(b->next);
    pdmc_free(b->middle);
    pdmc_free(b->radius);
}

// No more bins than elements along each axis: what is beyond the last is in the last.
static void place_bins(int elements, double reach, pdmc_element_bins *b)
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

pdmc_status pdmc_element_bins_create(const pdmc_mesh *mesh, double reach, pdmc_element_bins *b)
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
        const int bin = pdmc_element_bin(b, 1, b->middle[e][1]) * b->count[0] + pdmc_element_bin(b, 0, b->middle[e][0]);
        b->next[e] = b->first[bin];
        b->first[bin] = e;
    }
done:
    return status;
}
