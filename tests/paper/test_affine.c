// SPDX-License-Identifier: GPL-3.0-or-later
#include "kansa/samples.h"

#include "paper/plate.h"
#include "pdmc/fracture.h"

#include <gsl/gsl_math.h>

static void make_noisy(plate *p, int bins, double variation)
{
    plate_make_cracked(p, 0.5, 0.0, 8);
    p->problem.solver.horizon = 0.5;
    p->problem.solver.shape = 0.1;
    p->problem.energy.horizon = 0.1;
    p->problem.energy.extension = 0.05;
    paper_settings(p, true);
    p->uncertainties[0] = (pdmc_uncertainty){PDMC_QUANTITY_MICROMODULUS, .bins = bins, .variation = variation};
    p->problem.uncertainty_count = 1;
}

static void make(plate *p, pdmc_paper **paper, pdmc_affine *model)
{
    *paper = NULL;
    CHECK_OK(pdmc_paper_create(&p->problem, 2, paper));
    CHECK_OK(pdmc_paper_affine(*paper, model));
}

// The factored rows against the definition, through displacements of the model itself; and the symmetries of mode I.
static void factored_rows_give_the_energy_of_the_definition(void **state)
{
    (void)state;
    static pdmc_crossing_bond bonds[PDMC_CROSSING_BONDS];
    plate p;
    pdmc_paper *paper;
    pdmc_affine model;
    pdmc_ring_rule rings;
    double energy[16], sum = 0.0;
    int count;
    make_noisy(&p, 5, 0.2);
    make(&p, &paper, &model);
    nominal(&p.problem, &model, PDMC_BONDS_ALL, energy);
    const double phi = M_PI / 4.0, x_t[2] = {0.5 + 0.05 * cos(phi), 0.05 * sin(phi)};
    CHECK_OK(pdmc_ring_rule_create(PDMC_CROSSING_RINGS, 1, 3, p.problem.energy.horizon, &rings));
    CHECK_OK(pdmc_crossing_bonds(&p.problem, x_t, phi, &rings, &count, bonds));
    for (int b = 0; b < count; b++) {
        double u[2], v[2];
        CHECK_OK(pdmc_paper_displacement(paper, bonds[b].start, bonds[b].start, u));
        CHECK_OK(pdmc_paper_displacement(paper, bonds[b].end, bonds[b].end, v));
        const double s = bonds[b].direction[0] * (v[0] - u[0]) + bonds[b].direction[1] * (v[1] - u[1]);
        sum += rings.mean[bonds[b].ring] * bonds[b].weight * s * s;
    }
    const double exact = 0.5 * pdmc_micromodulus(&p.problem.material, p.problem.energy.horizon) * sum;
    CHECK_NEAR(energy[8 + 1] / exact, 1.0, 1e-9);
    for (int a = 0; a < 8; a++) {
        CHECK_NEAR(energy[8 + a], energy[8 + (8 - a) % 8], 1e-7 * energy[8]);
        CHECK_NEAR(energy[a], energy[8 + (12 - a) % 8], 1e-7 * energy[8]);
    }
    pdmc_ring_rule_clear(&rings);
    pdmc_affine_clear(&model);
    pdmc_paper_destroy(&paper);
}

// The same deviation in every bin scales every row of forces, and nothing else: u with the inverse of the modulus, and
// y = K_0 x as well in the rows of forces, where the loads are.
static void a_uniform_deviation_scales_the_modulus(void **state)
{
    (void)state;
    plate p;
    pdmc_paper *paper;
    pdmc_affine model;
    double xi[PDMC_PAPER_TERMS] = {0}, modulus = 1.0, scale[2] = {1.0, 1.0};
    make_noisy(&p, 7, 0.2);
    make(&p, &paper, &model);
    assert_int_equal(model.terms, PDMC_PAPER_TERMS);
    for (int b = 0; b < 7; b++) {
        modulus += 0.25 * model.modulus_weight[b];
        for (int m = 0; m < model.terms; m++) xi[m] += 0.25 * model.term_weight[b * model.terms + m];
    }
    CHECK_NEAR(modulus, 1.25, 1e-14);
    CHECK_NEAR(xi[0], 0.25, 1e-14);
    for (int m = 1; m < model.terms; m++) CHECK_NEAR(xi[m], 0.0, 1e-14);
    double *x = pdmc_calloc((size_t)model.unknowns, sizeof *x);
    assert_non_null(x);
    CHECK_OK(model.verbs->solve(&model, xi, scale, x));
    const double *held = pdmc_affine_solution(&model, 0), *loads = pdmc_affine_solution(&model, 1);
    for (int i = 0; i < model.unknowns; i++) CHECK_NEAR(1.25 * x[i], held[i] + loads[i], 1e-9);
    pdmc_free(x);
    pdmc_affine_clear(&model);
    pdmc_paper_destroy(&paper);
}

// The Legendre coefficients of a deviation in its bins, against their integral.
static void terms_are_legendre_coefficients(void **state)
{
    (void)state;
    plate p;
    pdmc_paper *paper;
    pdmc_affine model;
    make_noisy(&p, 4, 0.2);
    make(&p, &paper, &model);
    // the second of four bins is s from -1/2 to 0: 3/2 int s = -3/16, 5/2 int (3 s^2 - 1) / 2 = -15/32
    CHECK_NEAR(model.term_weight[1 * PDMC_PAPER_TERMS], 0.25, 1e-15);
    CHECK_NEAR(model.term_weight[1 * PDMC_PAPER_TERMS + 1], -3.0 / 16.0, 1e-15);
    CHECK_NEAR(model.term_weight[1 * PDMC_PAPER_TERMS + 2], -15.0 / 32.0, 1e-15);
    CHECK_NEAR(model.modulus_weight[1], 7.0 / 64.0, 1e-15);
    pdmc_affine_clear(&model);
    pdmc_paper_destroy(&paper);
}

static void the_expansion_converges_to_the_direct_solution(void **state)
{
    (void)state;
    enum { COUNT = 24, ORDERS = 8 };
    static double energy[16 * 64], direct[16 * 64];
    plate p;
    pdmc_paper *paper;
    pdmc_affine model;
    double K[64], median, previous = INFINITY;
    make_noisy(&p, 100, 0.2);
    make(&p, &paper, &model);
    solve_samples(&p, &model, PDMC_INVERSE_DIRECT, 0, COUNT, direct, K);
    printf("  100 bins, 20 %%, %d dimensions of %d: error of G against direct by order, median (largest):",
           model.unknowns, paper->unknowns);
    for (int order = 0; order <= ORDERS; order += 2) {
        solve_samples(&p, &model, PDMC_INVERSE_NEUMANN, order, COUNT, energy, K);
        const double largest = largest_error(energy, direct, COUNT, &median);
        printf(" %.1e (%.1e)", median, largest);
        assert_true(largest < 0.5 * previous || largest < 1e-4);
        previous = largest;
    }
    printf("\n");
    assert_true(previous < 1e-3);
    pdmc_affine_clear(&model);
    pdmc_paper_destroy(&paper);
}

// Without a random c(r) the model has its mean solutions and nothing else.
static void a_certain_micromodulus_needs_no_terms(void **state)
{
    (void)state;
    plate p;
    pdmc_paper *paper;
    pdmc_affine model;
    pdmc_tip tip;
    make_noisy(&p, 100, 0.2);
    p.problem.uncertainty_count = 0;
    make(&p, &paper, &model);
    assert_int_equal(model.terms, 0);
    assert_int_equal(model.unknowns, 1);
    CHECK_OK(pdmc_paper_tip(paper, 1, &tip));
    CHECK_NEAR(model.stress_intensity[2] * pdmc_affine_solution(&model, 1)[0] / tip.stress_intensity[0], 1.0, 1e-9);
    pdmc_affine_clear(&model);
    pdmc_paper_destroy(&paper);
}

static void refused_allocations_are_reported(void **state)
{
    (void)state;
    plate p;
    pdmc_paper *paper = NULL;
    pdmc_affine model;
    make_noisy(&p, 3, 0.2);
    p.problem.solver.spacing = 1.25;
    p.problem.energy.angles = 4;
    p.problem.energy.tip_count = 1;
    CHECK_OK(pdmc_paper_create(&p.problem, 1, &paper));
    CHECK_FAILS_CLEANLY(pdmc_paper_affine(paper, &model), pdmc_affine_clear(&model));
    pdmc_paper_destroy(&paper);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(factored_rows_give_the_energy_of_the_definition),
        cmocka_unit_test(a_uniform_deviation_scales_the_modulus),
        cmocka_unit_test(terms_are_legendre_coefficients),
        cmocka_unit_test(the_expansion_converges_to_the_direct_solution),
        cmocka_unit_test(a_certain_micromodulus_needs_no_terms),
        cmocka_unit_test(refused_allocations_are_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
