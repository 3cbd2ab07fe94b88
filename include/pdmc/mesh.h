// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Meshes of intervals and triangles. Lengths in any unit.

#include "pdmc/base.h"

/// Intervals or triangles, with corners counter-clockwise.
typedef struct {
    int dimension;
    int node_count;
    double *x; // [node_count, dimension]
    int element_count;
    int *corner;    // [element_count, dimension + 1] nodes
    uint8_t *layer; // [element_count] 1 where the field is prescribed
    uint8_t *rough; // [element_count] 1 where a mixed space is discontinuous
} pdmc_mesh;

/// A box with its middle at the origin, in equal cells, and round it a layer in cells no longer than those. In two
/// dimensions each cell is two triangles, whose common edges meet in every second node.
/// @param[in]  dimension  1 or 2
/// @param[in]  size       [dimension] of the box
/// @param[in]  cells      [dimension] >= 1
/// @param[in]  layer      > 0, width of the layer
/// @param[out] mesh       free with pdmc_mesh_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_ARG, or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_mesh_box(int dimension, const double size[], const int cells[], double layer,
                                                  pdmc_mesh *mesh);

/// A rectangle in cells between lines along both axes; each cell is two triangles as of a box.
/// @param[in]  columns, rows  >= 1
/// @param[in]  x, y           [columns + 1], [rows + 1] of the lines, ascending
/// @param[out] mesh           free with pdmc_mesh_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_ARG (too many elements), or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_mesh_rectangle(int columns, const double x[], int rows, const double y[],
                                                        pdmc_mesh *mesh);

/// Opens a mesh of triangles along a segment that no element straddles: the nodes on it, its ends excepted, are doubled,
/// and the elements to the right of from -> to get the new ones, which come last. What is to be open at the edge of the
/// mesh must end beyond it.
/// @return PDMC_OK or PDMC_ERR_NOMEM, after which the mesh is as it was
PDMC_API PDMC_NODISCARD pdmc_status pdmc_mesh_cut(pdmc_mesh *mesh, const double from[2], const double to[2]);

/// Marks as rough the elements whose middle lies in a box.
PDMC_API void pdmc_mesh_mark_rough(pdmc_mesh *mesh, const double from[], const double to[]);

/// A zeroed mesh is allowed.
PDMC_API void pdmc_mesh_clear(pdmc_mesh *mesh);

/// The longest edge.
PDMC_API double pdmc_mesh_spacing(const pdmc_mesh *mesh);
