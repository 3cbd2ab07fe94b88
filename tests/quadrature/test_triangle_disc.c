// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/quadrature.h"

#include "check.h"
#include "pdmc/random.h"

#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <string.h>

// By the signed sectors and triangles that each edge makes with the centre: each ray ends at the edge or at the circle.
// The implementation adds the parts that lie inside, this takes away what lies outside.
enum { DEGREE = 3, MONOMIALS = 10 };

static double monomial(int i, int j, double x, double y)
{
    return gsl_pow_int(x, i) * gsl_pow_int(y, j);
}

typedef struct {
    double radius, p[2], q[2];
    const gsl_integration_glfixed_table *table;
} wedge;

// int x^i y^j over the triangle of the centre, p and q.
static double triangle_integral(const wedge *w, int i, int j)
{
    double sum = 0.0;
    for (size_t k = 0; k < w->table->n; k++) {
        double t, weight;
        gsl_integration_glfixed_point(0.0, 1.0, k, &t, &weight, w->table);
        sum += weight * monomial(i, j, w->p[0] + t * (w->q[0] - w->p[0]), w->p[1] + t * (w->q[1] - w->p[1]));
    }
    return (w->p[0] * w->q[1] - w->p[1] * w->q[0]) * sum / (i + j + 2);
}

// ... over the sector from the direction of p to that of q.
static double sector_integral(const wedge *w, int i, int j)
{
    const double from = atan2(w->p[1], w->p[0]);
    const double angle = atan2(w->p[0] * w->q[1] - w->p[1] * w->q[0], w->p[0] * w->q[0] + w->p[1] * w->q[1]);
    double sum = 0.0;
    for (size_t k = 0; k < w->table->n; k++) {
        double t, weight;
        gsl_integration_glfixed_point(0.0, angle, k, &t, &weight, w->table);
        sum += weight * monomial(i, j, cos(from + t), sin(from + t));
    }
    return gsl_pow_int(w->radius, i + j + 2) * sum / (i + j + 2);
}

// The parts of an edge before, inside and after the disc: signed as the edge turns about the centre.
static void add_edge(const double a[2], const double b[2], double radius, int most,
                     const gsl_integration_glfixed_table *table, double integral[MONOMIALS])
{
    const double d[2] = {b[0] - a[0], b[1] - a[1]};
    const double dd = d[0] * d[0] + d[1] * d[1], ad = a[0] * d[0] + a[1] * d[1];
    const double root = ad * ad - dd * (a[0] * a[0] + a[1] * a[1] - radius * radius);
    const double half = root > 0.0 ? sqrt(root) / dd : 0.0;
    const double cut[4] = {0.0, GSL_MIN_DBL(1.0, GSL_MAX_DBL(0.0, -ad / dd - half)),
                           GSL_MIN_DBL(1.0, GSL_MAX_DBL(0.0, -ad / dd + half)), 1.0};
    for (int part = 0; part < 3; part++) {
        if (cut[part] == cut[part + 1]) continue;
        wedge w = {.radius = radius, .table = table};
        for (int k = 0; k < 2; k++) {
            w.p[k] = a[k] + cut[part] * d[k];
            w.q[k] = a[k] + cut[part + 1] * d[k];
        }
        for (int degree = 0, at = 0; degree <= most; degree++)
            for (int j = 0; j <= degree; j++, at++)
                integral[at] += (part == 1 ? triangle_integral : sector_integral)(&w, degree - j, j);
    }
}

static void integrate_by_edges(const double corner[6], double radius, int most,
                               const gsl_integration_glfixed_table *table, double integral[MONOMIALS])
{
    memset(integral, 0, MONOMIALS * sizeof *integral);
    for (int e = 0; e < 3; e++) add_edge(&corner[2 * e], &corner[2 * ((e + 1) % 3)], radius, most, table, integral);
    const double turn =
        (corner[2] - corner[0]) * (corner[5] - corner[1]) - (corner[3] - corner[1]) * (corner[4] - corner[0]);
    for (int at = 0; at < MONOMIALS; at++) integral[at] *= turn < 0.0 ? -1.0 : 1.0;
}

static void integrate_by_rule(const pdmc_triangle_disc_rule *rule, const double corner[6], double radius,
                              pdmc_area_rule *points, double integral[MONOMIALS])
{
    pdmc_triangle_disc_points(rule, corner, (double[2]){0.0, 0.0}, radius, points);
    assert_true(points->count <= rule->capacity);
    memset(integral, 0, MONOMIALS * sizeof *integral);
    for (int p = 0; p < points->count; p++) {
        const double *x = &points->x[2 * p];
        assert_true(points->weight[p] > 0.0 && hypot(x[0], x[1]) < radius * (1.0 + 1e-14));
        for (int degree = 0, at = 0; degree <= DEGREE; degree++)
            for (int j = 0; j <= degree; j++, at++)
                integral[at] += points->weight[p] * monomial(degree - j, j, x[0], x[1]);
    }
}

// A circle about the origin meets a triangle in one of these ways. The edges that are crossed once are two or none: a
// closed line enters as often as it leaves.
typedef struct {
    int code, corners;
    bool is_whole;
} way;
static const way ways[] = {{0, 0, false},   {0, 0, true},    {0, 3, false},   {110, 1, false}, {110, 2, false},
                           {200, 0, false}, {220, 0, false}, {222, 0, false}, {211, 1, false}};
enum { WAYS = sizeof ways / sizeof *ways };

static int way_of(const pdmc_triangle_disc_case *is)
{
    const int code = 100 * is->crossings[0] + 10 * is->crossings[1] + is->crossings[2];
    for (int w = 0; w < WAYS; w++)
        if (ways[w].code == code && ways[w].corners == is->corners && ways[w].is_whole == is->is_whole) return w;
    fail_msg("crossings %d with %d corners inside", code, is->corners);
    return -1;
}

// Of the radius squared, and so of what both ways of computing round: the reference's wedges reach to the circle.
static void random_intersections_have_their_area_and_their_integrals(void **state)
{
    (void)state;
    enum { CASES = FINEST_LEFT_OUT ? 4000 : 100000, INTEGRATED = FINEST_LEFT_OUT ? 400 : 4000 };
    int found[WAYS] = {0};
    double worst_area = 0.0, worst_integral = 0.0;
    pdmc_triangle_disc_rule rule;
    pdmc_area_rule points = {0};
    gsl_integration_glfixed_table *table = gsl_integration_glfixed_table_alloc(20);
    CHECK_OK(pdmc_triangle_disc_rule_create(DEGREE, &rule));
    points.x = pdmc_calloc(2 * (size_t)rule.capacity, sizeof(double));
    points.weight = pdmc_calloc((size_t)rule.capacity, sizeof(double));
    for (int sample = 0; sample < CASES; sample++) {
        double u[7], corner[6], want[MONOMIALS], got[MONOMIALS];
        pdmc_random_uniform(7, PDMC_STREAM_PROBES, (uint64_t)sample, 0, 7, u);
        for (int k = 0; k < 6; k++) corner[k] = 2.0 * u[k] - 1.0;
        const double radius = 0.02 + 1.2 * u[6] * u[6];
        const pdmc_triangle_disc_case is = pdmc_triangle_disc_classify(corner, (double[2]){0.0, 0.0}, radius);
        found[way_of(&is)]++;
        integrate_by_edges(corner, radius, sample < INTEGRATED ? DEGREE : 0, table, want);
        const double area = pdmc_triangle_disc_area(corner, (double[2]){0.0, 0.0}, radius);
        worst_area = fmax(worst_area, fabs(area - want[0]));
        if (sample >= INTEGRATED) continue;
        integrate_by_rule(&rule, corner, radius, &points, got);
        for (int at = 0; at < MONOMIALS; at++) worst_integral = fmax(worst_integral, fabs(got[at] - want[at]));
    }
    print_message("area %.2g, integrals to degree 3 %.2g\n", worst_area, worst_integral);
    for (int w = 0; w < WAYS; w++) print_message("  %03d, %d corners: %d\n", ways[w].code, ways[w].corners, found[w]);
    for (int w = 0; w < WAYS; w++) assert_true(found[w] > 0);
    CHECK_NEAR(worst_area, 0.0, 1e-13);
    CHECK_NEAR(worst_integral, 0.0, 1e-12);
    pdmc_free(points.x);
    pdmc_free(points.weight);
    pdmc_triangle_disc_rule_clear(&rule);
    gsl_integration_glfixed_table_free(table);
}

static double area(double x1, double y1, double x2, double y2, double x3, double y3, double radius)
{
    const double corner[6] = {x1 + 5.0, y1 - 2.0, x2 + 5.0, y2 - 2.0, x3 + 5.0, y3 - 2.0};
    return pdmc_triangle_disc_area(corner, (double[2]){5.0, -2.0}, radius);
}

// A centre on an edge or in a corner, circles that touch an edge, corners on the circle: where a rounded point decides
// what is crossed, the area does not jump.
static void touching_circles_have_the_area_of_their_neighbours(void **state)
{
    (void)state;
    const double tolerance = 1e-14;
    CHECK_NEAR(area(-3.0, 0.0, 3.0, 0.0, 0.0, 4.0, 1.0), M_PI_2, tolerance); // half a disc
    CHECK_NEAR(area(0.0, 0.0, 3.0, 0.0, 0.0, 4.0, 1.0), M_PI_4, tolerance);  // a quarter, from a corner
    CHECK_NEAR(area(-3.0, -1.0, 3.0, -1.0, 0.0, 5.0, 1.0), M_PI, tolerance); // touched from inside
    CHECK_NEAR(area(-3.0, 1.0, 3.0, 1.0, 0.0, 5.0, 1.0), 0.0, tolerance);    // ... and from outside
    CHECK_NEAR(area(0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0), 0.5, tolerance);     // two corners on the circle
    CHECK_NEAR(area(1.0, 0.0, 2.0, 0.0, 1.0, 1.0, 1.0), 0.0, tolerance);     // one, all else outside
    CHECK_NEAR(area(1.0, 0.0, -1.0, 0.0, 0.0, 1.0, 1.0), 1.0, tolerance);    // all three
    CHECK_NEAR(area(0.0, 0.0, 1.0, 0.0, 2.0, 0.0, 1.5), 0.0, tolerance);     // no area at all
    for (int i = -3; i <= 3; i++) { // a lower edge nearly touched, by as little as a rounding
        const double shift = -1.0 + i * 1.1e-16;
        CHECK_NEAR(area(-3.0, shift, 3.0, shift, 0.0, 5.0, 1.0), M_PI, tolerance);
        CHECK_NEAR(area(0.6 + i * 1.1e-16, 0.8, 2.0, 0.8, 0.6, 3.0, 1.0), 0.0, tolerance);
    }
}

// A corner a rounding outside the circle has an arc of no length between its two chords, whose ends are rounded.
static void a_corner_on_the_circle_has_no_arc(void **state)
{
    (void)state;
    for (int i = 0; i < 2000; i++) {
        const double angle = 0.001 * i, radius = 1.0 + (i % 3) * 1.1e-16;
        const double x = radius * cos(angle), y = radius * sin(angle);
        CHECK_NEAR(area(x, y, -0.3, 0.1, 0.2, -0.1, 1.0), 0.5 * fabs((-0.3 - x) * (-0.1 - y) - (0.1 - y) * (0.2 - x)),
                   1e-15);
    }
}

// At the highest degree, on half a disc: the odd moments of y are what changes sign.
static void high_degrees_are_exact(void **state)
{
    (void)state;
    pdmc_triangle_disc_rule rule;
    const double corner[6] = {-9.0, 0.0, 9.0, 0.0, 0.0, 9.0};
    CHECK_OK(pdmc_triangle_disc_rule_create(PDMC_TRIANGLE_DISC_DEGREE, &rule));
    pdmc_area_rule points = {.x = pdmc_calloc(2 * (size_t)rule.capacity, sizeof(double)),
                             .weight = pdmc_calloc((size_t)rule.capacity, sizeof(double))};
    pdmc_triangle_disc_points(&rule, corner, (double[2]){0.0, 0.0}, 2.0, &points);
    double sum = 0.0;
    for (int p = 0; p < points.count; p++) sum += points.weight[p] * gsl_pow_int(points.x[2 * p + 1], 11);
    // int r^12 dr = 2^13 / 13, int_0^pi sin^11 = 2 * 10!! / 11!! = 512 / 693
    CHECK_NEAR(sum, 8192.0 / 13.0 * 512.0 / 693.0, 1e-12 * 8192.0);
    pdmc_free(points.x);
    pdmc_free(points.weight);
    pdmc_triangle_disc_rule_clear(&rule);
    CHECK_STATUS(pdmc_triangle_disc_rule_create(-1, &rule), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_triangle_disc_rule_create(PDMC_TRIANGLE_DISC_DEGREE + 1, &rule), PDMC_ERR_ARG);
    CHECK_FAILS_CLEANLY(pdmc_triangle_disc_rule_create(2, &rule), pdmc_triangle_disc_rule_clear(&rule));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_intersections_have_their_area_and_their_integrals),
        cmocka_unit_test(touching_circles_have_the_area_of_their_neighbours),
        cmocka_unit_test(a_corner_on_the_circle_has_no_arc),
        cmocka_unit_test(high_degrees_are_exact),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
