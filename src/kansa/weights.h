// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kansa/kansa_impl.h"

/// Fills the model's weights of the bins of c(r), after its bins and radial terms, of which there is one a ring or none.
PDMC_NODISCARD pdmc_status pdmc_kansa_weights(const pdmc_kansa *kansa, pdmc_affine *model);
