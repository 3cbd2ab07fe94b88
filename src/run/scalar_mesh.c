// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/scalar_mesh.h"

#include "base/base_impl.h"

#include <math.h>

static pdmc_status draw(const pdmc_scalar *study, pdmc_mesh *mesh)
{
    const pdmc_mesh_plate plate = pdmc_scalar_plate(study);
    double width;
    pdmc_status status = pdmc_mesh_triangles(&plate, mesh);
    if (status == PDMC_OK) status = pdmc_mesh_layer_width(mesh, &width);
    if (status != PDMC_OK || width >= study->horizon * (1.0 - 1e-9)) return status;
    return pdmc_raise(PDMC_ERR_CONFIG, "the layer is only %g wide where the edge is round; a smaller spacing helps",
                      width);
}

static pdmc_status make(const pdmc_scalar *study, int level, const pdmc_mesh *before, pdmc_mesh *mesh)
{
    const pdmc_scalar_level at = pdmc_scalar_level_of(study, level);
    const double size[2] = {study->width, study->height};
    bool has_layer[4];
    for (int side = 0; side < 4; side++) has_layer[side] = pdmc_scalar_holds(study, side);
    if (study->mesh == PDMC_ELEMENTS_CELLS)
        return pdmc_mesh_open_box(study->dimension, size, at.cells, at.horizon, has_layer, mesh);
    if (level > 0) return (study->vary == PDMC_VARY_SPACING ? pdmc_mesh_refine : pdmc_mesh_copy)(before, mesh);
    return study->mesh == PDMC_ELEMENTS_FILE ? pdmc_mesh_copy(&study->first, mesh) : draw(study, mesh);
}

pdmc_status pdmc_run_mesh(const pdmc_scalar *study, int level, const pdmc_mesh *before, pdmc_mesh *mesh)
{
    const double from[2] = {study->rough_from, -INFINITY}, to[2] = {study->rough_to, INFINITY};
    *mesh = (pdmc_mesh){0};
    const pdmc_status status = make(study, level, before, mesh);
    if (status == PDMC_OK) pdmc_mesh_mark_rough(mesh, from, to);
    else pdmc_mesh_clear(mesh);
    return status;
}
