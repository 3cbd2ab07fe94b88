// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/results.h"

/// Fills the statistics of results->ensemble from its samples, with intervals at results->confidence: Clopper & Pearson's of the
/// shares of the outcomes, Student's of means, distribution-free ones of quantiles.
/// @return PDMC_OK, PDMC_ERR_DATA (all samples failed) or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_ensemble_summarise(pdmc_results *results);
