// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/sight.h"

#include "check.h"
#include "pdmc/geometry.h"
#include "pdmc/random.h"

#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <string.h>

enum { MOMENTS = 12, MOST_CRACKS = 3 };
static const double horizon = 0.8;

// The same integrals by another way: over the angle by GSL, along each ray in closed form between where it enters and leaves
// the triangle, the bin, or meets a crack.
typedef struct {
    double (*corner)[2];
    int cracks;
    const pdmc_crack *crack; // [cracks]
    double inner, outer;     // of the bin
    int degree, power;       // of the moment: r^(degree - 3) e_x^(degree - power) e_y^power
} rays;

// Where the ray from the origin meets the segment ab, or infinity.
static double meet(const double e[2], const double a[2], const double b[2])
{
    const double d[2] = {b[0] - a[0], b[1] - a[1]}, determinant = d[0] * e[1] - d[1] * e[0];
    const double t = (a[1] * e[0] - a[0] * e[1]) / determinant, r = (d[0] * a[1] - d[1] * a[0]) / determinant;
    return t >= 0.0 && t <= 1.0 && r > 0.0 ? r : INFINITY;
}

static double along_ray(double theta, void *context)
{
    const rays *c = context;
    const double e[2] = {cos(theta), sin(theta)};
    double near = INFINITY, far = 0.0;
    for (int i = 0; i < 3; i++) {
        const double r = meet(e, c->corner[i], c->corner[(i + 1) % 3]);
        near = fmin(near, r);
        if (isfinite(r)) far = fmax(far, r);
    }
    if (near == far) near = 0.0; // the origin is inside
    for (int k = 0; k < c->cracks; k++)
        if (meet(e, c->crack[k].from, c->crack[k].to) < far) return 0.0; // none passes through the triangle
    near = fmax(near, c->inner);
    far = fmin(far, c->outer);
    const int m = c->degree - 1;
    return near < far ? (gsl_pow_int(far, m) - gsl_pow_int(near, m)) / m * gsl_pow_int(e[0], c->degree - c->power) *
                            gsl_pow_int(e[1], c->power)
                      : 0.0;
}

static void add_angle(const double x[2], int *count, double angle[])
{
    angle[(*count)++] = atan2(x[1], x[0]);
}

// The directions between which a ray's ends change smoothly: of corners, of ends of cracks, and of where edges meet circles.
static int find_angles(const rays *c, double angle[])
{
    int count = 0;
    angle[count++] = -M_PI;
    for (int i = 0; i < 3; i++) {
        const double *a = c->corner[i], *b = c->corner[(i + 1) % 3], d[2] = {b[0] - a[0], b[1] - a[1]};
        add_angle(a, &count, angle);
        for (int k = 0; k < 2; k++) {
            const double radius = k == 0 ? c->inner : c->outer, p = a[0] * d[0] + a[1] * d[1];
            const double q = d[0] * d[0] + d[1] * d[1], w = p * p - q * (a[0] * a[0] + a[1] * a[1] - radius * radius);
            for (int sign = -1; sign <= 1 && w > 0.0; sign += 2) {
                const double t = (-p + sign * sqrt(w)) / q;
                if (t > 0.0 && t < 1.0) add_angle((double[2]){a[0] + t * d[0], a[1] + t * d[1]}, &count, angle);
            }
        }
    }
    for (int k = 0; k < c->cracks; k++) {
        add_angle(c->crack[k].from, &count, angle);
        add_angle(c->crack[k].to, &count, angle);
    }
    angle[count++] = M_PI;
    for (int i = 1; i < count; i++)
        for (int j = i; j > 0 && angle[j - 1] > angle[j]; j--) {
            const double later = angle[j - 1];
            angle[j - 1] = angle[j];
            angle[j] = later;
        }
    return count;
}

static double by_rays(rays *c)
{
    double angle[64], sum = 0.0;
    const int count = find_angles(c, angle);
    gsl_integration_glfixed_table *rule = gsl_integration_glfixed_table_alloc(40);
    const gsl_function f = {along_ray, c};
    for (int i = 1; i < count; i++)
        if (angle[i] > angle[i - 1]) sum += gsl_integration_glfixed(&f, angle[i - 1], angle[i], rule);
    gsl_integration_glfixed_table_free(rule);
    return sum;
}

static double entry(const pdmc_bond_moments *m, int degree, int power)
{
    return degree == 2 ? m->second[power] : degree == 3 ? m->third[power] : m->fourth[power];
}

static void check_by_rays(double corner[3][2], int cracks, const pdmc_crack crack[], int bins,
                          const pdmc_bond_moments moments[], double tolerance)
{
    for (int bin = 0; bin < bins; bin++)
        for (int degree = 2; degree <= 4; degree++)
            for (int power = 0; power <= degree; power++) {
                rays c = {corner, cracks, crack, horizon * bin / bins, horizon * (bin + 1) / bins, degree, power};
                CHECK_NEAR(entry(&moments[bin], degree, power), by_rays(&c), tolerance);
            }
}

static bool random_triangle(uint64_t sample, double corner[3][2])
{
    double u[6];
    pdmc_random_uniform(7, PDMC_STREAM_PROBES, sample, 0, 6, u);
    for (int k = 0; k < 6; k++) corner[k / 2][k % 2] = 2.0 * u[k] - 1.0;
    const double turn = (corner[1][0] - corner[0][0]) * (corner[2][1] - corner[0][1]) -
                        (corner[1][1] - corner[0][1]) * (corner[2][0] - corner[0][0]);
    if (turn < 0.0)
        for (int d = 0; d < 2; d++) {
            const double first = corner[1][d];
            corner[1][d] = corner[2][d];
            corner[2][d] = first;
        }
    double nearest = INFINITY; // rays along an edge are no test
    for (int i = 0; i < 3; i++)
        nearest = fmin(nearest, pdmc_point_segment_distance((double[2]){0.0, 0.0}, corner[i], corner[(i + 1) % 3]));
    return fabs(turn) > 0.05 && nearest > 0.05;
}

static void moments_are_integrals_along_rays(void **state)
{
    (void)state;
    int tried = 0, inside = 0;
    for (uint64_t sample = 0; tried < 60; sample++) {
        double corner[3][2];
        pdmc_bond_moments moments[2] = {0};
        if (!random_triangle(sample, corner)) continue;
        tried++;
        pdmc_polygon_bond_moments(horizon, 2, 3, corner, moments);
        inside += moments[0].second[0] + moments[0].second[2] > 0.999 * M_PI * 0.5 * horizon;
        check_by_rays(corner, 0, NULL, 2, moments, 1e-13);
    }
    assert_true(inside > 0);
}

// Its moments of e e^T, of e e e e, and no third ones.
static void a_polygon_round_the_origin_has_the_moments_of_the_disc(void **state)
{
    (void)state;
    double corner[4][2] = {{-1.0, -0.9}, {1.1, -1.0}, {0.9, 1.2}, {-1.0, 1.0}};
    pdmc_bond_moments m = {0};
    pdmc_polygon_bond_moments(horizon, 1, 4, corner, &m);
    const double four = gsl_pow_3(horizon) / 3.0 * 0.25 * M_PI;
    const pdmc_bond_moments want = {.second = {M_PI * horizon, 0.0, M_PI * horizon},
                                    .fourth = {3.0 * four, 0.0, four, 0.0, 3.0 * four}};
    for (int degree = 2; degree <= 4; degree++)
        for (int power = 0; power <= degree; power++)
            CHECK_NEAR(entry(&m, degree, power), entry(&want, degree, power), 1e-14);
}

static bool meets(double corner[3][2], const pdmc_crack *crack)
{
    bool any = false;
    for (int i = 0; i < 3; i++)
        any = any || pdmc_segments_cross(corner[i], corner[(i + 1) % 3], crack->from, crack->to);
    return any;
}

static int random_cracks(uint64_t sample, double corner[3][2], pdmc_crack crack[MOST_CRACKS])
{
    int count = 0;
    for (int c = 0; c < MOST_CRACKS; c++) {
        double u[4];
        pdmc_random_uniform(7, PDMC_STREAM_PROBES, sample, 6 + 4 * (uint32_t)c, 4, u);
        crack[count] =
            (pdmc_crack){.from = {1.4 * u[0] - 0.7, 1.4 * u[1] - 0.7}, .to = {1.4 * u[2] - 0.7, 1.4 * u[3] - 0.7}};
        const double distance = pdmc_point_segment_distance((double[2]){0.0, 0.0}, crack[count].from, crack[count].to);
        if (distance > 0.05 && !meets(corner, &crack[count])) count++;
    }
    return count;
}

// Up to three cracks, whose shadows overlap or leave the triangle in two parts.
static void cracks_hide_what_rays_do_not_reach(void **state)
{
    (void)state;
    int hidden[MOST_CRACKS + 1] = {0};
    for (uint64_t sample = 0; sample < 1500; sample++) {
        double corner[3][2];
        pdmc_crack crack[MOST_CRACKS];
        if (!random_triangle(sample, corner)) continue;
        const int count = random_cracks(sample, corner, crack);
        pdmc_bond_moments all = {0}, seen = {0};
        const pdmc_sight sight = pdmc_sight_from((double[2]){0.0, 0.0}, horizon, count, crack);
        pdmc_polygon_bond_moments(horizon, 1, 3, corner, &all);
        pdmc_sight_moments(&sight, horizon, 1, corner, &seen);
        const double part = (seen.second[0] + seen.second[2]) / (all.second[0] + all.second[2]);
        if (part > 1.0 - 1e-9 || part < 1e-9 || hidden[count] >= 15) continue; // all or nothing
        hidden[count]++;
        check_by_rays(corner, count, crack, 1, &seen, 1e-12);
    }
    for (int count = 1; count <= MOST_CRACKS; count++) assert_true(hidden[count] >= 8);
}

// A point at the tail of a crack sees it as a point: nothing is hidden.
static void a_crack_straight_ahead_hides_nothing(void **state)
{
    (void)state;
    const pdmc_crack crack = {.from = {0.1, 0.0}, .to = {0.3, 0.0}};
    double corner[3][2] = {{0.3, -0.1}, {0.5, -0.1}, {0.4, 0.1}};
    pdmc_bond_moments all = {0}, seen = {0};
    const pdmc_sight sight = pdmc_sight_from((double[2]){0.0, 0.0}, horizon, 1, &crack);
    pdmc_polygon_bond_moments(horizon, 1, 3, corner, &all);
    pdmc_sight_moments(&sight, horizon, 1, corner, &seen);
    assert_memory_equal(&all, &seen, sizeof all);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(moments_are_integrals_along_rays),
        cmocka_unit_test(a_polygon_round_the_origin_has_the_moments_of_the_disc),
        cmocka_unit_test(cracks_hide_what_rays_do_not_reach),
        cmocka_unit_test(a_crack_straight_ahead_hides_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
