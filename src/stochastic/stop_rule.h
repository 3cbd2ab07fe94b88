// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// When there are samples enough: sampling goes on in rounds until the interval of the target is narrow enough (Chow &
/// Robbins 1965). Every round but the last that is allowed ends with a whole number of the samples that are solved and counted
/// together, and with as many in each replicate of a design.

#include "pdmc/stochastic.h"

/// The samples of the first round, in whole numbers of those that are `together`, and of the last that is allowed. Both are the study's own where it has no target.
int pdmc_stop_rule_first(const pdmc_problem *problem, int together);
int pdmc_stop_rule_most(const pdmc_problem *problem);

/// How well the target is known at the tip where it is known worst.
/// @param[in] counts  as of pdmc_summarise()
/// @return PDMC_OK or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_stop_rule_judge(const pdmc_problem *problem, const pdmc_sample_counts *counts,
                                                const pdmc_results *results, pdmc_round *round);

/// The samples of the next round, in all: as many as the last one says, but at least a tenth more and at most twice as many,
/// since what it says is no better known than the deviation.
int pdmc_stop_rule_next(const pdmc_problem *problem, int together, const pdmc_round *round);
