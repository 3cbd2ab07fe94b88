// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/problem.h"

/// The factor L of the normal variables g = L w behind a fracture energy that varies in space, at the tips: L L' holds the
/// covariance at their distances. Triangular, so that a tip more leaves those before it as they are, and the first column is
/// all that is left where the correlation is full. Correlations are lowered by 1e-12 of themselves for every tip, so that
/// also a matrix that is singular to rounding, of tips that are close, has its factor.
/// @param[in]  value   [PDMC_SCALARS] of the scalar quantities, which may place the cracks
/// @param[out] factor  [tips, tips]
/// @return PDMC_OK, PDMC_ERR_NOMEM, or PDMC_ERR_ARG
PDMC_NODISCARD pdmc_status pdmc_toughness_factor(const pdmc_problem *problem, const double value[], double factor[]);
