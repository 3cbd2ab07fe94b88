// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scalar.h"

#include <math.h>

double pdmc_rate_of(const double values[], int level)
{
    return level > 0 ? log2(values[level - 1] / values[level]) : NAN;
}
