// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/run.h"

/// The part of pdmc_run_cost() that is the method's own: its solution at the mean, and as many samples as the problem says.
pdmc_cost pdmc_collocation_cost(const pdmc_problem *problem, int threads);
pdmc_cost pdmc_bond_cost(const pdmc_problem *problem, int threads);
pdmc_cost pdmc_galerkin_cost(const pdmc_problem *problem, int threads);
