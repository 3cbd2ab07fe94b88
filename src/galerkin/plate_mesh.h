// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/mesh.h"
#include "pdmc/problem.h"

/// A plate in cells no larger than the spacing, between lines through the ends of its cracks, which must be parallel to its
/// sides and are open; beyond every side with prescribed displacements it goes on for a horizon. Or in triangles by Gmsh, with
/// cracks at any angle. Elements within a horizon of a crack are rough.
/// @param[out] mesh  free with pdmc_mesh_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_CONFIG (a crack at an angle to cells), PDMC_ERR_ARG (too many elements), PDMC_ERR_EXTERN (Gmsh
/// could not be loaded), or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_plate_mesh(const pdmc_problem *problem, pdmc_mesh *mesh);

/// Whether a support holds anything on a side.
bool pdmc_plate_holds(const pdmc_problem *problem, pdmc_side side);
