// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/grid.h"

#include <math.h>

// Where a point is from the crack's "from", along the crack and to the left of it.
typedef struct {
    double along, left; // length
} crack_place;

static crack_place place(const pdmc_crack *crack, const double t[2], double slack, const double x[2])
{
    const double d[2] = {x[0] - crack->from[0], x[1] - crack->from[1]}, left = t[0] * d[1] - t[1] * d[0];
    return (crack_place){t[0] * d[0] + t[1] * d[1], fabs(left) <= slack ? 0.0 : left};
}

bool pdmc_bond_is_cut(const pdmc_crack *crack, double scale, const double a[2], const double b[2])
{
    const double d[2] = {crack->to[0] - crack->from[0], crack->to[1] - crack->from[1]};
    const double length = hypot(d[0], d[1]), t[2] = {d[0] / length, d[1] / length}, slack = 1e-9 * scale;
    const crack_place p = place(crack, t, slack, a), q = place(crack, t, slack, b);
    if ((p.left < 0.0) == (q.left < 0.0)) return false;
    // From the left to the right whichever way the bond is given, so that both give the same to the last bit.
    const crack_place left = p.left < 0.0 ? q : p, right = p.left < 0.0 ? p : q;
    const double along = left.along + left.left / (left.left - right.left) * (right.along - left.along);
    return -slack <= along && along <= length + slack;
}
