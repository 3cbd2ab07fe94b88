// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/neighbours.h"

#include "base/base_impl.h"
#include "galerkin/element_bins.h"

#include <math.h>
#include <stdlib.h>

static bool is_near(const pdmc_element_bins *b, double reach, int e, int other)
{
    const double distance = hypot(b->middle[e][0] - b->middle[other][0], b->middle[e][1] - b->middle[other][1]);
    return e == other || distance < reach + b->radius[e] + b->radius[other];
}

// Returns their number; writes them where there is room given.
static int64_t find_of(const pdmc_element_bins *b, double reach, int e, int found[])
{
    int64_t count = 0;
    const int i = pdmc_element_bin(b, 0, b->middle[e][0]), j = pdmc_element_bin(b, 1, b->middle[e][1]);
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
    pdmc_element_bins b = {0};
    pdmc_neighbours made = {0};
    const int elements = mesh->element_count;
    *neighbours = made;
    PDMC_NEW(made.start, elements + 1);
    if (reach > 0.0) PDMC_TRY(pdmc_element_bins_create(mesh, reach, &b));
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
    pdmc_element_bins_clear(&b);
    pdmc_neighbours_clear(&made);
    return status;
}

void pdmc_neighbours_clear(pdmc_neighbours *neighbours)
{
    pdmc_free(neighbours->start);
    pdmc_free(neighbours->element);
    *neighbours = (pdmc_neighbours){0};
}
