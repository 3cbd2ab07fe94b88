// SPDX-License-Identifier: GPL-3.0-or-later

/// The mean solution of the paper's recipe: what it gets right, and how wrong it is where it is wrong.

#include "kansa/boundary_collocation.h"
#include "paper/plate.h"

#include "paper/disc.h"

#include <gsl/gsl_math.h>

static void elongation(const pdmc_paper *paper, double half, double strain[2])
{
    double top[2], bottom[2], left[2], right[2];
    const double x[4][2] = {{0, half}, {0, -half}, {-half, 0}, {half, 0}};
    CHECK_OK(pdmc_paper_displacement(paper, x[0], x[0], top));
    CHECK_OK(pdmc_paper_displacement(paper, x[1], x[1], bottom));
    CHECK_OK(pdmc_paper_displacement(paper, x[2], x[2], left));
    CHECK_OK(pdmc_paper_displacement(paper, x[3], x[3], right));
    strain[0] = (right[0] - left[0]) / (2 * half);
    strain[1] = (top[1] - bottom[1]) / (2 * half);
}

static pdmc_paper *solved(const plate *p)
{
    pdmc_paper *paper = NULL;
    CHECK_OK(pdmc_paper_create(&p->problem, 2, &paper));
    return paper;
}

// Where a node's disc is whole, K q = 0 for q = 1, x, y (eq. A.12): with the displacement of every side held, the rows of
// the nodes inside are consistent with a rigid motion.
static void held_sides_carry_the_plate_with_them(void **state)
{
    (void)state;
    plate p;
    plate_make(&p, 4.0, 5, 0.5);
    for (int side = 0; side < 4; side++)
        p.supports[p.problem.support_count++] = (pdmc_support){(pdmc_side)side, {true, true}, {0.3, -0.2}};
    plate_crack(&p, 0.1, 0.05, 0.7, 0.6);
    paper_settings(&p, true);
    pdmc_paper *paper = solved(&p);
    double u[2];
    const double x[2] = {0.37, -1.1};
    CHECK_OK(pdmc_paper_displacement(paper, x, x, u));
    CHECK_NEAR(u[0], 0.3, 1e-12);
    CHECK_NEAR(u[1], -0.2, 1e-12);
    assert_int_equal(paper->motions, 0);
    pdmc_paper_destroy(&paper);
}

// One element (table 1): four nodes and four monomials, so the side conditions leave nothing of the multiquadrics, and the
// rows of a corner's quarter disc are c delta^2 / 2 (e_x / 3 + 2 e_y / 3) = sigma / e and c delta^2 / 2 (2 e_x / 3 + e_y / 3)
// = 0, whence e_y = 4 pi delta / (9 e) sigma / E = -2 e_x: with e = delta / 5, 6.98 times sigma / E.
static void one_element_has_a_closed_form(void **state)
{
    (void)state;
    plate p;
    plate_make(&p, 1.0, 1, 1.0);
    p.problem.material.youngs_modulus = 1.5;
    plate_load(&p, PDMC_SIDE_TOP, 0.0, 1.0);
    plate_load(&p, PDMC_SIDE_BOTTOM, 0.0, -1.0);
    paper_settings(&p, true);
    pdmc_paper *paper = solved(&p);
    double strain[2];
    elongation(paper, 0.5, strain);
    CHECK_NEAR(strain[1], 20.0 * M_PI / 9.0 / 1.5, 1e-11);
    CHECK_NEAR(strain[0], -10.0 * M_PI / 9.0 / 1.5, 1e-11);
    for (int k = 0; k < 4; k++) {
        CHECK_NEAR(paper->coefficients[k], 0.0, 1e-13);
        CHECK_NEAR(paper->coefficients[paper->basis.scalars + k], 0.0, 1e-13);
    }
    pdmc_paper_destroy(&paper);
}

static void visibility_is_symmetric_and_ends_at_the_crack(void **state)
{
    (void)state;
    plate p;
    plate_make(&p, 4.0, 4, 0.5);
    plate_crack(&p, 0.1, -0.2, 0.8, 0.7);
    plate_crack(&p, -1.0, 0.9, 0.3, 2.0);
    unsigned seed = 1;
    int hidden = 0;
    for (int i = 0; i < 2000; i++) {
        double x[4];
        for (int k = 0; k < 4; k++) {
            seed = seed * 1664525U + 1013904223U;
            x[k] = seed / 4294967296.0 * 4.0 - 2.0;
        }
        const bool sees = pdmc_paper_visible(&p.problem, x, x + 2);
        assert_true(sees == pdmc_paper_visible(&p.problem, x + 2, x));
        hidden += !sees;
        const double d[2] = {x[2] - x[0], x[3] - x[1]}, length = hypot(d[0], d[1]);
        const double reach = pdmc_paper_reach(&p.problem, 10.0, x, (const double[2]){d[0] / length, d[1] / length});
        assert_true(sees == (reach > length)); // the basis and the discs are cut by the same crack
    }
    assert_in_range(hidden, 200, 1800);
}

// Left and right, and up and down.
static void a_symmetric_plate_has_symmetric_tips(void **state)
{
    (void)state;
    plate p;
    plate_make_cracked(&p, 0.5, 0.0, 16);
    p.problem.solver.horizon = 0.3125;
    p.problem.solver.shape = 0.05;
    paper_settings(&p, true);
    pdmc_paper *paper = solved(&p);
    pdmc_tip tip[2];
    for (int t = 0; t < 2; t++) CHECK_OK(pdmc_paper_tip(paper, t, &tip[t]));
    CHECK_NEAR(tip[0].stress_intensity[0] / tip[1].stress_intensity[0], 1.0, 1e-8);
    for (int t = 0; t < 2; t++) CHECK_NEAR(tip[t].stress_intensity[1] / tip[1].stress_intensity[0], 0.0, 1e-8);
    assert_true(isnan(tip[0].t_stress) && isnan(tip[0].stress_intensity_error[0]));
    CHECK_NEAR(paper->residual, 0.0, 1e-9); // symmetry balances the loads
    pdmc_paper_destroy(&paper);
}

// The opening that the fit is made for: u = K / E' 8 sqrt(r / 2 pi) is q_6 of a tip, 2 sqrt(r / L) wide.
static void the_fit_finds_the_opening_of_a_tip_function(void **state)
{
    (void)state;
    plate p;
    plate_make_cracked(&p, 0.5, 0.3, 8);
    paper_settings(&p, true);
    pdmc_paper *paper = solved(&p);
    double *row = pdmc_calloc(2 * (size_t)paper->unknowns, sizeof *row);
    assert_non_null(row);
    CHECK_OK(pdmc_paper_stress_intensity_rows(paper, 1, row, row + paper->unknowns));
    const int q6 = paper->basis.nodes.count + 4 + 4 + 1, scalars = paper->basis.scalars; // of the second tip
    const double K = 2.0 * sqrt(2.0 * M_PI) / 8.0 / sqrt(2.5);
    CHECK_NEAR(row[q6], -K * sin(0.3), 1e-9);
    CHECK_NEAR(row[scalars + q6], K * cos(0.3), 1e-9);
    CHECK_NEAR(row[paper->unknowns + q6], K * cos(0.3), 1e-9);
    CHECK_NEAR(row[paper->unknowns + scalars + q6], K * sin(0.3), 1e-9);
    pdmc_free(row);
    pdmc_paper_destroy(&paper);
}

static void the_number_of_threads_changes_nothing(void **state)
{
    (void)state;
    plate p;
    pdmc_paper *paper[2] = {NULL, NULL};
    plate_make_cracked(&p, 0.5, 0.3, 8);
    paper_settings(&p, true);
    for (int t = 0; t < 2; t++) CHECK_OK(pdmc_paper_create(&p.problem, 1 + t, &paper[t]));
    assert_memory_equal(paper[0]->coefficients, paper[1]->coefficients,
                        (size_t)paper[0]->unknowns * sizeof *paper[0]->coefficients);
    for (int t = 0; t < 2; t++) pdmc_paper_destroy(&paper[t]);
}

static double error_of_K(int cells, double horizon, bool tip_functions, double exact, double *strain)
{
    plate p;
    pdmc_tip tip;
    double e[2];
    plate_make_cracked(&p, 0.5, 0.0, cells);
    p.problem.solver.horizon = horizon;
    p.problem.solver.shape = 0.16 * p.problem.solver.spacing;
    paper_settings(&p, tip_functions);
    pdmc_paper *paper = solved(&p);
    CHECK_OK(pdmc_paper_tip(paper, 1, &tip));
    elongation(paper, 2.5, e);
    pdmc_paper_destroy(&paper);
    *strain = e[1];
    return 100.0 * (tip.stress_intensity[0] / exact - 1.0);
}

static double error_of_analytic_K(int cells, double exact)
{
    plate p;
    pdmc_kansa *kansa = NULL;
    pdmc_tip tip;
    plate_make_cracked(&p, 0.5, 0.0, cells);
    CHECK_OK(pdmc_kansa_create(&p.problem, NULL, 2, &kansa));
    CHECK_OK(pdmc_kansa_tip(kansa, 1, &tip));
    pdmc_kansa_destroy(&kansa);
    return 100.0 * (tip.stress_intensity[0] / exact - 1.0);
}

// For the record: no convergence with more nodes, with tip functions or without.
static void the_error_of_K_does_not_fall(void **state)
{
    (void)state;
    reference exact;
    reference_solve(&exact, 5.0, 0.5, 0.0);
    enum { HORIZONS = FINEST_LEFT_OUT ? 1 : 3 };
    const double horizons[3] = {0.1, 0.5, 1.0};
    double worst[6] = {0}; // of the two finest grids
    printf("  central crack a = 0.5, W = 5, psi = 0.16 h, e = delta / 5; error of K_I in %% (elongation, 1.06 is "
           "right)\n");
    printf("  nodes | delta = 0.1                 | 0.5                         | 1.0                         | "
           "analytic\n");
    printf("        | tip functions  none         | tip functions  none         | tip functions  none         |\n");
    for (int cells = 8; cells <= 20 - 4 * FINEST_LEFT_OUT; cells += 4) {
        printf("  %5d |", (cells + 1) * (cells + 1));
        for (int d = 0; d < HORIZONS; d++) {
            for (int none = 0; none < 2; none++) {
                double strain;
                const double error = error_of_K(cells, horizons[d], !none, exact.K[0], &strain);
                printf(" %+6.1f (%.2f)", error, strain);
                if (cells >= 16) worst[2 * d + none] = fmax(worst[2 * d + none], fabs(error));
            }
            printf(" |");
        }
        const double analytic = error_of_analytic_K(cells, exact.K[0]);
        printf(" %+.2f\n", analytic);
        if (cells >= 16) assert_true(fabs(analytic) < 0.1);
    }
    for (int k = 0; k < 2 * HORIZONS; k++) assert_true(worst[k] > 10.0);
}

static void refusal_of_memory(void **state)
{
    (void)state;
    plate p;
    pdmc_paper *paper = NULL;
    plate_make_cracked(&p, 0.5, 0.3, 4);
    paper_settings(&p, true);
    p.uncertainties[0] = (pdmc_uncertainty){PDMC_QUANTITY_MICROMODULUS, .bins = 10, .variation = 0.2};
    p.problem.uncertainty_count = 1;
    CHECK_FAILS_CLEANLY(pdmc_paper_create(&p.problem, 1, &paper), (void)0);
    pdmc_paper_destroy(&paper);
}

static void bad_input_is_refused(void **state)
{
    (void)state;
    plate p;
    pdmc_paper *paper = NULL;
    plate_make_cracked(&p, 0.5, 0.0, 4);
    paper_settings(&p, true);
    CHECK_STATUS(pdmc_paper_create(&p.problem, 0, &paper), PDMC_ERR_ARG);
    p.problem.solver.edge_layer = 0.0;
    CHECK_STATUS(pdmc_paper_create(&p.problem, 1, &paper), PDMC_ERR_ARG);
    paper_settings(&p, true);
    p.loads[0].traction[1] = 2.0;
    CHECK_STATUS(pdmc_paper_create(&p.problem, 1, &paper), PDMC_ERR_CONFIG);
    assert_null(paper);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(held_sides_carry_the_plate_with_them),
        cmocka_unit_test(one_element_has_a_closed_form),
        cmocka_unit_test(visibility_is_symmetric_and_ends_at_the_crack),
        cmocka_unit_test(a_symmetric_plate_has_symmetric_tips),
        cmocka_unit_test(the_fit_finds_the_opening_of_a_tip_function),
        cmocka_unit_test(the_number_of_threads_changes_nothing),
        cmocka_unit_test(the_error_of_K_does_not_fall),
        cmocka_unit_test(refusal_of_memory),
        cmocka_unit_test(bad_input_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
