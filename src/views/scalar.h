// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What the views of a scalar study share.

#include "views/views_impl.h"

/// Binary logarithm of the ratio of a number of the level before to that of a level: the order in what is halved. NaN
/// at the first level.
double pdmc_rate_of(const double values[], int level);
