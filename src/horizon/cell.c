// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/horizon.h"

#include <math.h>
#include <string.h>

/// x - sin x, 0 <= x <= 2 pi, without cancellation.
static double less_sine(double x)
{
    if (x > 1.0) return x - sin(x);
    double sum = 0.0, term = x * x * x / 6.0;
    for (int n = 4; fabs(term) > 1e-18 * sum; n += 2) {
        sum += term;
        term *= -x * x / (n * (n + 1));
    }
    return sum;
}

/// The area between a small circle's arc and the great circle through its ends, on the unit sphere: 2 atan(k tan(phi /
/// 2)) - k phi, with the arc's angle phi and its plane at the distance k from the centre.
static double sliver(double k, double square, double half_tangent)
{
    const double t = half_tangent, less = square / (1.0 + k); // 1 - k, from 1 - k^2
    if (t > 0.5) return 2.0 * (less * atan(t) - atan2(less * t, 1.0 + k * t * t));
    double sum = 0.0, power = k * t * t * t, even = k * k, part = square;
    for (int n = 3; n < 60 && power * part > 1e-18 * fabs(sum); n += 2) {
        sum += (n & 2 ? 1.0 : -1.0) * power * part / n;
        part = part + even * square; // 1 - k^(n + 1)
        even *= k * k;
        power *= t * t;
    }
    return 2.0 * sum;
}

// A face of a box, or a rectangle, in the quadrant of positive coordinates, seen from its lower corner: lengths are
// small and exact there, where coordinates lose them in rounding.
typedef struct {
    double corner[2], size[2];
    double depth; // r^2 - corner^2, of the circle round the origin that cuts it
} face;

// What the circle leaves of it.
typedef struct {
    double area, moment;      // moment: of r^2 - x^2 - y^2
    bool has_arc;             // that goes through the face's inside
    double left[2], right[2]; // its ends, from the corner: the one with the smaller x first
    double half_tangent;      // of half its angle
} quadrant;

/// How far the circle is from the corner along one axis: sqrt(x^2 + depth) - x.
static double reach(double x, double depth)
{
    return depth / (x + sqrt(x * x + depth));
}

/// The depth at the far end of a side.
static double depth_beyond(const face *f, int axis)
{
    return f->depth - f->size[axis] * (2.0 * f->corner[axis] + f->size[axis]);
}

/// int (depth - 2 x t - t^2) dt over [0, length].
static double below_arc(double depth, double x, double length)
{
    return length * (depth - length * (x + length / 3.0));
}

static void find_arc(const face *f, quadrant *q)
{
    double *const ends[2] = {q->right, q->left};
    for (int a = 0; a < 2; a++) {
        const int b = 1 - a;
        const double along = reach(f->corner[a], f->depth);
        const bool is_cut = along > f->size[a];
        ends[a][a] = is_cut ? f->size[a] : along;
        ends[a][b] = is_cut ? reach(f->corner[b], depth_beyond(f, a)) : 0.0;
    }
    const double half_chord = 0.5 * hypot(q->right[0] - q->left[0], q->left[1] - q->right[1]);
    const double square = f->depth + f->corner[0] * f->corner[0] + f->corner[1] * f->corner[1];
    q->half_tangent = half_chord / sqrt(fmax(0.0, square - half_chord * half_chord));
}

/// The divergence theorem for x (r^2 - x^2), which has no part on the arc: twice the sides' distances times their
/// integrals.
static double moment_of(const face *f, const quadrant *q, double square)
{
    double sides = 0.0;
    const double *const ends[2] = {q->right, q->left};
    for (int a = 0; a < 2; a++) {
        const int b = 1 - a;
        const double near_end = q->has_arc ? ends[b][b] : f->size[b];
        const double far_end = !q->has_arc ? f->size[b] : ends[a][a] < f->size[a] ? 0.0 : ends[a][b];
        sides -= f->corner[a] * below_arc(f->depth, f->corner[b], near_end);
        sides += (f->corner[a] + f->size[a]) * below_arc(depth_beyond(f, a), f->corner[b], far_end);
    }
    return 0.25 * (2.0 * square * q->area + sides);
}

static quadrant cut_face(const face *f)
{
    quadrant q = {0};
    if (!(f->depth > 0.0)) return q;
    const double square = f->depth + f->corner[0] * f->corner[0] + f->corner[1] * f->corner[1];
    q.has_arc = depth_beyond(f, 0) < f->size[1] * (2.0 * f->corner[1] + f->size[1]);
    q.area = f->size[0] * f->size[1];
    if (q.has_arc) {
        find_arc(f, &q);
        q.area = q.left[0] * f->size[1] + 0.5 * (q.left[1] + q.right[1]) * (q.right[0] - q.left[0]) +
                 0.5 * square * less_sine(2.0 * atan(q.half_tangent));
    }
    q.moment = moment_of(f, &q, square);
    return q;
}

// The part of the sphere inside a box of the octant of positive coordinates, as its boundary is followed. Points are
// relative to the box's lower corner.
typedef struct {
    const double *corner;
    double radius, area; // area: a solid angle
    bool has_apex;
    double apex[3]; // of the spherical triangles
} patch;

/// The solid angle of the triangle apex, b, c, all at the distance `radius` (van Oosterom and Strackee).
static double triangle(const patch *p, const double b[3], const double c[3])
{
    double x[3], y[3], z[3], u[3], v[3], xy = 0.0, yz = 0.0, zx = 0.0;
    for (int i = 0; i < 3; i++) {
        x[i] = p->corner[i] + p->apex[i];
        y[i] = p->corner[i] + b[i];
        z[i] = p->corner[i] + c[i];
        u[i] = b[i] - p->apex[i];
        v[i] = c[i] - p->apex[i];
        xy += x[i] * y[i];
        yz += y[i] * z[i];
        zx += z[i] * x[i];
    }
    const double product =
        x[0] * (u[1] * v[2] - u[2] * v[1]) + x[1] * (u[2] * v[0] - u[0] * v[2]) + x[2] * (u[0] * v[1] - u[1] * v[0]);
    return 2.0 * atan2(product, p->radius * (p->radius * p->radius + xy + yz + zx));
}

/// An arc on a face x[axis] = corner + height. Seen from outside the boundary of the patch turns from axis + 1 to axis
/// + 2 on a lower face, and back on an upper one.
static void follow_arc(patch *p, const quadrant *q, int axis, double height)
{
    const bool is_upper = height > 0.0;
    const double *const from = is_upper ? q->left : q->right, *const to = is_upper ? q->right : q->left;
    double start[3], end[3];
    const int next = (axis + 1) % 3, last = (axis + 2) % 3;
    start[axis] = end[axis] = height;
    start[next] = from[0];
    start[last] = from[1];
    end[next] = to[0];
    end[last] = to[1];
    if (!p->has_apex) memcpy(p->apex, start, sizeof start);
    p->has_apex = true;
    const double k = (p->corner[axis] + height) / p->radius;
    const double between = sliver(k, (1.0 - k) * (1.0 + k), q->half_tangent);
    p->area += triangle(p, start, end) + (is_upper ? -between : between);
}

/// In the octant of positive coordinates. The sphere is met as the plane u + v + w = radius^2 by the box of squares:
/// its part inside is a polygon of at most six sides.
static double cut_octant(const double corner[3], const double size[3], double radius, double moment[3])
{
    patch p = {.corner = corner, .radius = radius};
    double faces = 0.0, towards = 0.0;
    const double depth = (radius - corner[2]) * (radius + corner[2]) - corner[0] * corner[0] - corner[1] * corner[1];
    for (int a = 0; a < 3; a++) {
        const int next = (a + 1) % 3, last = (a + 2) % 3;
        face f = {{corner[next], corner[last]}, {size[next], size[last]}, depth};
        const quadrant lower = cut_face(&f);
        f.depth -= size[a] * (2.0 * corner[a] + size[a]);
        const quadrant upper = cut_face(&f);
        if (lower.has_arc) follow_arc(&p, &lower, a, 0.0);
        if (upper.has_arc) follow_arc(&p, &upper, a, size[a]);
        faces += size[a] * upper.area;
        towards += corner[a] * (lower.area - upper.area);
        moment[a] = 0.5 * (lower.moment - upper.moment);
    }
    return fmax(0.0, (faces + (radius * radius * radius * p.area - towards)) / 3.0);
}

static double cut_quadrant(const double corner[3], const double size[3], double radius, double moment[3])
{
    const double depth = (radius - corner[1]) * (radius + corner[1]) - corner[0] * corner[0];
    const face f = {{corner[0], corner[1]}, {size[0], size[1]}, depth};
    const quadrant q = cut_face(&f);
    const double *const ends[2] = {q.right, q.left};
    for (int a = 0; a < 2; a++) {
        const int b = 1 - a;
        moment[a] = 0.5 * below_arc(depth, corner[b], ends[b][b]);
        if (ends[a][a] >= size[a]) moment[a] -= 0.5 * below_arc(depth_beyond(&f, a), corner[b], ends[a][b]);
    }
    moment[2] = 0.0;
    return q.area;
}

static double distance(const pdmc_cell *cell, bool is_far)
{
    double square = 0.0;
    for (int a = 0; a < 3; a++) {
        const double low = cell->lower[a], high = cell->upper[a];
        const double near = fmax(0.0, fmax(low, -high)), far = fmax(fabs(low), fabs(high));
        square += is_far ? far * far : near * near;
    }
    return square;
}

static double whole(int dimension, const pdmc_cell *cell, double moment[3])
{
    double volume = 1.0;
    for (int a = 0; a < dimension; a++) volume *= cell->upper[a] - cell->lower[a];
    for (int a = 0; a < 3; a++) moment[a] = 0.5 * (cell->lower[a] + cell->upper[a]) * volume;
    return volume;
}

/// The pieces of a cell on either side of the coordinate planes, turned into positive coordinates.
static double cut_pieces(int dimension, const pdmc_cell *cell, double radius, double moment[3])
{
    double volume = 0.0;
    memset(moment, 0, 3 * sizeof *moment);
    for (unsigned octant = 0; octant < 1u << dimension; octant++) {
        pdmc_cell piece = {0};
        double part[3], size[3] = {0.0};
        bool is_empty = false;
        for (int a = 0; a < dimension; a++) {
            const bool is_negative = octant >> a & 1;
            piece.lower[a] = fmax(0.0, is_negative ? -cell->upper[a] : cell->lower[a]);
            piece.upper[a] = is_negative ? -cell->lower[a] : cell->upper[a];
            size[a] = fmin(piece.upper[a] - piece.lower[a], cell->upper[a] - cell->lower[a]);
            is_empty |= !(size[a] > 0.0);
        }
        if (is_empty || distance(&piece, false) >= radius * radius) continue;
        const bool is_whole = distance(&piece, true) <= radius * radius;
        if (is_whole) volume += whole(dimension, &piece, part);
        else volume += (dimension == 3 ? cut_octant : cut_quadrant)(piece.lower, size, radius, part);
        for (int a = 0; a < dimension; a++) moment[a] += octant >> a & 1 ? -part[a] : part[a];
    }
    return volume;
}

double pdmc_cell_in_sphere(int dimension, const pdmc_cell *cell, double radius, double centroid[3])
{
    double moment[3], volume = 0.0;
    for (int a = 0; a < 3; a++) centroid[a] = 0.5 * (cell->lower[a] + cell->upper[a]);
    const double square = radius * radius;
    if (distance(cell, true) <= square) return whole(dimension, cell, moment);
    if (distance(cell, false) < square) volume = cut_pieces(dimension, cell, radius, moment);
    for (int a = 0; a < dimension && volume > 0.0; a++)
        centroid[a] = fmin(cell->upper[a], fmax(cell->lower[a], moment[a] / volume));
    return volume;
}
