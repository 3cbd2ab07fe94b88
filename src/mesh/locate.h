// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/mesh.h"

/// Intervals or triangles by the cells of a grid that their boxes meet.
typedef struct {
    const pdmc_mesh *mesh;
    double origin[2], size[2]; // of the grid, and of a cell
    int count[2];              // 1 along y for intervals
    int *start;                // [cells + 1]
    int *element;              // [start[cells]] ascending in each cell
} pdmc_mesh_locator;

/// @param[in]  mesh  in one or two dimensions, kept by reference
/// @param[out] out   free with pdmc_mesh_locator_clear(); zero on failure
/// @return PDMC_OK or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_mesh_locator_create(const pdmc_mesh *mesh, pdmc_mesh_locator *out);
void pdmc_mesh_locator_clear(pdmc_mesh_locator *locator);

/// The element that holds a point, or whose edges it lies least beyond; -1 where none is near.
/// @param[in]  x      [dimension]
/// @param[out] depth  the least of the point's barycentric coordinates, negative outside; NULL is allowed
int pdmc_mesh_locate(const pdmc_mesh_locator *locator, const double x[], double *depth);
