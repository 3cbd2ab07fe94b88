// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "field/polynomials.h"
#include "pdmc/field.h"

/// Functions over the rectangle, each a polynomial plus a combination of directions
///     d(x) = sum_j C(|x - x_j|) weight_j.
typedef struct {
    int count;
    pdmc_polynomials space;
    double *coefficient; // [count, polynomials]

    int directions, sources;
    pdmc_covariance covariance;
    double *source; // [sources, 2]
    double *weight; // [sources, directions]
    double *mix;    // [count, directions]
} pdmc_functions;

/// @param[in]  x      [points, 2]
/// @param[out] value  [points, count]
/// @return PDMC_OK or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_functions_at(const pdmc_functions *functions, int points, const double x[], int threads,
                                             double value[]);

/// sum_j C(|x - x_j|) weight_j at one point, for several columns of weights.
/// @param[in]  source  [sources, 2]
/// @param[in]  weight  [sources, columns]
/// @param[out] value   [columns]
void pdmc_covariance_sum(const pdmc_covariance *covariance, int sources, const double source[], int columns,
                         const double weight[], const double x[2], double value[]);

/// A zeroed one is allowed.
void pdmc_functions_clear(pdmc_functions *functions);
