// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "horizon/points.h"
#include "pdmc/quadrature.h"

#include <math.h>
#include <string.h>

enum { MAX_GAUSS = 4, MAX_CELLS_A_SIDE = 1000 };

pdmc_horizon_options pdmc_horizon_options_default(pdmc_horizon_kind kind, int dimension, double radius, double spacing)
{
    return (pdmc_horizon_options){.kind = kind,
                                  .dimension = dimension,
                                  .radius = radius,
                                  .spacing = spacing,
                                  .gauss_points = 2,
                                  .adaptive = {.accuracy = 5e-4, .threshold = 1e-4, .most = 8, .extrapolates = true},
                                  .within = {{-INFINITY, -INFINITY, -INFINITY}, {INFINITY, INFINITY, INFINITY}}};
}

/// The same bytes with room for more; NULL, and the old ones kept, where there is no memory.
static void *larger(void *array, size_t used, size_t room)
{
    char *bytes = pdmc_calloc(room, 1);
    if (!bytes) return NULL;
    if (used > 0) memcpy(bytes, array, used);
    pdmc_free(array);
    return bytes;
}

static pdmc_status make_room_for_points(pdmc_points *p)
{
    pdmc_horizon_rule *rule = p->rule;
    const size_t used = (size_t)p->points * sizeof(double), room = used == 0 ? 1024 * sizeof(double) : 2 * used;
    double *position = larger(rule->position, 3 * used, 3 * room);
    if (!position) return PDMC_ERR_NOMEM;
    rule->position = position;
    double *weight = larger(rule->weight, used, room);
    if (!weight) return PDMC_ERR_NOMEM;
    rule->weight = weight;
    p->points = (int)(room / sizeof(double));
    return PDMC_OK;
}

static pdmc_status make_room_for_cells(pdmc_points *p)
{
    pdmc_horizon_rule *rule = p->rule;
    const size_t used = (size_t)p->cells * sizeof(int), room = used == 0 ? 512 * sizeof(int) : 2 * used;
    int *cell = larger(rule->cell, 3 * used, 3 * room);
    if (!cell) return PDMC_ERR_NOMEM;
    rule->cell = cell;
    int *first = larger(rule->first, used == 0 ? 0 : used + sizeof(int), room + sizeof(int));
    if (!first) return PDMC_ERR_NOMEM;
    rule->first = first;
    p->cells = (int)(room / sizeof(int));
    return PDMC_OK;
}

pdmc_status pdmc_points_add(pdmc_points *p, const double position[3], double weight)
{
    pdmc_horizon_rule *rule = p->rule;
    if (rule->point_count == p->points) {
        const pdmc_status status = make_room_for_points(p);
        if (status != PDMC_OK) return status;
    }
    memcpy(&rule->position[3 * (size_t)rule->point_count], position, 3 * sizeof *position);
    rule->weight[rule->point_count++] = weight;
    return PDMC_OK;
}

/// Keeps the cell if it got points.
static pdmc_status end_cell(pdmc_points *p, const int at[3])
{
    pdmc_horizon_rule *rule = p->rule;
    if (rule->cell_count == p->cells) {
        const pdmc_status status = make_room_for_cells(p);
        if (status != PDMC_OK) return status;
    }
    if (rule->point_count == rule->first[rule->cell_count]) return PDMC_OK;
    memcpy(&rule->cell[3 * (size_t)rule->cell_count], at, 3 * sizeof *at);
    rule->first[++rule->cell_count] = rule->point_count;
    return PDMC_OK;
}

static double length(const double x[3])
{
    return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
}

/// The share of a volume of extent `size` round a point at the distance r, eq. 2.16.
static double taper(double r, double radius, double size)
{
    return fmin(1.0, fmax(0.0, (radius + 0.5 * size - r) / size));
}

/// How much of the extent `size` round x lies within the body.
static double inside(const pdmc_horizon_options *o, const double x[3], double size)
{
    double share = 1.0;
    for (int a = 0; a < o->dimension; a++) {
        const double low = fmax(x[a] - 0.5 * size, o->within.lower[a]),
                     high = fmin(x[a] + 0.5 * size, o->within.upper[a]);
        share *= fmax(0.0, high - low) / size;
    }
    return share;
}

static pdmc_status add_cubic(const pdmc_horizon_options *o, const double node[3], pdmc_points *points)
{
    const double r = length(node);
    const double volume = inside(o, node, o->spacing) * pow(o->spacing, o->dimension);
    if (r > o->radius * (1.0 + 1e-12) || volume == 0.0) return PDMC_OK; // a node on the horizon is inside
    return pdmc_points_add(points, node, taper(r, o->radius, o->spacing) * volume);
}

static pdmc_status add_gauss(const pdmc_horizon_options *o, const double node[3], pdmc_points *points)
{
    const int n = o->gauss_points;
    double x[MAX_GAUSS], w[MAX_GAUSS];
    pdmc_status status = pdmc_gauss_legendre(n, -0.5, 0.5, x, w);
    const int layers = o->dimension == 3 ? n : 1;
    for (int i = 0; i < n * n * layers && status == PDMC_OK; i++) {
        const int at[3] = {i / layers / n, i / layers % n, i % layers};
        double point[3] = {0.0}, volume = 1.0;
        for (int a = 0; a < o->dimension; a++) {
            point[a] = node[a] + o->spacing * x[at[a]];
            volume *= o->spacing * w[at[a]];
        }
        const double size = o->dimension == 3 ? cbrt(volume) : sqrt(volume); // eq. 3.12
        volume *= taper(length(point), o->radius, size) * inside(o, point, size);
        if (volume > 0.0) status = pdmc_points_add(points, point, volume);
    }
    return status;
}

/// The part of the cell within the body; false where there is none.
static bool clip(const pdmc_horizon_options *o, const double node[3], pdmc_cell *cell)
{
    bool is_there = true;
    *cell = (pdmc_cell){0};
    for (int a = 0; a < o->dimension; a++) {
        cell->lower[a] = fmax(node[a] - 0.5 * o->spacing, o->within.lower[a]);
        cell->upper[a] = fmin(node[a] + 0.5 * o->spacing, o->within.upper[a]);
        is_there &= cell->lower[a] < cell->upper[a];
    }
    return is_there;
}

static pdmc_status add_part(const pdmc_horizon_options *o, const double node[3], pdmc_points *points)
{
    pdmc_cell cell;
    double centroid[3];
    if (!clip(o, node, &cell)) return PDMC_OK;
    const double volume = pdmc_cell_in_sphere(o->dimension, &cell, o->radius, centroid);
    if (!(volume > 0.0)) return PDMC_OK;
    return o->kind == PDMC_RULE_ADAPTIVE ? pdmc_adapt(o, &cell, points) : pdmc_points_add(points, centroid, volume);
}

static pdmc_status check(const pdmc_horizon_options *o)
{
    const pdmc_adaptive *adaptive = &o->adaptive;
    PDMC_REQUIRE(o->dimension == 2 || o->dimension == 3, "dimension = %d is neither 2 nor 3", o->dimension);
    PDMC_REQUIRE(isfinite(o->radius) && o->radius > 0.0, "radius = %g is not > 0", o->radius);
    PDMC_REQUIRE(isfinite(o->spacing) && o->spacing > 0.0, "spacing = %g is not > 0", o->spacing);
    PDMC_REQUIRE(o->radius <= 0.5 * MAX_CELLS_A_SIDE * o->spacing, "radius / spacing = %g is above %d",
                 o->radius / o->spacing, MAX_CELLS_A_SIDE / 2);
    PDMC_REQUIRE(1 <= o->gauss_points && o->gauss_points <= MAX_GAUSS, "gauss_points = %d not in [1, %d]",
                 o->gauss_points, MAX_GAUSS);
    PDMC_REQUIRE(adaptive->accuracy > 0.0, "accuracy = %g is not > 0", adaptive->accuracy);
    PDMC_REQUIRE(adaptive->threshold >= 0.0, "threshold = %g is not >= 0", adaptive->threshold);
    PDMC_REQUIRE(0 <= adaptive->start && adaptive->start <= adaptive->most && adaptive->most <= 12,
                 "indices from %d to %d are not within [0, 12]", adaptive->start, adaptive->most);
    PDMC_REQUIRE(0 <= o->integrand_count && o->integrand_count <= PDMC_MAX_INTEGRANDS,
                 "integrand_count = %d not in [0, %d]", o->integrand_count, PDMC_MAX_INTEGRANDS);
    PDMC_REQUIRE(o->integrand_count == 0 || o->integrand, "integrand is missing");
    return PDMC_OK;
}

static pdmc_status add_cell(const pdmc_horizon_options *o, const int at[3], pdmc_points *points)
{
    double node[3] = {0.0};
    for (int a = 0; a < o->dimension; a++) node[a] = at[a] * o->spacing - o->origin[a];
    switch (o->kind) {
    case PDMC_RULE_CUBIC: return add_cubic(o, node, points);
    case PDMC_RULE_GAUSS: return add_gauss(o, node, points);
    case PDMC_RULE_EXACT:
    case PDMC_RULE_ADAPTIVE: break;
    }
    return add_part(o, node, points);
}

pdmc_status pdmc_horizon_rule_create(const pdmc_horizon_options *options, pdmc_horizon_rule *rule)
{
    *rule = (pdmc_horizon_rule){0};
    pdmc_status status = check(options);
    if (status != PDMC_OK) return status;
    pdmc_points points = {.rule = rule};
    int from[3] = {0}, to[3] = {0}, at[3];
    for (int a = 0; a < options->dimension; a++) {
        from[a] = (int)floor((options->origin[a] - options->radius) / options->spacing - 0.5);
        to[a] = (int)ceil((options->origin[a] + options->radius) / options->spacing + 0.5);
    }
    for (at[0] = from[0]; at[0] <= to[0]; at[0]++) {
        for (at[1] = from[1]; at[1] <= to[1]; at[1]++) {
            for (at[2] = from[2]; at[2] <= to[2]; at[2]++) {
                PDMC_TRY(add_cell(options, at, &points));
                PDMC_TRY(end_cell(&points, at));
            }
        }
    }
done:
    if (status != PDMC_OK) pdmc_horizon_rule_clear(rule);
    return status;
}

void pdmc_horizon_rule_clear(pdmc_horizon_rule *rule)
{
    pdmc_free(rule->cell);
    pdmc_free(rule->first);
    pdmc_free(rule->position);
    pdmc_free(rule->weight);
    *rule = (pdmc_horizon_rule){0};
}

double pdmc_horizon_rule_volume(const pdmc_horizon_rule *rule)
{
    double sum = 0.0, lost = 0.0;
    for (int i = 0; i < rule->point_count; i++) {
        const double term = rule->weight[i] - lost, next = sum + term;
        lost = (next - sum) - term;
        sum = next;
    }
    return sum;
}

double pdmc_horizon_rule_distance(const pdmc_horizon_rule *rule, int dimension, double volume)
{
    const double each = volume / rule->point_count;
    return dimension == 3 ? cbrt(each) : sqrt(each);
}
