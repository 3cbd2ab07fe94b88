// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/solid.h"

#include <math.h>

/// int s^k / (s^2 + D^2)^(3/2) ds for k = 0..3, up to constants.
static void primitives(double s, double distance, double integral[4])
{
    const double length = hypot(s, distance), squared = distance * distance;
    integral[0] = squared > 0.0 ? s / (squared * length) : -0.5 / (s * s);
    integral[1] = -1.0 / length;
    integral[2] = (squared > 0.0 ? asinh(s / distance) : log(s)) - s / length;
    integral[3] = length + squared / length;
}

void pdmc_line_to_point_force(const double strain[3][3], double horizon, double depth, const double across[2],
                              double force[3])
{
    const double distance = hypot(across[0], across[1]), end = sqrt(fmax(0.0, horizon * horizon - distance * distance));
    double low[4], high[4], moment[4];
    force[0] = force[1] = force[2] = 0.0;
    if (end <= depth) return;
    primitives(depth, distance, low);
    primitives(end, distance, high);
    for (int k = 0; k < 4; k++) moment[k] = high[k] - low[k];
    // xi . strain xi = a + b s + c s^2
    const double a = across[0] * (strain[0][0] * across[0] + strain[0][1] * across[1]) +
                     across[1] * (strain[1][0] * across[0] + strain[1][1] * across[1]);
    const double b = 2.0 * (strain[0][2] * across[0] + strain[1][2] * across[1]), c = strain[2][2];
    const double along = a * moment[0] + b * moment[1] + c * moment[2];
    force[0] = across[0] * along;
    force[1] = across[1] * along;
    force[2] = a * moment[1] + b * moment[2] + c * moment[3];
}
