// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/run.h"

/// Moves the bodies of an explicit study from record to record, and keeps snapshots. Where a step cannot be taken the status
/// of the results says so, and they end with the last state before it.
/// @param[in]     sample   with its factors; NULL: the study as it is
/// @param[in,out] results  described already; gets `particles`
/// @return PDMC_OK (also when stopped early), PDMC_ERR_CONFIG with what the engine refuses, PDMC_ERR_INTERRUPTED when stopped
/// before the first step, or PDMC_ERR_NOMEM
pdmc_status pdmc_run_explicit(const pdmc_explicit *study, const pdmc_explicit_sample *sample,
                              const pdmc_run_options *options, pdmc_results *results);
