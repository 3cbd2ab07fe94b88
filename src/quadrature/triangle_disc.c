// SPDX-License-Identifier: GPL-3.0-or-later

/// Intersections of a triangle and a disc. Each edge has a chord, the part of it that lies in the disc; between the end
/// of a chord and the beginning of the next one runs an arc. So the intersection is the polygon of the ends of the
/// chords and a segment of the disc on each side that is an arc. All this is done with the centre at the origin and a
/// radius of 1.

#include "pdmc/quadrature.h"

#include "base/base_impl.h"

#include <float.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_sf_gamma.h>
#include <math.h>

enum { MOST_TRIANGLES = 4, MOST_ARCS = 3 };

typedef struct {
    int chords;
    double chord[3][2][2]; // [chord, from or to, coordinate], counter-clockwise
    pdmc_triangle_disc_case is;
} section;

static double cross(const double a[2], const double b[2])
{
    return a[0] * b[1] - a[1] * b[0];
}

static double dot(const double a[2], const double b[2])
{
    return a[0] * b[0] + a[1] * b[1];
}

static void scale_corners(const double corner[6], const double centre[2], double radius, double scaled[3][2])
{
    for (int i = 0; i < 3; i++)
        for (int d = 0; d < 2; d++) scaled[i][d] = (corner[2 * i + d] - centre[d]) / radius;
    const double ab[2] = {scaled[1][0] - scaled[0][0], scaled[1][1] - scaled[0][1]};
    const double ac[2] = {scaled[2][0] - scaled[0][0], scaled[2][1] - scaled[0][1]};
    if (cross(ab, ac) >= 0.0) return;
    for (int d = 0; d < 2; d++) {
        const double swap = scaled[1][d];
        scaled[1][d] = scaled[2][d];
        scaled[2][d] = swap;
    }
}

// Adds the chord of the edge from a to b, if it has one, and returns how often the circle crosses the edge. The corners
// decide which crossings there are, so that two edges agree about the corner between them.
static int add_chord(const double a[2], const double b[2], section *s)
{
    const bool is_in[2] = {dot(a, a) <= 1.0, dot(b, b) <= 1.0};
    const double length = hypot(b[0] - a[0], b[1] - a[1]);
    if (length == 0.0) return 0;
    const double u[2] = {(b[0] - a[0]) / length, (b[1] - a[1]) / length};
    const double foot = -dot(a, u), half = sqrt(fmax(0.0, 1.0 - gsl_pow_2(cross(a, u))));
    if (!is_in[0] && !is_in[1] && (half == 0.0 || foot <= 0.0 || foot >= length)) return 0;
    const double from = is_in[0] ? 0.0 : fmin(length, fmax(0.0, foot - half));
    const double to = is_in[1] ? length : fmin(length, fmax(0.0, foot + half));
    for (int d = 0; d < 2; d++) {
        s->chord[s->chords][0][d] = is_in[0] ? a[d] : a[d] + from * u[d];
        s->chord[s->chords][1][d] = is_in[1] ? b[d] : a[d] + to * u[d];
    }
    s->chords++;
    return !is_in[0] + !is_in[1];
}

static bool has_origin(double x[3][2])
{
    bool inside = true;
    for (int i = 0; i < 3; i++) inside = inside && cross(x[i], x[(i + 1) % 3]) >= 0.0;
    return inside;
}

static void sort_descending(int crossings[3])
{
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2 - i; j++)
            if (crossings[j] < crossings[j + 1]) {
                const int swap = crossings[j];
                crossings[j] = crossings[j + 1];
                crossings[j + 1] = swap;
            }
}

static section intersect(double x[3][2])
{
    section s = {0};
    for (int i = 0; i < 3; i++) {
        s.is.corners += dot(x[i], x[i]) <= 1.0;
        s.is.crossings[i] = add_chord(x[i], x[(i + 1) % 3], &s);
    }
    s.is.is_whole = s.chords == 0 && has_origin(x);
    sort_descending(s.is.crossings);
    return s;
}

// The angle of the arc that follows a chord. A chord is either a rounded point or longer than the root of the rounding
// of 1, and only after a single one of these can the arc be almost the whole circle; so less than nothing is nothing,
// as where two chords meet in a corner.
static double arc_after(const section *s, int chord)
{
    const double *from = s->chord[chord][1], *to = s->chord[(chord + 1) % s->chords][0];
    const double angle = atan2(cross(from, to), dot(from, to)), rounding = 1e-9;
    if (angle > 0.0) return angle;
    return angle > -rounding ? 0.0 : angle + 2.0 * M_PI;
}

pdmc_triangle_disc_case pdmc_triangle_disc_classify(const double corner[6], const double centre[2], double radius)
{
    double x[3][2];
    scale_corners(corner, centre, radius, x);
    return intersect(x).is;
}

double pdmc_triangle_disc_area(const double corner[6], const double centre[2], double radius)
{
    double x[3][2], twice = 0.0;
    scale_corners(corner, centre, radius, x);
    const section s = intersect(x);
    if (s.is.is_whole) return M_PI * radius * radius;
    for (int i = 0; i < s.chords; i++) {
        const double *from = s.chord[i][0], *to = s.chord[i][1];
        twice += cross(from, to) + arc_after(&s, i);
    }
    return 0.5 * twice * radius * radius;
}

// The product of frequency and angle up to which a Gauss rule of n points over [0, angle] integrates sines and cosines
// of that frequency: the bound of its error, (n!)^4 / ((2n+1) (2n)!^3) times that product to the power 2n, is below
// rounding.
static double reach_of(unsigned n)
{
    const double log_factor =
        4.0 * gsl_sf_lnfact(n) - 3.0 * gsl_sf_lnfact(2 * n) - log(2.0 * n + 1.0) - log(0.5 * DBL_EPSILON);
    return exp(-log_factor / (2.0 * n));
}

static int points_of_arc(const pdmc_triangle_disc_rule *rule, double half_angle)
{
    int n = 1;
    while (n < PDMC_TRIANGLE_DISC_LINE && rule->reach[n - 1] < (rule->degree + 2) * half_angle) n++;
    return n;
}

static int points_of_triangle(int degree)
{
    return (degree + 3) / 2; // along the axis the degree is one more, by the width
}

static int points_across(int degree)
{
    return degree / 2 + 1;
}

// Where the rule of n points begins.
static int start_of(int n)
{
    return n * (n - 1) / 2;
}

pdmc_status pdmc_triangle_disc_rule_create(int degree, pdmc_triangle_disc_rule *rule)
{
    pdmc_status status = PDMC_OK;
    pdmc_triangle_disc_rule made = {.degree = degree};
    *rule = (pdmc_triangle_disc_rule){0};
    PDMC_REQUIRE(0 <= degree && degree <= PDMC_TRIANGLE_DISC_DEGREE, "degree %d is not in [0, %d]", degree,
                 PDMC_TRIANGLE_DISC_DEGREE);
    PDMC_NEW(made.x, start_of(PDMC_TRIANGLE_DISC_LINE + 1));
    PDMC_NEW(made.w, start_of(PDMC_TRIANGLE_DISC_LINE + 1));
    for (int n = 1; n <= PDMC_TRIANGLE_DISC_LINE; n++)
        PDMC_TRY(pdmc_gauss_legendre(n, 0.0, 1.0, &made.x[start_of(n)], &made.w[start_of(n)]));
    for (int n = 1; n <= PDMC_TRIANGLE_DISC_LINE; n++) made.reach[n - 1] = reach_of((unsigned)n);
    made.capacity = MOST_TRIANGLES * points_of_triangle(degree) * points_of_triangle(degree) +
                    MOST_ARCS * points_of_arc(&made, M_PI) * points_across(degree);
    *rule = made;
    made = (pdmc_triangle_disc_rule){0};
done:
    pdmc_triangle_disc_rule_clear(&made);
    return status;
}

void pdmc_triangle_disc_rule_clear(pdmc_triangle_disc_rule *rule)
{
    pdmc_free(rule->x);
    pdmc_free(rule->w);
    *rule = (pdmc_triangle_disc_rule){0};
}

static void add_point(double x, double y, double weight, pdmc_area_rule *points)
{
    points->x[2 * points->count] = x;
    points->x[2 * points->count + 1] = y;
    points->weight[points->count++] = weight;
}

// Gauss' rules along lines from the corner a and across, collapsed at a.
static void add_triangle(const pdmc_triangle_disc_rule *rule, const double a[2], const double b[2], const double c[2],
                         pdmc_area_rule *points)
{
    const int n = points_of_triangle(rule->degree);
    const double *x = &rule->x[start_of(n)], *w = &rule->w[start_of(n)];
    const double ab[2] = {b[0] - a[0], b[1] - a[1]}, bc[2] = {c[0] - b[0], c[1] - b[1]};
    const double twice_area = cross(ab, bc);
    if (!(twice_area > 0.0)) return; // two of the corners are one
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            add_point(a[0] + x[i] * (ab[0] + x[j] * bc[0]), a[1] + x[i] * (ab[1] + x[j] * bc[1]),
                      twice_area * w[i] * w[j] * x[i], points);
}

// The chord at the angle t from the middle of the arc is 2 sin t long, and d(cos t) from the next: so a polynomial
// becomes one of sines and cosines of t.
static void add_segment(const pdmc_triangle_disc_rule *rule, const double middle[2], double half_angle,
                        pdmc_area_rule *points)
{
    const int n = points_of_arc(rule, half_angle), m = points_across(rule->degree);
    const double *x = &rule->x[start_of(n)], *w = &rule->w[start_of(n)];
    const double *y = &rule->x[start_of(m)], *v = &rule->w[start_of(m)];
    for (int i = 0; i < n; i++) {
        const double along = cos(half_angle * x[i]), half_chord = sin(half_angle * x[i]);
        for (int j = 0; j < m; j++) {
            const double across = half_chord * (2.0 * y[j] - 1.0);
            add_point(along * middle[0] - across * middle[1], along * middle[1] + across * middle[0],
                      2.0 * half_angle * w[i] * v[j] * half_chord * half_chord, points);
        }
    }
}

static void add_arc(const pdmc_triangle_disc_rule *rule, const section *s, int chord, pdmc_area_rule *points)
{
    const double *from = s->chord[chord][1];
    const double half_angle = 0.5 * arc_after(s, chord);
    const double middle[2] = {cos(half_angle) * from[0] - sin(half_angle) * from[1],
                              cos(half_angle) * from[1] + sin(half_angle) * from[0]};
    if (half_angle > 0.0) add_segment(rule, middle, half_angle, points);
}

// The fan of triangles from the first corner of the polygon; ends that follow each other may be the same point.
static void add_polygon(const pdmc_triangle_disc_rule *rule, const section *s, pdmc_area_rule *points)
{
    for (int i = 1; i + 1 < 2 * s->chords; i++)
        add_triangle(rule, s->chord[0][0], s->chord[i / 2][i % 2], s->chord[(i + 1) / 2][(i + 1) % 2], points);
}

void pdmc_triangle_disc_points(const pdmc_triangle_disc_rule *rule, const double corner[6], const double centre[2],
                               double radius, pdmc_area_rule *points)
{
    double x[3][2];
    scale_corners(corner, centre, radius, x);
    const section s = intersect(x);
    points->count = 0;
    if (s.is.is_whole) add_segment(rule, (double[2]){1.0, 0.0}, M_PI, points);
    add_polygon(rule, &s, points);
    for (int i = 0; i < s.chords; i++) add_arc(rule, &s, i, points);
    for (int i = 0; i < points->count; i++) {
        for (int d = 0; d < 2; d++) points->x[2 * i + d] = centre[d] + radius * points->x[2 * i + d];
        points->weight[i] *= radius * radius;
    }
}
