// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/scalar.h"

/// Makes the mesh of the level before that of this one: finer where the spacing varies, otherwise the same. Cells are made
/// anew; each triangle becomes four, so that the domain does not change.
/// @param[in,out] mesh  zero at the first level; stays the caller's after a failure too
PDMC_NODISCARD pdmc_status pdmc_run_next_mesh(const pdmc_scalar *study, int level, pdmc_mesh *mesh);
