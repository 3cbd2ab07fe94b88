// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/horizon.h"
#include "pdmc/quadrature.h"
#include "pdmc/random.h"

#include "check.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_sort.h>

/// A face at depth h leaves W_bdry / W_inf = (3 d^4 + 4 d^3 h - h^4) / (6 d^4) (Yu 2011, eq. 4.50, its sign mended).
static void one_face(void **state)
{
    (void)state;
    const double d = 1.7;
    for (int i = 0; i <= 10; i++) {
        const double h = d * i / 10.0;
        const double below[3] = {INFINITY, h, INFINITY}, above[3] = {INFINITY, INFINITY, INFINITY};
        CHECK_NEAR(pdmc_integrate_distance_in_box(d, below, above),
                   M_PI * (3.0 * gsl_pow_4(d) + 4.0 * gsl_pow_3(d) * h - gsl_pow_4(h)) / 6.0, 1e-13 * gsl_pow_4(d));
    }
}

/// Points on an edge and on a corner see a quarter and an eighth.
static void edge_and_corner(void **state)
{
    (void)state;
    const double on[3] = {0.0, 0.0, 0.0}, edge[3] = {0.0, INFINITY, 0.0}, far[3] = {INFINITY, INFINITY, INFINITY};
    CHECK_NEAR(pdmc_integrate_distance_in_box(2.0, edge, far), M_PI * 16.0 / 4.0, 1e-12);
    CHECK_NEAR(pdmc_integrate_distance_in_box(2.0, on, far), M_PI * 16.0 / 8.0, 1e-12);
    CHECK_NEAR(pdmc_integrate_distance_in_box(2.0, on, on), 0.0, 0.0);
}

static double volume_of(double radius, void *context)
{
    double centroid[3];
    return radius > 0.0 ? pdmc_cell_in_sphere(3, context, radius, centroid) : 0.0;
}

/// int_0^1 V(r) dr, adaptively between the radii at which another face, edge or corner is reached.
static double smaller_balls(pdmc_cell *box, size_t count, const double radii[])
{
    double points[16] = {0.0}, value = 0.0;
    size_t n = 1;
    for (size_t i = 0; i < count; i++)
        if (radii[i] < 1.0) points[n++] = radii[i];
    points[n++] = 1.0;
    gsl_sort(points, 1, n);
    gsl_integration_workspace *space = gsl_integration_workspace_alloc(200);
    const gsl_function f = {volume_of, box};
    gsl_error_handler_t *handler = gsl_set_error_handler_off(); // rounding may stop it before 1e-13
    for (size_t i = 0; i + 1 < n; i++) {
        double part, error;
        gsl_integration_qags(&f, points[i], points[i + 1], 1e-13, 1e-12, 200, space, &part, &error);
        value += part;
    }
    gsl_integration_workspace_free(space);
    gsl_set_error_handler(handler);
    return value;
}

/// Random corners of all kinds, from the box within the ball to the ball within the box, against the volumes of all
/// smaller balls, which are another room's: int |x| dV = R V(R) - int_0^R V(r) dr. The tolerance is the adaptive rule's.
static void random_corners(void **state)
{
    (void)state;
    int kinds[4] = {0, 0, 0, 0};
    for (int i = 0; i < (FINEST_LEFT_OUT ? 30 : 300); i++) {
        double a[3];
        pdmc_random_uniform(1, PDMC_STREAM_PROBES, (uint64_t)i, 0, 3, a);
        for (int k = 0; k < 3; k++) a[k] *= 1.3;
        const double none[3] = {0.0, 0.0, 0.0};
        pdmc_cell box = {{0.0, 0.0, 0.0}, {a[0], a[1], a[2]}};
        const double radii[7] = {a[0],
                                 a[1],
                                 a[2],
                                 hypot(a[0], a[1]),
                                 hypot(a[1], a[2]),
                                 hypot(a[2], a[0]),
                                 sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2])};
        CHECK_NEAR(pdmc_integrate_distance_in_box(1.0, none, a), volume_of(1.0, &box) - smaller_balls(&box, 7, radii),
                   1e-11);
        int cuts = 0;
        for (int k = 0; k < 3; k++) cuts += radii[3 + k] < 1.0;
        kinds[cuts]++;
    }
    for (int k = 0; k < 4; k++) assert_true(kinds[k] > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(one_face), cmocka_unit_test(edge_and_corner),
                                       cmocka_unit_test(random_corners)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
