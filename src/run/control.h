// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/run.h"

/// The problem of the cheaper method, whose first samples are the own ones; it points into the problem.
pdmc_problem pdmc_control_problem(const pdmc_problem *problem, int own_samples);

/// Draws and solves the samples of the cheaper method that problem->control names, and fills results->control with what
/// they say of the results' own. An early stop with no more of them than own samples leaves it empty.
/// @param[in,out] results  summarised, with all samples of the problem
PDMC_NODISCARD pdmc_status pdmc_run_control(const pdmc_problem *problem, const pdmc_run_options *options,
                                            pdmc_results *results);
