// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A limit state: what may happen, as a function of independent standard normal variables z. It has happened where g(z) > 0.
/// Reliability methods see nothing else of a study.

#include "pdmc/base.h"

typedef struct {
    int dimension; // of z, >= 1
    /// g of many points, in any number of threads; a point's value depends on the point alone, to the bit.
    /// @param[in]  z  [count, dimension]
    /// @param[out] g  [count] finite; NaN where a point cannot be solved
    pdmc_status (*evaluate)(void *context, int count, const double z[], double g[]);
    void *context;
} pdmc_limit_state;
