// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/galerkin.h"

/// Where bin `bin` ends.
double pdmc_kernel_radius(const pdmc_scalar_kernel *kernel, int bin);

/// int_0^r c(s) s^(m + dimension - 1) ds for r in bin `bin` is
///     scale weight[bin] r^q / q + constant[bin][m],  q = m + dimension - power;
/// `bin` = kernel->bins stands for all r beyond the horizon, where the weight is 0. Returns the constant, which the
/// kernel keeps where q > 0.
double pdmc_kernel_constant(const pdmc_scalar_kernel *kernel, int bin, int m);

/// int_from^to c(r) r^m dr in one dimension, 0 <= from <= to; not finite where m + 1 <= power and from = 0.
double pdmc_kernel_radial(const pdmc_scalar_kernel *kernel, int m, double from, double to);

/// int c |xi|^0, xi, xi xi^T over an element or over its part in the horizon, xi from the centre: one in one dimension.
typedef struct {
    double zero, first[2], second[3]; // second: xx, xy, yy
} pdmc_moments;

/// Adds those of a point at xi with the weight c.
static inline void pdmc_moments_add(const double xi[2], double c, pdmc_moments *moments)
{
    moments->zero += c;
    for (int k = 0; k < 2; k++) moments->first[k] += c * xi[k];
    for (int k = 0; k < 3; k++) moments->second[k] += c * xi[k / 2] * xi[(k + 1) / 2];
}

/// Of the interval [a, b], relative to the centre. Where it contains the centre and power >= 1, the zeroth is not
/// finite.
void pdmc_interval_moments(const pdmc_scalar_kernel *kernel, double a, double b, pdmc_moments *moments);

/// Of the triangle with corners [3, 2] relative to the centre, counter-clockwise. By the edges: each has a wedge with
/// the centre, counted with the sign of its turn, in which the radial integral is in closed form; that over the angle
/// is too, but for the integral of r^-power along the edge, which is by Gauss points where power is neither 0 nor 1.
void pdmc_triangle_moments(const pdmc_scalar_kernel *kernel, double corner[3][2], pdmc_moments *moments);
