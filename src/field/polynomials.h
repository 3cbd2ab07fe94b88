// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/quadrature.h"

/// Products of Legendre polynomials over a rectangle that is centred at the origin, orthonormal in L2:
///     p_mn(x, y) = p_m(x) p_n(y),   p_m(x) = sqrt((2 m + 1) / width) P_m(2 x / width),
/// in the order p_00, p_01, ..., with the degree in y running fastest.
typedef struct {
    double size[2]; // width, height
    int degree[2];  // the highest in x and in y, <= PDMC_HIGHEST_DEGREE
} pdmc_polynomials;

enum { PDMC_HIGHEST_DEGREE = 499 };

/// How many there are, (degree[0] + 1) (degree[1] + 1).
int pdmc_polynomials_count(const pdmc_polynomials *space);

/// p_0, ..., p_degree at x in [-length / 2, length / 2], by the three-term recurrence.
/// @param[out] value  [degree + 1]
void pdmc_legendre(int degree, double length, double x, double value[]);

/// All of them at points.
/// @param[in]  x      [points, 2]
/// @param[out] value  [points, count]
void pdmc_polynomials_at(const pdmc_polynomials *space, int points, const double x[], double value[]);

/// Gauss' rule of degree + 1 points in each direction, by which the polynomials are orthonormal.
/// @param[out] rule  free with pdmc_area_rule_clear(); zero on failure
/// @return PDMC_OK or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_polynomials_rule(const pdmc_polynomials *space, pdmc_area_rule *rule);
