// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What the errors of a reduced model's samples can do to their statistics.

#include "pdmc/results.h"

/// Bounds of how far the mean and the quantiles of an energy, in any direction, may be from those of the same samples
/// solved in full, over the mean of the largest energy; the worst of all tips.
///
/// sqrt(G) of every direction is off by at most delta. With the largest energy G of each sample, a mean is then off by
/// at most mean(2 sqrt(G) delta + delta^2). A quantile is an order statistic, so that its root is off by at most the
/// largest delta D: Q by at most 2 sqrt(Q) D + D^2, most where Q is that of the largest energy.
/// @param[in]  delta           [samples] of the measure
/// @param[out] scratch         [samples]
/// @param[out] mean_error      NaN where all samples failed
/// @param[out] quantile_error  [PDMC_QUANTILES] at pdmc_quantile_levels
void pdmc_model_error(const pdmc_results *results, pdmc_measure measure, const double delta[], double scratch[],
                      double *mean_error, double quantile_error[]);
