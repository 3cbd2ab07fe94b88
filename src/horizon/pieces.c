// SPDX-License-Identifier: GPL-3.0-or-later
#include "horizon/pieces.h"

#include <math.h>

enum { MAX_BREAKS = 14 };

double pdmc_limit_at(const pdmc_limit *limit, double x)
{
    return limit->half == 0 ? limit->value : limit->half * sqrt(fmax(0.0, limit->value - x * x));
}

double pdmc_piece_top(const pdmc_pieces *pieces, const pdmc_piece *piece, double x, double y)
{
    if (!piece->is_curved) return piece->top;
    return fmax(piece->bottom, sqrt(fmax(0.0, pieces->radius * pieces->radius - x * x - y * y)));
}

// A cell in its own axes, Z >= 0, with the squares of the radii of the circles in its lower and upper face of Z.
typedef struct {
    double lower[3], upper[3];
    double wide, narrow;
} frame;

static void insert(double x, double breaks[MAX_BREAKS], int *count)
{
    int at = *count;
    while (at > 0 && breaks[at - 1] > x) at--;
    if (at > 0 && breaks[at - 1] == x) return;
    for (int i = (*count)++; i > at; i--) breaks[i] = breaks[i - 1];
    breaks[at] = x;
}

/// Where on X the limits of Y change: at the ends of the circles, and where they meet the planes of Y.
static int find_breaks(const frame *f, double breaks[MAX_BREAKS])
{
    int count = 0;
    const double planes[] = {0.0, f->lower[1], f->upper[1]}, squares[] = {f->wide, f->narrow};
    insert(f->lower[0], breaks, &count);
    insert(f->upper[0], breaks, &count);
    for (int c = 0; c < 2; c++) {
        for (int p = 0; p < 3; p++) {
            const double x = sqrt(fmax(0.0, squares[c] - planes[p] * planes[p]));
            if (f->lower[0] < x && x < f->upper[0]) insert(x, breaks, &count);
            if (f->lower[0] < -x && -x < f->upper[0]) insert(-x, breaks, &count);
        }
    }
    return count;
}

/// The part of Y inside a circle, where X is near x; false where it is empty.
static bool clip(const frame *f, double square, double x, pdmc_limit y[2])
{
    if (square <= x * x) return false;
    const double half = sqrt(square - x * x);
    y[0] = -half > f->lower[1] ? (pdmc_limit){square, -1} : (pdmc_limit){f->lower[1], 0};
    y[1] = half < f->upper[1] ? (pdmc_limit){square, 1} : (pdmc_limit){f->upper[1], 0};
    return half > f->lower[1] && -half < f->upper[1];
}

static void add(pdmc_pieces *pieces, const frame *f, const double x[2], pdmc_limit from, pdmc_limit to, bool is_curved)
{
    if (pieces->dimension == 3 && from.half == to.half && from.value == to.value) return;
    pieces->piece[pieces->count++] = (pdmc_piece){{x[0], x[1]}, {from, to}, f->lower[2], f->upper[2], is_curved};
}

/// Between two breaks: inside the narrow circle the cell is whole along Z, between the circles it ends at the sphere.
static void add_between(pdmc_pieces *pieces, const frame *f, const double x[2])
{
    pdmc_limit outer[2], inner[2];
    const double middle = 0.5 * (x[0] + x[1]);
    if (!clip(f, f->wide, middle, outer)) return;
    if (!clip(f, f->narrow, middle, inner)) {
        add(pieces, f, x, outer[0], outer[1], true);
        return;
    }
    if (pieces->dimension == 3) add(pieces, f, x, outer[0], inner[0], true);
    add(pieces, f, x, inner[0], inner[1], false);
    if (pieces->dimension == 3) add(pieces, f, x, inner[1], outer[1], true);
}

static void add_frame(pdmc_pieces *pieces, frame *f)
{
    double breaks[MAX_BREAKS];
    f->wide = (pieces->radius - f->lower[2]) * (pieces->radius + f->lower[2]);
    f->narrow = (pieces->radius - f->upper[2]) * (pieces->radius + f->upper[2]);
    const int count = find_breaks(f, breaks);
    for (int i = 0; i + 1 < count; i++) add_between(pieces, f, &breaks[i]);
}

/// X, Y and Z by the distance of the cell's middle along them; in the plane X and Z. What has zero inside comes first.
static void choose_axes(const pdmc_cell *cell, pdmc_pieces *pieces)
{
    double middle[3]; // twice
    int *axis = pieces->axis;
    for (int a = 0; a < 3; a++) {
        const bool has_zero = cell->lower[a] < 0.0 && cell->upper[a] > 0.0;
        middle[a] = has_zero ? 0.0 : fabs(cell->lower[a] + cell->upper[a]);
        axis[a] = a;
    }
    const int places = pieces->dimension;
    for (int i = 1; i < places; i++) {
        for (int k = i; k > 0 && middle[axis[k - 1]] > middle[axis[k]]; k--) {
            const int swap = axis[k];
            axis[k] = axis[k - 1];
            axis[k - 1] = swap;
        }
    }
    if (places == 2) {
        axis[2] = axis[1];
        axis[1] = 2;
    }
    for (int k = 0; k < 3; k++) pieces->turn[k] = cell->lower[axis[k]] + cell->upper[axis[k]] < 0.0 ? -1.0 : 1.0;
}

void pdmc_pieces_of(int dimension, const pdmc_cell *cell, double radius, pdmc_pieces *pieces)
{
    pieces->dimension = dimension;
    pieces->radius = radius;
    pieces->count = 0;
    choose_axes(cell, pieces);
    frame f;
    for (int k = 0; k < 3; k++) {
        const int a = pieces->axis[k];
        f.lower[k] = pieces->turn[k] > 0.0 ? cell->lower[a] : -cell->upper[a];
        f.upper[k] = pieces->turn[k] > 0.0 ? cell->upper[a] : -cell->lower[a];
    }
    add_frame(pieces, &f);
}
