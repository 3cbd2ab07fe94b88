// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/field.h"

/// Says what is wrong with the parameters.
PDMC_NODISCARD pdmc_status pdmc_covariance_check(const pdmc_covariance *covariance);

/// Says which point is outside of the rectangle by more than rounding.
PDMC_NODISCARD pdmc_status pdmc_field_check_points(const double size[2], int points, const double x[]);

/// 1 or -1, by which an eigenvector is multiplied so that its largest component is positive; of components that are
/// equally large to rounding, the first.
double pdmc_field_sign(int count, const double vector[]);
