// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/run.h"

/// Solves the levels of a scalar study one after the other.
/// @param[in,out] results  described already; gets `scalar`
/// @return PDMC_OK (also when stopped after a level), PDMC_ERR_CONFIG (nothing is free), PDMC_ERR_SINGULAR (nothing holds the
/// elements together), PDMC_ERR_INTERRUPTED when stopped before the first level was done, PDMC_ERR_EXTERN, or
/// PDMC_ERR_NOMEM
pdmc_status pdmc_run_scalar(const pdmc_scalar *study, const pdmc_run_options *options, pdmc_results *results);
