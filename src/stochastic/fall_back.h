// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "stochastic/block.h"

/// Solves again, by surer ways, the samples of a block whose iteration did not converge, and notes how.
/// @param[in] count  of the block's samples
PDMC_NODISCARD pdmc_status pdmc_block_fall_back(pdmc_block *block, int count);
