// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/galerkin.h"

#include <gsl/gsl_math.h>
#include <math.h>

// All by one exponential that does not overflow: tanh, its derivative, and ln cosh.
static pdmc_law_value saturating(double stretch, double most)
{
    const double t = fabs(stretch) / most, e = exp(-2.0 * t), sum = 1.0 + e;
    return (pdmc_law_value){.force = copysign(-most * expm1(-2.0 * t) / sum, stretch),
                            .slope = 4.0 * e / (sum * sum),
                            .energy = most * most * (t + log(0.5 * sum))};
}

static pdmc_law_value softening(double stretch, double scale)
{
    const double square = gsl_pow_2(stretch / scale), e = exp(-square);
    return (pdmc_law_value){
        .force = stretch * e, .slope = (1.0 - 2.0 * square) * e, .energy = 0.5 * scale * scale * (1.0 - e)};
}

pdmc_law_value pdmc_law_at(const pdmc_bond_law *law, double stretch)
{
    const double half = 0.5 * stretch * stretch, square = gsl_pow_2(stretch / law->stretch);
    switch (law->kind) {
    case PDMC_LAW_LINEAR: break;
    case PDMC_LAW_SATURATING: return saturating(stretch, law->stretch);
    case PDMC_LAW_STIFFENING:
        return (pdmc_law_value){stretch * (1.0 + square), 1.0 + 3.0 * square, half * (1.0 + 0.5 * square)};
    case PDMC_LAW_SOFTENING: return softening(stretch, law->stretch);
    }
    return (pdmc_law_value){stretch, 1.0, half};
}
