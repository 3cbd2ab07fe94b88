// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/mesh.h"

#include "base/base_impl.h"
#include "mesh/mesh_impl.h"

#include <math.h>
#include <string.h>

// The nodes along one axis: those of the layer, of the box, and of the layer again.
typedef struct {
    int cells, layer_cells[2]; // in all, and in the layer at either end
    double *x;                 // [cells + 1]
} axis;

static pdmc_status axis_create(double size, int cells, double layer, const bool has_layer[2], axis *out)
{
    pdmc_status status = PDMC_OK;
    const double spacing = size / cells;
    const int outer = (int)fmax(1.0, ceil(layer / spacing * (1.0 - 1e-9)));
    const int below = has_layer[0] ? outer : 0, above = has_layer[1] ? outer : 0;
    *out = (axis){.cells = below + cells + above, .layer_cells = {below, above}};
    PDMC_NEW(out->x, out->cells + 1);
    for (int i = 0; i <= cells; i++) out->x[below + i] = size * ((double)i / cells - 0.5);
    for (int i = 1; i <= below; i++) out->x[below - i] = -0.5 * size - layer * i / outer;
    for (int i = 1; i <= above; i++) out->x[below + cells + i] = 0.5 * size + layer * i / outer;
done:
    return status;
}

static bool is_outside(const axis *a, int cell)
{
    return cell < a->layer_cells[0] || cell >= a->cells - a->layer_cells[1];
}

static void fill_interval(const axis *a, pdmc_mesh *mesh)
{
    memcpy(mesh->x, a->x, (size_t)mesh->node_count * sizeof *mesh->x);
    for (int i = 0; i < a->cells; i++) {
        mesh->corner[2 * i] = i;
        mesh->corner[2 * i + 1] = i + 1;
        mesh->layer[i] = is_outside(a, i);
    }
}

static void mark_layer(const axis a[2], pdmc_mesh *mesh)
{
    for (int j = 0; j < a[1].cells; j++)
        for (int i = 0; i < a[0].cells; i++)
            for (int k = 0; k < 2; k++)
                mesh->layer[2 * (j * a[0].cells + i) + k] = is_outside(&a[0], i) || is_outside(&a[1], j);
}

pdmc_status pdmc_mesh_box(int dimension, const double size[], const int cells[], double layer, pdmc_mesh *mesh)
{
    const bool all[4] = {true, true, true, true};
    return pdmc_mesh_open_box(dimension, size, cells, layer, all, mesh);
}

pdmc_status pdmc_mesh_open_box(int dimension, const double size[], const int cells[], double layer,
                               const bool has_layer[], pdmc_mesh *mesh)
{
    pdmc_status status = PDMC_OK;
    axis a[2] = {{0}, {0}};
    pdmc_mesh made = {0};
    *mesh = made;
    PDMC_REQUIRE(dimension == 1 || dimension == 2, "a dimension of %d is neither 1 nor 2", dimension);
    PDMC_REQUIRE(layer > 0.0 && isfinite(layer), "a layer of %g is not > 0", layer);
    for (int d = 0; d < dimension; d++) {
        PDMC_REQUIRE(size[d] > 0.0 && isfinite(size[d]), "a size of %g is not > 0", size[d]);
        PDMC_REQUIRE(cells[d] >= 1, "%d cells are not 1 or more", cells[d]);
    }
    for (int d = 0; d < dimension; d++) PDMC_TRY(axis_create(size[d], cells[d], layer, &has_layer[2 * d], &a[d]));
    if (dimension == 1) PDMC_TRY(pdmc_mesh_allocate(1, a[0].cells + 1.0, a[0].cells, &made));
    else PDMC_TRY(pdmc_mesh_rectangle(a[0].cells, a[0].x, a[1].cells, a[1].x, &made));
    if (dimension == 1) fill_interval(a, &made);
    else mark_layer(a, &made);
    *mesh = made;
    made = (pdmc_mesh){0};
done:
    for (int d = 0; d < 2; d++) pdmc_free(a[d].x);
    pdmc_mesh_clear(&made);
    return status;
}
