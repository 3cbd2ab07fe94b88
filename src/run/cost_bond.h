// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/run.h"

/// As pdmc_run_cost(), of a grid of bonds.
pdmc_cost pdmc_bond_cost(const pdmc_problem *problem, int threads);
