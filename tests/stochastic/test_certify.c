// SPDX-License-Identifier: GPL-3.0-or-later

/// What bounds of solutions do to energies, in closed form and by the worst errors that they allow.

#include "stochastic/certify.h"

#include "check.h"
#include "pdmc/fracture.h"

#include <gsl/gsl_math.h>
#include <math.h>

enum { ANGLES = 72, RINGS = 2, BINS = 2 };

// One sample of one tip.
typedef struct {
    pdmc_problem problem;
    pdmc_affine model;
    pdmc_variables variables;
    pdmc_results results;
    pdmc_draw draw;
    pdmc_block block;
    pdmc_tip tip;
    double angle[ANGLES], ring[RINGS], ring_weight[BINS * RINGS], tip_modulus[1], direction[ANGLES], intensity[2];
    double largest[4], toughness[4]; // of two samples of two tips
} fixture;

static void fixture_make(fixture *f)
{
    *f = (fixture){.problem = {.material = {4.0, PDMC_PLANE_STRESS, 1.0}},
                   .ring = {0.6, 1.2},
                   .ring_weight = {0.25, 0.5, 0.25, 0.5},
                   .tip_modulus = {2.25},
                   .intensity = {0.03, 0.04},
                   .tip = {.direction = 0.3}};
    f->model = (pdmc_affine){.crossing_bound = 2.0,
                             .tips = 1,
                             .angles = ANGLES,
                             .rings = RINGS,
                             .bins = BINS,
                             .ring_weight = f->ring_weight};
    f->variables = (pdmc_variables){.problem = &f->problem, .model = &f->model};
    f->results = (pdmc_results){.tip_count = 1, .angle_count = ANGLES, .angles = f->angle, .tips = &f->tip};
    f->draw = (pdmc_draw){.effective_modulus = 1.44,
                          .ring_weight = f->ring,
                          .tip_modulus = f->tip_modulus,
                          .direction_modulus = f->direction};
    f->block = (pdmc_block){.problem = &f->problem, .variables = &f->variables};
    f->block.drawn.draw[0] = f->draw;
    f->block.bound.error[0] = 0.05;
    f->block.bound.coercivity[0] = 0.64;
    f->block.bound.intensity = f->intensity;
    for (int a = 0; a < ANGLES; a++) f->angle[a] = 2.0 * M_PI * a / ANGLES;
    for (int a = 0; a < ANGLES; a++) f->direction[a] = a == 5 ? 1.69 : 1.0;
}

static double root_of(const fixture *f, pdmc_measure measure)
{
    double delta;
    pdmc_certify_root_energies(&f->block, 1, &f->results, measure, &delta);
    return delta;
}

static double bond_root(const fixture *f)
{
    return root_of(f, PDMC_MEASURE_BOND);
}

// The sample's stiffness is E_eff times that of the bound's norm; with a field the norm is that of the mean, over which a
// sample's bonds have at most 1.69 in space and 1.2 of their mean 1 over the radius, and the bound is divided by alpha.
static void bonds_have_the_norm_of_the_bound(void **state)
{
    (void)state;
    fixture f;
    fixture_make(&f);
    CHECK_NEAR(bond_root(&f), 2.0 * 0.05 * 1.2, 1e-15);
    f.model.field = (const pdmc_field *)&f;
    CHECK_NEAR(bond_root(&f), 2.0 * 0.05 * 1.3 * sqrt(1.2) / 0.8, 1e-15);
    f.model.crossing_bound = 0.0;
    assert_true(isinf(bond_root(&f)));
    f.model.crossing_bound = 2.0;
    f.block.bound.error[0] = INFINITY;
    assert_true(isinf(bond_root(&f)));
    f.block.failure[0] = PDMC_SAMPLE_SINGULAR;
    CHECK_NEAR(bond_root(&f), 0.0, 0.0);
}

// sqrt of the largest difference of G that an error of K of a given size and direction makes in any direction of growth.
static double worst_change(const fixture *f, const double error[2])
{
    const double modulus = f->tip_modulus[0] * pdmc_plane_modulus(&f->problem.material), at[2] = {5.0, 0.0};
    double worst = 0.0;
    for (int a = 0; a < ANGLES; a++) {
        double before[2], after[2], K[2];
        for (int k = 0; k < 2; k++) K[k] = f->tip_modulus[0] * (at[k] + error[k]);
        pdmc_kinked_stress_intensity(f->angle[a] - f->tip.direction, K, after);
        for (int k = 0; k < 2; k++) K[k] = f->tip_modulus[0] * at[k];
        pdmc_kinked_stress_intensity(f->angle[a] - f->tip.direction, K, before);
        if (before[0] < 0.0 || after[0] < 0.0) continue;
        worst = fmax(worst, fabs(hypot(after[0], after[1]) - hypot(before[0], before[1])) / sqrt(modulus));
    }
    return worst;
}

// No error within the bounds changes a root by more, and one of that size in some direction changes it by nearly as much.
static void intensities_have_the_norm_of_a_kink(void **state)
{
    (void)state;
    fixture f;
    fixture_make(&f);
    const double delta = root_of(&f, PDMC_MEASURE_GRIFFITH);
    double worst = 0.0;
    for (int i = 0; i < 360; i++) {
        const double error[2] = {0.05 * cos(i * M_PI / 180.0), 0.05 * sin(i * M_PI / 180.0)};
        worst = fmax(worst, worst_change(&f, error));
    }
    print_message("the worst error changes a root by %.3f of the bound\n", worst / delta);
    assert_true(worst <= delta);
    assert_true(worst > 0.8 * delta);
}

// G = 4 is within (2 +- delta)^2, and 2 delta sqrt(G) + delta^2 the farther of the two.
static void a_root_decides(void **state)
{
    (void)state;
    fixture f;
    fixture_make(&f);
    f.results.largest_energy[PDMC_MEASURE_BOND] = f.largest;
    f.results.sample_fracture_energy = f.toughness;
    f.results.measure = PDMC_MEASURE_BOND;
    f.largest[0] = 4.0;
    CHECK_NEAR(pdmc_certify_relative(&f.results, PDMC_MEASURE_BOND, 0, 0.1), (2.1 * 2.1 - 4.0) / 4.0, 1e-15);
    const double toughness[4] = {1.89 * 1.89, 1.91 * 1.91, 2.09 * 2.09, 2.11 * 2.11};
    for (int k = 0; k < 4; k++) {
        f.toughness[0] = toughness[k];
        assert_int_equal(pdmc_certify_is_in_doubt(&f.results, 0, 0.1), k == 1 || k == 2);
    }
    f.results.tip_count = 2; // a tip of the second sample, which has its own G_c, may be in doubt as well
    for (int k = 0; k < 4; k++) {
        for (int i = 0; i < 4; i++) f.largest[i] = 4.0 + i;
        for (int i = 0; i < 4; i++) f.toughness[i] = 4.0 + i;
        f.toughness[2] = 1.0;
        f.toughness[3] = toughness[k] * 7.0 / 4.0; // roots that differ by 0.11 or 0.09, times sqrt(7 / 4)
        assert_true(pdmc_certify_is_in_doubt(&f.results, 0, 0.1));
        assert_int_equal(pdmc_certify_is_in_doubt(&f.results, 1, 0.1 * sqrt(7.0 / 4.0)), k == 1 || k == 2);
    }
}

// A root that is off by what the goal allows makes the nominal energy's relative error 0.75 of what is asked for, up to its
// square: by bonds 2 crossing_bound error / sqrt(G), and the intensities as they are certified.
static void the_goal_is_what_is_asked_for(void **state)
{
    (void)state;
    fixture f;
    double nominal[ANGLES] = {0.0}, intensity[1];
    pdmc_reduced_goal goal;
    fixture_make(&f);
    nominal[7] = 4.0;
    f.tip_modulus[0] = 1.0;
    f.problem.sampling.energy_tolerance = 1e-3;
    f.results.nominal_bond_energy = f.results.nominal_griffith_energy = nominal;
    pdmc_certify_goal(&f.variables, &f.results, intensity, &goal);
    assert_null(goal.intensity);
    f.block.drawn.draw[0].effective_modulus = 1.0;
    f.block.bound.error[0] = goal.error;
    CHECK_NEAR(2.0 * bond_root(&f) / 2.0, 0.75e-3, 1e-15);
    f.problem.energy.measure = PDMC_MEASURE_GRIFFITH;
    pdmc_certify_goal(&f.variables, &f.results, intensity, &goal);
    f.intensity[0] = 0.6 * goal.intensity[0];
    f.intensity[1] = 0.8 * goal.intensity[0];
    CHECK_NEAR(root_of(&f, PDMC_MEASURE_GRIFFITH), 0.75e-3, 1e-15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bonds_have_the_norm_of_the_bound),
        cmocka_unit_test(intensities_have_the_norm_of_a_kink),
        cmocka_unit_test(a_root_decides),
        cmocka_unit_test(the_goal_is_what_is_asked_for),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
