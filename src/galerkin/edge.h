// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <math.h>

/// An edge as a centre sees it: on the line at the signed distance h, whose points are h n + s t, from s = from to s = to.
/// n turned by a right angle is t.
typedef struct {
    double n[2], t[2], h, from, to;
} pdmc_edge;

/// The edge from a to b, relative to the centre; its wedge with the centre is empty where h is 0, as for a = b.
static inline pdmc_edge pdmc_edge_of(const double a[2], const double b[2])
{
    const double d[2] = {b[0] - a[0], b[1] - a[1]}, length = sqrt(d[0] * d[0] + d[1] * d[1]);
    if (length == 0.0) return (pdmc_edge){0};
    pdmc_edge edge = {.t = {d[0] / length, d[1] / length}};
    edge.n[0] = edge.t[1];
    edge.n[1] = -edge.t[0];
    edge.h = a[0] * edge.n[0] + a[1] * edge.n[1];
    edge.from = a[0] * edge.t[0] + a[1] * edge.t[1];
    edge.to = edge.from + length;
    return edge;
}

/// Half of the chord that a circle about the centre cuts from the line.
static inline double pdmc_half_chord(double radius, double h)
{
    return sqrt(fmax(0.0, (radius - h) * (radius + h)));
}

/// The direction of the point at s.
static inline void pdmc_edge_direction(const pdmc_edge *edge, double s, double e[2])
{
    const double r = sqrt(edge->h * edge->h + s * s);
    for (int d = 0; d < 2; d++) e[d] = (edge->h * edge->n[d] + s * edge->t[d]) / r;
}

/// The angle by which one direction is turned into another.
static inline double pdmc_turn(const double from[2], const double to[2])
{
    return atan2(from[0] * to[1] - from[1] * to[0], from[0] * to[0] + from[1] * to[1]);
}

/// asinh(to / h) - asinh(from / h) by one logarithm: of (to + r) / (from + r) with the radii r, on the side where nothing
/// cancels.
static inline double pdmc_asinh_difference(double h, double from, double to, const double r[2])
{
    if (to <= 0.0) return pdmc_asinh_difference(h, -to, -from, (double[2]){r[1], r[0]});
    if (from < 0.0) return log((to + r[1]) * (r[0] - from) / (h * h));
    return log1p((to - from) * (r[0] + r[1] + to + from) / ((r[0] + r[1]) * (from + r[0])));
}
