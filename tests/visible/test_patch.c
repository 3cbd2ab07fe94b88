// SPDX-License-Identifier: GPL-3.0-or-later
#include "visible/cracked.h"

// Displacements u = (exx x + exy y, exy x + eyy y) up to a rigid motion, which differences over d do not see.
static void check_uniform_strain(const pdmc_visible *visible, double exx, double eyy, double exy, double tolerance)
{
    const double d = 0.5, points[3][2] = {{0.1, 0.2}, {-1.7, 1.1}, {2.0, -2.0}};
    for (int k = 0; k < 3; k++) {
        const double x = points[k][0], y = points[k][1];
        const double at[4][2] = {{x + d, y}, {x - d, y}, {x, y + d}, {x, y - d}};
        double u[4][2];
        for (int i = 0; i < 4; i++) CHECK_OK(pdmc_visible_displacement(visible, at[i], at[i], u[i]));
        CHECK_NEAR((u[0][0] - u[1][0]) / (2 * d), exx, tolerance);
        CHECK_NEAR((u[2][1] - u[3][1]) / (2 * d), eyy, tolerance);
        CHECK_NEAR((u[0][1] - u[1][1] + u[2][0] - u[3][0]) / (4 * d), exy, tolerance);
    }
}

// Both plane assumptions and both radial functions; the polynomials of the stencils hold the solution.
static void uniform_stress_gives_uniform_strain(void **state)
{
    (void)state;
    const double loads[3][3] = {{0.0, 1.0, 0.0}, {1.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}; // s_x, s_y, tau
    for (int i = 0; i < 6; i++) {
        const double *s = loads[i % 3], E = 210.0, nu = i / 3 ? 0.25 : 1.0 / 3.0;
        plate p;
        pdmc_visible *visible = NULL;
        cracked_make(&p, 5.0, 0.15, 6);
        p.problem.material.assumption = i / 3 ? PDMC_PLANE_STRAIN : PDMC_PLANE_STRESS;
        p.problem.solver.stencil = i / 3 ? PDMC_STENCIL_POLYHARMONIC : PDMC_STENCIL_IMQ;
        p.problem.material.youngs_modulus = E;
        cracked_load(&p, s);
        CHECK_OK(pdmc_visible_create(&p.problem, NULL, 2, &visible));
        const double E1 = i / 3 ? E / (1.0 - nu * nu) : E, nu1 = i / 3 ? nu / (1.0 - nu) : nu;
        check_uniform_strain(visible, (s[0] - nu1 * s[1]) / E1, (s[1] - nu1 * s[0]) / E1, s[2] * (1.0 + nu) / E,
                             1e-8 / E);
        pdmc_visible_destroy(&visible);
    }
}

// A plate on rollers, and one that is pulled by prescribed displacements; none of them is free to move but in x.
static void supports_hold_what_they_name(void **state)
{
    (void)state;
    plate p;
    pdmc_visible *visible = NULL;
    cracked_make(&p, 5.0, 0.15, 6);
    plate_load(&p, PDMC_SIDE_TOP, 0.0, 2.0);
    p.supports[0] = (pdmc_support){PDMC_SIDE_BOTTOM, {false, true}, {0.0, 0.5}};
    p.problem.support_count = 1;
    CHECK_OK(pdmc_visible_create(&p.problem, NULL, 1, &visible));
    check_uniform_strain(visible, -2.0 / 3.0, 2.0, 0.0, 1e-8);
    double u[2];
    const double x[2] = {0.3, -2.5};
    CHECK_OK(pdmc_visible_displacement(visible, x, x, u));
    CHECK_NEAR(u[1], 0.5, 1e-8);
    pdmc_visible_destroy(&visible);

    p.problem.load_count = 0;
    p.supports[1] = (pdmc_support){PDMC_SIDE_TOP, {false, true}, {0.0, 1.5}};
    p.problem.support_count = 2;
    CHECK_OK(pdmc_visible_create(&p.problem, NULL, 1, &visible));
    check_uniform_strain(visible, -0.2 / 3.0, 0.2, 0.0, 1e-8);
    pdmc_visible_destroy(&visible);
}

// A displacement u = (y, -x) / 10 outside the plate, which a crack does not feel.
static void rotate(const double x[2], double u[2])
{
    u[0] = 0.1 * x[1] + 0.3;
    u[1] = -0.1 * x[0];
}

static void a_rigid_motion_is_a_solution_with_a_crack(void **state)
{
    (void)state;
    const pdmc_visible_data data = {.outside = rotate};
    plate p;
    pdmc_visible *visible = NULL;
    cracked_make(&p, 2.0, 0.2, 4);
    plate_crack(&p, 0.1, 0.0, 0.5, 0.4);
    CHECK_OK(pdmc_visible_create(&p.problem, &data, 1, &visible));
    const double face[2] = {0.1, 0.0}, points[3][2] = {{0.3, 0.1}, {-0.7, 0.9}, {0.1, 0.0}};
    for (int k = 0; k < 3; k++) {
        double u[2], want[2];
        CHECK_OK(pdmc_visible_displacement(visible, points[k], k == 2 ? face : points[k], u));
        rotate(points[k], want);
        for (int i = 0; i < 2; i++) CHECK_NEAR(u[i], want[i], 1e-8);
    }
    pdmc_visible_destroy(&visible);
}

static void bad_requests_are_refused(void **state)
{
    (void)state;
    plate p;
    pdmc_visible *visible = NULL;
    cracked_make(&p, 5.0, 0.15, 6);
    plate_load(&p, PDMC_SIDE_TOP, 0.0, 1.0);
    CHECK_STATUS(pdmc_visible_create(&p.problem, NULL, 1, &visible), PDMC_ERR_CONFIG);
    CHECK_STATUS(pdmc_visible_create(&p.problem, NULL, 0, &visible), PDMC_ERR_ARG);
    p.problem.solver.refinement = 1;
    CHECK_STATUS(pdmc_visible_create(&p.problem, NULL, 1, &visible), PDMC_ERR_ARG);
    assert_null(visible);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(uniform_stress_gives_uniform_strain),
        cmocka_unit_test(supports_hold_what_they_name),
        cmocka_unit_test(a_rigid_motion_is_a_solution_with_a_crack),
        cmocka_unit_test(bad_requests_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
