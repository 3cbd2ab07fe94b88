// SPDX-License-Identifier: GPL-3.0-or-later
#include "visible/cracked.h"

#include "pdmc/fracture.h"
#include "support/drawn_block.h"

#include <gsl/gsl_math.h>

// A crack under tension, its plate's c(r) uncertain in `bins` bins.
static void make_noisy(plate *p, int bins, double variation, int refinement)
{
    const double tension[3] = {0.0, 1.0, 0.0};
    cracked_make(p, 5.0, 0.15, refinement);
    cracked_load(p, tension);
    plate_crack(p, 0.0, 0.0, 0.5, 0.0);
    p->uncertainties[0] = (pdmc_uncertainty){PDMC_QUANTITY_MICROMODULUS, .bins = bins, .variation = variation};
    p->problem.uncertainty_count = 1;
}

enum { COUNT = 4, DIRECTIONS = 16 };

// Energies of the first samples, [COUNT, DIRECTIONS].
static void sample(plate *p, const pdmc_affine *model, pdmc_inverse inverse, int order, double energy[])
{
    drawn_block drawn;
    p->problem.sampling.inverse = inverse;
    p->problem.sampling.order = order;
    pdmc_block *block = drawn_block_begin(&drawn, &p->problem, model, COUNT);
    CHECK_OK(pdmc_block_solve(block, COUNT));
    pdmc_block_energies(block, PDMC_BONDS_ALL);
    for (int s = 0; s < COUNT; s++) {
        assert_int_equal(block->failure[s], PDMC_SAMPLE_OK);
        for (int d = 0; d < DIRECTIONS; d++) energy[DIRECTIONS * s + d] = block->energy[d * PDMC_BLOCK + s];
    }
    drawn_block_end(&drawn);
}

static double largest_difference(const double energy[], const double exact[])
{
    double worst = 0.0;
    for (int i = 0; i < COUNT * DIRECTIONS; i++)
        if (exact[i] > 0.0) worst = fmax(worst, fabs(energy[i] / exact[i] - 1.0));
    return worst;
}

static void the_expansion_converges_to_direct_solutions(void **state)
{
    (void)state;
    plate p;
    pdmc_visible *visible = NULL;
    pdmc_affine model;
    double exact[COUNT * DIRECTIONS], energy[COUNT * DIRECTIONS], error[3];
    make_noisy(&p, 100, 0.2, 4);
    CHECK_OK(pdmc_visible_create(&p.problem, NULL, 2, &visible));
    CHECK_OK(pdmc_visible_affine(visible, &model));
    sample(&p, &model, PDMC_INVERSE_DIRECT, 0, exact);
    for (int k = 0; k < 3; k++) {
        sample(&p, &model, PDMC_INVERSE_NEUMANN, 2 * k, energy);
        error[k] = largest_difference(energy, exact);
    }
    printf("  expansion of orders 0, 2, 4 against direct solutions: %.1e %.1e %.1e\n", error[0], error[1], error[2]);
    assert_true(error[0] > 1e-3);
    assert_true(error[1] < 1e-2 * error[0]);
    assert_true(error[2] < 5e-6);
    pdmc_affine_clear(&model);
    pdmc_visible_destroy(&visible);
}

// One bin: c is constant in r, and a plate under traction moves as 1 / c.
static void a_uniform_deviation_scales_displacements(void **state)
{
    (void)state;
    const double eta = 0.3, load[2] = {0.0, 1.0};
    plate p;
    pdmc_visible *visible = NULL;
    pdmc_affine model;
    double xi[32], x[256];
    make_noisy(&p, 1, 0.2, 3);
    p.problem.sampling.inverse = PDMC_INVERSE_DIRECT;
    CHECK_OK(pdmc_visible_create(&p.problem, NULL, 1, &visible));
    CHECK_OK(pdmc_visible_affine(visible, &model));
    assert_true(model.terms <= 32 && model.unknowns <= 256);
    for (int m = 0; m < model.terms; m++) xi[m] = eta * model.term_weight[m];
    CHECK_NEAR(model.modulus_weight[0], 1.0, 1e-12);
    CHECK_OK(model.verbs->solve(&model, xi, load, x));
    const double *mean = pdmc_affine_solution(&model, 1);
    for (int k = 0; k < model.unknowns; k++) CHECK_NEAR(x[k], mean[k] / (1.0 + eta), 1e-9 * fabs(mean[0]));
    pdmc_affine_clear(&model);
    pdmc_visible_destroy(&visible);
}

// E_eff = (pi / 3) int c r^2 dr: a bin has its share of r^3.
static void bins_share_the_modulus(void **state)
{
    (void)state;
    enum { BINS = 7 };
    plate p;
    pdmc_visible *visible = NULL;
    pdmc_affine model;
    make_noisy(&p, BINS, 0.2, 3);
    CHECK_OK(pdmc_visible_create(&p.problem, NULL, 1, &visible));
    CHECK_OK(pdmc_visible_affine(visible, &model));
    for (int b = 0; b < BINS; b++)
        CHECK_NEAR(model.modulus_weight[b], (pow(b + 1, 3) - pow(b, 3)) / pow(BINS, 3), 1e-13);
    pdmc_affine_clear(&model);
    pdmc_visible_destroy(&visible);
}

static double energy_by_definition(const pdmc_visible *visible, const pdmc_problem *problem, const double x_t[2],
                                   double phi)
{
    static pdmc_crossing_bond bonds[PDMC_CROSSING_BONDS];
    pdmc_ring_rule rings;
    int count;
    double sum = 0.0;
    CHECK_OK(pdmc_ring_rule_create(PDMC_CROSSING_RINGS, 1, 3, problem->energy.horizon, &rings));
    CHECK_OK(pdmc_crossing_bonds(problem, x_t, phi, &rings, &count, bonds));
    for (int b = 0; b < count; b++) {
        double u[2], v[2];
        CHECK_OK(pdmc_visible_displacement(visible, bonds[b].start, bonds[b].start, u));
        CHECK_OK(pdmc_visible_displacement(visible, bonds[b].end, bonds[b].end, v));
        const double s = bonds[b].direction[0] * (v[0] - u[0]) + bonds[b].direction[1] * (v[1] - u[1]);
        sum += rings.mean[bonds[b].ring] * bonds[b].weight * s * s;
    }
    pdmc_ring_rule_clear(&rings);
    return 0.5 * pdmc_micromodulus(&problem->material, problem->energy.horizon) * sum;
}

// Without uncertainty the model's only coordinate is the mean solution.
static void the_mean_has_the_energy_of_the_definition(void **state)
{
    (void)state;
    plate p;
    pdmc_visible *visible = NULL;
    pdmc_affine model;
    pdmc_tip tip;
    double energy[COUNT * DIRECTIONS];
    make_noisy(&p, 1, 0.2, 4);
    p.problem.uncertainty_count = 0;
    CHECK_OK(pdmc_visible_create(&p.problem, NULL, 1, &visible));
    CHECK_OK(pdmc_visible_affine(visible, &model));
    assert_int_equal(model.unknowns, 1);
    sample(&p, &model, PDMC_INVERSE_NEUMANN, 0, energy);
    for (int a = 0; a < 3; a++) {
        const double phi = 0.25 * M_PI * a, d = p.problem.energy.extension;
        const double x_t[2] = {0.5 + d * cos(phi), d * sin(phi)};
        CHECK_NEAR(energy[8 + a] / energy_by_definition(visible, &p.problem, x_t, phi), 1.0, 1e-9);
    }
    assert_true(energy[8 + 4] == 0.0); // back along the crack every bond is cut
    for (int t = 0; t < 2; t++) {
        CHECK_OK(pdmc_visible_tip(visible, t, &tip));
        CHECK_NEAR(model.stress_intensity[2 * t] * pdmc_affine_solution(&model, 1)[0], tip.stress_intensity[0], 1e-10);
    }
    pdmc_affine_clear(&model);
    pdmc_visible_destroy(&visible);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_expansion_converges_to_direct_solutions),
        cmocka_unit_test(a_uniform_deviation_scales_displacements),
        cmocka_unit_test(bins_share_the_modulus),
        cmocka_unit_test(the_mean_has_the_energy_of_the_definition),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
