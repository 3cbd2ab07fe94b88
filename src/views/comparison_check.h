// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/comparison.h"

/// Refuses what cannot be compared: different units, or a dynamic study with a static one.
/// @return PDMC_OK or PDMC_ERR_DATA
pdmc_status pdmc_comparison_check(const pdmc_comparison *c);

/// Writes what makes the two studies differ besides their method, a line each.
void pdmc_comparison_remark(const pdmc_comparison *c, FILE *notes);
