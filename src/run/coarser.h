// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/problem.h"

/// Changes the options of a problem's solver to a discretisation about 1.25 times as coarse, to estimate errors by.
/// A grid of bonds keeps its horizon, and the parity of its rows, on which it depends where a crack runs.
/// @return false where the plate has no coarser grid of square cells
bool pdmc_make_coarser(pdmc_problem *problem);
