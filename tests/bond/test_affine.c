// SPDX-License-Identifier: GPL-3.0-or-later

/// Samples of a cracked grid: three ways to solve them, and what symmetry demands of their energies.

#include "bond/cracked.h"
#include "support/drawn_block.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <string.h>

enum { COUNT = 8, VALUES = COUNT * TIPS * ANGLES };

// Energies of the first samples, [COUNT, TIPS ANGLES].
static void sample(cracked *c, pdmc_inverse inverse, int order, double energy[VALUES])
{
    drawn_block drawn;
    c->problem.sampling.inverse = inverse;
    c->problem.sampling.order = order;
    pdmc_block *block = drawn_block_begin(&drawn, &c->problem, &c->model, COUNT);
    CHECK_OK(pdmc_block_solve(block, COUNT));
    pdmc_block_energies(block, PDMC_BONDS_ALL);
    for (int s = 0; s < COUNT; s++) {
        assert_int_equal(block->failure[s], PDMC_SAMPLE_OK);
        for (int d = 0; d < TIPS * ANGLES; d++) energy[TIPS * ANGLES * s + d] = block->energy[d * PDMC_BLOCK + s];
    }
    drawn_block_end(&drawn);
}

static double largest_difference(const double energy[VALUES], const double exact[VALUES])
{
    double worst = 0.0;
    for (int i = 0; i < VALUES; i++)
        if (exact[i] > 0.0) worst = fmax(worst, fabs(energy[i] / exact[i] - 1.0));
    return worst;
}

// Conjugate gradients stop at 1e-10 in the energy norm; a local energy may be 100 times as sensitive as the norm.
static void expansion_and_iteration_converge_to_direct_solutions(void **state)
{
    (void)state;
    static double exact[VALUES], energy[VALUES];
    cracked c;
    double error[5];
    describe(&c, 100, 0.2);
    make(&c);
    sample(&c, PDMC_INVERSE_DIRECT, 0, exact);
    for (int order = 0; order <= 4; order++) {
        sample(&c, PDMC_INVERSE_NEUMANN, order, energy);
        error[order] = largest_difference(energy, exact);
        print_message("expansion of order %d: largest error of G %.1e\n", order, error[order]);
        if (order > 0) assert_true(error[order] < 0.5 * error[order - 1]);
    }
    sample(&c, PDMC_INVERSE_KRYLOV, 0, energy);
    const double iterated = largest_difference(energy, exact);
    print_message("conjugate gradients to 1e-10: %.1e\n", iterated);
    assert_true(iterated < 1e-8);
    assert_true(error[4] < 1e-3); // contraction 0.1 to 0.2 a step, five steps
    clear(&c);
}

// With prescribed displacements the load on the free unknowns changes with the sample.
static void the_same_where_displacements_are_prescribed(void **state)
{
    (void)state;
    static double exact[VALUES], energy[VALUES];
    cracked c;
    describe(&c, 10, 0.2);
    c.problem.load_count = 0;
    c.problem.support_count = 2;
    c.supports[0] = (pdmc_support){PDMC_SIDE_TOP, {true, true}, {0.0, 0.01}};
    c.supports[1] = (pdmc_support){PDMC_SIDE_BOTTOM, {true, true}, {0.0, -0.01}};
    make(&c);
    sample(&c, PDMC_INVERSE_DIRECT, 0, exact);
    sample(&c, PDMC_INVERSE_KRYLOV, 0, energy);
    assert_true(exact[ANGLES] > 0.0); // ahead of the right tip
    assert_true(largest_difference(energy, exact) < 1e-8);
    sample(&c, PDMC_INVERSE_NEUMANN, 8, energy);
    assert_true(largest_difference(energy, exact) < 1e-2); // ten bins scatter three times as much as a hundred
    clear(&c);
}

// One bin: c is constant in r, and a plate under traction moves as 1 / c.
static void a_uniform_deviation_scales_displacements(void **state)
{
    (void)state;
    const double eta = 0.3, load[2] = {0.0, 1.0};
    cracked c;
    double xi[64], *x = NULL;
    describe(&c, 1, 0.2);
    make(&c);
    assert_true(c.model.terms <= 64);
    for (int m = 0; m < c.model.terms; m++) xi[m] = eta * c.model.term_weight[m];
    CHECK_NEAR(c.model.modulus_weight[0], 1.0, 1e-14);
    x = pdmc_calloc((size_t)c.model.unknowns, sizeof *x);
    CHECK_OK(c.model.verbs->solve(&c.model, xi, load, x));
    double size = 0.0;
    for (int k = 0; k < c.model.unknowns; k++) size = fmax(size, fabs(x[k]));
    for (int k = 0; k < c.model.unknowns; k++)
        CHECK_NEAR(x[k], pdmc_affine_solution(&c.model, 1)[k] / (1.0 + eta), 1e-11 * size); // condition some 1e4
    pdmc_free(x);
    clear(&c);
}

// The plate is its own mirror image in both axes; so is the rule that counts crossings.
static void energies_have_the_symmetry_of_the_plate(void **state)
{
    (void)state;
    static double energy[VALUES];
    cracked c;
    describe(&c, 100, 0.2);
    make(&c);
    sample(&c, PDMC_INVERSE_DIRECT, 0, energy);
    for (int a = 0; a < ANGLES; a++) {
        const double G = energy[ANGLES + a]; // of the right tip
        const int up_down = (ANGLES - a) % ANGLES, left_right = (ANGLES / 2 - a + ANGLES) % ANGLES;
        CHECK_NEAR(energy[ANGLES + up_down], G, 1e-9 * energy[ANGLES]);
        CHECK_NEAR(energy[left_right], G, 1e-9 * energy[ANGLES]);
    }
    assert_true(energy[ANGLES] > energy[ANGLES + 1] && energy[ANGLES + 1] > energy[ANGLES + 4]); // mode I
    clear(&c);
}

static void every_allocation_may_be_refused(void **state)
{
    (void)state;
    cracked c;
    describe(&c, 2, 0.1);
    c.problem.plate = (pdmc_plate){1.6, 1.6, 1.0};
    c.problem.energy.angles = 4;
    CHECK_FAILS_CLEANLY(pdmc_bond_create(&c.problem, 1, &c.bond), (void)0);
    CHECK_FAILS_CLEANLY(pdmc_bond_affine(c.bond, NULL, &c.model), (void)0);
    clear(&c);
}

static void a_plate_in_two_pieces_is_refused(void **state)
{
    (void)state;
    cracked c;
    describe(&c, 2, 0.1);
    memcpy(&c.crack, &(pdmc_crack){"a", {-3.0, 0.0}, {1.9999, 0.0}}, sizeof c.crack);
    CHECK_STATUS(pdmc_bond_create(&c.problem, 1, &c.bond), PDMC_ERR_SINGULAR);
    assert_non_null(strstr(pdmc_last_error(), "not held by bonds"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(expansion_and_iteration_converge_to_direct_solutions),
        cmocka_unit_test(the_same_where_displacements_are_prescribed),
        cmocka_unit_test(a_uniform_deviation_scales_displacements),
        cmocka_unit_test(energies_have_the_symmetry_of_the_plate),
        cmocka_unit_test(every_allocation_may_be_refused),
        cmocka_unit_test(a_plate_in_two_pieces_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
