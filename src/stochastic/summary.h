// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Single figures of the summary, before it is made.

#include "pdmc/stochastic.h"

/// The share of an event among independent samples that did not fail, with bounds for which a failed one may have been either.
/// @param[in] hits  of the samples that did not fail
pdmc_estimate pdmc_summarise_share(size_t hits, size_t failed, size_t samples, double confidence);

/// P(G > G_c) of a tip, as results->probability will have it.
PDMC_NODISCARD pdmc_status pdmc_summarise_probability(const pdmc_results *results, int tip, pdmc_estimate *probability);

/// The mean and the quantile at p of the energies of the results' measure, as results->statistics will have them.
/// @param[in] counts     as of pdmc_summarise()
/// @param[in] direction  tip * angles + angle
/// At least one sample has not failed.
PDMC_NODISCARD pdmc_status pdmc_summarise_energy(const pdmc_sample_counts *counts, const pdmc_results *results,
                                                 size_t direction, double p, pdmc_estimate *mean,
                                                 pdmc_estimate *quantile);
