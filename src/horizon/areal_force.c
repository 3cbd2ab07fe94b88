// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "pdmc/horizon.h"
#include "pdmc/quadrature.h"

#include <math.h>
#include <string.h>

enum { MAX_GAUSS = 4 };

// A plane through a node, and the point of the line behind it whose horizon is looked at.
typedef struct {
    pdmc_horizon_options options;
    const pdmc_bonded_body *body;
    const double *node;
    int axis;
    double centre[3], moved[3]; // of the horizon, and its displacement
    double density[3];
    double size; // of the sum without signs
    pdmc_stress_effort effort;
} plane;

static double length(const double x[3])
{
    return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
}

/// The force of the bond to the point at xi from the centre, on a unit of volume squared.
static void bond_force(void *context, const double xi[3], double force[])
{
    const plane *p = context;
    const pdmc_horizon_options *o = &p->options;
    double end[3], u[3] = {0.0}, y[3], along = 0.0;
    const double r = length(xi);
    for (int a = 0; a < 3; a++) end[a] = p->centre[a] + xi[a];
    p->body->displacement(p->body->context, end, u);
    for (int a = 0; a < 3; a++) {
        along += xi[a] * (u[a] - p->moved[a]);
        y[a] = xi[a] + u[a] - p->moved[a];
    }
    const double c =
        p->body->micromodulus * pdmc_profile_at(p->body->profile, o->dimension, o->radius, fmin(r, o->radius));
    const double deformed = length(y);
    for (int a = 0; a < 3; a++) {
        force[a] = p->body->is_linear ? c * along / (r * r * r) * xi[a] : c * (deformed - r) / r * y[a] / deformed;
        if (!(r > 0.0)) force[a] = 0.0; // of the point with itself
    }
}

/// Adds `weight` times the force of the half of the horizon of the point `behind` the node.
static pdmc_status add_point(plane *p, double behind, double weight)
{
    pdmc_horizon_rule rule;
    pdmc_horizon_options o = p->options;
    memcpy(p->centre, p->node, sizeof p->centre);
    p->centre[p->axis] -= behind;
    p->body->displacement(p->body->context, p->centre, p->moved);
    o.origin[p->axis] = -behind;
    for (int side = 0; side < 2; side++) { // the body's edges, from this centre
        double *edge = side ? o.within.upper : o.within.lower;
        edge[p->axis] += behind;
    }
    o.within.lower[p->axis] = fmax(behind, o.within.lower[p->axis]);
    o.integrand_count = 3;
    o.integrand = bond_force;
    o.context = p;
    const pdmc_status status = pdmc_horizon_rule_create(&o, &rule);
    if (status != PDMC_OK) return status;
    for (int i = 0; i < rule.point_count; i++) {
        double force[3];
        bond_force(p, &rule.position[3 * (size_t)i], force);
        for (int a = 0; a < 3; a++) p->density[a] += weight * rule.weight[i] * force[a];
        p->size += weight * rule.weight[i] * length(force);
    }
    p->effort.points += rule.point_count;
    pdmc_horizon_rule_clear(&rule);
    return PDMC_OK;
}

/// The length of the line, to the horizon or to the body's edge.
static double line_length(const plane *p)
{
    return fmin(p->options.radius, fmax(0.0, -p->options.within.lower[p->axis]));
}

/// Points at the same places of each spacing, shares of it that end with the line.
static pdmc_status add_spacings(plane *p, int count, const double place[], const double share[])
{
    pdmc_status status = PDMC_OK;
    const double spacing = p->options.spacing, end = line_length(p);
    double from = 0.0;
    for (int m = 0; from < end; m++) {
        const double size = fmin(spacing, end - from), whole = size / spacing;
        for (int i = 0; i < count && status == PDMC_OK; i++)
            status = add_point(p, from + size * place[i], spacing * whole * share[i]);
        if (status != PDMC_OK) return status;
        from = (m + 1) * spacing;
    }
    return status;
}

/// The nodes of the line, each with the part of the line that is nearest to it.
static pdmc_status add_nodes(plane *p)
{
    pdmc_status status = PDMC_OK;
    const double spacing = p->options.spacing, end = line_length(p);
    for (int m = 0; m * spacing <= end * (1.0 + 1e-12) && status == PDMC_OK; m++) {
        const double low = fmax(0.0, (m - 0.5) * spacing), high = fmin(end, (m + 0.5) * spacing);
        status = add_point(p, m * spacing, high - low);
    }
    return status;
}

/// Trapezoidal rules of 1, 2, 4, ... intervals, extrapolated to Simpson's, until one more changes no more than EPS of
/// what forces would sum to if they had no signs.
static pdmc_status add_refined(plane *p)
{
    const pdmc_adaptive *adaptive = &p->options.adaptive;
    const double end = line_length(p);
    double before[3] = {0.0}, last[3] = {0.0}, change = INFINITY;
    for (int index = 1, of = 1; index <= adaptive->most && change > adaptive->accuracy * p->size / of; index++) {
        of = 1 << (index - 1);
        for (int i = 0; i <= of; i++) {
            if (index > 1 && i % 2 == 0) continue; // in the rule before
            const pdmc_status status = add_point(p, end * i / of, i == 0 || i == of ? 0.5 * end : end);
            if (status != PDMC_OK) return status;
        }
        change = index > 2 ? 0.0 : INFINITY;
        for (int a = 0; a < 3; a++) {
            const double trapezoidal = p->density[a] / of;
            const bool is_first = index == 1 || !adaptive->extrapolates;
            const double better = is_first ? trapezoidal : (4.0 * trapezoidal - before[a]) / 3.0;
            change = fmax(change, fabs(better - last[a]));
            before[a] = trapezoidal;
            last[a] = better;
        }
    }
    memcpy(p->density, last, sizeof last);
    return PDMC_OK;
}

static pdmc_status integrate_line(plane *p)
{
    double x[MAX_GAUSS], w[MAX_GAUSS];
    switch (p->options.kind) {
    case PDMC_RULE_CUBIC: return add_nodes(p);
    case PDMC_RULE_ADAPTIVE: return add_refined(p);
    case PDMC_RULE_EXACT: return add_spacings(p, 1, (double[]){0.5}, (double[]){1.0});
    case PDMC_RULE_GAUSS: break;
    }
    PDMC_REQUIRE(1 <= p->options.gauss_points && p->options.gauss_points <= MAX_GAUSS,
                 "gauss_points = %d not in [1, %d]", p->options.gauss_points, MAX_GAUSS);
    const pdmc_status status = pdmc_gauss_legendre(p->options.gauss_points, 0.0, 1.0, x, w);
    return status == PDMC_OK ? add_spacings(p, p->options.gauss_points, x, w) : status;
}

static pdmc_status count_half(plane *p)
{
    pdmc_status status = PDMC_OK;
    const double total = p->effort.points;
    double kept[3];
    memcpy(kept, p->density, sizeof kept);
    PDMC_TRY(add_point(p, 0.0, 0.0));
    p->effort.half_points = (int)(p->effort.points - total);
    p->effort.points = total;
    memcpy(p->density, kept, sizeof kept);
done:
    return status;
}

pdmc_status pdmc_areal_force_density(const pdmc_horizon_options *options, const pdmc_bonded_body *body,
                                     const double node[3], int axis, double density[3], pdmc_stress_effort *effort)
{
    PDMC_REQUIRE(0 <= axis && axis < options->dimension, "axis = %d not in [0, %d)", axis, options->dimension);
    PDMC_REQUIRE(body->displacement, "displacement is missing");
    PDMC_REQUIRE(isfinite(options->radius) && options->radius > 0.0 && options->spacing > 0.0,
                 "radius = %g, spacing = %g are not > 0", options->radius, options->spacing);
    plane p = {.options = *options, .body = body, .node = node, .axis = axis};
    memset(p.options.origin, 0, sizeof p.options.origin);
    pdmc_status status = integrate_line(&p);
    if (status != PDMC_OK) return status;
    if (effort) {
        if ((status = count_half(&p)) != PDMC_OK) return status;
        effort->half_points = p.effort.half_points;
        effort->points += p.effort.points;
    }
    memcpy(density, p.density, sizeof p.density);
    return PDMC_OK;
}

pdmc_status pdmc_horizon_stress(const pdmc_horizon_options *options, const pdmc_bonded_body *body, const double node[3],
                                double stress[9], pdmc_stress_effort *effort)
{
    pdmc_stress_effort total = {0};
    memset(stress, 0, 9 * sizeof *stress);
    for (int axis = 0; axis < options->dimension; axis++) {
        double density[3];
        const pdmc_status status = pdmc_areal_force_density(options, body, node, axis, density, effort ? &total : NULL);
        if (status != PDMC_OK) return status;
        for (int a = 0; a < 3; a++) stress[3 * a + axis] = density[a];
    }
    if (effort) *effort = total;
    return PDMC_OK;
}
