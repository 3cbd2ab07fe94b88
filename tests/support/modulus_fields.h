// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Factors M(x) on Young's modulus, in the form that finite_element_plate takes.

#include <math.h>

/// M = 1 + gradient . x
typedef struct {
    double gradient[2];
} linear_modulus;

static inline double linear_modulus_at(const void *context, const double x[2])
{
    const linear_modulus *m = context;
    return 1.0 + m->gradient[0] * x[0] + m->gradient[1] * x[1];
}

/// M = 1 + amplitude cos(2 pi x / length + phase_0) cos(2 pi y / length + phase_1)
typedef struct {
    double amplitude, length, phase[2];
} wave_modulus;

static inline double wave_modulus_at(const void *context, const double x[2])
{
    const wave_modulus *m = context;
    const double k = 2.0 * acos(-1.0) / m->length;
    return 1.0 + m->amplitude * cos(k * x[0] + m->phase[0]) * cos(k * x[1] + m->phase[1]);
}
