// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/pair.h"

#include "base/base_impl.h"
#include "galerkin/kernel.h"

#include <math.h>

enum {
    MOST_POINTS = 256,
    DEGREE = 4
}; // of the rule for polynomials: two of the values, and two to spare for the kernel

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
    if (made.polynomial.capacity > MOST_POINTS)
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

static void add_inner_point(const pdmc_scalar_kernel *kernel, const double xi[2], double weight, pdmc_moments *m)
{
    const double r = sqrt(xi[0] * xi[0] + xi[1] * xi[1]);
    if (r == 0.0 || r >= kernel->horizon) return;
    const double c = weight * pdmc_scalar_kernel_at(kernel, r);
    m->zero += c;
    for (int k = 0; k < 2; k++) m->first[k] += c * xi[k];
    for (int k = 0; k < 3; k++) m->second[k] += c * xi[k / 2] * xi[(k + 1) / 2];
}

static pdmc_moments careless_moments(const pdmc_pair_rule *rule, const pdmc_element *other, const double x[2])
{
    pdmc_moments m = {0};
    for (int p = 0; p < rule->careless.count; p++) {
        double xi[2];
        pdmc_element_point(other, rule->kernel->dimension, &rule->careless.at[PDMC_CORNERS * p], xi);
        for (int d = 0; d < 2; d++) xi[d] -= x[d];
        add_inner_point(rule->kernel, xi, other->size * rule->careless.weight[p], &m);
    }
    return m;
}

// The part of an interval within the horizon, on one side of the centre after the other.
static pdmc_moments polynomial_interval(const pdmc_pair_rule *rule, const pdmc_element *other, const double x[2])
{
    pdmc_moments m = {0};
    const double horizon = rule->kernel->horizon, cut[3] = {-horizon, 0.0, horizon};
    for (int side = 0; side < 2; side++) {
        const double from = fmax(other->corner[0][0] - x[0], cut[side]);
        const double to = fmin(other->corner[1][0] - x[0], cut[side + 1]);
        for (int p = 0; p < rule->careless.count && from < to; p++) {
            const double *at = &rule->careless.at[PDMC_CORNERS * p];
            add_inner_point(rule->kernel, (double[2]){at[0] * from + at[1] * to, 0.0},
                            (to - from) * rule->careless.weight[p], &m);
        }
    }
    return m;
}

static pdmc_moments polynomial_triangle(const pdmc_pair_rule *rule, const pdmc_element *other, const double x[2])
{
    pdmc_moments m = {0};
    double place[2 * MOST_POINTS], weight[MOST_POINTS];
    pdmc_area_rule points = {.x = place, .weight = weight};
    pdmc_triangle_disc_points(&rule->polynomial, (const double *)other->corner, x, rule->kernel->horizon, &points);
    for (int p = 0; p < points.count; p++)
        add_inner_point(rule->kernel, (double[2]){place[2 * p] - x[0], place[2 * p + 1] - x[1]}, weight[p], &m);
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

static pdmc_moments inner_moments(const pdmc_pair_rule *rule, const pdmc_element *other, const double x[2])
{
    switch (rule->rule.inner) {
    case PDMC_INNER_EXACT: return exact_moments(rule, other, x);
    case PDMC_INNER_POLYNOMIAL: break;
    case PDMC_INNER_CARELESS: return careless_moments(rule, other, x);
    }
    return rule->kernel->dimension == 1 ? polynomial_interval(rule, other, x) : polynomial_triangle(rule, other, x);
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

static bool is_beyond(const pdmc_pair_rule *rule, const pdmc_element *other, const double x[2])
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
        if (is_beyond(rule, other, x)) continue;
        const pdmc_moments m = inner_moments(rule, other, x);
        pdmc_element_coordinates(other, dimension, x, far);
        if (same) add_same(dimension + 1, element, &m, weight, block);
        else add_different(dimension + 1, near, far, other, &m, weight, block);
    }
}
