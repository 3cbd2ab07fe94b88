// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "mesh/mesh_impl.h"

#include <stdlib.h>

typedef struct {
    int node[2], place; // in pdmc_edges.of
} side;

static int by_nodes(const void *a, const void *b)
{
    const side *p = a, *q = b;
    if (p->node[0] != q->node[0]) return p->node[0] < q->node[0] ? -1 : 1;
    if (p->node[1] != q->node[1]) return p->node[1] < q->node[1] ? -1 : 1;
    return (p->place > q->place) - (p->place < q->place);
}

static side side_of(const pdmc_mesh *mesh, int place)
{
    const int e = place / 3, k = place % 3;
    const int a = mesh->corner[3 * e + (k + 1) % 3], b = mesh->corner[3 * e + (k + 2) % 3];
    return (side){.node = {a < b ? a : b, a < b ? b : a}, .place = place};
}

pdmc_status pdmc_edges_create(const pdmc_mesh *mesh, pdmc_edges *edges)
{
    pdmc_status status = PDMC_OK;
    pdmc_edges made = {0};
    side *sides = NULL;
    const int count = 3 * mesh->element_count;
    *edges = made;
    PDMC_REQUIRE(mesh->dimension == 2, "the mesh is of dimension %d, must be of 2", mesh->dimension);
    PDMC_NEW(sides, count);
    PDMC_NEW(made.node, count);
    PDMC_NEW(made.of, count);
    PDMC_NEW(made.elements, count);
    for (int i = 0; i < count; i++) sides[i] = side_of(mesh, i);
    qsort(sides, (size_t)count, sizeof *sides, by_nodes);
    for (int i = 0; i < count; i++) {
        const side *s = &sides[i];
        const bool is_same = i > 0 && s[-1].node[0] == s->node[0] && s[-1].node[1] == s->node[1];
        if (!is_same) made.count++;
        for (int k = 0; k < 2; k++) made.node[made.count - 1][k] = s->node[k];
        made.of[s->place] = made.count - 1;
        made.elements[made.count - 1]++;
    }
    *edges = made;
    made = (pdmc_edges){0};
done:
    pdmc_free(sides);
    pdmc_edges_clear(&made);
    return status;
}

void pdmc_edges_clear(pdmc_edges *edges)
{
    pdmc_free(edges->node);
    pdmc_free(edges->of);
    pdmc_free(edges->elements);
    *edges = (pdmc_edges){0};
}
