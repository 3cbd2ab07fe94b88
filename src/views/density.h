// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The smooth probability density of an energy, beside that of the bins.
///
/// It needs the energies themselves, and so is of the samples whose energies are kept, where the bins count all. It is
/// found where it is shown: a file that held it at some points could not say it at others.

#include "pdmc/results.h"

/// Density by pdmc_statistics_kernel_density() with Silverman's bandwidth, reflected at 0 unless an energy is below it.
/// @param[in]  at       a place of [T, A]
/// @param[in]  energy   [points] where
/// @param[out] density  [points]; NaN where no sample is kept, or their spread cannot be told
/// @return PDMC_OK or PDMC_ERR_NOMEM
pdmc_status pdmc_view_density(const pdmc_results *r, pdmc_measure measure, size_t at, size_t points,
                              const double energy[], pdmc_estimate density[]);
