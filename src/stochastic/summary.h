// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Single figures of the summary, before it is made.

#include "pdmc/stochastic.h"

/// P(G > G_c) of a tip, as results->probability will have it.
PDMC_NODISCARD pdmc_status pdmc_summarise_probability(const pdmc_results *results, int tip, pdmc_estimate *probability);

/// The mean and the quantile at p of the energies of the results' measure, as results->statistics will have them.
/// @param[in] counts     as of pdmc_summarise()
/// @param[in] direction  tip * angles + angle
/// At least one sample has not failed.
PDMC_NODISCARD pdmc_status pdmc_summarise_energy(const pdmc_sample_counts *counts, const pdmc_results *results,
                                                 size_t direction, double p, pdmc_estimate *mean,
                                                 pdmc_estimate *quantile);
