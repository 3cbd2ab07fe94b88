// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/geometry.h"

#include <math.h>

// Twice the signed area of the triangle abc: positive where c lies to the left of a -> b.
static double orientation(const double a[2], const double b[2], const double c[2])
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// For c on the line through a and b.
static bool lies_between(const double a[2], const double b[2], const double c[2])
{
    return fmin(a[0], b[0]) <= c[0] && c[0] <= fmax(a[0], b[0]) && fmin(a[1], b[1]) <= c[1] && c[1] <= fmax(a[1], b[1]);
}

static bool on_opposite_sides(double s, double t)
{
    return (s > 0.0 && t < 0.0) || (s < 0.0 && t > 0.0);
}

bool pdmc_segments_cross(const double p[2], const double q[2], const double a[2], const double b[2])
{
    const double op = orientation(a, b, p), oq = orientation(a, b, q);
    const double oa = orientation(p, q, a), ob = orientation(p, q, b);
    if (on_opposite_sides(op, oq) && on_opposite_sides(oa, ob)) return true;
    return (op == 0.0 && lies_between(a, b, p)) || (oq == 0.0 && lies_between(a, b, q)) ||
           (oa == 0.0 && lies_between(p, q, a)) || (ob == 0.0 && lies_between(p, q, b));
}

double pdmc_point_segment_distance(const double p[2], const double a[2], const double b[2])
{
    const double d[2] = {b[0] - a[0], b[1] - a[1]}, length2 = d[0] * d[0] + d[1] * d[1];
    const double along = length2 > 0.0 ? ((p[0] - a[0]) * d[0] + (p[1] - a[1]) * d[1]) / length2 : 0.0;
    const double t = fmin(fmax(along, 0.0), 1.0);
    return hypot(p[0] - a[0] - t * d[0], p[1] - a[1] - t * d[1]);
}
