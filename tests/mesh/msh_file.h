// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Meshes as files of Gmsh, version 2.

#include "pdmc/mesh.h"

#include "check.h"

/// Elements of the layer are in the physical group 1, "layer", where the file is to have it.
static inline void write_msh(const char *path, const pdmc_mesh *mesh, bool has_group)
{
    const int d = mesh->dimension;
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n", file);
    if (has_group) fputs("$PhysicalNames\n1\n2 1 \"layer\"\n$EndPhysicalNames\n", file);
    fprintf(file, "$Nodes\n%d\n", mesh->node_count);
    for (int i = 0; i < mesh->node_count; i++)
        fprintf(file, "%d %.17g %.17g %.17g\n", i + 1, mesh->x[d * i], mesh->x[d * i + 1],
                d == 3 ? mesh->x[d * i + 2] : 0.0);
    fprintf(file, "$EndNodes\n$Elements\n%d\n", mesh->element_count);
    for (int e = 0; e < mesh->element_count; e++) {
        const int entity = mesh->layer[e] ? 1 : 2;
        fprintf(file, "%d %d 2 %d %d", e + 1, d == 2 ? 2 : 4, entity, entity);
        for (int k = 0; k <= d; k++) fprintf(file, " %d", mesh->corner[(d + 1) * e + k] + 1);
        fputc('\n', file);
    }
    fputs("$EndElements\n", file);
    assert_int_equal(fclose(file), 0);
}
