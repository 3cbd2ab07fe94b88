// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The mean of independent values >= 0 that may be skewed, taken in one by one.

#include "pdmc/reliability.h"

typedef struct {
    long count, positive; // values, and those that are not 0
    double unit;          // the first of these: powers of values / unit neither overflow nor vanish
    double sum, squares, cubes, largest;
} pdmc_average;

void pdmc_average_add(pdmc_average *average, double x);

/// NaN without values.
double pdmc_average_value(const pdmc_average *average);

/// The mean's coefficient of variation; NaN where all are 0 and with less than two values.
double pdmc_average_variation(const pdmc_average *average);

/// (sum x)^2 / sum x^2; 0 where all are 0.
double pdmc_average_effective(const pdmc_average *average);

/// max x^2 / sum x^2; NaN where all are 0.
double pdmc_average_largest_share(const pdmc_average *average);

/// The mean's interval after Hall (1992): with T = (mean - mu) / s, n values and their skewness k,
///     T + k T^2 / 3 + k^2 T^3 / 27 + k / (6 n)
/// is without skewness to second order, and increases with T. It is taken to have Student's quantiles / sqrt(n). [0, inf] with
/// less than three values.
pdmc_estimate pdmc_average_interval(const pdmc_average *average, double confidence);

/// What two averages say of a probability: that of what was an event, and that of what may have been one.
void pdmc_average_report(const pdmc_average *events, const pdmc_average *possible, double confidence,
                         pdmc_reliability *result);

/// The reliability index of a probability and its bounds.
pdmc_estimate pdmc_reliability_index(pdmc_estimate probability);
