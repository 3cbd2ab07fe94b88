// SPDX-License-Identifier: GPL-3.0-or-later

/// What follows from the random quantities of a sample: the modulus that is divided out, loads, energies.

#include "pdmc/fracture.h"
#include "stochastic/draw.h"
#include "stochastic/toy.h"

enum { BINS = 3, TERMS = 2 };

/// An operator of one unknown that is a sum over bins, K(c) = sum_b c_b k_b with k_b = sum_m term_weight[b][m] K_m and
/// sum_b k_b = 1 at the mean.
static const double term_weight[BINS * TERMS] = {0.1, 0.2, 0.3, -0.1, 0.2, 0.1};
static const double term[TERMS] = {1.5, 0.5};
static const double modulus_weight[BINS] = {0.05, 0.25, 0.70};

static double share_of_bin(int b)
{
    double k = 0.0;
    for (int m = 0; m < TERMS; m++) k += term_weight[b * TERMS + m] * term[m];
    return k;
}

typedef struct {
    pdmc_problem problem;
    pdmc_affine model;
    double weights[BINS * TERMS], modulus[BINS], rings[BINS];
    double micromodulus[BINS], xi[TERMS + 1], ring_weight[1], tip_modulus[1], direction_modulus[1], toughness[1];
    double tip_stiffness, direction_stiffness;
    pdmc_draw draw;
} sample;

static void sample_make(sample *s)
{
    *s = (sample){.problem = {.plate = {1.0, 1.0, 2.0}, .material = {3.0, PDMC_PLANE_STRESS, 1.0}}};
    for (int k = 0; k < BINS * TERMS; k++) s->weights[k] = term_weight[k];
    for (int b = 0; b < BINS; b++) s->modulus[b] = modulus_weight[b], s->rings[b] = 0.1 * (b + 1);
    s->model = (pdmc_affine){.terms = TERMS,
                             .radial_terms = TERMS,
                             .bins = BINS,
                             .rings = 1,
                             .tips = 1,
                             .angles = 1,
                             .term_weight = s->weights,
                             .modulus_weight = s->modulus,
                             .ring_weight = s->rings};
    s->draw = (pdmc_draw){.micromodulus = s->micromodulus,
                          .xi = s->xi,
                          .ring_weight = s->ring_weight,
                          .tip_modulus = s->tip_modulus,
                          .direction_modulus = s->direction_modulus,
                          .fracture_energy = s->toughness};
    pdmc_draw_mean(&s->problem, &s->model, &s->draw);
    assert_true(s->toughness[0] == 1.0);
}

static double *value_of(sample *s, pdmc_quantity quantity)
{
    return &s->draw.value[quantity - PDMC_FIRST_SCALAR];
}

static double scaled_answer(const sample *s)
{
    double stiffness = 1.0;
    for (int m = 0; m < TERMS; m++) stiffness += s->xi[m] * term[m];
    return s->draw.load_share / stiffness;
}

// K(c) x = F by terms from which the modulus has been taken out is K(c) x = F.
static void the_modulus_is_divided_out(void **state)
{
    (void)state;
    static const double bins[][BINS] = {{1.2, 0.7, 1.1}, {2.0, 2.0, 2.0}, {0.1, 0.1, 3.0}, {1.0, 1.0, 1.0}};
    for (size_t k = 0; k < sizeof bins / sizeof *bins; k++) {
        sample s;
        double stiffness = 0.0, modulus = 0.0, ring = 0.0;
        sample_make(&s);
        for (int b = 0; b < BINS; b++) {
            s.micromodulus[b] = bins[k][b];
            stiffness += bins[k][b] * share_of_bin(b);
            modulus += bins[k][b] * modulus_weight[b];
            ring += bins[k][b] * s.rings[b];
        }
        *value_of(&s, PDMC_QUANTITY_LOAD) = 1.3;
        pdmc_draw_complete(&s.problem, &s.model, &s.draw);
        CHECK_NEAR(scaled_answer(&s), 1.3 / stiffness, 1e-14);
        CHECK_NEAR(s.draw.effective_modulus, modulus, 1e-14);
        CHECK_NEAR(s.ring_weight[0], ring, 1e-14);
        // a c(r) that is larger by the same factor everywhere leaves nothing in the terms
        if (bins[k][0] == bins[k][BINS - 1]) CHECK_NEAR(fabs(s.xi[0]) + fabs(s.xi[1]), 0.0, 1e-15);
    }
}

// Forces on the sides stay when the plate is thicker, so that stresses are smaller; a modulus leaves stresses as they are.
static void thickness_and_modulus_act_on_the_load(void **state)
{
    (void)state;
    sample s;
    sample_make(&s);
    *value_of(&s, PDMC_QUANTITY_LOAD) = 1.3;
    *value_of(&s, PDMC_QUANTITY_THICKNESS) = 2.5; // of 2
    *value_of(&s, PDMC_QUANTITY_YOUNGS_MODULUS) = 4.5;
    for (int b = 0; b < BINS; b++) s.micromodulus[b] = 0.5;
    pdmc_draw_complete(&s.problem, &s.model, &s.draw);
    CHECK_NEAR(s.draw.load_factor, 1.3 / 1.25, 1e-15);
    CHECK_NEAR(s.draw.effective_modulus, 0.5 * 1.5, 1e-15);
    CHECK_NEAR(scaled_answer(&s), 1.3 / 1.25 / (0.5 * 1.5), 1e-14);
    CHECK_NEAR(s.tip_modulus[0], 0.5 * 1.5, 1e-15);
    CHECK_NEAR(s.direction_modulus[0], 1.5, 1e-15); // the bonds have their c(r) besides
}

static void a_stiffness_in_space_acts_where_it_is(void **state)
{
    (void)state;
    sample s;
    static char any_field;
    sample_make(&s);
    s.model.terms = TERMS + 1;
    s.model.field = (const pdmc_field *)(const void *)&any_field; // that there is one, no more
    s.model.tip_stiffness = &s.tip_stiffness;
    s.model.direction_stiffness = &s.direction_stiffness;
    s.tip_stiffness = 0.8, s.direction_stiffness = -0.4;
    s.xi[TERMS] = 0.5;
    *value_of(&s, PDMC_QUANTITY_YOUNGS_MODULUS) = 6.0;
    pdmc_draw_complete(&s.problem, &s.model, &s.draw);
    CHECK_NEAR(s.tip_modulus[0], 2.0 * (1.0 + 0.5 * 0.8), 1e-15);
    CHECK_NEAR(s.direction_modulus[0], 2.0 * (1.0 - 0.5 * 0.4), 1e-15);
    CHECK_NEAR(s.xi[TERMS], 0.5, 0.0);
    pdmc_draw_mean(&s.problem, &s.model, &s.draw);
    CHECK_NEAR(s.tip_modulus[0], 1.0, 0.0);
}

// Without a positive modulus there is no answer, and no division by it.
static void a_modulus_that_is_not_positive_is_left_alone(void **state)
{
    (void)state;
    sample s;
    sample_make(&s);
    for (int b = 0; b < BINS; b++) s.micromodulus[b] = b == BINS - 1 ? -1.0 : 1.0;
    pdmc_draw_complete(&s.problem, &s.model, &s.draw);
    CHECK_NEAR(s.draw.effective_modulus, -0.4, 1e-15);
    assert_true(isfinite(s.xi[0]) && isfinite(s.draw.load_share));
}

// K = S / t whatever E and c(r) are, and G = K^2 / E_eff.
static void energies_take_every_scalar_of_the_sample(void **state)
{
    (void)state;
    enum { QUANTITIES = 4, SAMPLES = 70 };
    toy t;
    pdmc_results r;
    toy_make(&t, 0.2, 0.1);
    pdmc_uncertainty quantities[QUANTITIES] = {t.uncertainties[0], t.uncertainties[1],
                                               toy_scalar(PDMC_QUANTITY_YOUNGS_MODULUS, PDMC_LOGNORMAL, 0.3, 0.2),
                                               toy_scalar(PDMC_QUANTITY_THICKNESS, PDMC_UNIFORM, 0.0, 0.0)};
    quantities[3].law.lower = 0.5, quantities[3].law.upper = 1.5;
    t.modulus = 1.0; // all of c(r) is modulus
    t.problem.uncertainties = quantities;
    t.problem.uncertainty_count = QUANTITIES;
    t.problem.sampling.samples = SAMPLES;
    t.problem.sampling.inverse = PDMC_INVERSE_DIRECT;
    CHECK_OK(toy_run(&t, &one_thread, &r));
    for (int s = 0; s < SAMPLES; s++) {
        const double load = r.load_factor[s], modulus = r.effective_modulus[s], x = load / modulus;
        assert_true(load > 0.3 && load < 3.0 && modulus != r.micromodulus[s]);
        CHECK_NEAR(r.stress_intensity[2 * s], load, 1e-14);
        CHECK_NEAR(r.energy[PDMC_MEASURE_GRIFFITH][s * ANGLES], load * load / modulus, 1e-13);
        // the toy's bonds: c_0 / 2 = 1, a quarter of their stiffness is counted
        CHECK_NEAR(r.energy[PDMC_MEASURE_BOND][s * ANGLES + 1], 0.25 * modulus * x * x, 1e-13);
    }
    pdmc_results_clear(&r);
}

// A plate of no thickness has no answer.
static void a_thickness_that_is_not_positive_is_marked(void **state)
{
    (void)state;
    toy t;
    pdmc_results r;
    toy_make(&t, 0.0, 0.0);
    t.uncertainties[1] = toy_scalar(PDMC_QUANTITY_THICKNESS, PDMC_NORMAL, 1.0, 1.0);
    t.problem.sampling.samples = 200;
    CHECK_OK(toy_run(&t, &one_thread, &r));
    for (int s = 0; s < r.sample_count; s++) { // the load factor is 1 / thickness
        assert_int_equal(r.failure[s], r.load_factor[s] > 0.0 ? PDMC_SAMPLE_OK : PDMC_SAMPLE_SOFT);
        assert_int_equal(isnan(r.stress_intensity[2 * s]), r.load_factor[s] < 0.0);
    }
    assert_true(r.failed_count > 12 && r.failed_count < 52); // Phi(-1) 200 = 31.7, four deviations of 5.2 either way
    pdmc_results_clear(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_modulus_is_divided_out),
        cmocka_unit_test(thickness_and_modulus_act_on_the_load),
        cmocka_unit_test(a_stiffness_in_space_acts_where_it_is),
        cmocka_unit_test(a_modulus_that_is_not_positive_is_left_alone),
        cmocka_unit_test(a_thickness_that_is_not_positive_is_marked),
        cmocka_unit_test(energies_take_every_scalar_of_the_sample),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
