// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/mesh.h"

#include "base/base_impl.h"
#include "mesh/gmsh.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

// Gmsh takes what it does not know for one of its scripts, and runs it.
static pdmc_status check_kind(const char *path)
{
    char first = 0;
    const char *end = strrchr(path, '.');
    FILE *file = fopen(path, "rb");
    if (!file) return pdmc_raise(PDMC_ERR_NO_INPUT, "%s: %s", path, strerror(errno));
    const bool is_read = fread(&first, 1, 1, file) == 1;
    fclose(file);
    if (!end || strcmp(end, ".msh") != 0)
        return pdmc_raise(PDMC_ERR_DATA, "%s: is no mesh of Gmsh, whose names end in .msh", path);
    if (!is_read || first != '$')
        return pdmc_raise(PDMC_ERR_DATA, "%s: is no mesh of Gmsh, which begins with $MeshFormat", path);
    return PDMC_OK;
}

pdmc_status pdmc_mesh_read(const char *path, int dimension, pdmc_mesh *mesh)
{
    pdmc_status status = PDMC_OK;
    pdmc_gmsh gmsh;
    pdmc_gmsh_mesh read = {0};
    *mesh = (pdmc_mesh){0};
    PDMC_REQUIRE(dimension == 2 || dimension == 3, "a dimension of %d is neither 2 nor 3", dimension);
    if ((status = check_kind(path)) != PDMC_OK || (status = pdmc_gmsh_load(&gmsh)) != PDMC_OK) return status;
    bool is_read;
#pragma omp critical(pdmc_gmsh) // which is one for the whole process
    is_read = gmsh.read(path, &read);
    if (!is_read) PDMC_FAIL(PDMC_ERR_DATA, "%s: %s", path, read.message);
    if (read.dimension != dimension)
        PDMC_FAIL(PDMC_ERR_DATA, "%s: has %s, must have %s", path, read.dimension == 3 ? "tetrahedra" : "triangles",
                  dimension == 3 ? "tetrahedra" : "triangles alone");
    PDMC_TRY(pdmc_gmsh_convert(&read, path, mesh));
done:
    gmsh.clear(&read);
    return status;
}
