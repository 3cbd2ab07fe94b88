// SPDX-License-Identifier: GPL-3.0-or-later

/// Two intervals: int int c(x' - x) (u' - u) (v' - v) dx' dx = int c(r) I(r) dr, where I(r) integrates over all x with
/// x in the one and x + r in the other. It is a polynomial of the third degree between the differences of the ends.

#include "galerkin/kernel.h"
#include "galerkin/pair.h"

#include <math.h>

enum { VALUES = 4 }; // two of the other interval, then two of the first

// I(r) of all products, added with a factor: by two Gauss points, as the integrand is quadratic in x.
static void add_products(const pdmc_element *e, const pdmc_element *f, double r, double factor,
                         double sum[VALUES][VALUES])
{
    const double from = fmax(e->corner[0][0], f->corner[0][0] - r), to = fmin(e->corner[1][0], f->corner[1][0] - r);
    for (int point = 0; point < 2 && from < to; point++) {
        const double x[2] = {0.5 * (from + to) + (point ? 0.5 : -0.5) * (to - from) / sqrt(3.0), 0.0};
        double near[PDMC_CORNERS], far[PDMC_CORNERS];
        pdmc_element_coordinates(e, 1, x, near);
        pdmc_element_coordinates(f, 1, (double[2]){x[0] + r, 0.0}, far);
        const double value[VALUES] = {far[0], far[1], -near[0], -near[1]};
        for (int a = 0; a < VALUES; a++)
            for (int b = 0; b < VALUES; b++) sum[a][b] += factor * 0.5 * (to - from) * value[a] * value[b];
    }
}

// c is analytic but at r = 0: 10 points are exact to rounding where r at most doubles, 6 where it grows by a quarter.
static void add_far_piece(const pdmc_pair_rule *rule, const pdmc_element *e, const pdmc_element *f, double from,
                          double to, double sum[VALUES][VALUES])
{
    while (from < to) {
        const double upper = fmin(to, 2.0 * from);
        const int which = upper > 1.25 * from, n = which ? 10 : 6;
        for (int i = 0; i < n; i++) {
            const double r = from + (upper - from) * rule->x[which][i];
            add_products(e, f, r, (upper - from) * rule->w[which][i] * pdmc_scalar_kernel_at(rule->kernel, r), sum);
        }
        from = upper;
    }
}

// From r = 0, where the intervals touch and I goes with r: I / r is quadratic, by its values in three points, and its
// powers are integrated in closed form.
static void add_near_piece(const pdmc_pair_rule *rule, const pdmc_element *e, const pdmc_element *f, double to,
                           double sum[VALUES][VALUES])
{
    double m[3];
    for (int k = 0; k < 3; k++) m[k] = pdmc_kernel_radial(rule->kernel, k + 1, 0.0, to) / pow(to, k);
    // Lagrange's polynomials in r / to for the points 1/3, 2/3 and 1
    const double weight[3] = {3.0 * m[0] - 7.5 * m[1] + 4.5 * m[2], -3.0 * m[0] + 12.0 * m[1] - 9.0 * m[2],
                              m[0] - 4.5 * m[1] + 4.5 * m[2]};
    for (int k = 0; k < 3; k++) {
        const double r = to * (k + 1) / 3.0;
        add_products(e, f, r, weight[k] / r, sum);
    }
}

// One piece of r without a difference of ends in it, cut where the kernel is.
static void add_piece(const pdmc_pair_rule *rule, const pdmc_element *e, const pdmc_element *f, double from, double to,
                      double sum[VALUES][VALUES])
{
    const pdmc_scalar_kernel *kernel = rule->kernel;
    to = fmin(to, kernel->horizon);
    if (from <= 0.0 && to > 0.0) {
        add_near_piece(rule, e, f, to, sum);
        return;
    }
    for (int bin = 0; bin < kernel->bins; bin++)
        add_far_piece(rule, e, f, fmax(from, bin > 0 ? pdmc_kernel_radius(kernel, bin - 1) : 0.0),
                      fmin(to, pdmc_kernel_radius(kernel, bin)), sum);
}

// All pairs of points within one interval: u' - u goes with their distance r, and h - r of the points have one.
static void integrate_same(const pdmc_pair_rule *rule, const pdmc_element *e, pdmc_pair_block *block)
{
    const double h = e->size, to = fmin(h, rule->kernel->horizon);
    const double sum = h * pdmc_kernel_radial(rule->kernel, 2, 0.0, to) - pdmc_kernel_radial(rule->kernel, 3, 0.0, to);
    for (int a = 0; a < 2; a++)
        for (int b = 0; b < 2; b++) block->own[a][b] = e->gradient[a][0] * e->gradient[b][0] * sum;
}

void pdmc_interval_pair(const pdmc_pair_rule *rule, const pdmc_element *element, const pdmc_element *other, bool same,
                        pdmc_pair_block *block)
{
    double sum[VALUES][VALUES] = {{0}};
    *block = (pdmc_pair_block){0};
    if (same) {
        integrate_same(rule, element, block);
        return;
    }
    const double gap = other->corner[0][0] - element->corner[1][0]; // a rounding where they touch
    const double shorter = fmin(element->size, other->size), longer = fmax(element->size, other->size);
    const double touching = 1e-9 * shorter, least = gap > touching ? gap : 0.0;
    const double end[4] = {least, least + shorter, least + longer, least + shorter + longer};
    for (int k = 0; k < 3; k++) add_piece(rule, element, other, end[k], end[k + 1], sum);
    for (int a = 0; a < 2; a++)
        for (int b = 0; b < 2; b++) {
            block->far[a][b] = sum[a][b];
            block->cross[a][b] = sum[a][2 + b];
            block->own[a][b] = sum[2 + a][2 + b];
        }
}
