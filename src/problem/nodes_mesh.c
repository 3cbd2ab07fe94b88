// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem/nodes_file.h"

#include "base/base_impl.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int by_place(const void *a, const void *b)
{
    const pdmc_node *p = a, *q = b;
    for (int k = 0; k < PDMC_AXES; k++)
        if (p->x[k] != q->x[k]) return p->x[k] < q->x[k] ? -1 : 1;
    return 0;
}

// Cracks of bodies are broken bonds; nodes that a mesh has twice, one on either side, would be in one place.
static pdmc_status check_places(const char *path, int count, const pdmc_node nodes[])
{
    pdmc_status status = PDMC_OK;
    pdmc_node *sorted = NULL;
    PDMC_NEW(sorted, count);
    memcpy(sorted, nodes, (size_t)count * sizeof *sorted);
    qsort(sorted, (size_t)count, sizeof *sorted, by_place);
    for (int i = 1; i < count; i++) {
        const double *x = sorted[i].x;
        if (by_place(&sorted[i - 1], &sorted[i]) == 0)
            PDMC_FAIL(PDMC_ERR_DATA, "%s: two nodes are at (%g, %g, %g), must be in places of their own", path, x[0],
                      x[1], x[2]);
    }
done:
    pdmc_free(sorted);
    return status;
}

pdmc_status pdmc_nodes_of_mesh(const char *path, int dimension, pdmc_share share, double depth,
                               char generator[PDMC_GENERATOR_SIZE], int *count, pdmc_node **nodes)
{
    pdmc_status status = PDMC_OK;
    const size_t d = (size_t)dimension;
    pdmc_mesh mesh = {0};
    pdmc_node *made = NULL;
    double *volume = NULL;
    *count = 0;
    *nodes = NULL;
    PDMC_TRY(pdmc_mesh_read(path, dimension, &mesh));
    PDMC_NEW(made, mesh.node_count);
    PDMC_NEW(volume, mesh.node_count);
    for (int i = 0; i < mesh.node_count; i++) memcpy(made[i].x, &mesh.x[d * (size_t)i], d * sizeof *mesh.x);
    PDMC_TRY(check_places(path, mesh.node_count, made));
    PDMC_TRY(pdmc_mesh_node_volumes(&mesh, share, volume));
    for (int i = 0; i < mesh.node_count; i++) {
        made[i].volume = depth * volume[i];
        if (!(made[i].volume > 0.0))
            PDMC_FAIL(PDMC_ERR_DATA, "%s: the node at (%g, %g, %g) has no volume", path, made[i].x[0], made[i].x[1],
                      made[i].x[2]);
    }
    memcpy(generator, mesh.generator, sizeof mesh.generator);
    *count = mesh.node_count;
    *nodes = made;
    made = NULL;
done:
    pdmc_free(made);
    pdmc_free(volume);
    pdmc_mesh_clear(&mesh);
    return status;
}
