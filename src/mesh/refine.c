// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/mesh.h"

#include "base/base_impl.h"
#include "mesh/mesh_impl.h"

#include <string.h>

// The middles of edges are behind the nodes.
static void place_nodes(const pdmc_mesh *mesh, const pdmc_edges *edges, pdmc_mesh *finer)
{
    memcpy(finer->x, mesh->x, 2 * (size_t)mesh->node_count * sizeof *mesh->x);
    for (int i = 0; i < edges->count; i++)
        for (int k = 0; k < 2; k++)
            finer->x[2 * (size_t)(mesh->node_count + i) + (size_t)k] =
                0.5 * (mesh->x[2 * edges->node[i][0] + k] + mesh->x[2 * edges->node[i][1] + k]);
}

static void split_triangle(const pdmc_mesh *mesh, const pdmc_edges *edges, int e, pdmc_mesh *finer)
{
    const int *c = &mesh->corner[3 * (size_t)e], *edge = &edges->of[3 * (size_t)e], first = mesh->node_count;
    const int m[3] = {first + edge[0], first + edge[1], first + edge[2]};
    const int parts[4][3] = {{c[0], m[2], m[1]}, {m[2], c[1], m[0]}, {m[1], m[0], c[2]}, {m[0], m[1], m[2]}};
    memcpy(&finer->corner[12 * (size_t)e], parts, sizeof parts);
    memset(&finer->layer[4 * (size_t)e], mesh->layer[e], 4);
    memset(&finer->rough[4 * (size_t)e], mesh->rough[e], 4);
}

pdmc_status pdmc_mesh_refine(const pdmc_mesh *mesh, pdmc_mesh *finer)
{
    pdmc_status status = PDMC_OK;
    pdmc_edges edges;
    pdmc_mesh made = {0};
    *finer = made;
    if ((status = pdmc_edges_create(mesh, &edges)) != PDMC_OK) return status;
    PDMC_TRY(pdmc_mesh_allocate(2, (double)mesh->node_count + edges.count, 4.0 * mesh->element_count, &made));
    place_nodes(mesh, &edges, &made);
    for (int e = 0; e < mesh->element_count; e++) split_triangle(mesh, &edges, e, &made);
    memcpy(made.generator, mesh->generator, sizeof made.generator);
    *finer = made;
    made = (pdmc_mesh){0};
done:
    pdmc_edges_clear(&edges);
    pdmc_mesh_clear(&made);
    return status;
}
