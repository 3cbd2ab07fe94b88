// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "stochastic/block.h"

/// Solves each of the block's samples on the model of its own plate, with its energies. The samples are shared out to
/// the family's threads, since such a sample costs far more than the others. One without a plate or without a model of
/// it is marked.
PDMC_NODISCARD pdmc_status pdmc_block_solve_own_plates(pdmc_block *block, int count);
