// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/elastic.h"
#include "pdmc/results.h"
#include "pdmc/stochastic.h"

/// Brings the body of an elastic study to rest and records it.
/// @return PDMC_OK, PDMC_ERR_CONFIG with what pdmc_solid_create() refuses, PDMC_ERR_INTERRUPTED, PDMC_ERR_SINGULAR where it
///         does not come to rest, or PDMC_ERR_NOMEM
pdmc_status pdmc_run_elastic(const pdmc_elastic *study, const pdmc_run_options *options, pdmc_results *results);
