// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/mesh_impl.h"

#include "base/base_impl.h"

#include <math.h>
#include <string.h>

pdmc_status pdmc_mesh_allocate(int dimension, double nodes, double elements, pdmc_mesh *mesh)
{
    pdmc_status status = PDMC_OK;
    if (3.0 * elements > INT32_MAX) PDMC_FAIL(PDMC_ERR_ARG, "%.3g elements are too many", elements);
    mesh->dimension = dimension;
    mesh->node_count = (int)nodes;
    mesh->element_count = (int)elements;
    PDMC_NEW(mesh->x, nodes * dimension);
    PDMC_NEW(mesh->corner, elements * (dimension + 1));
    PDMC_NEW(mesh->layer, elements);
    PDMC_NEW(mesh->rough, elements);
done:
    return status;
}

void pdmc_mesh_mark_rough(pdmc_mesh *mesh, const double from[], const double to[])
{
    const int n = mesh->dimension + 1;
    for (int e = 0; e < mesh->element_count; e++) {
        bool inside = true;
        for (int d = 0; d < mesh->dimension; d++) {
            double middle = 0.0;
            for (int k = 0; k < n; k++) middle += mesh->x[mesh->dimension * mesh->corner[n * e + k] + d] / n;
            inside = inside && from[d] <= middle && middle <= to[d];
        }
        if (inside) mesh->rough[e] = 1;
    }
}

pdmc_status pdmc_mesh_copy(const pdmc_mesh *mesh, pdmc_mesh *copy)
{
    const size_t nodes = (size_t)mesh->node_count, elements = (size_t)mesh->element_count, d = (size_t)mesh->dimension;
    pdmc_mesh made = {0};
    const pdmc_status status = pdmc_mesh_allocate(mesh->dimension, (double)nodes, (double)elements, &made);
    *copy = (pdmc_mesh){0};
    if (status != PDMC_OK) {
        pdmc_mesh_clear(&made);
        return status;
    }
    memcpy(made.x, mesh->x, nodes * d * sizeof *mesh->x);
    memcpy(made.corner, mesh->corner, elements * (d + 1) * sizeof *mesh->corner);
    memcpy(made.layer, mesh->layer, elements);
    memcpy(made.rough, mesh->rough, elements);
    memcpy(made.generator, mesh->generator, sizeof made.generator);
    *copy = made;
    return PDMC_OK;
}

void pdmc_mesh_clear(pdmc_mesh *mesh)
{
    pdmc_free(mesh->x);
    pdmc_free(mesh->corner);
    pdmc_free(mesh->layer);
    pdmc_free(mesh->rough);
    *mesh = (pdmc_mesh){0};
}

static double edge_length(const pdmc_mesh *mesh, int from, int to)
{
    if (mesh->dimension == 1) return fabs(mesh->x[to] - mesh->x[from]);
    const double *a = &mesh->x[2 * (size_t)from], *b = &mesh->x[2 * (size_t)to];
    return hypot(b[0] - a[0], b[1] - a[1]);
}

double pdmc_mesh_spacing(const pdmc_mesh *mesh)
{
    const int n = mesh->dimension + 1;
    double longest = 0.0;
    for (int e = 0; e < mesh->element_count; e++)
        for (int k = 0; k < n; k++)
            longest = fmax(longest, edge_length(mesh, mesh->corner[n * e + k], mesh->corner[n * e + (k + 1) % n]));
    return longest;
}
