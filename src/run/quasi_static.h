// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/run.h"

/// Brings the bodies of a quasi-static study to rest at one load after the other. Where they do not come to rest the status of
/// the results says so, and they end with the last state of rest.
/// @param[in]     sample   with its factors; NULL: the study as it is
/// @param[in,out] results  described already; gets `particles`
/// @return PDMC_OK (also when stopped early), PDMC_ERR_CONFIG with what the engine refuses, PDMC_ERR_INTERRUPTED when stopped
/// before the first state of rest, or PDMC_ERR_NOMEM
pdmc_status pdmc_run_quasi_static(const pdmc_explicit *study, const pdmc_explicit_sample *sample,
                                  const pdmc_run_options *options, pdmc_results *results);
