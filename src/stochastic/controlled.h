// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What samples of a cheaper method, drawn with the same random numbers, say of a study's own.

#include "pdmc/stochastic.h"

/// Fills results->control but for its advice: the mean of the energy in every direction by regression on the cheaper
/// energy, and the probability of growth by the cheaper event, its threshold G_c times the ratio of the energies at the
/// mean; see pdmc_statistics_control() and pdmc_statistics_stratified_proportion(). Of samples that failed, in either, nothing is known: all is NaN then.
/// @param[in]     cheaper  samples of which the first are those of the results, which keep them all
/// @param[in]     counts   of the cheaper samples, as pdmc_monte_carlo() gives them
/// @param[in,out] results  summarised
/// @return PDMC_OK, PDMC_ERR_NOMEM or PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status pdmc_control_samples(const pdmc_results *cheaper, const pdmc_sample_counts *counts,
                                                pdmc_results *results);

/// How many samples of the cheaper method give the narrowest interval of a mean for the time that these have taken:
/// n sqrt(w R^2 / (1 - R^2)), w the cost of one of the n own samples over that of a cheaper one (Peherstorfer, Willcox &
/// Gunzburger 2016); R that of the direction where the mean plate has its largest energy, of the tip where it is least.
/// @param[in] cost_ratio  w
double pdmc_control_advice(const pdmc_results *results, double cost_ratio);
