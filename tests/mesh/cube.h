// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A cube in tetrahedra.

#include "mesh/mesh_impl.h"

#include "check.h"

// A cube of n^3 cells of side 1 in six tetrahedra each, which share the diagonal (Kuhn).
static inline void cube_create(int n, pdmc_mesh *mesh)
{
    static const int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    const int m = n + 1, stride[3] = {1, m, m * m};
    *mesh = (pdmc_mesh){0};
    CHECK_OK(pdmc_mesh_allocate(3, m * m * m, 6.0 * n * n * n, mesh));
    for (int i = 0; i < m * m * m; i++)
        for (int a = 0; a < 3; a++) mesh->x[3 * i + a] = i / stride[a] % m;
    for (int cell = 0, e = 0; cell < n * n * n; cell++)
        for (int k = 0; k < 6; k++, e++) {
            int node = cell % n + m * (cell / n % n) + m * m * (cell / n / n);
            mesh->corner[4 * e] = node;
            for (int a = 0; a < 3; a++) mesh->corner[4 * e + 1 + a] = node += stride[orders[k][a]];
            if (pdmc_mesh_extent(mesh, e) > 0.0) continue;
            const int last = mesh->corner[4 * e + 3];
            mesh->corner[4 * e + 3] = mesh->corner[4 * e + 2];
            mesh->corner[4 * e + 2] = last;
        }
}

// Moves the nodes inside, so that the mesh is not Delaunay's.
static inline void shake(pdmc_mesh *mesh, double by, const double low[], const double high[])
{
    const int d = mesh->dimension;
    for (int i = 0; i < mesh->node_count; i++) {
        bool is_inside = true;
        for (int a = 0; a < d; a++)
            is_inside = is_inside && mesh->x[d * i + a] > low[a] && mesh->x[d * i + a] < high[a];
        for (int a = 0; a < d && is_inside; a++) mesh->x[d * i + a] += by * sin(12.9898 * i + 78.233 * a);
    }
}
