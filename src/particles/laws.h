// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A material as the kernels want it.

#include "pdmc/particles.h"

typedef struct {
    double micromodulus, critical_stretch, strengthening;
    double fibre[PDMC_AXES]; // unit vector
    double fibre_excess;     // c along it over c, less 1; 0: all directions are alike
    const double *strengths; // [PDMC_STRENGTH_CLASSES] factors of s_0, by the hash of a bond; NULL: all 1
} pdmc_brittle_law;
