// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kansa/response.h"

/// Fills the model's crossings: the stretch of every bond that crosses a potential fracture line, as a functional of the
/// coordinates of the response space.
PDMC_NODISCARD pdmc_status pdmc_kansa_energy(const pdmc_kansa *kansa, const pdmc_response *response,
                                             pdmc_affine *model);
