// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "pdmc/reliability.h"

#include <cblas.h>
#include <gsl/gsl_cdf.h>
#include <math.h>
#include <string.h>

enum { SHORTER_STEPS = 12 };                   // lambda = 1, 1/2, ...
static const double longest_step = 6.0;        // in z: a small gradient far from the event may ask for anything
static const double enough = 0.1;              // share of the predicted decrease of the merit (Armijo)
static const double reach[] = {1.0, 2.0, 4.0}; // of the points on the axes that are tried where g is flat
enum { REACHES = sizeof reach / sizeof reach[0] };

typedef struct {
    const pdmc_limit_state *limit;
    const pdmc_first_order_options *options;
    int n;
    double *z, *gradient, *step; // [n]
    double g, slope;             // at z; |gradient|
    double *trial, *value;       // [trials, n], [trials] points evaluated at once, and their g
    long evaluations;
} search;

pdmc_first_order_options pdmc_first_order_options_default(void)
{
    return (pdmc_first_order_options){.difference = 0.05, .tolerance = 1e-4, .most_iterations = 50, .start = NULL};
}

static pdmc_status evaluate(search *s, int count)
{
    s->evaluations += count;
    return s->limit->evaluate(s->limit->context, count, s->trial, s->value);
}

/// Row k of the trials: z with component i moved.
static void set_trial(search *s, int k, int i, double by)
{
    double *row = &s->trial[(size_t)k * (size_t)s->n];
    memcpy(row, s->z, (size_t)s->n * sizeof *row);
    row[i] += by;
}

/// One-sided where one of the neighbours cannot be solved.
static double difference(double below, double here, double above, double h)
{
    if (isnan(below)) return (above - here) / h;
    if (isnan(above)) return (here - below) / h;
    return (above - below) / (2.0 * h);
}

/// g and its gradient at z; NaN where they cannot be had.
static pdmc_status linearise(search *s)
{
    const double h = s->options->difference;
    for (int i = 0; i < s->n; i++) {
        set_trial(s, 2 * i, i, -h);
        set_trial(s, 2 * i + 1, i, h);
    }
    set_trial(s, 2 * s->n, 0, 0.0);
    const pdmc_status status = evaluate(s, 2 * s->n + 1);
    if (status != PDMC_OK) return status;
    s->g = s->value[2 * s->n];
    for (int i = 0; i < s->n; i++) s->gradient[i] = difference(s->value[2 * i], s->g, s->value[2 * i + 1], h);
    s->slope = sqrt(cblas_ddot(s->n, s->gradient, 1, s->gradient, 1));
    return PDMC_OK;
}

static bool has_slope(const search *s)
{
    return s->slope > 0.0 && isfinite(s->slope) && isfinite(s->g);
}

/// Moves z to the point of the axes where g is nearest to the other side, or leaves it where there is none better.
static pdmc_status leave_flat_start(search *s)
{
    int best = -1, count = 2 * REACHES * s->n;
    const double side = s->g > 0.0 ? -1.0 : 1.0;
    for (int k = 0; k < count; k++) {
        const double r = reach[k / (2 * s->n)];
        set_trial(s, k, k % s->n, k / s->n % 2 ? r : -r);
    }
    const pdmc_status status = evaluate(s, count);
    if (status != PDMC_OK) return status;
    for (int k = 0; k < count; k++)
        if (side * s->value[k] > (best < 0 ? -INFINITY : side * s->value[best])) best = k;
    if (best >= 0) memcpy(s->z, &s->trial[(size_t)best * (size_t)s->n], (size_t)s->n * sizeof *s->z);
    return linearise(s);
}

/// d, from z to the nearest point of the plane g + grad g . d = 0 to the origin.
static void aim(search *s)
{
    const double along = (cblas_ddot(s->n, s->gradient, 1, s->z, 1) - s->g) / (s->slope * s->slope);
    for (int i = 0; i < s->n; i++) s->step[i] = along * s->gradient[i] - s->z[i];
}

/// At the surface, and at that point of it whose direction is the surface's normal.
static bool arrived(const search *s)
{
    const double along = cblas_ddot(s->n, s->gradient, 1, s->z, 1) / s->slope;
    double beside = 0.0;
    for (int i = 0; i < s->n; i++) {
        const double off = s->z[i] - along * s->gradient[i] / s->slope;
        beside += off * off;
    }
    return fabs(s->g) <= s->options->tolerance * s->slope && sqrt(beside) <= s->options->tolerance;
}

/// c of the merit: twice what makes d a descent (Zhang & Der Kiureghian's choice).
static double penalty(const search *s, double z_norm, const double full[])
{
    const double least = z_norm / s->slope;
    const double target = cblas_ddot(s->n, full, 1, full, 1);
    if (fabs(s->g) <= s->options->tolerance * s->slope) return 2.0 * least;
    return 2.0 * fmax(least, 0.5 * target / fabs(s->g));
}

/// Takes the longest of the steps that decreases the merit enough. All are evaluated at once.
static pdmc_status advance(search *s, bool *moved)
{
    const double length = cblas_dnrm2(s->n, s->step, 1), z_norm = cblas_dnrm2(s->n, s->z, 1);
    const double first = fmin(1.0, longest_step / length);
    for (int k = 0; k < SHORTER_STEPS; k++) {
        double *row = &s->trial[(size_t)k * (size_t)s->n];
        memcpy(row, s->z, (size_t)s->n * sizeof *row);
        cblas_daxpy(s->n, ldexp(first, -k), s->step, 1, row, 1);
    }
    const pdmc_status status = evaluate(s, SHORTER_STEPS);
    if (status != PDMC_OK) return status;
    const double c = penalty(s, z_norm, s->trial), merit = 0.5 * z_norm * z_norm + c * fabs(s->g);
    const double rate = cblas_ddot(s->n, s->z, 1, s->step, 1) - c * fabs(s->g); // along d, where grad g . d = -g
    *moved = false;
    for (int k = 0; k < SHORTER_STEPS && !*moved; k++) {
        const double *row = &s->trial[(size_t)k * (size_t)s->n];
        const double there = 0.5 * cblas_ddot(s->n, row, 1, row, 1) + c * fabs(s->value[k]);
        *moved = there <= merit + enough * ldexp(first, -k) * rate; // never of NaN
        if (*moved) memcpy(s->z, row, (size_t)s->n * sizeof *row);
    }
    return PDMC_OK;
}

static pdmc_status iterate(search *s, bool *converged)
{
    bool moved = true;
    pdmc_status status = linearise(s);
    if (status == PDMC_OK && !has_slope(s)) status = leave_flat_start(s);
    *converged = false;
    for (int k = 0; k < s->options->most_iterations && status == PDMC_OK && moved && has_slope(s); k++) {
        if ((*converged = arrived(s))) break;
        aim(s);
        status = advance(s, &moved);
        if (status == PDMC_OK && moved) status = linearise(s);
    }
    return status;
}

static pdmc_status search_make(const pdmc_limit_state *limit, const pdmc_first_order_options *options, search *s)
{
    pdmc_status status = PDMC_OK;
    const int n = limit->dimension, rows = 2 * REACHES * n + SHORTER_STEPS; // more than any batch
    *s = (search){.limit = limit, .options = options, .n = n};
    PDMC_NEW(s->z, n);
    PDMC_NEW(s->gradient, n);
    PDMC_NEW(s->step, n);
    PDMC_NEW(s->trial, (size_t)rows * (size_t)n);
    PDMC_NEW(s->value, rows);
    if (options->start) memcpy(s->z, options->start, (size_t)n * sizeof *s->z);

done:
    return status;
}

static void search_clear(search *s)
{
    pdmc_free(s->z);
    pdmc_free(s->gradient);
    pdmc_free(s->step);
    pdmc_free(s->trial);
    pdmc_free(s->value);
}

/// The origin's side is the side of g there: the gradient points to the event, and so does z from an origin outside.
static void report(const search *s, bool converged, pdmc_first_order *point)
{
    point->converged = converged;
    point->evaluations = s->evaluations;
    point->residual = has_slope(s) ? fabs(s->g) / s->slope : NAN;
    point->index = point->probability = point->slope = NAN;
    memcpy(point->z, s->z, (size_t)s->n * sizeof *s->z);
    for (int i = 0; i < s->n; i++) point->importance[i] = NAN;
    if (!converged) return;
    point->index = copysign(cblas_dnrm2(s->n, s->z, 1), cblas_ddot(s->n, s->z, 1, s->gradient, 1));
    point->probability = gsl_cdf_ugaussian_Q(point->index);
    point->slope = s->slope;
    for (int i = 0; i < s->n; i++) point->importance[i] = pow(s->gradient[i] / s->slope, 2.0);
}

pdmc_status pdmc_first_order_find(const pdmc_limit_state *limit, const pdmc_first_order_options *options,
                                  pdmc_first_order *point)
{
    pdmc_status status = PDMC_OK;
    search s = {0};
    bool converged;
    *point = (pdmc_first_order){.dimension = limit->dimension};
    PDMC_REQUIRE(limit->dimension >= 1, "dimension = %d is not positive", limit->dimension);
    PDMC_REQUIRE(options->difference > 0.0, "difference = %g is not positive", options->difference);
    PDMC_REQUIRE(options->tolerance > 0.0, "tolerance = %g is not positive", options->tolerance);
    PDMC_NEW(point->z, limit->dimension);
    PDMC_NEW(point->importance, limit->dimension);
    PDMC_TRY(search_make(limit, options, &s));
    PDMC_TRY(iterate(&s, &converged));
    report(&s, converged, point);

done:
    search_clear(&s);
    return status;
}

void pdmc_first_order_clear(pdmc_first_order *point)
{
    pdmc_free(point->z);
    pdmc_free(point->importance);
    *point = (pdmc_first_order){0};
}
