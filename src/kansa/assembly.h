// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kansa/kansa_impl.h"

/// Fills the rings' rows, the loads and the mean system.
/// @param[out] matrix  [rows, unknowns] row-major A_0
PDMC_NODISCARD pdmc_status pdmc_kansa_assemble(pdmc_kansa *kansa, const pdmc_kansa_data *data, double matrix[]);
