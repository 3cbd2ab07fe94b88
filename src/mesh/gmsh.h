// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The module that calls Gmsh, loaded when it is first asked for.

#include "mesh/gmsh/module.h"

typedef struct {
    pdmc_gmsh_version_function *version;
    pdmc_gmsh_read_function *read;
    pdmc_gmsh_plate_function *plate;
    pdmc_gmsh_clear_function *clear;
} pdmc_gmsh;

/// @return PDMC_OK, or PDMC_ERR_EXTERN with what is missing
PDMC_NODISCARD pdmc_status pdmc_gmsh_load(pdmc_gmsh *gmsh);

/// The mesh without the nodes of no element, and with elements turned the right way round.
/// @param[in]  name  of the file or of what was asked for, for messages
/// @param[out] mesh  zero on failure
/// @return PDMC_OK, PDMC_ERR_DATA, or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_gmsh_convert(const pdmc_gmsh_mesh *from, const char *name, pdmc_mesh *mesh);
