// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Meshes of intervals, triangles and tetrahedra. Lengths in any unit.

#include "pdmc/base.h"

enum { PDMC_GENERATOR_SIZE = 32 };

/// Intervals, triangles or tetrahedra of positive size: the corners of triangles are counter-clockwise.
typedef struct {
    int dimension;
    int node_count;
    double *x; // [node_count, dimension]
    int element_count;
    int *corner;                         // [element_count, dimension + 1] nodes
    uint8_t *layer;                      // [element_count] 1 where the field is prescribed
    uint8_t *rough;                      // [element_count] 1 where a mixed space is discontinuous
    char generator[PDMC_GENERATOR_SIZE]; // what made or read it, "Gmsh 4.8.4"; "" where it was pdmc itself
} pdmc_mesh;

/// What linear functions on a mesh share between elements: the values in nodes, nothing, or those in nodes of no rough element.
typedef enum { PDMC_SPACE_CONTINUOUS, PDMC_SPACE_DISCONTINUOUS, PDMC_SPACE_MIXED } pdmc_space_kind;

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

/// The same with a layer at some of the sides only.
/// @param[in]  has_layer  [2 dimension] at the left, the right, the bottom, and the top
PDMC_API PDMC_NODISCARD pdmc_status pdmc_mesh_open_box(int dimension, const double size[], const int cells[],
                                                       double layer, const bool has_layer[], pdmc_mesh *mesh);

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

/// A round hole.
typedef struct {
    double centre[2], radius;
} pdmc_hole;

/// A straight crack; an end may lie on a side of the plate.
typedef struct {
    double from[2], to[2];
} pdmc_slit;

/// A rectangle with its middle at the origin. Holes lie inside and apart from each other, cracks inside, apart from each
/// other and from holes.
typedef struct {
    double width, height;
    double layer;              // width round the rectangle and inside its holes; 0 for none, and with cracks
    double spacing;            // length of edges, about
    double fine_spacing, near; // ... within `near` of holes and cracks; from there it grows by a quarter of the way
    int hole_count, slit_count;
    const pdmc_hole *holes;
    const pdmc_slit *slits;
} pdmc_mesh_plate;

/// @return PDMC_OK, or PDMC_ERR_ARG with what cannot be
PDMC_API PDMC_NODISCARD pdmc_status pdmc_mesh_check_plate(const pdmc_mesh_plate *plate);

/// The plate in triangles, by Gmsh: the same on every machine that has the same version of it. The circle of a hole becomes
/// a polygon. Edges follow the cracks, whose nodes are double but for the tips inside.
/// @param[out] mesh  free with pdmc_mesh_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_ARG, PDMC_ERR_EXTERN (Gmsh failed, or could not be loaded), or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_mesh_triangles(const pdmc_mesh_plate *plate, pdmc_mesh *mesh);

/// What makes such meshes here, "Gmsh 4.8.4".
/// @return PDMC_OK or PDMC_ERR_EXTERN
PDMC_API PDMC_NODISCARD pdmc_status pdmc_mesh_generator(char generator[PDMC_GENERATOR_SIZE]);

/// Reads a file of Gmsh (.msh, of any version that Gmsh reads): its tetrahedra, or its triangles where it has none. Nodes of
/// no element are left out. What lies in the physical group "layer" is marked as layer.
/// @param[in]  dimension  2 or 3, which the file must have
/// @param[out] mesh       free with pdmc_mesh_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_NO_INPUT (no such file), PDMC_ERR_DATA (it is no mesh of simplices, or not of this dimension; has
/// an element without extent; is not in the plane of x and y), PDMC_ERR_EXTERN (Gmsh could not be loaded), or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_mesh_read(const char *path, int dimension, pdmc_mesh *mesh);

/// Splits each triangle into four by the middles of its edges.
/// @param[out] finer  free with pdmc_mesh_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_ARG (no triangles, or too many), or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_mesh_refine(const pdmc_mesh *mesh, pdmc_mesh *finer);

/// Marks as layer the triangles nearer to the edge of the mesh than `width`.
/// @return PDMC_OK, PDMC_ERR_ARG (no triangles; nothing is left outside the layer), or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_mesh_mark_layer(pdmc_mesh *mesh, double width);

/// The distance between the triangles that are not in the layer and the edge of the mesh.
/// @return PDMC_OK, PDMC_ERR_ARG (no triangles), or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_mesh_layer_width(const pdmc_mesh *mesh, double *width);

/// Length, area or volume of an element.
PDMC_API double pdmc_mesh_extent(const pdmc_mesh *mesh, int element);

/// How the body is shared out among the nodes: each element equally among its corners; or each point of the body to the
/// nearest node, in Voronoi cells that end at the surface of the body.
typedef enum { PDMC_SHARE_ELEMENTS, PDMC_SHARE_VORONOI } pdmc_share;

/// Area or volume of the body that each node has; together they are the body's.
/// @param[out] volume  [node_count]
/// @return PDMC_OK, PDMC_ERR_ARG (intervals), or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_mesh_node_volumes(const pdmc_mesh *mesh, pdmc_share share, double volume[]);

/// Marks as rough the elements whose middle lies in a box.
PDMC_API void pdmc_mesh_mark_rough(pdmc_mesh *mesh, const double from[], const double to[]);

/// @param[out] copy  free with pdmc_mesh_clear(); zero on failure
/// @return PDMC_OK or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_mesh_copy(const pdmc_mesh *mesh, pdmc_mesh *copy);

/// A zeroed mesh is allowed.
PDMC_API void pdmc_mesh_clear(pdmc_mesh *mesh);

/// The longest edge of intervals or triangles.
PDMC_API double pdmc_mesh_spacing(const pdmc_mesh *mesh);
