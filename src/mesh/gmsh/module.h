// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What passes between the library and the module that calls Gmsh. The module is loaded only where a mesh is asked for:
/// Gmsh brings some ninety libraries with it, which cost every command 0.1 s. It shares no symbol with the library.

#include "pdmc/mesh.h"

#include <stddef.h>

enum { PDMC_GMSH_MOST_HOLES = 1000, PDMC_GMSH_MOST_SLITS = 100 };

/// A mesh as Gmsh has it, in malloc()'s memory.
typedef struct {
    int dimension; // 2 or 3, of the elements
    size_t node_count, element_count;
    double *x;      // [node_count, 3], those of no element too
    size_t *corner; // [element_count, dimension + 1] nodes
    uint8_t *layer; // [element_count] 1 in the physical group "layer"
    bool has_layer; // there is such a group
    char version[PDMC_GENERATOR_SIZE];
    char message[512]; // after a failure
} pdmc_gmsh_mesh;

/// @return whether it succeeded; the mesh is to be freed with pdmc_gmsh_clear() in any case
typedef bool pdmc_gmsh_read_function(const char *path, pdmc_gmsh_mesh *mesh);
typedef bool pdmc_gmsh_plate_function(const pdmc_mesh_plate *plate, pdmc_gmsh_mesh *mesh);
typedef void pdmc_gmsh_clear_function(pdmc_gmsh_mesh *mesh);

/// Nothing but the version.
typedef bool pdmc_gmsh_version_function(pdmc_gmsh_mesh *mesh);

PDMC_API pdmc_gmsh_version_function pdmc_gmsh_version;
PDMC_API pdmc_gmsh_read_function pdmc_gmsh_read;
PDMC_API pdmc_gmsh_plate_function pdmc_gmsh_plate;
PDMC_API pdmc_gmsh_clear_function pdmc_gmsh_clear;
