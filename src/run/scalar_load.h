// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/scalar.h"

/// factor sin(number.x + phase).
typedef struct {
    int dimension;
    double number[2], phase, factor; // 1 / length, radians
} pdmc_wave;

double pdmc_wave_at(const void *wave, const double x[]);
pdmc_wave pdmc_wave_times(const pdmc_wave *wave, double factor);
/// Its values in the places of all values of a space.
void pdmc_wave_fill(const pdmc_wave *wave, const pdmc_space *space, double u[]);

/// What holds the field of a scalar study and pulls at it.
typedef struct {
    const pdmc_scalar *study;
    pdmc_wave wave;      // of length 0 in a study that has none
    double lambda;       // of the wave: of the kernel, or of the classical wave where the horizon varies; 0 without
    pdmc_area_rule half; // for the operator where bonds have a law
} pdmc_scalar_load;

/// @param[out] load  free with pdmc_scalar_load_clear(); zero on failure
PDMC_NODISCARD pdmc_status pdmc_scalar_load_create(const pdmc_scalar *study, const pdmc_scalar_kernel *kernel,
                                                   pdmc_scalar_load *load);
void pdmc_scalar_load_clear(pdmc_scalar_load *load);

/// Adds (b, v) for every free v, with the flux of open sides in a layer of a depth, or on the sides themselves if that is 0.
/// @param[out] out  [free_count]
PDMC_NODISCARD pdmc_status pdmc_scalar_load_add(const pdmc_scalar_load *load, const pdmc_space *space, double depth,
                                                double out[]);

/// Sets the prescribed values of u [count].
void pdmc_scalar_load_prescribe(const pdmc_scalar_load *load, const pdmc_space *space, double u[]);
