// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/stochastic.h"
#include "stochastic/variables.h"

/// Fills results->reliability as the problem asks: the design point, the probability that a tip grows by each method, and
/// the quantities that its margin comes from. A stop that progress asks for leaves out what is not done, and marks the
/// results as interrupted.
/// @param[in] model  that samples are solved by: `full`, or one reduced from it
PDMC_NODISCARD pdmc_status pdmc_rare_event(const pdmc_variables *variables, const pdmc_affine *model,
                                           const pdmc_affine *full, const pdmc_run_options *options,
                                           pdmc_results *results);
