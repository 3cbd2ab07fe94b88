// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/sight.h"

#include "pdmc/geometry.h"

#include <string.h>

typedef struct {
    int corners;
    double corner[PDMC_POLYGON_CORNERS][2];
} polygon;

static double cross(const double a[2], const double b[2])
{
    return a[0] * b[1] - a[1] * b[0];
}

pdmc_sight pdmc_sight_from(const double x[2], double reach, int count, const pdmc_crack cracks[])
{
    pdmc_sight sight;
    sight.count = 0;
    for (int c = 0; c < count; c++) {
        if (pdmc_point_segment_distance(x, cracks[c].from, cracks[c].to) >= reach) continue;
        double(*end)[2] = sight.end[sight.count];
        for (int d = 0; d < 2; d++) {
            end[0][d] = cracks[c].from[d] - x[d];
            end[1][d] = cracks[c].to[d] - x[d];
        }
        const double turn = cross(end[0], end[1]);
        if (turn == 0.0) continue; // a crack straight ahead hides nothing
        if (turn < 0.0) {
            double first[2];
            memcpy(first, end[0], sizeof first);
            memcpy(end[0], end[1], sizeof first);
            memcpy(end[1], first, sizeof first);
        }
        sight.count++;
    }
    return sight;
}

// The part of a polygon to the left of the ray from the origin in a direction (side = 1) or to its right (-1).
static void clip(const polygon *in, const double direction[2], double side, polygon *out)
{
    out->corners = 0;
    for (int i = 0; i < in->corners; i++) {
        const double *a = in->corner[i], *b = in->corner[(i + 1) % in->corners];
        const double left[2] = {side * cross(direction, a), side * cross(direction, b)};
        if (left[0] >= 0.0) memcpy(out->corner[out->corners++], a, 2 * sizeof *a);
        if ((left[0] > 0.0 && left[1] < 0.0) || (left[0] < 0.0 && left[1] > 0.0)) {
            const double t = left[0] / (left[0] - left[1]);
            for (int d = 0; d < 2; d++) out->corner[out->corners][d] = a[d] + t * (b[d] - a[d]);
            out->corners++;
        }
    }
}

// Where x is from the line of a crack: positive on the origin's side.
static double before(double end[2][2], const double x[2])
{
    const double along[2] = {end[1][0] - end[0][0], end[1][1] - end[0][1]},
                 from[2] = {x[0] - end[0][0], x[1] - end[0][1]};
    return cross(along, from);
}

static bool is_all_before(double end[2][2], const polygon *p)
{
    for (int i = 0; i < p->corners; i++)
        if (before(end, p->corner[i]) < 0.0) return false;
    return true;
}

// Whether a part between the directions of the ends is behind the crack: all of it is, or none, and so is its middle.
static bool is_behind(double end[2][2], const polygon *p)
{
    double middle[2] = {0.0, 0.0};
    for (int i = 0; i < p->corners; i++)
        for (int d = 0; d < 2; d++) middle[d] += p->corner[i][d] / p->corners;
    return p->corners >= 3 && before(end, middle) < 0.0;
}

// What the cracks from `first` on leave of a polygon: right of the first direction, and left of both.
static void add_seen(const pdmc_sight *sight, int first, double horizon, int bins, polygon *p,
                     pdmc_bond_moments moments[])
{
    for (int c = first; c < sight->count; c++) {
        const double(*end)[2] = sight->end[c];
        polygon right, left, between, rest;
        if (is_all_before((double(*)[2])end, p)) continue;
        clip(p, end[0], 1.0, &left);
        clip(&left, end[1], -1.0, &between);
        if (!is_behind((double(*)[2])end, &between)) continue;
        clip(p, end[0], -1.0, &right);
        clip(&left, end[1], 1.0, &rest);
        add_seen(sight, c + 1, horizon, bins, &right, moments);
        add_seen(sight, c + 1, horizon, bins, &rest, moments);
        return;
    }
    if (p->corners >= 3) pdmc_polygon_bond_moments(horizon, bins, p->corners, p->corner, moments);
}

void pdmc_sight_moments(const pdmc_sight *sight, double horizon, int bins, double corner[3][2],
                        pdmc_bond_moments moments[])
{
    if (sight->count == 0) {
        pdmc_polygon_bond_moments(horizon, bins, 3, corner, moments);
        return;
    }
    polygon whole = {.corners = 3};
    memcpy(whole.corner, corner, 3 * sizeof *corner);
    add_seen(sight, 0, horizon, bins, &whole, moments);
}
