// SPDX-License-Identifier: GPL-3.0-or-later

/// Iterated composite trapezoidal rules over the pieces of a cell, refined direction by direction (section 2.4.3).

#include "base/base_impl.h"
#include "horizon/pieces.h"
#include "horizon/points.h"

#include <math.h>
#include <string.h>

enum { VALUES = PDMC_MAX_INTEGRANDS };

// A piece with the indices of its rules and what they give.
typedef struct {
    const pdmc_piece *piece;
    int index[3];
    double value[VALUES];
} part;

typedef struct {
    const pdmc_horizon_options *options;
    pdmc_pieces pieces;
    part parts[PDMC_MAX_PIECES];
    int values; // of the integrand, at least 1
} cell_rule;

static int intervals(int index)
{
    return index == 0 ? 0 : 1 << (index - 1);
}

static double station(double from, double to, int i, int of)
{
    const double share = of == 0 ? 0.5 : (double)i / of;
    return (1.0 - share) * from + share * to;
}

/// Of the station's share in an interval of length 1. Simpson's rule is (4 T(n) - T(n - 1)) / 3.
static double share(const pdmc_adaptive *adaptive, int i, int of)
{
    if (of == 0) return 1.0;
    const bool is_end = i == 0 || i == of;
    if (!adaptive->extrapolates || of == 1) return (is_end ? 0.5 : 1.0) / of;
    return (is_end ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) / (3.0 * of);
}

// Where the points of a piece go: into sums of the integrand, or into the rule.
typedef struct {
    double *sums;
    pdmc_points *points;
} sink;

static void to_space(const pdmc_pieces *pieces, const double own[3], double position[3])
{
    for (int k = 0; k < 3; k++) position[pieces->axis[k]] = pieces->turn[k] * own[k];
}

static pdmc_status put(const cell_rule *rule, const double own[3], double weight, const sink *to)
{
    double position[3], value[VALUES] = {1.0};
    to_space(&rule->pieces, own, position);
    if (to->points) return pdmc_points_add(to->points, position, weight);
    const pdmc_horizon_options *o = rule->options;
    if (o->integrand_count > 0) o->integrand(o->context, position, value);
    for (int v = 0; v < rule->values; v++) to->sums[v] += weight * value[v];
    return PDMC_OK;
}

static pdmc_status put_column(const cell_rule *rule, const part *p, double x, double y, double weight, const sink *to)
{
    pdmc_status status = PDMC_OK;
    const pdmc_adaptive *adaptive = &rule->options->adaptive;
    const double bottom = p->piece->bottom, top = pdmc_piece_top(&rule->pieces, p->piece, x, y);
    const int of = intervals(p->index[2]);
    if (!(weight * (top - bottom) > 0.0)) return PDMC_OK; // at the edge of the sphere
    for (int i = 0; i <= of && status == PDMC_OK; i++) {
        const double own[3] = {x, y, station(bottom, top, i, of)};
        status = put(rule, own, weight * (top - bottom) * share(adaptive, i, of), to);
    }
    return status;
}

static pdmc_status put_part(const cell_rule *rule, const part *p, const sink *to)
{
    pdmc_status status = PDMC_OK;
    const pdmc_adaptive *adaptive = &rule->options->adaptive;
    const bool is_plane = rule->options->dimension == 2;
    const double *ends = p->piece->x;
    const int of[2] = {intervals(p->index[0]), is_plane ? 0 : intervals(p->index[1])};
    for (int i = 0; i <= of[0]; i++) {
        const double x = station(ends[0], ends[1], i, of[0]);
        const double from = pdmc_limit_at(&p->piece->y[0], x), to_y = pdmc_limit_at(&p->piece->y[1], x);
        const double slice = (ends[1] - ends[0]) * share(adaptive, i, of[0]) * (is_plane ? 1.0 : to_y - from);
        for (int j = 0; j <= of[1] && status == PDMC_OK; j++) {
            const double y = is_plane ? 0.0 : station(from, to_y, j, of[1]);
            status = put_column(rule, p, x, y, slice * share(adaptive, j, of[1]), to);
        }
    }
    return status;
}

static pdmc_status integrate(const cell_rule *rule, part *p)
{
    memset(p->value, 0, sizeof p->value);
    return put_part(rule, p, &(sink){.sums = p->value});
}

/// By how much an integral over the piece may change.
static double allowance(const cell_rule *rule)
{
    const pdmc_horizon_options *o = rule->options;
    const double one = pow(o->spacing, o->dimension);
    double largest = 0.0;
    for (int v = 0; v < rule->values; v++) {
        double sum = 0.0;
        for (int q = 0; q < rule->pieces.count; q++) sum += rule->parts[q].value[v];
        largest = fmax(largest, fabs(sum));
    }
    return o->adaptive.accuracy * (largest > o->adaptive.threshold * one ? largest : one);
}

static double change(const part *one, const part *other)
{
    double largest = 0.0;
    for (int v = 0; v < VALUES; v++) largest = fmax(largest, fabs(one->value[v] - other->value[v]));
    return largest;
}

/// Raises the indices of the directions in which one more changes too much.
static pdmc_status refine(const cell_rule *rule, part *p, double allowed, bool *is_refined)
{
    part next = *p;
    for (int d = 0; d < 3; d++) {
        if (d == 1 && rule->options->dimension == 2) continue;
        if (p->index[d] >= rule->options->adaptive.most) continue;
        part trial = *p;
        trial.index[d]++;
        const pdmc_status status = integrate(rule, &trial);
        if (status != PDMC_OK) return status;
        if (change(&trial, p) > allowed) next.index[d]++;
    }
    *is_refined = memcmp(next.index, p->index, sizeof next.index) != 0;
    if (!*is_refined) return PDMC_OK;
    *p = next;
    return integrate(rule, p);
}

static pdmc_status settle(cell_rule *rule)
{
    pdmc_status status = PDMC_OK;
    const int start = rule->options->adaptive.start;
    bool is_left[PDMC_MAX_PIECES], goes_on = true;
    for (int q = 0; q < rule->pieces.count && status == PDMC_OK; q++) {
        rule->parts[q] = (part){.piece = &rule->pieces.piece[q], .index = {start, start, start}};
        status = integrate(rule, &rule->parts[q]);
        is_left[q] = true;
    }
    while (goes_on && status == PDMC_OK) {
        const double allowed = allowance(rule);
        goes_on = false;
        for (int q = 0; q < rule->pieces.count && status == PDMC_OK; q++) {
            if (is_left[q]) status = refine(rule, &rule->parts[q], allowed, &is_left[q]);
            goes_on |= is_left[q];
        }
    }
    return status;
}

static pdmc_status adapt_one(cell_rule *rule, const pdmc_cell *cell, pdmc_points *points)
{
    pdmc_pieces_of(rule->options->dimension, cell, rule->options->radius, &rule->pieces);
    pdmc_status status = settle(rule);
    for (int q = 0; q < rule->pieces.count && status == PDMC_OK; q++)
        status = put_part(rule, &rule->parts[q], &(sink){.points = points});
    return status;
}

static bool holds_centre(const pdmc_horizon_options *o, const pdmc_cell *cell)
{
    for (int a = 0; a < o->dimension; a++)
        if (cell->lower[a] >= 0.0 || cell->upper[a] <= 0.0) return false;
    return true;
}

pdmc_status pdmc_adapt(const pdmc_horizon_options *options, const pdmc_cell *cell, pdmc_points *points)
{
    pdmc_status status = PDMC_OK;
    cell_rule *rule = NULL;
    PDMC_NEW(rule, 1);
    rule->options = options;
    rule->values = options->integrand_count > 0 ? options->integrand_count : 1;
    if (!holds_centre(options, cell)) {
        PDMC_TRY(adapt_one(rule, cell, points));
    } else { // the sphere is a graph over either half, and kernels are singular in the middle
        pdmc_cell half = *cell;
        half.upper[options->dimension - 1] = 0.0;
        PDMC_TRY(adapt_one(rule, &half, points));
        half = *cell;
        half.lower[options->dimension - 1] = 0.0;
        PDMC_TRY(adapt_one(rule, &half, points));
    }
done:
    pdmc_free(rule);
    return status;
}
