// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/mesh.h"

enum { PDMC_MESH_AXES = 3, PDMC_MESH_CORNERS = 4 };

/// A zeroed mesh gets its sizes and room for as many nodes and elements; after a failure too it is freed with
/// pdmc_mesh_clear().
/// @return PDMC_OK, PDMC_ERR_ARG (too many elements), or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_mesh_allocate(int dimension, double nodes, double elements, pdmc_mesh *mesh);

/// An element by itself.
typedef struct {
    int dimension;
    double corner[PDMC_MESH_CORNERS][PDMC_MESH_AXES];
} pdmc_simplex;

pdmc_simplex pdmc_mesh_simplex(const pdmc_mesh *mesh, int element);

/// Length, area or volume, negative where the corners go round the other way.
double pdmc_simplex_extent(const pdmc_simplex *simplex);

/// The longest edge.
double pdmc_simplex_diameter(const pdmc_simplex *simplex);

/// @param[out] middle  [dimension] the mean of the corners
void pdmc_simplex_middle(const pdmc_simplex *simplex, double middle[]);

/// Between two points.
double pdmc_mesh_distance(int dimension, const double a[], const double b[]);

/// The edges of triangles.
typedef struct {
    int count;
    int (*node)[2]; // [count] the smaller first
    int *of;        // [element_count, 3] the edge that is opposite to each corner
    int *elements;  // [count] how many elements have it
} pdmc_edges;

/// @param[out] edges  free with pdmc_edges_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_ARG (no triangles), or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_edges_create(const pdmc_mesh *mesh, pdmc_edges *edges);
void pdmc_edges_clear(pdmc_edges *edges);
