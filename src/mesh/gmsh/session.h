// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What every use of Gmsh begins and ends with.

#include "mesh/gmsh/module.h"

/// Jumps to `done:` if the last call of Gmsh, whose last argument was &error, failed.
#define GMSH_TRY(call)                                                                                                 \
    do {                                                                                                               \
        int error = 0;                                                                                                 \
        call;                                                                                                          \
        if (error) goto done;                                                                                          \
    } while (0)

/// Starts Gmsh, silent, on one thread, without the user's options.
/// @param[out] threads  OpenMP's number, which Gmsh changes
bool pdmc_gmsh_begin(pdmc_gmsh_mesh *mesh, int *threads);

/// Keeps what Gmsh says of a failure, ends Gmsh, and puts OpenMP's number back. Returns `succeeded`.
bool pdmc_gmsh_end(bool succeeded, int threads, pdmc_gmsh_mesh *mesh);

/// The elements of the present model, of the highest dimension that has any; only triangles or tetrahedra with straight
/// edges.
bool pdmc_gmsh_take(pdmc_gmsh_mesh *mesh);
