// SPDX-License-Identifier: GPL-3.0-or-later

/// Quadrature over cut discs: against exact areas, appendix A's contour, and appendix A's closed forms.

#include "paper/plate.h"

#include "paper/disc.h"

#include <gsl/gsl_math.h>

static double area(const pdmc_problem *problem, double horizon, const double x[2])
{
    pdmc_paper_disc disc;
    double sum = 0.0;
    CHECK_OK(pdmc_paper_disc_create(problem, horizon, &disc));
    CHECK_OK(pdmc_paper_disc_cut(&disc, x));
    for (int b = 0; b < disc.count; b++) sum += disc.bond[b].weight * disc.bond[b].length;
    pdmc_paper_disc_clear(&disc);
    return sum;
}

// What a chord of a circle cuts off that subtends `angle` at its centre.
static double cap(double radius, double angle)
{
    return 0.5 * radius * radius * (angle - sin(angle));
}

static void areas_of_discs_that_the_plate_cuts(void **state)
{
    (void)state;
    plate p;
    plate_make(&p, 4.0, 4, 0.5);
    const double d = 0.3, r = 0.5;
    CHECK_NEAR(area(&p.problem, r, (const double[2]){0.1, 0.2}), M_PI * r * r, 1e-14);
    CHECK_NEAR(area(&p.problem, r, (const double[2]){0.3, 2.0}), 0.5 * M_PI * r * r, 1e-14);
    CHECK_NEAR(area(&p.problem, r, (const double[2]){-2.0, 2.0}), 0.25 * M_PI * r * r, 1e-14);
    CHECK_NEAR(area(&p.problem, r, (const double[2]){2.0 - d, 0.0}), M_PI * r * r - cap(r, 2.0 * acos(d / r)), 1e-9);
    CHECK_NEAR(area(&p.problem, 10.0, (const double[2]){0.7, -1.1}), 16.0, 1e-5); // secants of up to 80 degrees
}

// Behind a crack lies a shadow: the sector between the tips' directions without the triangle in front.
static void areas_of_discs_that_a_crack_cuts(void **state)
{
    (void)state;
    plate p;
    plate_make(&p, 4.0, 4, 0.5);
    plate_crack(&p, 0.05, 0.1, 0.2, 0.4);
    const double *from = p.cracks[0].from, *to = p.cracks[0].to;
    const double angle = atan2(to[1], to[0]) - atan2(from[1], from[0]);
    const double triangle = 0.5 * fabs(from[0] * to[1] - from[1] * to[0]);
    const double shadow = 0.5 * fabs(remainder(angle, 2.0 * M_PI)) * 0.25 - triangle;
    CHECK_NEAR(area(&p.problem, 0.5, (const double[2]){0.0, 0.0}), M_PI * 0.25 - shadow, 1e-9);

    plate_make(&p, 4.0, 4, 0.5); // a crack longer than the disc cuts off a cap
    plate_crack(&p, 0.0, 0.2, 1.5, 0.0);
    CHECK_NEAR(area(&p.problem, 0.5, (const double[2]){0.0, 0.0}), M_PI * 0.25 - cap(0.5, 2.0 * acos(0.4)), 1e-9);
    CHECK_NEAR(area(&p.problem, 0.5, (const double[2]){0.3, 0.2 + 1e-9}), M_PI * 0.125,
               1e-8); // at its face: half a disc
}

// Eq. A.8 sums steps dtheta along the crack, eq. A.9 gives the radius there; the curve tends to r(theta) with order 1.
static double worst_of_contour(const pdmc_problem *problem, int steps)
{
    const pdmc_crack *crack = &problem->cracks[0];
    const double *z1 = crack->from, u[2] = {crack->to[0] - z1[0], crack->to[1] - z1[1]};
    const double length = hypot(u[0], u[1]), l = (u[0] * z1[1] - u[1] * z1[0]) / length; // the node is the origin
    const double along = (z1[0] * u[0] + z1[1] * u[1]) / length, alpha = atan2(u[1], u[0]), step = 1.0 / steps;
    double theta = atan2(l, along), worst = 0.0;
    for (int j = 1; j < steps; j++) {
        const double s = along + j * step * length;
        theta -= l * length / (s * s + l * l) * step;
        const double radius = hypot(z1[0] + j * step * u[0], z1[1] + j * step * u[1]);
        const double exact = pdmc_paper_reach(problem, 10.0, (const double[2]){0.0, 0.0},
                                              (const double[2]){cos(theta + alpha), sin(theta + alpha)});
        worst = fmax(worst, fabs(radius - exact));
    }
    return worst;
}

static void the_contour_of_the_appendix_has_this_one_for_its_limit(void **state)
{
    (void)state;
    plate p;
    plate_make(&p, 4.0, 4, 0.5);
    plate_crack(&p, 0.05, 0.2, 0.3, 0.3);
    const double coarse = worst_of_contour(&p.problem, 200), fine = worst_of_contour(&p.problem, 1600);
    printf("  r(theta) by eq. A.8 and A.9 off the crack by %.2e with 200 steps, %.2e with 1600\n", coarse, fine);
    CHECK_NEAR(log(coarse / fine) / log(8.0), 1.0, 0.1);
    assert_true(fine < 1e-3);
}

// Eq. A.11 - A.13, taken between 0 and 2 pi: K_Q1 = K_Q2 = K_Q3 = 0, and in K_Q4 the off-diagonal pi / 4 delta^3 / 3 of
// the bond xy (times c); the bracket [0 0; 0 0] of K_Q1 is 0 for any disc. The tensor acts on u and on v alike.
static void closed_forms_of_whole_discs(void **state)
{
    (void)state;
    const double horizon = 0.4, x[2] = {0.3, -0.2};
    plate p;
    pdmc_paper_disc disc;
    double K[4][3] = {{0}};
    plate_make(&p, 4.0, 4, horizon);
    CHECK_OK(pdmc_paper_disc_create(&p.problem, horizon, &disc));
    CHECK_OK(pdmc_paper_disc_cut(&disc, x));
    for (int b = 0; b < disc.count; b++) {
        const double *e = disc.bond[b].direction, r = disc.bond[b].length;
        const double Q[4] = {0.0, r * e[0], r * e[1], (x[0] + r * e[0]) * (x[1] + r * e[1]) - x[0] * x[1]};
        for (int q = 0; q < 4; q++) {
            K[q][0] += disc.bond[b].weight * e[0] * e[0] * Q[q];
            K[q][1] += disc.bond[b].weight * e[0] * e[1] * Q[q];
            K[q][2] += disc.bond[b].weight * e[1] * e[1] * Q[q];
        }
    }
    const double scale = pow(horizon, 3);
    for (int q = 0; q < 4; q++)
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(K[q][k], q == 3 && k == 1 ? 0.25 * M_PI * scale / 3.0 : 0.0, 1e-13 * scale);
    pdmc_paper_disc_clear(&disc);
}

// The same between 0 and pi / 2, a quarter disc at a corner, where the brackets of eq. A.12 do not vanish:
// int cos^3 = 2/3, int cos^2 sin = 1/3, int cos^2 sin^2 = pi / 16, int cos^3 sin = 1/4.
static void closed_forms_of_a_quarter(void **state)
{
    (void)state;
    const double horizon = 0.4, x[2] = {-2.0, -2.0};
    plate p;
    pdmc_paper_disc disc;
    plate_make(&p, 4.0, 4, horizon);
    CHECK_OK(pdmc_paper_disc_create(&p.problem, horizon, &disc));
    CHECK_OK(pdmc_paper_disc_cut(&disc, x));
    double sum[4] = {0};
    for (int b = 0; b < disc.count; b++) {
        const double *e = disc.bond[b].direction, r = disc.bond[b].length, w = disc.bond[b].weight;
        sum[0] += w * r * pow(e[0], 3);
        sum[1] += w * r * e[0] * e[0] * e[1];
        sum[2] += w * r * r * e[0] * e[0] * e[1] * e[1];
        sum[3] += w * r * r * pow(e[0], 3) * e[1];
    }
    const double r2 = horizon * horizon / 2.0, r3 = pow(horizon, 3) / 3.0;
    const double exact[4] = {2.0 / 3.0 * r2, r2 / 3.0, M_PI / 16.0 * r3, 0.25 * r3};
    for (int k = 0; k < 4; k++) CHECK_NEAR(sum[k], exact[k], 1e-13 * r2);
    pdmc_paper_disc_clear(&disc);
}

static void refusal_of_memory(void **state)
{
    (void)state;
    plate p;
    pdmc_paper_disc disc;
    plate_make(&p, 4.0, 4, 0.5);
    CHECK_FAILS_CLEANLY(pdmc_paper_disc_create(&p.problem, 0.5, &disc), pdmc_paper_disc_clear(&disc));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(areas_of_discs_that_the_plate_cuts),
        cmocka_unit_test(areas_of_discs_that_a_crack_cuts),
        cmocka_unit_test(the_contour_of_the_appendix_has_this_one_for_its_limit),
        cmocka_unit_test(closed_forms_of_whole_discs),
        cmocka_unit_test(closed_forms_of_a_quarter),
        cmocka_unit_test(refusal_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
