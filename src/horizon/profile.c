// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/horizon.h"

double pdmc_profile_at(pdmc_profile profile, int dimension, double radius, double r)
{
    const double s = r / radius, fall = 1.0 - s * s;
    if (s > 1.0) return 0.0;
    // int s^d ds over int s^d g ds, [0, 1]
    switch (profile) {
    case PDMC_PROFILE_CONSTANT: break;
    case PDMC_PROFILE_CONE: return (dimension == 3 ? 5.0 : 4.0) * (1.0 - s);
    case PDMC_PROFILE_BELL: return (dimension == 3 ? 6.0 : 35.0 / 8.0) * fall * fall;
    }
    return 1.0;
}
