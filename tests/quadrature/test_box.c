// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/quadrature.h"
#include "pdmc/random.h"

#include "check.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_sort.h>

/// A face at depth h leaves W_bdry / W_inf = (3 d^4 + 4 d^3 h - h^4) / (6 d^4) (Yu 2011, eq. 4.50, its sign mended), and
/// a cap's volume is known.
static void one_face(void **state)
{
    (void)state;
    const double d = 1.7;
    for (int i = 0; i <= 10; i++) {
        const double h = d * i / 10.0;
        const double below[3] = {INFINITY, h, INFINITY}, above[3] = {INFINITY, INFINITY, INFINITY};
        const pdmc_ball_in_box got = pdmc_integrate_ball_in_box(d, below, above);
        const double cap = M_PI * (d - h) * (d - h) * (2.0 * d + h) / 3.0;
        CHECK_NEAR(got.volume, 4.0 / 3.0 * M_PI * gsl_pow_3(d) - cap, 1e-13 * gsl_pow_3(d));
        CHECK_NEAR(got.distance, M_PI * (3.0 * gsl_pow_4(d) + 4.0 * gsl_pow_3(d) * h - gsl_pow_4(h)) / 6.0,
                   1e-13 * gsl_pow_4(d));
    }
}

/// Points on an edge and on a corner see a quarter and an eighth.
static void edge_and_corner(void **state)
{
    (void)state;
    const double on[3] = {0.0, 0.0, 0.0}, edge[3] = {0.0, INFINITY, 0.0}, far[3] = {INFINITY, INFINITY, INFINITY};
    CHECK_NEAR(pdmc_integrate_ball_in_box(2.0, edge, far).distance, M_PI * 16.0 / 4.0, 1e-12);
    CHECK_NEAR(pdmc_integrate_ball_in_box(2.0, on, far).distance, M_PI * 16.0 / 8.0, 1e-12);
    CHECK_NEAR(pdmc_integrate_ball_in_box(2.0, on, on).volume, 0.0, 0.0);
}

typedef struct {
    double radius, side[3];
} octant;

/// Area of the slice at x: a quarter of a disc within the rectangle [0, side[1]] x [0, side[2]].
static double slice(double x, void *context)
{
    const octant *o = context;
    const double squared = fmax(0.0, gsl_pow_2(o->radius) - x * x), radius = sqrt(squared);
    const double top = fmin(o->side[2], radius), end = fmin(o->side[1], radius);
    const double flat = fmin(o->side[1], sqrt(fmax(0.0, squared - top * top)));
    const double primitive[2] = {
        flat * sqrt(fmax(0.0, squared - flat * flat)) + squared * atan2(flat, sqrt(fmax(0.0, squared - flat * flat))),
        end * sqrt(fmax(0.0, squared - end * end)) + squared * atan2(end, sqrt(fmax(0.0, squared - end * end))),
    };
    return flat * top + 0.5 * (primitive[1] - primitive[0]);
}

static double volume_of(double radius, void *context)
{
    const octant *o = context;
    const double none[3] = {0.0, 0.0, 0.0};
    return radius > 0.0 ? pdmc_integrate_ball_in_box(radius, none, o->side).volume : 0.0;
}

/// Integrates between break points, adaptively.
static double integrate(double (*function)(double, void *), octant *o, double end, int count, const double corner[])
{
    double points[8] = {0.0}, value = 0.0, error;
    size_t n = 1;
    for (int i = 0; i < count; i++)
        if (corner[i] > 0.0 && corner[i] < end) points[n++] = corner[i];
    points[n++] = end;
    gsl_sort(points, 1, n);
    gsl_integration_workspace *space = gsl_integration_workspace_alloc(200);
    const gsl_function f = {function, o};
    gsl_error_handler_t *handler = gsl_set_error_handler_off(); // rounding may stop it before 1e-13
    for (size_t i = 0; i + 1 < n; i++) {
        double part;
        gsl_integration_qags(&f, points[i], points[i + 1], 1e-13, 1e-12, 200, space, &part, &error);
        value += part;
    }
    gsl_integration_workspace_free(space);
    gsl_set_error_handler(handler);
    return value;
}

/// Random octants of all kinds, from the box within the ball to the ball within the box, against slices, and the
/// distances against the volumes of all smaller balls: int |x| dV = R V(R) - int_0^R V(r) dr. The tolerance is the
/// adaptive rule's with room for a root at the slices' ends.
static void random_octants(void **state)
{
    (void)state;
    int kinds[4] = {0, 0, 0, 0};
    for (int i = 0; i < (FINEST_LEFT_OUT ? 30 : 300); i++) {
        octant o = {1.0, {0.0}};
        pdmc_random_uniform(1, PDMC_STREAM_PROBES, (uint64_t)i, 0, 3, o.side);
        for (int k = 0; k < 3; k++) o.side[k] *= 1.3;
        const double *a = o.side, none[3] = {0.0, 0.0, 0.0};
        const double along[3] = {sqrt(fmax(0.0, 1.0 - a[1] * a[1])), sqrt(fmax(0.0, 1.0 - a[2] * a[2])),
                                 sqrt(fmax(0.0, 1.0 - a[1] * a[1] - a[2] * a[2]))};
        const double radii[7] = {a[0],
                                 a[1],
                                 a[2],
                                 hypot(a[0], a[1]),
                                 hypot(a[1], a[2]),
                                 hypot(a[2], a[0]),
                                 sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2])};
        const pdmc_ball_in_box got = pdmc_integrate_ball_in_box(1.0, none, o.side);
        CHECK_NEAR(got.volume, integrate(slice, &o, fmin(1.0, a[0]), 3, along), 1e-11);
        CHECK_NEAR(got.distance, got.volume - integrate(volume_of, &o, 1.0, 6, radii), 1e-11);
        int cuts = 0;
        for (int k = 0; k < 3; k++) cuts += radii[3 + k] < 1.0;
        kinds[cuts]++;
    }
    for (int k = 0; k < 4; k++) assert_true(kinds[k] > 0);
}

/// A box within the ball has its own volume, to rounding.
static void box_within(void **state)
{
    (void)state;
    const double below[3] = {0.2, 0.5, 0.4}, above[3] = {0.3, 0.1, 0.6};
    CHECK_NEAR(pdmc_integrate_ball_in_box(1.0, below, above).volume, 0.5 * 0.6 * 1.0, 1e-15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(one_face), cmocka_unit_test(edge_and_corner),
                                       cmocka_unit_test(random_octants), cmocka_unit_test(box_within)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
