// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/particles.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

double pdmc_brittle_micromodulus(int dimension, pdmc_assumption assumption, double youngs_modulus, double horizon,
                                 double thickness)
{
    const double area = pi * horizon * horizon * horizon;
    if (dimension == 3) return 12.0 * youngs_modulus / (area * horizon);
    if (assumption == PDMC_PLANE_STRESS) return 9.0 * youngs_modulus / (area * thickness);
    return 48.0 * youngs_modulus / (5.0 * area * thickness);
}

double pdmc_brittle_critical_stretch(int dimension, double fracture_energy, double micromodulus, double horizon,
                                     double thickness)
{
    const double squared = horizon * horizon, fourth = squared * squared;
    if (dimension == 3) return sqrt(10.0 * fracture_energy / (pi * micromodulus * fourth * horizon));
    return sqrt(4.0 * fracture_energy / (micromodulus * thickness * fourth));
}
