// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/edge.h"
#include "galerkin/kernel.h"

#include <gsl/gsl_math.h>
#include <math.h>

// ---- intervals ----

static double radial_part(const pdmc_scalar_kernel *kernel, int bin, int m, double from, double to)
{
    const double q = m + 1 - kernel->power;
    const double integral = q == 0.0 ? log(to / from) : (pow(to, q) - pow(from, q)) / q;
    return kernel->scale * kernel->weight[bin] * integral;
}

double pdmc_kernel_radial(const pdmc_scalar_kernel *kernel, int m, double from, double to)
{
    double sum = 0.0;
    for (int bin = 0; bin < kernel->bins; bin++) {
        const double lower = fmax(from, bin > 0 ? pdmc_kernel_radius(kernel, bin - 1) : 0.0);
        const double upper = fmin(to, pdmc_kernel_radius(kernel, bin));
        if (lower < upper) sum += radial_part(kernel, bin, m, lower, upper);
    }
    return sum;
}

// On the side of the centre given by its sign, from a to b, both >= 0.
static void add_side(const pdmc_scalar_kernel *kernel, double sign, double a, double b, pdmc_moments *moments)
{
    moments->zero += pdmc_kernel_radial(kernel, 0, a, b);
    moments->first[0] += sign * pdmc_kernel_radial(kernel, 1, a, b);
    moments->second[0] += pdmc_kernel_radial(kernel, 2, a, b);
}

void pdmc_interval_moments(const pdmc_scalar_kernel *kernel, double a, double b, pdmc_moments *moments)
{
    *moments = (pdmc_moments){0};
    if (b > 0.0) add_side(kernel, 1.0, fmax(0.0, a), b, moments);
    if (a < 0.0) add_side(kernel, -1.0, fmax(0.0, -b), -a, moments);
}

// ---- triangles ----

// int r^-power ds: with s = h sinh v the integrand is h^(1-power) cosh^(1-power) v, analytic up to a distance of pi /
// 2, so that panels of length 1 with 10 points are exact to rounding.
static double gauss_along(double power, double h, double from, double to)
{
    static const double x[5] = {0.1488743389816312, 0.4333953941292472, 0.6794095682990244, 0.8650633666889845,
                                0.9739065285171717};
    static const double w[5] = {0.2955242247147529, 0.2692667193099963, 0.2190863625159821, 0.1494513491505806,
                                0.0666713443086881};
    const double lower = asinh(from / h), upper = asinh(to / h);
    const int panels = (int)ceil(upper - lower);
    const double half = 0.5 * (upper - lower) / panels;
    double sum = 0.0;
    for (int p = 0; p < panels; p++) {
        const double middle = lower + (2 * p + 1) * half;
        for (int i = 0; i < 5; i++)
            sum += w[i] * (pow(cosh(middle - half * x[i]), 1.0 - power) + pow(cosh(middle + half * x[i]), 1.0 - power));
    }
    return pow(h, 1.0 - power) * half * sum;
}

// int r^-power ds.
static double integrate_along(double power, double h, double from, double to, const double r[2])
{
    if (power == 0.0) return to - from;
    if (power == 1.0) return pdmc_asinh_difference(h, from, to, r);
    return gauss_along(power, fabs(h), from, to);
}

static double power_of(double r, double exponent)
{
    return exponent == 1.0 ? r : exponent == 2.0 ? r * r : pow(r, exponent);
}

// The part of the wedge below the line where the radius is in one bin: int h x^m r^-power ds, over q. What int s^2
// r^-power ds is follows from the derivative of s r^(2 - power).
static void add_power(const pdmc_scalar_kernel *kernel, int bin, const pdmc_edge *l, double from, double to,
                      pdmc_moments *moments)
{
    const double p = kernel->power, h = l->h, factor = kernel->scale * kernel->weight[bin] * h;
    const double by[3] = {1.0 / (2.0 - p), 1.0 / (3.0 - p), 1.0 / (4.0 - p)};
    const double r[2] = {sqrt(from * from + h * h), sqrt(to * to + h * h)};
    const double root[2] = {power_of(r[0], 2.0 - p), power_of(r[1], 2.0 - p)};
    const double i0 = integrate_along(p, h, from, to, r), i1 = by[0] * (root[1] - root[0]);
    const double i2 = by[1] * (to * root[1] - from * root[0] - h * h * i0);
    const double *n = l->n, *t = l->t, first = by[1] * factor, second = by[2] * factor;
    moments->zero += by[0] * factor * i0;
    for (int k = 0; k < 2; k++) moments->first[k] += first * (h * n[k] * i0 + t[k] * i1);
    for (int k = 0; k < 3; k++) {
        const int i = k / 2, j = (k + 1) / 2; // xx, xy, yy
        moments->second[k] +=
            second * (h * h * n[i] * n[j] * i0 + h * (n[i] * t[j] + n[j] * t[i]) * i1 + t[i] * t[j] * i2);
    }
}

// ... and the rest of the radial integral, which does not depend on the radius: int e^m dtheta times it.
static void add_constant(const pdmc_scalar_kernel *kernel, int bin, const pdmc_edge *l, double from, double to,
                         pdmc_moments *moments)
{
    double e[2][2];
    pdmc_edge_direction(l, from, e[0]);
    pdmc_edge_direction(l, to, e[1]);
    const double angle = pdmc_turn(e[0], e[1]);
    const double *constant = kernel->constant[bin];
    const double product = e[1][0] * e[1][1] - e[0][0] * e[0][1];
    moments->zero += constant[0] * angle;
    moments->first[0] += constant[1] * (e[1][1] - e[0][1]);
    moments->first[1] += constant[1] * (e[0][0] - e[1][0]);
    moments->second[0] += 0.5 * constant[2] * (angle + product);
    moments->second[1] += 0.5 * constant[2] * (e[1][1] * e[1][1] - e[0][1] * e[0][1]);
    moments->second[2] += 0.5 * constant[2] * (angle - product);
}

static void add_piece(const pdmc_scalar_kernel *kernel, int bin, const pdmc_edge *l, double from, double to,
                      pdmc_moments *moments)
{
    if (from >= to) return;
    if (bin < kernel->bins) add_power(kernel, bin, l, from, to, moments);
    if (bin > 0) add_constant(kernel, bin, l, from, to, moments);
}

static void add_edge(const pdmc_scalar_kernel *kernel, const pdmc_edge *l, pdmc_moments *moments)
{
    if (l->h == 0.0) return; // the wedge is empty
    double inner = 0.0;
    for (int bin = 0; bin <= kernel->bins; bin++) {
        const double outer = bin < kernel->bins ? pdmc_half_chord(pdmc_kernel_radius(kernel, bin), l->h) : INFINITY;
        if (inner == 0.0) {
            add_piece(kernel, bin, l, fmax(l->from, -outer), fmin(l->to, outer), moments);
        } else {
            add_piece(kernel, bin, l, fmax(l->from, -outer), fmin(l->to, -inner), moments);
            add_piece(kernel, bin, l, fmax(l->from, inner), fmin(l->to, outer), moments);
        }
        inner = outer;
    }
}

void pdmc_triangle_moments(const pdmc_scalar_kernel *kernel, double corner[3][2], pdmc_moments *moments)
{
    pdmc_edge edge[3];
    *moments = (pdmc_moments){0};
    for (int i = 0; i < 3; i++) {
        edge[i] = pdmc_edge_of(corner[i], corner[(i + 1) % 3]);
        if (edge[i].h <= -kernel->horizon) return; // the disc lies on its other side
    }
    for (int i = 0; i < 3; i++) add_edge(kernel, &edge[i], moments);
}
