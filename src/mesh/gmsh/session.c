// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/gmsh/session.h"

#include <gmshc.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>

static bool set_options(void)
{
    static const struct {
        const char *name;
        double value;
    } options[] = {
        {"General.Terminal", 0.0},
        {"General.NumThreads", 1.0},
        {"Mesh.Algorithm", 6.0},  // frontal Delaunay, the most regular triangles
        {"Mesh.RandomSeed", 1.0}, // of the tiny shifts that keep nodes off common circles
        {"Mesh.MeshSizeExtendFromBoundary", 0.0},
        {"Mesh.MeshSizeFromPoints", 0.0},
    };
    for (size_t i = 0; i < sizeof options / sizeof options[0]; i++)
        GMSH_TRY(gmshOptionSetNumber(options[i].name, options[i].value, &error));
    return true;
done:
    return false;
}

static bool take_version(pdmc_gmsh_mesh *mesh)
{
    char *version = NULL;
    GMSH_TRY(gmshOptionGetString("General.Version", &version, &error));
    snprintf(mesh->version, sizeof mesh->version, "Gmsh %s", version);
    gmshFree(version);
    return true;
done:
    return false;
}

bool pdmc_gmsh_begin(pdmc_gmsh_mesh *mesh, int *threads)
{
    *threads = omp_get_max_threads();
    GMSH_TRY(gmshInitialize(0, NULL, 0, &error));
    return set_options() && take_version(mesh);
done:
    return false;
}

static void keep_message(pdmc_gmsh_mesh *mesh)
{
    char *message = NULL;
    int error = 0;
    if (mesh->message[0]) return;
    gmshLoggerGetLastError(&message, &error);
    snprintf(mesh->message, sizeof mesh->message, "%s", message && *message ? message : "failed without a message");
    gmshFree(message);
}

bool pdmc_gmsh_end(bool succeeded, int threads, pdmc_gmsh_mesh *mesh)
{
    int error = 0;
    if (!succeeded) keep_message(mesh);
    gmshFinalize(&error);
    omp_set_num_threads(threads);
    return succeeded;
}

bool pdmc_gmsh_version(pdmc_gmsh_mesh *mesh)
{
    int threads;
    const bool is_known = pdmc_gmsh_begin(mesh, &threads);
    return pdmc_gmsh_end(is_known, threads, mesh);
}

void pdmc_gmsh_clear(pdmc_gmsh_mesh *mesh)
{
    free(mesh->x);
    free(mesh->corner);
    free(mesh->layer);
    mesh->x = NULL;
    mesh->corner = NULL;
    mesh->layer = NULL;
}
