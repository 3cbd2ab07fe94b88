// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "field/field_impl.h"

#include <math.h>

pdmc_status pdmc_field_check_points(const double size[2], int points, const double x[])
{
    const double half = 0.5 * (1.0 + 1e-9);
    for (int i = 0; i < points; i++)
        PDMC_REQUIRE(fabs(x[2 * i]) <= half * size[0] && fabs(x[2 * i + 1]) <= half * size[1],
                     "the point (%g, %g) is outside of the rectangle of %g by %g", x[2 * i], x[2 * i + 1], size[0],
                     size[1]);
    return PDMC_OK;
}

double pdmc_field_sign(int count, const double vector[])
{
    const double equal = 1.0 + 1e-8;
    double largest = 0.0;
    for (int i = 0; i < count; i++)
        if (fabs(vector[i]) > equal * fabs(largest)) largest = vector[i];
    return largest < 0.0 ? -1.0 : 1.0;
}
