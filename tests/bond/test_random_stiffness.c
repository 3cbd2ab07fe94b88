// SPDX-License-Identifier: GPL-3.0-or-later

/// Samples of a random stiffness by bonds: four inverses, the reduced model's bound, scatter, and any number of threads.

#include "bond/method.h"
#include "bond/random_stiffness.h"
#include "bond/varying_plate.h"
#include "stochastic/reduced.h"
#include "support/drawn_block.h"

#include <string.h>

enum { B = PDMC_BLOCK, COUNT = 8, VALUES = COUNT * TIPS * (2 + ANGLES) };

static void describe(varying_plate *v, pdmc_distribution_kind distribution, double length)
{
    varying_plate_describe(v, 30, 3.0);
    v->uncertainties[0] = (pdmc_uncertainty){.quantity = PDMC_QUANTITY_STIFFNESS,
                                             .distribution = distribution,
                                             .variation = 0.2,
                                             .covariance = {PDMC_COVARIANCE_EXPONENTIAL, length, 0.0},
                                             .modes = 20};
    v->uncertainties[1] = (pdmc_uncertainty){.quantity = PDMC_QUANTITY_MICROMODULUS, .bins = 20, .variation = 0.1};
    v->problem.uncertainty_count = 1;
}

// Stress intensities and energies of the first samples.
static void sample(const varying_plate *v, const pdmc_affine *model, pdmc_inverse inverse, int order, double value[])
{
    pdmc_problem problem = v->problem;
    drawn_block drawn;
    problem.sampling.inverse = inverse;
    problem.sampling.order = order;
    pdmc_block *block = drawn_block_begin(&drawn, &problem, model, COUNT);
    CHECK_OK(pdmc_block_solve(block, COUNT));
    pdmc_block_energies(block, PDMC_BONDS_ALL);
    for (int s = 0; s < COUNT; s++) {
        assert_int_equal(block->failure[s], PDMC_SAMPLE_OK);
        for (int k = 0; k < 2 * TIPS; k++) *value++ = block->intensity[k * B + s];
        for (int d = 0; d < TIPS * ANGLES; d++) *value++ = block->energy[d * B + s];
    }
    drawn_block_end(&drawn);
}

static double difference(const double a[], const double b[])
{
    double worst = 0.0, largest = 0.0;
    for (int k = 0; k < VALUES; k++) worst = fmax(worst, fabs(a[k] - b[k]));
    for (int k = 0; k < VALUES; k++) largest = fmax(largest, fabs(b[k]));
    return worst / largest;
}

// Alone, with c(r), and with prescribed displacements. Conjugate gradients stop at 1e-10; eight orders of a contraction of
// 0.3 leave 1e-4 or less.
static void all_inverses_agree(void **state)
{
    (void)state;
    static double exact[VALUES], value[VALUES];
    for (int kind = 0; kind < 3; kind++) {
        varying_plate v;
        pdmc_discretisation plate = {0};
        pdmc_affine model;
        describe(&v, kind == 1 ? PDMC_LOGNORMAL : PDMC_NORMAL, 0.5);
        v.problem.uncertainty_count = kind == 1 ? 2 : 1;
        if (kind == 2) {
            v.problem.load_count = 0;
            v.problem.support_count = 2;
            v.supports[0] = (pdmc_support){PDMC_SIDE_TOP, {true, true}, {0.0, 1.0}};
            v.supports[1] = (pdmc_support){PDMC_SIDE_BOTTOM, {true, true}, {0.0, -1.0}};
        }
        CHECK_OK(pdmc_bond_discretise(&v.problem, 2, &plate));
        CHECK_OK(plate.verbs->affine(plate.method, &model));
        assert_int_equal(model.terms - model.radial_terms, pdmc_field_terms(model.field));
        sample(&v, &model, PDMC_INVERSE_DIRECT, 0, exact);
        sample(&v, &model, PDMC_INVERSE_KRYLOV, 0, value);
        const double iterated = difference(value, exact);
        sample(&v, &model, PDMC_INVERSE_NEUMANN, 8, value);
        const double expanded = difference(value, exact);
        print_message("  %d terms: conjugate gradients off by %.1e, order 8 by %.1e\n", model.terms, iterated,
                      expanded);
        assert_true(iterated < 1e-8);
        assert_true(expanded < 1e-3);
        pdmc_affine_clear(&model);
        plate.verbs->destroy(plate.method);
    }
}

// Against direct solutions of samples that the reduced model was not made with; terms of shells and of the field together.
static void the_bound_holds(void **state)
{
    (void)state;
    enum { CHECKED = 24 };
    for (int quantities = 1; quantities <= 2; quantities++) {
        varying_plate v;
        pdmc_discretisation plate = {0};
        pdmc_affine model, reduced;
        drawn_block drawn;
        pdmc_reduced_bound bound;
        const pdmc_reduced_goal goal = {.error = 0.03};
        const double scale[2] = {0.0, 1.0};
        double least = INFINITY, most = 0.0;
        describe(&v, PDMC_NORMAL, 0.5);
        v.uncertainties[0].variation = 0.15;
        v.problem.uncertainty_count = quantities;
        CHECK_OK(pdmc_bond_discretise(&v.problem, 2, &plate));
        CHECK_OK(plate.verbs->affine(plate.method, &model));
        const double *xi = drawn_block_begin(&drawn, &v.problem, &model, B)->drawn.xi;
        CHECK_OK(pdmc_reduced_create(&drawn.variables, &goal, 2, &reduced));
        const int n = model.unknowns, r = reduced.unknowns;
        double *y = new_values((size_t)(B * r)), *x = new_values(B * (size_t)n), *Kx = new_values(B * (size_t)n);
        bound.intensity = new_values(B * 2 * TIPS);
        CHECK_OK(pdmc_reduced_solve(&reduced, xi, NULL, y, &bound));
        for (int s = 0; s < CHECKED; s++) CHECK_OK(model.verbs->solve(&model, &xi[s * model.terms], scale, &x[s * n]));
        CHECK_OK(model.verbs->multiply(&model, 1.0, xi, x, Kx));
        for (int s = 0; s < CHECKED; s++) {
            // Galerkin: e' K e = x' K x - y' V' F
            const double work = inner(n, &x[s * n], &Kx[s * n]);
            const double error = sqrt(work - inner(r, &y[s * r], pdmc_affine_solution(&reduced, 1)));
            least = fmin(least, bound.error[s] / error);
            most = fmax(most, bound.error[s] / error);
            for (int k = 0; k < 2 * TIPS; k++) {
                const double K = inner(n, &model.stress_intensity[k * n], &x[s * n]);
                const double K_r = inner(r, &reduced.stress_intensity[k * r], &y[s * r]);
                assert_true(fabs(K - K_r) <= bound.intensity[s * 2 * TIPS + k]);
            }
        }
        print_message("  %d of %d unknowns, bound / error from %.2f to %.2f\n", r, n, least, most);
        assert_true(least >= 1.0);
        assert_true(most < 12.0); // as of the weak form: 2 by the probes, and the least stiffness over that of the tips
        free(x);
        free(Kx);
        free(y);
        free(bound.intensity);
        pdmc_affine_clear(&reduced);
        drawn_block_end(&drawn);
        pdmc_affine_clear(&model);
        plate.verbs->destroy(plate.method);
    }
}

// K(xi) >= alpha K_0 as no bond has a factor below alpha: the least of the nodes' and the least of the shells'.
static void no_bond_is_softer_than_the_bound(void **state)
{
    (void)state;
    for (int quantities = 1; quantities <= 2; quantities++) {
        varying_plate v;
        pdmc_bond_random_stiffness random;
        pdmc_affine model;
        drawn_block drawn;
        double alpha[B];
        describe(&v, PDMC_NORMAL, 0.5);
        v.problem.uncertainty_count = quantities;
        CHECK_OK(pdmc_bond_create(&v.problem, 1, &v.bond));
        CHECK_OK(pdmc_bond_random_stiffness_create(v.bond, &random));
        CHECK_OK(pdmc_bond_affine(v.bond, &random.stiffness, &model));
        model.field = random.field;
        const double *all = drawn_block_begin(&drawn, &v.problem, &model, B)->drawn.xi;
        CHECK_OK(model.verbs->coercivity(&model, all, alpha));
        for (int s = 0; s < B; s += 5) {
            const double *xi = &all[s * model.terms], *field = &xi[model.radial_terms];
            double node = INFINITY, shell = quantities > 1 ? INFINITY : 0.0;
            for (int i = 0; i < v.bond->plate.grid.nodes; i++)
                node = fmin(node, 1.0 + inner(random.stiffness.terms, field,
                                              &random.stiffness.value[i * random.stiffness.terms]));
            for (int m = 0; m < model.radial_terms; m++) shell = fmin(shell, xi[m]);
            CHECK_NEAR(alpha[s], node + shell, 1e-13);
            assert_true(alpha[s] < 0.95);
        }
        drawn_block_end(&drawn);
        pdmc_affine_clear(&model);
        pdmc_bond_random_stiffness_clear(&random);
        pdmc_bond_destroy(&v.bond);
    }
}

// The first function holds all that ln G depends on to first order: with it alone the scatter is v sqrt(s' C s), s the
// derivatives at the nodes, as summed here over all pairs of nodes.
static void modes_keep_the_scatter_of_the_energy(void **state)
{
    (void)state;
    varying_plate v;
    pdmc_bond_random_stiffness random;
    describe(&v, PDMC_NORMAL, 0.5);
    CHECK_OK(pdmc_bond_create(&v.problem, 2, &v.bond));
    CHECK_OK(pdmc_bond_random_stiffness_create(v.bond, &random));
    const int nodes = v.bond->plate.grid.nodes, terms = random.stiffness.terms;
    for (int t = 0; t < TIPS; t++) {
        const double *release = &random.stiffness.release[t * nodes];
        double exact = 0.0, kept = 0.0;
        for (int i = 0; i < nodes; i++)
            for (int j = 0; j < nodes; j++) {
                double a[2], b[2];
                pdmc_bond_grid_node(&v.bond->plate.grid, i, a);
                pdmc_bond_grid_node(&v.bond->plate.grid, j, b);
                exact += 0.04 * release[i] * release[j] * exp(-hypot(a[0] - b[0], a[1] - b[1]) / 0.5);
            }
        for (int k = 0; k < terms; k++) {
            double sum = 0.0;
            for (int i = 0; i < nodes; i++) sum += release[i] * random.stiffness.value[i * terms + k];
            kept += sum * sum;
        }
        print_message("  coefficient of variation of G to first order %.4f, of all modes %.4f\n", sqrt(kept),
                      sqrt(exact));
        CHECK_NEAR(kept, exact, 1e-10 * exact); // a sum of 810,000 products
    }
    pdmc_bond_random_stiffness_clear(&random);
    pdmc_bond_destroy(&v.bond);
}

static void samples_do_not_depend_on_threads(void **state)
{
    (void)state;
    static double first[VALUES], second[VALUES];
    varying_plate v;
    describe(&v, PDMC_LOGNORMAL, 0.5);
    v.problem.uncertainty_count = 2;
    for (int threads = 1; threads <= 3; threads += 2) {
        pdmc_discretisation plate = {0};
        pdmc_affine model;
        CHECK_OK(pdmc_bond_discretise(&v.problem, threads, &plate));
        CHECK_OK(plate.verbs->affine(plate.method, &model));
        sample(&v, &model, PDMC_INVERSE_KRYLOV, 0, threads == 1 ? first : second);
        pdmc_affine_clear(&model);
        plate.verbs->destroy(plate.method);
    }
    assert_memory_equal(first, second, sizeof first);
}

static void every_allocation_may_be_refused(void **state)
{
    (void)state;
    varying_plate v;
    pdmc_bond_random_stiffness random;
    pdmc_affine model;
    describe(&v, PDMC_NORMAL, 2.0);
    v.problem.solver.spacing = 0.5;
    v.problem.solver.horizon = 1.0;
    v.problem.solver.load_layer = 0.5;
    v.uncertainties[0].modes = 3;
    v.problem.energy.angles = 2;
    CHECK_OK(pdmc_bond_create(&v.problem, 1, &v.bond));
    CHECK_FAILS_CLEANLY(pdmc_bond_random_stiffness_create(v.bond, &random), (void)0);
    CHECK_FAILS_CLEANLY(pdmc_bond_affine(v.bond, &random.stiffness, &model), pdmc_affine_clear(&model));
    pdmc_bond_random_stiffness_clear(&random);
    pdmc_bond_destroy(&v.bond);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_inverses_agree),
        cmocka_unit_test(the_bound_holds),
        cmocka_unit_test(no_bond_is_softer_than_the_bound),
        cmocka_unit_test(modes_keep_the_scatter_of_the_energy),
        cmocka_unit_test(samples_do_not_depend_on_threads),
        cmocka_unit_test(every_allocation_may_be_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
