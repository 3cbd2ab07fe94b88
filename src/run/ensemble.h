// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/run.h"

/// An explicit study: its motion with every quantity at its mean, with all records, and where there are random quantities that
/// of every sample, of which its outcome is kept.
///
/// Sample i depends on (seed, i) alone. Samples are shared out to the threads one by one; where there are fewer of them than
/// threads they come one after another, and each has all threads. When stopped, samples under way are given up, and the
/// results hold those up to the first that is missing.
/// @param[in,out] results  described already; gets `particles` and `ensemble`, with their statistics
/// @return as pdmc_run_explicit(); PDMC_ERR_DATA where all samples failed; PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status pdmc_run_ensemble(const pdmc_study *study, const pdmc_run_options *options,
                                             pdmc_results *results);
