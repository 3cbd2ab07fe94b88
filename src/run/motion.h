// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/discretisation.h"
#include "pdmc/stochastic.h"

/// Integrates the motion of a dynamic problem and records it in results->motion. `options->progress` is called after
/// every step; where it asks for an early stop, the results hold the steps up to then.
/// @return PDMC_OK (also when stopped early), PDMC_ERR_CONFIG where the discretisation has no motion,
/// PDMC_ERR_SINGULAR, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status pdmc_run_motion(const pdmc_problem *problem, const pdmc_discretisation *plate,
                                           const pdmc_run_options *options, pdmc_results *results);
