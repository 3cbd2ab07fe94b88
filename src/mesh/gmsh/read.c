// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/gmsh/session.h"

#include <gmshc.h>

static bool merge(const char *path)
{
    GMSH_TRY(gmshMerge(path, &error));
    return true;
done:
    return false;
}

bool pdmc_gmsh_read(const char *path, pdmc_gmsh_mesh *mesh)
{
    int threads;
    const bool is_done = pdmc_gmsh_begin(mesh, &threads) && merge(path) && pdmc_gmsh_take(mesh);
    return pdmc_gmsh_end(is_done, threads, mesh);
}
