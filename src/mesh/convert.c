// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "mesh/gmsh.h"
#include "mesh/mesh_impl.h"

#include <math.h>
#include <string.h>

// The number of each node that an element has, in order, and -1 of the others.
static size_t number_nodes(const pdmc_gmsh_mesh *from, int number[])
{
    size_t count = 0;
    for (size_t i = 0; i < from->node_count; i++) number[i] = -1;
    for (size_t k = 0; k < from->element_count * ((size_t)from->dimension + 1); k++) number[from->corner[k]] = 0;
    for (size_t i = 0; i < from->node_count; i++)
        if (number[i] == 0) number[i] = (int)count++;
    return count;
}

static pdmc_status check_plane(const pdmc_gmsh_mesh *from, const char *name, const int number[])
{
    for (size_t i = 0; i < from->node_count; i++)
        if (number[i] >= 0 && from->x[3 * i + 2] != 0.0)
            return pdmc_raise(PDMC_ERR_DATA, "%s: a node lies at z = %g, must be 0", name, from->x[3 * i + 2]);
    return PDMC_OK;
}

static void copy(const pdmc_gmsh_mesh *from, const int number[], pdmc_mesh *mesh)
{
    const size_t d = (size_t)mesh->dimension;
    for (size_t i = 0; i < from->node_count; i++)
        if (number[i] >= 0) memcpy(&mesh->x[d * (size_t)number[i]], &from->x[3 * i], d * sizeof *mesh->x);
    for (size_t k = 0; k < from->element_count * (d + 1); k++) mesh->corner[k] = number[from->corner[k]];
    memcpy(mesh->layer, from->layer, from->element_count);
    memcpy(mesh->generator, from->version, sizeof mesh->generator);
}

// The volume that an element has to exceed is the rounding error of its edges.
static pdmc_status turn(pdmc_mesh *mesh, const char *name)
{
    const int d = mesh->dimension;
    for (int e = 0; e < mesh->element_count; e++) {
        int *corner = &mesh->corner[(size_t)e * (size_t)(d + 1)];
        const pdmc_simplex simplex = pdmc_mesh_simplex(mesh, e);
        const double extent = pdmc_simplex_extent(&simplex);
        if (!(fabs(extent) > 1e-14 * pow(pdmc_simplex_diameter(&simplex), d)))
            return pdmc_raise(PDMC_ERR_DATA, "%s: the element with the corner (%g, %g) has no extent", name,
                              mesh->x[d * corner[0]], mesh->x[d * corner[0] + 1]);
        if (extent > 0.0) continue;
        const int last = corner[d];
        corner[d] = corner[d - 1];
        corner[d - 1] = last;
    }
    return PDMC_OK;
}

pdmc_status pdmc_gmsh_convert(const pdmc_gmsh_mesh *from, const char *name, pdmc_mesh *mesh)
{
    pdmc_status status = PDMC_OK;
    int *number = NULL;
    pdmc_mesh made = {0};
    *mesh = made;
    if (from->node_count > INT32_MAX) PDMC_FAIL(PDMC_ERR_DATA, "%s: has too many nodes, %zu", name, from->node_count);
    PDMC_NEW(number, from->node_count);
    const size_t nodes = number_nodes(from, number);
    if (from->dimension == 2) PDMC_TRY(check_plane(from, name, number));
    PDMC_TRY(pdmc_mesh_allocate(from->dimension, (double)nodes, (double)from->element_count, &made));
    copy(from, number, &made);
    PDMC_TRY(turn(&made, name));
    *mesh = made;
    made = (pdmc_mesh){0};
done:
    pdmc_free(number);
    pdmc_mesh_clear(&made);
    return status;
}
