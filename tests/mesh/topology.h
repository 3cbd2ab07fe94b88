// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What a mesh of triangles amounts to.

#include "mesh/mesh_impl.h"

#include "check.h"

typedef struct {
    double area, body_area, rim; // rim: length of all edges of one element only
    int euler;                   // nodes - edges + triangles: 1 of a disc, 0 of a ring
    int most_elements_of_an_edge;
} topology;

static inline topology topology_of(const pdmc_mesh *mesh)
{
    topology t = {0};
    pdmc_edges edges;
    CHECK_OK(pdmc_edges_create(mesh, &edges));
    for (int e = 0; e < mesh->element_count; e++) {
        const double area = pdmc_mesh_extent(mesh, e);
        assert_true(area > 0.0);
        t.area += area;
        if (!mesh->layer[e]) t.body_area += area;
    }
    for (int i = 0; i < edges.count; i++) {
        const int *n = edges.node[i];
        if (edges.elements[i] > t.most_elements_of_an_edge) t.most_elements_of_an_edge = edges.elements[i];
        if (edges.elements[i] == 1) t.rim += pdmc_mesh_distance(2, &mesh->x[2 * n[0]], &mesh->x[2 * n[1]]);
    }
    t.euler = mesh->node_count - edges.count + mesh->element_count;
    pdmc_edges_clear(&edges);
    return t;
}
