// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/mesh.h"

#include "base/base_impl.h"
#include "mesh/mesh_impl.h"

#include <math.h>
#include <string.h>

// The two triangles of a cell; the diagonal changes from cell to cell.
static void fill_cell(int columns, int i, int j, pdmc_mesh *mesh)
{
    const int across = columns + 1, sw = j * across + i, se = sw + 1, nw = sw + across, ne = nw + 1;
    const int rising[2][3] = {{sw, se, ne}, {sw, ne, nw}}, falling[2][3] = {{sw, se, nw}, {se, ne, nw}};
    memcpy(&mesh->corner[6 * ((size_t)j * (size_t)columns + (size_t)i)], (i + j) % 2 ? falling : rising, sizeof rising);
}

pdmc_status pdmc_mesh_rectangle(int columns, const double x[], int rows, const double y[], pdmc_mesh *mesh)
{
    pdmc_status status = PDMC_OK;
    pdmc_mesh made = {0};
    *mesh = made;
    PDMC_TRY(pdmc_mesh_allocate(2, (columns + 1.0) * (rows + 1.0), 2.0 * columns * rows, &made));
    for (int n = 0; n < made.node_count; n++) {
        made.x[2 * (size_t)n] = x[n % (columns + 1)];
        made.x[2 * (size_t)n + 1] = y[n / (columns + 1)];
    }
    for (int j = 0; j < rows; j++)
        for (int i = 0; i < columns; i++) fill_cell(columns, i, j, &made);
    *mesh = made;
    made = (pdmc_mesh){0};
done:
    pdmc_mesh_clear(&made);
    return status;
}
