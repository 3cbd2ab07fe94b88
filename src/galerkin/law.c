// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/galerkin.h"

#include <math.h>

double pdmc_law_force(const pdmc_bond_law *law, double stretch)
{
    const double t = stretch / law->stretch;
    switch (law->kind) {
    case PDMC_LAW_LINEAR: break;
    case PDMC_LAW_SATURATING: return law->stretch * tanh(t);
    case PDMC_LAW_STIFFENING: return stretch * (1.0 + t * t);
    case PDMC_LAW_SOFTENING: return stretch * exp(-t * t);
    }
    return stretch;
}

double pdmc_law_slope(const pdmc_bond_law *law, double stretch)
{
    const double t = stretch / law->stretch;
    switch (law->kind) {
    case PDMC_LAW_LINEAR: break;
    case PDMC_LAW_SATURATING: return 1.0 / (cosh(t) * cosh(t));
    case PDMC_LAW_STIFFENING: return 1.0 + 3.0 * t * t;
    case PDMC_LAW_SOFTENING: return (1.0 - 2.0 * t * t) * exp(-t * t);
    }
    return 1.0;
}

// ln cosh t, of which the exponential of a large t would overflow.
static double log_cosh(double t)
{
    return fabs(t) + log1p(0.5 * expm1(-2.0 * fabs(t)));
}

double pdmc_law_energy(const pdmc_bond_law *law, double stretch)
{
    const double t = stretch / law->stretch, square = law->stretch * law->stretch;
    switch (law->kind) {
    case PDMC_LAW_LINEAR: break;
    case PDMC_LAW_SATURATING: return square * log_cosh(t);
    case PDMC_LAW_STIFFENING: return 0.5 * stretch * stretch * (1.0 + 0.5 * t * t);
    case PDMC_LAW_SOFTENING: return -0.5 * square * expm1(-t * t);
    }
    return 0.5 * stretch * stretch;
}
