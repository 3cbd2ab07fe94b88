// SPDX-License-Identifier: GPL-3.0-or-later
#include "kansa/boundary_collocation.h"
#include "kansa/plate.h"

#include "kansa/points.h"

#include <gsl/gsl_sf_ellint.h>

static const double degree = 0.017453292519943295;

static void solve(plate *p, pdmc_tip tips[2])
{
    pdmc_kansa *kansa = NULL;
    CHECK_OK(pdmc_kansa_create(&p->problem, NULL, 2, &kansa));
    for (int t = 0; t < 2; t++) CHECK_OK(pdmc_kansa_tip(kansa, t, &tips[t]));
    pdmc_kansa_destroy(&kansa);
}

// K_I of a central crack, horizon 0.2 a, by nodes and half length, against boundary collocation. The bounds are those
// of the formulation's first measurement, 0.17 % and less at 289 nodes; both tips agree by symmetry.
static void stress_intensity_of_a_central_crack(void **state)
{
    (void)state;
    const double lengths[5] = {0.1, 0.25, 0.5, 0.75, 1.0};
    const int cells[4] = {10, 16, 20, 24};
    const double bound[4][5] = {{0.05, 0.05, 0.20, 0.42, 0.46},
                                {0.03, 0.03, 0.05, 0.10, 0.17},
                                {0.02, 0.02, 0.03, 0.05, 0.07},
                                {0.01, 0.01, 0.005, 0.02, 0.03}};
    printf("  error of K_I in %%, central crack, a = 0.1, 0.25, 0.5, 0.75, 1.0\n");
    for (int i = 0; i < 4 - 2 * FINEST_LEFT_OUT; i++) {
        printf("  %3d nodes:", (cells[i] + 1) * (cells[i] + 1));
        for (int k = 0; k < 5; k++) {
            reference exact;
            plate p;
            pdmc_tip tips[2];
            reference_solve(&exact, 5.0, lengths[k], 0.0);
            assert_true(exact.residual < 1e-3);
            plate_make_cracked(&p, lengths[k], 0.0, cells[i]);
            solve(&p, tips);
            const double error = 100.0 * (tips[1].stress_intensity[0] / exact.K[0] - 1.0);
            printf(" %+.3f", error);
            CHECK_NEAR(error, 0.0, bound[i][k]);
            CHECK_NEAR(tips[0].stress_intensity[0] / tips[1].stress_intensity[0], 1.0, 1e-4);
            for (int t = 0; t < 2; t++) CHECK_NEAR(tips[t].stress_intensity[1] / exact.K[0], 0.0, 1e-6);
        }
        printf("\n");
    }
}

static void stress_intensity_of_inclined_cracks(void **state)
{
    (void)state;
    printf("  inclined cracks, a = 0.5, 289 nodes: angle, errors of K_I and K_II in %% of K\n");
    for (int angle = 15; angle <= 75; angle += 15) {
        reference exact;
        plate p;
        pdmc_tip tips[2];
        reference_solve(&exact, 5.0, 0.5, angle * degree);
        plate_make_cracked(&p, 0.5, angle * degree, 16);
        solve(&p, tips);
        const double K = hypot(exact.K[0], exact.K[1]);
        for (int t = 0; t < 2; t++) {
            const double error[2] = {100.0 * (tips[t].stress_intensity[0] - exact.K[0]) / K,
                                     100.0 * (tips[t].stress_intensity[1] - exact.K[1]) / K};
            if (t) printf("  %d: %+.3f %+.3f\n", angle, error[0], error[1]);
            CHECK_NEAR(error[0], 0.0, 0.2);
            CHECK_NEAR(error[1], 0.0, 0.2);
        }
        CHECK_NEAR(tips[1].direction, angle * degree, 1e-14);
        CHECK_NEAR(fabs(remainder(tips[0].direction - angle * degree, 2 * acos(-1.0))), acos(-1.0), 1e-14);
    }
}

// Plane strain changes the strains, not the stresses of a traction problem.
static void stress_intensity_does_not_depend_on_the_assumption(void **state)
{
    (void)state;
    plate p;
    pdmc_tip stress[2], strain[2];
    plate_make_cracked(&p, 0.5, 0.5, 10);
    solve(&p, stress);
    p.problem.material.assumption = PDMC_PLANE_STRAIN;
    p.problem.material.youngs_modulus = 3.0;
    solve(&p, strain);
    for (int k = 0; k < 2; k++) CHECK_NEAR(strain[0].stress_intensity[k], stress[0].stress_intensity[k], 1e-7);
}

// T = sigma_y cos(2 angle) in an infinite plate under sigma_y, for an angle from the x axis: -1 for the central crack.
static void t_stress_of_a_small_crack(void **state)
{
    (void)state;
    const double angles[3] = {0.0, 30.0, 60.0};
    for (int k = 0; k < 3; k++) {
        plate p;
        pdmc_tip tips[2];
        plate_make_cracked(&p, 0.1, angles[k] * degree, 16);
        solve(&p, tips);
        CHECK_NEAR(tips[1].t_stress, -cos(2.0 * angles[k] * degree), 0.01); // (a / W)^2 = 4e-4 times a few
        CHECK_NEAR(tips[0].t_stress, tips[1].t_stress, 1e-4);
    }
}

// Two equal collinear cracks (Koiter): inner tips at b, outer at c.
// K = sigma sqrt(pi) (c^2 - C^2) / sqrt(c (c^2 - b^2)) outside and (C^2 - b^2) / sqrt(b (c^2 - b^2)) inside,
// C^2 = c^2 E(k) / K(k), k^2 = 1 - b^2 / c^2, in an infinite plate. The edges of this one add something between nothing
// and the 1.4 % that they add to a single crack of half length c.
static void collinear_cracks(void **state)
{
    (void)state;
    const double b = 0.05, c = 0.25, pi = acos(-1.0);
    const double C2 = c * c * gsl_sf_ellint_Ecomp(sqrt(1.0 - b * b / (c * c)), GSL_PREC_DOUBLE) /
                      gsl_sf_ellint_Kcomp(sqrt(1.0 - b * b / (c * c)), GSL_PREC_DOUBLE);
    const double outer = sqrt(pi) * (c * c - C2) / sqrt(c * (c * c - b * b));
    const double inner = sqrt(pi) * (C2 - b * b) / sqrt(b * (c * c - b * b));
    plate p;
    pdmc_tip tip[4];
    pdmc_kansa *kansa = NULL;
    plate_make(&p, 5.0, 16, 0.01);
    p.problem.solver.crack_orders = 10;
    plate_load(&p, PDMC_SIDE_TOP, 0.0, 1.0);
    plate_load(&p, PDMC_SIDE_BOTTOM, 0.0, -1.0);
    plate_crack(&p, 0.5 * (b + c), 0.0, 0.5 * (c - b), 0.0);
    plate_crack(&p, -0.5 * (b + c), 0.0, 0.5 * (c - b), 0.0);
    CHECK_OK(pdmc_kansa_create(&p.problem, NULL, 2, &kansa));
    for (int t = 0; t < 4; t++) CHECK_OK(pdmc_kansa_tip(kansa, t, &tip[t]));
    pdmc_kansa_destroy(&kansa);
    printf("  collinear cracks: errors of K_I %+.3f %% inside, %+.3f %% outside\n",
           100.0 * (tip[0].stress_intensity[0] / inner - 1.0), 100.0 * (tip[1].stress_intensity[0] / outer - 1.0));
    CHECK_NEAR(tip[0].stress_intensity[0] / inner, 1.007, 0.007);
    CHECK_NEAR(tip[1].stress_intensity[0] / outer, 1.007, 0.007);
    CHECK_NEAR(tip[3].stress_intensity[0] / tip[0].stress_intensity[0], 1.0, 1e-3);
    CHECK_NEAR(tip[2].stress_intensity[0] / tip[1].stress_intensity[0], 1.0, 1e-3);
}

// Every crack field is in equilibrium and leaves its own faces free of traction pairwise: gradients against
// differences.
static void gradients_are_those_of_the_values(void **state)
{
    (void)state;
    plate p;
    plate_make_cracked(&p, 0.5, 0.4, 4);
    pdmc_basis basis = {.shape = 1.0, .degree = 3, .scale = 2.5, .orders = 5, .shear_modulus = 0.375};
    CHECK_OK(pdmc_kansa_nodes(&p.problem, 1.25, &basis));
    CHECK_OK(pdmc_basis_complete(&basis, 1, p.cracks));
    pdmc_basis_values x, y, plus, minus;
    CHECK_OK(pdmc_basis_values_create(&basis, &x));
    CHECK_OK(pdmc_basis_values_create(&basis, &y));
    CHECK_OK(pdmc_basis_values_create(&basis, &plus));
    CHECK_OK(pdmc_basis_values_create(&basis, &minus));
    // the second point lies behind the crack as seen from its anchor: the continued sheet
    const double at[2][2] = {{0.3, 0.9}, {0.1, -0.05}}, anchor[2][2] = {{0.3, 0.9}, {0.05, 0.12}}, h = 1e-5;
    for (int k = 0; k < 2; k++) {
        pdmc_basis_gradient(&basis, at[k], anchor[k], &x, &y);
        for (int axis = 0; axis < 2; axis++) {
            double forward[2] = {at[k][0], at[k][1]}, backward[2] = {at[k][0], at[k][1]};
            forward[axis] += h;
            backward[axis] -= h;
            pdmc_basis_evaluate(&basis, forward, k ? anchor[k] : forward, &plus);
            pdmc_basis_evaluate(&basis, backward, k ? anchor[k] : backward, &minus);
            const pdmc_basis_values *slope = axis ? &y : &x;
            for (int j = 0; j < basis.scalars; j++)
                CHECK_NEAR((plus.scalar[j] - minus.scalar[j]) / (2 * h), slope->scalar[j], 1e-8);
            for (int j = 0; j < basis.fields; j++) { // differences: h^2 f''' and eps / h, both some 1e-7 of the fields
                const double scale = 1e-6 * (1.0 + fabs(slope->u[j]) + fabs(slope->v[j]));
                CHECK_NEAR((plus.u[j] - minus.u[j]) / (2 * h), slope->u[j], scale);
                CHECK_NEAR((plus.v[j] - minus.v[j]) / (2 * h), slope->v[j], scale);
            }
        }
    }
    pdmc_basis_values_clear(&x);
    pdmc_basis_values_clear(&y);
    pdmc_basis_values_clear(&plus);
    pdmc_basis_values_clear(&minus);
    pdmc_basis_clear(&basis);
}

// The derivative of the crack fields is infinite at a tip, the displacement is not: it is continuous there. The grid of
// many a study has a node on a tip.
static void the_displacement_at_a_tip_is_finite(void **state)
{
    (void)state;
    plate p;
    pdmc_kansa *kansa = NULL;
    plate_make_cracked(&p, 0.5, 0.0, 10);
    CHECK_OK(pdmc_kansa_create(&p.problem, NULL, 2, &kansa));
    for (int end = -1; end <= 1; end += 2) {
        const double tip[2] = {0.5 * end, 0.0}, ahead[2] = {0.5 * end + 1e-10 * end, 0.0};
        double u[2], near[2];
        CHECK_OK(pdmc_kansa_displacement(kansa, tip, tip, u));
        CHECK_OK(pdmc_kansa_displacement(kansa, ahead, ahead, near));
        for (int k = 0; k < 2; k++) CHECK_NEAR(u[k], near[k], 1e-4); // sqrt(1e-10) times a slope of some K / E
    }
    pdmc_kansa_destroy(&kansa);
}

// A collocation that cannot be solved says so.
static void a_singular_system_is_refused(void **state)
{
    (void)state;
    plate p;
    pdmc_kansa *kansa = NULL;
    plate_make_cracked(&p, 0.5, 0.0, 12);
    p.problem.solver.shape = 500.0;
    CHECK_STATUS(pdmc_kansa_create(&p.problem, NULL, 1, &kansa), PDMC_ERR_SINGULAR);
    assert_null(kansa);
}

static void refused_allocations_are_reported(void **state)
{
    (void)state;
    plate p;
    pdmc_kansa *kansa = NULL;
    plate_make_cracked(&p, 0.5, 0.0, 4);
    p.problem.solver.crack_orders = 2;
    CHECK_FAILS_CLEANLY(pdmc_kansa_create(&p.problem, NULL, 1, &kansa), pdmc_kansa_destroy(&kansa));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stress_intensity_of_a_central_crack),
        cmocka_unit_test(stress_intensity_of_inclined_cracks),
        cmocka_unit_test(stress_intensity_does_not_depend_on_the_assumption),
        cmocka_unit_test(t_stress_of_a_small_crack),
        cmocka_unit_test(collinear_cracks),
        cmocka_unit_test(gradients_are_those_of_the_values),
        cmocka_unit_test(the_displacement_at_a_tip_is_finite),
        cmocka_unit_test(a_singular_system_is_refused),
        cmocka_unit_test(refused_allocations_are_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
