// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/mesh.h"

#include "base/base_impl.h"
#include "mesh/mesh_impl.h"
#include "pdmc/geometry.h"

#include <math.h>

static const double *place(const pdmc_mesh *mesh, int node)
{
    return &mesh->x[2 * (size_t)node];
}

// Of two edges that do not cross.
static double distance_between(const pdmc_mesh *mesh, const int p[2], const int q[2])
{
    double least = INFINITY;
    for (int k = 0; k < 2; k++) {
        const double to_q = pdmc_point_segment_distance(place(mesh, p[k]), place(mesh, q[0]), place(mesh, q[1]));
        const double to_p = pdmc_point_segment_distance(place(mesh, q[k]), place(mesh, p[0]), place(mesh, p[1]));
        least = fmin(least, fmin(to_q, to_p));
    }
    return least;
}

// Moves the edges of one element only to the front.
static int keep_outer(pdmc_edges *edges)
{
    int count = 0;
    for (int i = 0; i < edges->count; i++) {
        if (edges->elements[i] != 1) continue;
        for (int k = 0; k < 2; k++) edges->node[count][k] = edges->node[i][k];
        count++;
    }
    return count;
}

// Of the edges of an element and one of the mesh. Most are so far apart that their ends say so.
static bool is_near(const pdmc_mesh *mesh, int element, const int edge[2], double limit)
{
    const int *c = &mesh->corner[3 * (size_t)element];
    const pdmc_simplex simplex = pdmc_mesh_simplex(mesh, element);
    const double reach =
        limit + pdmc_simplex_diameter(&simplex) + pdmc_mesh_distance(2, place(mesh, edge[0]), place(mesh, edge[1]));
    if (pdmc_mesh_distance(2, place(mesh, c[0]), place(mesh, edge[0])) > reach) return false;
    for (int k = 0; k < 3; k++)
        if (distance_between(mesh, (int[2]){c[k], c[(k + 1) % 3]}, edge) < limit) return true;
    return false;
}

pdmc_status pdmc_mesh_mark_layer(pdmc_mesh *mesh, double width)
{
    pdmc_edges edges;
    const double limit = width * (1.0 - 1e-9); // a layer that was made as wide has rounding errors
    int left = 0;
    const pdmc_status status = pdmc_edges_create(mesh, &edges);
    if (status != PDMC_OK) return status;
    const int outer = keep_outer(&edges);
    for (int e = 0; e < mesh->element_count; e++) {
        mesh->layer[e] = 0;
        for (int i = 0; i < outer && !mesh->layer[e]; i++) mesh->layer[e] = is_near(mesh, e, edges.node[i], limit);
        left += !mesh->layer[e];
    }
    pdmc_edges_clear(&edges);
    if (left > 0) return PDMC_OK;
    return pdmc_raise(PDMC_ERR_ARG, "no element is further from the edge of the mesh than %g", width);
}

// The edges that the body has alone are those of its own surface; all others of the body are further in.
static pdmc_status find_surface(const pdmc_mesh *mesh, const pdmc_edges *edges, bool is_surface[])
{
    pdmc_status status = PDMC_OK;
    int *of_body = NULL;
    PDMC_NEW(of_body, edges->count);
    for (int k = 0; k < 3 * mesh->element_count; k++) of_body[edges->of[k]] += !mesh->layer[k / 3];
    for (int i = 0; i < edges->count; i++) is_surface[i] = of_body[i] == 1;
done:
    pdmc_free(of_body);
    return status;
}

pdmc_status pdmc_mesh_layer_width(const pdmc_mesh *mesh, double *width)
{
    pdmc_status status = PDMC_OK;
    pdmc_edges edges;
    bool *is_surface = NULL;
    *width = INFINITY;
    if ((status = pdmc_edges_create(mesh, &edges)) != PDMC_OK) return status;
    PDMC_NEW(is_surface, edges.count);
    PDMC_TRY(find_surface(mesh, &edges, is_surface));
    for (int i = 0; i < edges.count; i++)
        for (int j = 0; j < edges.count && is_surface[i]; j++)
            if (edges.elements[j] == 1) *width = fmin(*width, distance_between(mesh, edges.node[i], edges.node[j]));
done:
    pdmc_free(is_surface);
    pdmc_edges_clear(&edges);
    return status;
}
