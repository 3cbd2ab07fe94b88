// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/scalar.h"

/// Makes the mesh of a level from that of the level before: finer where the spacing varies, otherwise the same. Cells are made
/// anew; each triangle becomes four, so that the domain does not change.
/// @param[in]  before  NULL at the first level
/// @param[out] mesh    free with pdmc_mesh_clear(); zero on failure
PDMC_NODISCARD pdmc_status pdmc_run_mesh(const pdmc_scalar *study, int level, const pdmc_mesh *before, pdmc_mesh *mesh);
