// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/run.h"

/// Measures every rule at every spacing of a study of quadrature, one after the other on one thread.
/// @param[in,out] results  described already; gets `quadrature`
/// @return PDMC_OK, PDMC_ERR_INTERRUPTED when stopped before all are measured, or PDMC_ERR_NOMEM
pdmc_status pdmc_run_quadrature(const pdmc_horizon_study *study, const pdmc_run_options *options,
                                pdmc_results *results);
