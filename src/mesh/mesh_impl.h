// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/mesh.h"

/// A zeroed mesh gets its sizes and room for as many nodes and elements; after a failure too it is freed with
/// pdmc_mesh_clear().
/// @return PDMC_OK, PDMC_ERR_ARG (too many elements), or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_mesh_allocate(int dimension, double nodes, double elements, pdmc_mesh *mesh);
