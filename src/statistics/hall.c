// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/hall.h"

#include <math.h>

double pdmc_hall_inverse(double a, double y)
{
    const double root = cbrt(1.0 + a * (y - a / 6.0));       // 1 + a T / 3
    return 3.0 * (y - a / 6.0) / (root * root + root + 1.0); // 3 (root - 1) / a, for a = 0 too
}
