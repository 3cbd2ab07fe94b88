// SPDX-License-Identifier: GPL-3.0-or-later
#include "visible/disc.h"

#include "base/base_impl.h"
#include "pdmc/quadrature.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>

enum { SECTORS = 12, LEVELS = 5, GRADED = 2 * LEVELS + 1, DIRECTIONS = 6 };

pdmc_status pdmc_disc_rule_create(const pdmc_cuts *cuts, const pdmc_plate *edge, double radius, int radial_points,
                                  int angular_points, pdmc_disc_rule *rule)
{
    pdmc_status status = PDMC_OK;
    *rule = (pdmc_disc_rule){cuts, edge, radius, radial_points, angular_points, NULL, NULL, NULL, NULL, NULL, NULL};
    PDMC_NEW(rule->node_r, radial_points);
    PDMC_NEW(rule->weight_r, radial_points);
    PDMC_NEW(rule->node_t, angular_points);
    PDMC_NEW(rule->weight_t, angular_points);
    PDMC_NEW(rule->breaks, SECTORS + 1 + DIRECTIONS * GRADED * cuts->count);
    PDMC_NEW(rule->splits, 3 + 2 * cuts->count);
    PDMC_TRY(pdmc_gauss_legendre(radial_points, 0.0, 1.0, rule->node_r, rule->weight_r));
    PDMC_TRY(pdmc_gauss_legendre(angular_points, 0.0, 1.0, rule->node_t, rule->weight_t));
done:
    if (status != PDMC_OK) pdmc_disc_rule_clear(rule);
    return status;
}

void pdmc_disc_rule_clear(pdmc_disc_rule *rule)
{
    pdmc_free(rule->node_r);
    pdmc_free(rule->weight_r);
    pdmc_free(rule->node_t);
    pdmc_free(rule->weight_t);
    pdmc_free(rule->breaks);
    pdmc_free(rule->splits);
    *rule = (pdmc_disc_rule){0};
}

// An angle in [0, 2 pi).
static double wrap(double angle)
{
    const double turned = fmod(angle, 2.0 * M_PI);
    return turned < 0.0 ? turned + 2.0 * M_PI : turned;
}

static int add_graded(double breaks[], int count, double angle)
{
    breaks[count++] = wrap(angle);
    for (int level = 1; level <= LEVELS; level++) {
        const double step = 2.0 * M_PI / SECTORS * ldexp(1.0, -level);
        breaks[count++] = wrap(angle + step);
        breaks[count++] = wrap(angle - step);
    }
    return count;
}

// Breaks towards one crack that the disc reaches: its direction, its tips, and where it leaves the disc.
static int add_crack(const pdmc_disc_rule *rule, int c, const pdmc_view *centre, double breaks[], int count)
{
    const pdmc_cut *cut = &rule->cuts->cut[c];
    double local[2];
    pdmc_cut_local(cut, centre->x, local);
    const double turn = atan2(cut->sine, cut->cosine), reach = rule->radius;
    if (fabs(local[1]) >= reach || fabs(local[0]) >= cut->half_length + reach) return count;
    count = add_graded(breaks, count, turn);
    count = add_graded(breaks, count, turn + M_PI);
    if (centre->crack == c) return count;
    const double half = sqrt(reach * reach - local[1] * local[1]);
    for (int end = -1; end <= 1; end += 2) {
        const double to_tip = end * cut->half_length - local[0];
        const double distance = sqrt(to_tip * to_tip + local[1] * local[1]);
        if (distance < reach) count = add_graded(breaks, count, turn + atan2(-local[1], to_tip));
        if (fabs(local[0] + end * half) < cut->half_length) breaks[count++] = wrap(turn + atan2(-local[1], end * half));
    }
    return count;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// Sorted breaks from the first to its next turn.
static int find_breaks(pdmc_disc_rule *rule, const pdmc_view *centre)
{
    double *breaks = rule->breaks;
    int count = 0, kept = 1;
    for (int i = 0; i < SECTORS; i++) breaks[count++] = 2.0 * M_PI * i / SECTORS;
    for (int c = 0; c < rule->cuts->count; c++) count = add_crack(rule, c, centre, breaks, count);
    qsort(breaks, (size_t)count, sizeof *breaks, compare);
    for (int i = 1; i < count; i++)
        if (breaks[i] - breaks[kept - 1] > 1e-6 && 2.0 * M_PI - breaks[i] > 1e-6) breaks[kept++] = breaks[i];
    breaks[kept] = 2.0 * M_PI;
    return kept;
}

// Distance along a ray to a crack, at most `limit`.
static double distance_to(const pdmc_cut *cut, const double x[2], const double e[2], double limit)
{
    double local[2];
    pdmc_cut_local(cut, x, local);
    const double along = cut->cosine * e[0] + cut->sine * e[1], across = cut->cosine * e[1] - cut->sine * e[0];
    if (local[1] * across >= 0.0) return limit;
    const double r = -local[1] / across;
    return r < limit && fabs(local[0] + r * along) < cut->half_length ? r : limit;
}

static double distance_to_edge(const pdmc_plate *plate, const double x[2], const double e[2])
{
    const double half[2] = {0.5 * plate->width, 0.5 * plate->height};
    double r = INFINITY;
    for (int k = 0; k < 2; k++)
        if (e[k] != 0.0) r = fmin(r, (copysign(half[k], e[k]) - x[k]) / e[k]);
    return r;
}

// Ends of the radial panels, ascending from 0; 0 where the ray is blocked at once.
static int find_splits(pdmc_disc_rule *rule, const pdmc_view *centre, const double e[2])
{
    double end = rule->radius, *splits = rule->splits;
    int count = 1;
    splits[0] = 0.0;
    for (int c = 0; c < rule->cuts->count; c++) {
        const pdmc_cut *cut = &rule->cuts->cut[c];
        if (centre->crack != c) end = distance_to(cut, centre->x, e, end);
        else if (centre->side * (cut->cosine * e[1] - cut->sine * e[0]) <= 0.0) return 0;
    }
    for (int t = 0; t < 2 * rule->cuts->count; t++) {
        const pdmc_cut *cut = &rule->cuts->cut[t / 2];
        double tip[2];
        pdmc_cut_global(cut, t % 2 ? cut->half_length : -cut->half_length, 0.0, tip);
        const double d[2] = {tip[0] - centre->x[0], tip[1] - centre->x[1]}, distance = hypot(d[0], d[1]);
        if (distance < end && d[0] * e[0] + d[1] * e[1] > sqrt(0.5) * distance) splits[count++] = distance;
    }
    const double edge = rule->edge ? distance_to_edge(rule->edge, centre->x, e) : INFINITY;
    if (1e-9 * end < edge && edge < end) splits[count++] = edge;
    splits[count++] = end;
    qsort(splits, (size_t)count, sizeof *splits, compare);
    return count;
}

static void visit_ray(pdmc_disc_rule *rule, const pdmc_view *centre, double theta, double weight,
                      pdmc_disc_visitor visit, void *context)
{
    const double e[2] = {cos(theta), sin(theta)};
    const int ends = find_splits(rule, centre, e);
    for (int k = 0; k + 1 < ends; k++) {
        const double low = rule->splits[k], length = rule->splits[k + 1] - low;
        for (int i = 0; i < rule->radial_points; i++) {
            const double r = low + length * rule->node_r[i];
            const pdmc_disc_point point = {
                {centre->x[0] + r * e[0], centre->x[1] + r * e[1]}, r, e[0], e[1], weight * length * rule->weight_r[i]};
            visit(context, &point);
        }
    }
}

void pdmc_disc_visit(pdmc_disc_rule *rule, const pdmc_view *centre, pdmc_disc_visitor visit, void *context)
{
    const int panels = find_breaks(rule, centre);
    for (int k = 0; k < panels; k++) {
        const double low = rule->breaks[k], width = rule->breaks[k + 1] - low;
        for (int i = 0; i < rule->angular_points; i++)
            visit_ray(rule, centre, low + width * rule->node_t[i], width * rule->weight_t[i], visit, context);
    }
}
