// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kansa/kansa_impl.h"

/// Fills the model's crossings: the stretch of every bond that crosses a potential fracture line, as a functional of
/// the model's coordinates.
/// @param[in] coefficients  [model->unknowns, unknowns of the collocation] the field of each coordinate
PDMC_NODISCARD pdmc_status pdmc_kansa_energy(const pdmc_kansa *kansa, const double coefficients[], pdmc_affine *model);
