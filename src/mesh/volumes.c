// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/mesh.h"

#include "base/base_impl.h"
#include "mesh/mesh_impl.h"
#include "mesh/vicinity.h"

#include <math.h>
#include <string.h>

// The points nearer to the origin than to another point: half of the plane or of space.
typedef double half_space[PDMC_MESH_AXES];

static double height_over(const half_space other, const double x[], int dimension)
{
    double height = 0.0;
    for (int a = 0; a < dimension; a++) height += other[a] * (x[a] - 0.5 * other[a]);
    return height;
}

static double extent_within(const pdmc_simplex *s, int count, half_space *const others);

// Where corners lie on both sides, an edge is cut in two at the height 0, and the simplex with it. A cut corner's height is set
// rather than computed, so that rounding does not cut it again.
static double extent_below(const pdmc_simplex *s, const double height[], int count, half_space *const others)
{
    int low = 0, high = 0;
    for (int k = 1; k <= s->dimension; k++) {
        if (height[k] < height[low]) low = k;
        if (height[k] > height[high]) high = k;
    }
    if (height[high] <= 0.0) return extent_within(s, count - 1, others + 1);
    if (height[low] >= 0.0) return 0.0;
    const double t = height[low] / (height[low] - height[high]);
    double sum = 0.0;
    for (int part = 0; part < 2; part++) {
        const int moved = part == 0 ? high : low;
        pdmc_simplex half = *s;
        double its_height[PDMC_MESH_CORNERS];
        for (int a = 0; a < s->dimension; a++)
            half.corner[moved][a] = s->corner[low][a] + t * (s->corner[high][a] - s->corner[low][a]);
        memcpy(its_height, height, sizeof its_height);
        its_height[moved] = 0.0;
        sum += extent_below(&half, its_height, count, others);
    }
    return sum;
}

// The part of a simplex that is nearer to the origin than to any of the others.
static double extent_within(const pdmc_simplex *s, int count, half_space *const others)
{
    double height[PDMC_MESH_CORNERS] = {0.0};
    if (count == 0) return pdmc_simplex_extent(s);
    for (int k = 0; k <= s->dimension; k++) height[k] = height_over(*others, s->corner[k], s->dimension);
    return extent_below(s, height, count, others);
}

// Of an element, about its middle: beyond it no node is the nearest to any point of the element, since a point of a simplex
// is nearer to one of its corners than the radius of its smallest ball, which is sqrt(d / (2 d + 2)) diameters at most (Jung).
static double reach_of(const pdmc_simplex *s, double middle[])
{
    double radius = 0.0;
    pdmc_simplex_middle(s, middle);
    for (int k = 0; k <= s->dimension; k++)
        radius = fmax(radius, pdmc_mesh_distance(s->dimension, middle, s->corner[k]));
    return (radius + sqrt(s->dimension / (2.0 * s->dimension + 2.0)) * pdmc_simplex_diameter(s)) * (1.0 + 1e-9);
}

// The corners of the element first: they leave little for other nodes.
static void put_corners_first(const pdmc_mesh *mesh, int element, int count, int node[])
{
    const int corners = mesh->dimension + 1;
    for (int k = 0; k < corners; k++)
        for (int i = k; i < count; i++) {
            if (node[i] != mesh->corner[element * corners + k]) continue;
            node[i] = node[k];
            node[k] = mesh->corner[element * corners + k];
        }
}

static void share_element(const pdmc_mesh *mesh, int element, int count, const int node[], half_space *others,
                          double volume[])
{
    const int d = mesh->dimension;
    for (int i = 0; i < count; i++) {
        const double *origin = &mesh->x[(size_t)d * (size_t)node[i]];
        pdmc_simplex s = pdmc_mesh_simplex(mesh, element);
        int other_count = 0;
        for (int k = 0; k <= d; k++)
            for (int a = 0; a < d; a++) s.corner[k][a] -= origin[a];
        for (int j = 0; j < count; j++) {
            if (j == i) continue;
            for (int a = 0; a < d; a++)
                others[other_count][a] = mesh->x[(size_t)d * (size_t)node[j] + (size_t)a] - origin[a];
            other_count++;
        }
        volume[node[i]] += extent_within(&s, other_count, others);
    }
}

static pdmc_status share_voronoi(const pdmc_mesh *mesh, double volume[])
{
    pdmc_status status = PDMC_OK;
    pdmc_vicinity vicinity = {0};
    half_space *others = NULL;
    PDMC_TRY(pdmc_vicinity_create(mesh->dimension, mesh->node_count, mesh->x, &vicinity));
    PDMC_NEW(others, mesh->node_count);
    for (int e = 0; e < mesh->element_count; e++) {
        double middle[PDMC_MESH_AXES];
        const pdmc_simplex s = pdmc_mesh_simplex(mesh, e);
        const double reach = reach_of(&s, middle);
        const int count = pdmc_vicinity_find(&vicinity, middle, reach);
        put_corners_first(mesh, e, count, vicinity.found);
        share_element(mesh, e, count, vicinity.found, others, volume);
    }
done:
    pdmc_free(others);
    pdmc_vicinity_clear(&vicinity);
    return status;
}

static void share_elements(const pdmc_mesh *mesh, double volume[])
{
    const int corners = mesh->dimension + 1;
    for (int e = 0; e < mesh->element_count; e++) {
        const double share = pdmc_mesh_extent(mesh, e) / corners;
        for (int k = 0; k < corners; k++) volume[mesh->corner[corners * e + k]] += share;
    }
}

pdmc_status pdmc_mesh_node_volumes(const pdmc_mesh *mesh, pdmc_share share, double volume[])
{
    PDMC_REQUIRE(mesh->dimension == 2 || mesh->dimension == 3, "the mesh is of dimension %d, must be of 2 or 3",
                 mesh->dimension);
    memset(volume, 0, (size_t)mesh->node_count * sizeof *volume);
    if (share == PDMC_SHARE_VORONOI) return share_voronoi(mesh, volume);
    share_elements(mesh, volume);
    return PDMC_OK;
}
