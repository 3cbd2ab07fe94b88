// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/pair.h"

#include "base/base_impl.h"
#include "galerkin/kernel.h"

#include <math.h>

enum { DEGREE = 4 }; // of the rule for polynomials: two of the values, and two to spare for the kernel

pdmc_status pdmc_pair_rule_create(const pdmc_scalar_kernel *kernel, const pdmc_form_rule *rule, pdmc_pair_rule *out)
{
    pdmc_status status = PDMC_OK;
    const pdmc_form_rule gauss = {.outer = PDMC_OUTER_GAUSS, .parts = 1};
    pdmc_pair_rule made = {.kernel = kernel, .rule = *rule};
    *out = (pdmc_pair_rule){0};
    PDMC_REQUIRE(rule->parts >= 1, "%d parts are not 1 or more", rule->parts);
    PDMC_REQUIRE(kernel->dimension == 1 || rule->outer != PDMC_OUTER_EXACT,
                 "the outer integral cannot be exact in two dimensions");
    PDMC_REQUIRE(kernel->dimension == 2 || rule->outer != PDMC_OUTER_EDGES || kernel->power < 1.0,
                 "in the ends of intervals a kernel of power %g has an infinite integral, the power must be < 1",
                 kernel->power);
    PDMC_TRY(pdmc_element_rule_outer(kernel->dimension, rule, &made.outer));
    PDMC_TRY(pdmc_element_rule_outer(kernel->dimension, &gauss, &made.careless));
    PDMC_TRY(pdmc_triangle_disc_rule_create(DEGREE, &made.polynomial));
    if (made.polynomial.capacity > PDMC_INNER_POINTS)
        PDMC_FAIL(PDMC_ERR_ARG, "an intersection needs %d points", made.polynomial.capacity);
    PDMC_TRY(pdmc_gauss_legendre(6, 0.0, 1.0, made.x[0], made.w[0]));
    PDMC_TRY(pdmc_gauss_legendre(10, 0.0, 1.0, made.x[1], made.w[1]));
    *out = made;
    made = (pdmc_pair_rule){0};
done:
    pdmc_pair_rule_clear(&made);
    return status;
}

void pdmc_pair_rule_clear(pdmc_pair_rule *rule)
{
    pdmc_element_rule_clear(&rule->outer);
    pdmc_element_rule_clear(&rule->careless);
    pdmc_triangle_disc_rule_clear(&rule->polynomial);
    *rule = (pdmc_pair_rule){0};
}

bool pdmc_pair_is_ordered(const pdmc_pair_rule *rule)
{
    return rule->rule.outer != PDMC_OUTER_EXACT;
}

// ---- the inner integral ----

static void add_point(double x, double y, double weight, pdmc_area_rule *points)
{
    points->x[2 * points->count] = x;
    points->x[2 * points->count + 1] = y;
    points->weight[points->count++] = weight;
}

static void careless_points(const pdmc_pair_rule *rule, const pdmc_element *other, pdmc_area_rule *points)
{
    for (int p = 0; p < rule->careless.count; p++) {
        double x[2];
        pdmc_element_point(other, rule->kernel->dimension, &rule->careless.at[PDMC_CORNERS * p], x);
        add_point(x[0], x[1], other->size * rule->careless.weight[p], points);
    }
}

// The part of an interval within the horizon, on one side of the centre after the other.
static void points_of_interval(const pdmc_pair_rule *rule, const pdmc_element *other, const double x[2],
                               pdmc_area_rule *points)
{
    const double horizon = rule->kernel->horizon, cut[3] = {x[0] - horizon, x[0], x[0] + horizon};
    for (int side = 0; side < 2; side++) {
        const double from = fmax(other->corner[0][0], cut[side]), to = fmin(other->corner[1][0], cut[side + 1]);
        for (int p = 0; p < rule->careless.count && from < to; p++) {
            const double *at = &rule->careless.at[PDMC_CORNERS * p];
            add_point(at[0] * from + at[1] * to, 0.0, (to - from) * rule->careless.weight[p], points);
        }
    }
}

void pdmc_pair_points(const pdmc_pair_rule *rule, const pdmc_element *other, const double x[2], pdmc_area_rule *points)
{
    points->count = 0;
    if (rule->rule.inner == PDMC_INNER_CARELESS) careless_points(rule, other, points);
    else if (rule->kernel->dimension == 1) points_of_interval(rule, other, x, points);
    else pdmc_triangle_disc_points(&rule->polynomial, (const double *)other->corner, x, rule->kernel->horizon, points);
}

static pdmc_moments moments_by_points(const pdmc_pair_rule *rule, const pdmc_element *other, const double x[2])
{
    pdmc_moments m = {0};
    double place[2 * PDMC_INNER_POINTS], weight[PDMC_INNER_POINTS];
    pdmc_area_rule points = {.x = place, .weight = weight};
    pdmc_pair_points(rule, other, x, &points);
    for (int p = 0; p < points.count; p++) {
        const double xi[2] = {place[2 * p] - x[0], place[2 * p + 1] - x[1]}, r = sqrt(xi[0] * xi[0] + xi[1] * xi[1]);
        if (r > 0.0) pdmc_moments_add(xi, weight[p] * pdmc_scalar_kernel_at(rule->kernel, r), &m);
    }
    return m;
}

static pdmc_moments exact_moments(const pdmc_pair_rule *rule, const pdmc_element *other, const double x[2])
{
    pdmc_moments m;
    double corner[PDMC_CORNERS][2];
    for (int a = 0; a < PDMC_CORNERS; a++)
        for (int d = 0; d < 2; d++) corner[a][d] = other->corner[a][d] - x[d];
    if (rule->kernel->dimension == 1) pdmc_interval_moments(rule->kernel, corner[0][0], corner[1][0], &m);
    else pdmc_triangle_moments(rule->kernel, corner, &m);
    return m;
}

// ---- pairs ----

// Within one element u' - u goes with xi, and the zeroth moment, which need not be finite, is not asked for.
static void add_same(int n, const pdmc_element *e, const pdmc_moments *m, double weight, pdmc_pair_block *block)
{
    for (int a = 0; a < n; a++) {
        const double *g = e->gradient[a];
        const double p[2] = {weight * (m->second[0] * g[0] + m->second[1] * g[1]),
                             weight * (m->second[1] * g[0] + m->second[2] * g[1])};
        for (int b = 0; b < n; b++) block->own[a][b] += p[0] * e->gradient[b][0] + p[1] * e->gradient[b][1];
    }
}

// The other's values v' = v'(x) + gradient'.xi, continued to the point x of the first element: int c v' and int c v' xi.
static void add_different(int n, const double near[], const double far[], const pdmc_element *other,
                          const pdmc_moments *m, double weight, pdmc_pair_block *block)
{
    for (int a = 0; a < n; a++) {
        const double *g = other->gradient[a], own = weight * near[a] * m->zero;
        const double zero = weight * (far[a] * m->zero + g[0] * m->first[0] + g[1] * m->first[1]);
        const double first[2] = {weight * (far[a] * m->first[0] + g[0] * m->second[0] + g[1] * m->second[1]),
                                 weight * (far[a] * m->first[1] + g[0] * m->second[1] + g[1] * m->second[2])};
        for (int b = 0; b < n; b++) {
            const double *h = other->gradient[b];
            block->own[a][b] += own * near[b];
            block->cross[a][b] -= zero * near[b];
            block->far[a][b] += far[b] * zero + h[0] * first[0] + h[1] * first[1];
        }
    }
}

void pdmc_pair_add_moments(int corners, const pdmc_element *element, const pdmc_element *other, bool same,
                           const double near[], const double far[], const pdmc_moments *m, double weight,
                           pdmc_pair_block *block)
{
    if (same) add_same(corners, element, m, weight, block);
    else add_different(corners, near, far, other, m, weight, block);
}

bool pdmc_pair_is_beyond(const pdmc_pair_rule *rule, const pdmc_element *other, const double x[2])
{
    const double d[2] = {other->middle[0] - x[0], other->middle[1] - x[1]};
    const double reach = rule->kernel->horizon + other->radius;
    return d[0] * d[0] + d[1] * d[1] >= reach * reach;
}

void pdmc_pair_integrate(const pdmc_pair_rule *rule, const pdmc_element *element, const pdmc_element *other, bool same,
                         pdmc_pair_block *block)
{
    const int dimension = rule->kernel->dimension;
    if (!pdmc_pair_is_ordered(rule)) {
        pdmc_interval_pair(rule, element, other, same, block);
        return;
    }
    *block = (pdmc_pair_block){0};
    for (int p = 0; p < rule->outer.count; p++) {
        double x[2], far[PDMC_CORNERS];
        const double *near = &rule->outer.at[PDMC_CORNERS * p], weight = 0.5 * element->size * rule->outer.weight[p];
        pdmc_element_point(element, dimension, near, x);
        if (pdmc_pair_is_beyond(rule, other, x)) continue;
        const pdmc_moments m =
            rule->rule.inner == PDMC_INNER_EXACT ? exact_moments(rule, other, x) : moments_by_points(rule, other, x);
        pdmc_element_coordinates(other, dimension, x, far);
        pdmc_pair_add_moments(dimension + 1, element, other, same, near, far, &m, weight, block);
    }
}
