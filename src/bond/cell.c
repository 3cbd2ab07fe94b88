// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/cell.h"

#include <gsl/gsl_math.h>

enum { EDGES = 4 };

// The part of an edge of the cell inside the disc, counter-clockwise round the cell, from the cell's middle.
typedef struct {
    bool exists;
    double from[2], to[2];
} piece;

static piece piece_of_edge(const double middle[2], double half, double radius, int edge)
{
    const int along = edge % 2, across = 1 - along;           // bottom, right, top, left
    const double out = edge == 1 || edge == 2 ? half : -half; // where the edge lies
    const double distance = middle[across] + out;             // of its line from the origin
    const double chord2 = (radius - distance) * (radius + distance);
    if (chord2 <= 0.0) return (piece){0};
    const double chord = sqrt(chord2);
    const double low = fmax(-half, -chord - middle[along]), high = fmin(half, chord - middle[along]);
    piece p = {.exists = low < high};
    const bool is_forward = edge < 2;
    p.from[across] = p.to[across] = out;
    p.from[along] = is_forward ? low : high;
    p.to[along] = is_forward ? high : low;
    return p;
}

// theta - sin theta without cancellation
static double segment_angle(double theta)
{
    if (theta > 0.5) return theta - sin(theta);
    const double t = theta * theta;
    double sum = 1.0;
    for (int k = 8; k >= 1; k--) sum = 1.0 - t / ((2.0 * k + 2.0) * (2.0 * k + 3.0)) * sum;
    return theta * t / 6.0 * sum;
}

static void add_triangle(pdmc_cell_part *sum, const double p[2], const double q[2])
{
    const double area = 0.5 * (p[0] * q[1] - p[1] * q[0]);
    sum->area += area;
    for (int i = 0; i < 2; i++) sum->moment[i] += area * (p[i] + q[i]) / 3.0;
}

// The segment between the arc q -> p, counter-clockwise, and its chord. The arc round a corner of the cell is short:
// a negative angle there is rounding, anywhere else an arc beyond half the circle.
static void add_segment(pdmc_cell_part *sum, const double middle[2], double radius, const double q[2],
                        const double p[2], bool is_round_corner)
{
    const double d[2] = {p[0] - q[0], p[1] - q[1]}, c[2] = {middle[0] + q[0], middle[1] + q[1]};
    const double cross = c[0] * d[1] - c[1] * d[0], dot = c[0] * (c[0] + d[0]) + c[1] * (c[1] + d[1]);
    double theta = atan2(cross, dot);
    if (theta < 0.0) theta = is_round_corner ? 0.0 : theta + 2.0 * M_PI;
    const double chord2 = d[0] * d[0] + d[1] * d[1];
    sum->area += 0.5 * radius * radius * segment_angle(theta);
    sum->moment[0] += chord2 * d[1] / 12.0;
    sum->moment[1] -= chord2 * d[0] / 12.0;
}

static int next_piece(const piece pieces[EDGES], int edge)
{
    do {
        edge = (edge + 1) % EDGES;
    } while (!pieces[edge].exists);
    return edge;
}

// The boundary of the part is the pieces of the edges and, from each to the next, an arc: the polygon of their ends, in
// which lengths of the size of the cell only are subtracted, and the segments outside its sides.
pdmc_cell_part pdmc_cell_in_disc(const double middle[2], double side, double radius)
{
    const double half = 0.5 * side;
    piece pieces[EDGES];
    bool is_cut = false;
    for (int k = 0; k < EDGES; k++) {
        pieces[k] = piece_of_edge(middle, half, radius, k);
        is_cut = is_cut || pieces[k].exists;
    }
    if (!is_cut) {
        const bool is_origin_inside = fabs(middle[0]) < half && fabs(middle[1]) < half;
        return (pdmc_cell_part){.area = is_origin_inside ? M_PI * radius * radius : 0.0};
    }
    pdmc_cell_part polygon = {0}, segments = {0};
    for (int k = 0; k < EDGES; k++) {
        if (!pieces[k].exists) continue;
        const int next = next_piece(pieces, k);
        add_triangle(&polygon, pieces[k].from, pieces[k].to);
        add_triangle(&polygon, pieces[k].to, pieces[next].from);
        add_segment(&segments, middle, radius, pieces[k].to, pieces[next].from, next == (k + 1) % EDGES);
    }
    pdmc_cell_part part = {.area = polygon.area + segments.area};
    for (int i = 0; i < 2; i++) part.moment[i] = polygon.moment[i] + polygon.area * middle[i] + segments.moment[i];
    return part;
}
