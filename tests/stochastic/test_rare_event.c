// SPDX-License-Identifier: GPL-3.0-or-later

/// Growth as a limit state of the toy, and what the methods of reliability say of it.

#include "stochastic/growth.h"
#include "stochastic/two_tips.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

static const double load_deviation = 0.1, toughness_deviation = 0.15; // of the logarithms
static const double median_toughness = 4.0;
static const double probability = 1e-4;

/// G = S^2 G_0 with lognormal S and G_c: log G / G_c is normal. In direction 3 the toy's bonds give G_0 = 9 ring_weight.
typedef struct {
    toy base;
    pdmc_uncertainty quantities[2];
} lognormal_toy;

static void lognormal_toy_make(lognormal_toy *t, pdmc_rare_method method)
{
    const double deviation = hypot(2.0 * load_deviation, toughness_deviation);
    toy_make(&t->base, 0.0, 0.0);
    t->quantities[0] = toy_scalar(PDMC_QUANTITY_LOAD, PDMC_LOGNORMAL, 0.0, load_deviation);
    t->quantities[1] =
        toy_scalar(PDMC_QUANTITY_FRACTURE_ENERGY, PDMC_LOGNORMAL, log(median_toughness), toughness_deviation);
    t->base.ring_weight = median_toughness / 9.0 * exp(-gsl_cdf_ugaussian_Qinv(probability) * deviation);
    t->base.problem.uncertainties = t->quantities;
    t->base.problem.sampling.samples = 100;
    t->base.problem.reliability = (pdmc_reliability_request){method, 0.05, 1000000, 0};
}

// Within four of its own coefficients of variation.
static void check_record(const pdmc_reliability_record *record, const char *name)
{
    assert_string_equal(record->name, name);
    assert_true(record->complete && record->failed == 0.0);
    assert_true(record->found.variation <= 0.05);
    CHECK_NEAR(record->found.probability.value, probability, 4.0 * record->found.variation * probability);
    assert_true(record->found.probability.lower < record->found.probability.value);
    assert_true(record->found.probability.upper < 1.3 * probability);
    CHECK_NEAR(record->found.index.value, gsl_cdf_ugaussian_Qinv(record->found.probability.value), 1e-12);
}

static void both_methods_find_the_closed_form(void **state)
{
    (void)state;
    lognormal_toy t;
    pdmc_results r;
    lognormal_toy_make(&t, PDMC_RARE_BOTH);
    t.base.problem.reliability.sensitivity = 2000;
    CHECK_OK(toy_run(&t.base, &one_thread, &r));
    assert_int_equal(r.reliability.record_count, 2);
    check_record(&r.reliability.records[0], "importance sampling");
    check_record(&r.reliability.records[1], "subset simulation");
    const double beta = gsl_cdf_ugaussian_Qinv(probability), shares[2] = {0.64, 0.36}; // 4 0.1^2 and 0.15^2
    CHECK_NEAR(r.reliability.first_order_index, beta, 1e-4);
    CHECK_NEAR(r.reliability.design_point[0], 0.8 * beta, 1e-3);
    CHECK_NEAR(r.reliability.design_point[1], -0.6 * beta, 1e-3);
    assert_int_equal(r.reliability.group_count, 2);
    assert_string_equal(r.reliability.groups[0].name, "load");
    assert_string_equal(r.reliability.groups[1].name, "fracture_energy");
    for (int g = 0; g < 2; g++) {
        const pdmc_reliability_group *group = &r.reliability.groups[g];
        assert_int_equal(group->variables, 1);
        CHECK_NEAR(group->importance, shares[g], 1e-3);
        // two intervals' widths: 95 % of four is missed too often
        CHECK_NEAR(group->first.value, shares[g], group->first.upper - group->first.lower);
        CHECK_NEAR(group->total.value, shares[g], group->total.upper - group->total.lower);
        assert_true(group->first.upper - group->first.lower < 0.2);
    }
    assert_true(r.status == PDMC_RUN_COMPLETE && r.runtime.reliability > 0.0);
    pdmc_results_clear(&r);
}

static const double strength = 2.0; // K_I at growth

// P(S / min c > strength): given the load, 1 - (1 - Phi((S / strength - 1) / v))^2, summed over the load by the trapezoidal
// rule, which is exact to rounding for such functions.
static double probability_of_either(void)
{
    const double h = 1e-3;
    double sum = 0.0;
    for (int k = -9000; k <= 9000; k++) {
        const double z = k * h, one = gsl_cdf_ugaussian_P((exp(scatter * z) / strength - 1.0) / scatter);
        sum += h * gsl_ran_ugaussian_pdf(z) * one * (2.0 - one);
    }
    return sum;
}

// Growth of any tip has no gradient where both are as near to it: either has its design point, and both are sampled at.
static void each_tip_has_its_design_point(void **state)
{
    (void)state;
    two_tips t;
    pdmc_results r;
    two_tips_make(&t);
    t.base.problem.material.fracture_energy = strength * strength;
    t.base.problem.reliability = (pdmc_reliability_request){PDMC_RARE_BOTH, 0.06, 1000000, 0};
    CHECK_OK(toy_run(&t.base, &one_thread, &r));
    const double exact = probability_of_either();
    assert_int_equal(r.reliability.record_count, 2);
    for (int m = 0; m < 2; m++) {
        const pdmc_reliability_record *record = &r.reliability.records[m];
        print_message("%s: %.3e [%.3e, %.3e], exact %.3e, %.0f points\n", record->name, record->found.probability.value,
                      record->found.probability.lower, record->found.probability.upper, exact, record->evaluations);
        assert_true(record->complete);
        CHECK_NEAR(record->found.probability.value, exact, 4.0 * record->found.variation * exact);
    }
    assert_true(isfinite(r.reliability.first_order_index));
    assert_true(r.reliability.records[0].evaluations <
                10000.0); // half of the event from the origin alone takes a million
    pdmc_results_clear(&r);
}

static void nothing_is_computed_that_was_not_asked_for(void **state)
{
    (void)state;
    lognormal_toy t;
    pdmc_results r;
    lognormal_toy_make(&t, PDMC_RARE_NONE);
    CHECK_OK(toy_run(&t.base, &one_thread, &r));
    assert_int_equal(r.reliability.record_count + r.reliability.group_count, 0);
    assert_true(isnan(r.reliability.first_order_index));
    pdmc_results_clear(&r);
    lognormal_toy_make(&t, PDMC_RARE_SUBSET);
    CHECK_OK(toy_run(&t.base, &one_thread, &r));
    assert_int_equal(r.reliability.record_count, 1);
    assert_true(isnan(r.reliability.first_order_index) && isnan(r.reliability.groups[0].importance));
    pdmc_results_clear(&r);
}

// The least that a study may allow: importance sampling keeps to it, subset simulation takes one small batch.
static void few_evaluations_are_not_exceeded_by_far(void **state)
{
    (void)state;
    lognormal_toy t;
    pdmc_results r;
    lognormal_toy_make(&t, PDMC_RARE_BOTH);
    t.base.problem.reliability.evaluations = 1000;
    t.base.problem.reliability.variation = 0.01;
    CHECK_OK(toy_run(&t.base, &one_thread, &r));
    assert_true(r.reliability.records[0].evaluations <= 1000.0);
    assert_true(r.reliability.records[1].evaluations <= 10000.0);
    for (int m = 0; m < 2; m++) {
        const pdmc_reliability_record *record = &r.reliability.records[m];
        assert_false(record->complete);
        CHECK_NEAR(record->found.probability.value, probability, 4.0 * record->found.variation * probability);
    }
    pdmc_results_clear(&r);
}

static void threads_change_no_bit(void **state)
{
    (void)state;
    lognormal_toy t;
    pdmc_results r[2];
    lognormal_toy_make(&t, PDMC_RARE_BOTH);
    t.base.problem.reliability.variation = 0.2;
    for (int k = 0; k < 2; k++) CHECK_OK(toy_run(&t.base, &(pdmc_run_options){.threads = 1 + 2 * k}, &r[k]));
    for (int m = 0; m < 2; m++)
        assert_memory_equal(&r[0].reliability.records[m].found.probability,
                            &r[1].reliability.records[m].found.probability, sizeof(pdmc_estimate));
    for (int k = 0; k < 2; k++) pdmc_results_clear(&r[k]);
}

typedef struct {
    int calls, allowed;
} patience;

static bool lose_patience(void *context, int done, int total)
{
    patience *p = context;
    return done < total || p->calls++ < p->allowed;
}

// What was finished stays; what was not is left out, and the results say so.
static void a_stop_keeps_what_is_done(void **state)
{
    (void)state;
    lognormal_toy t;
    pdmc_results whole;
    lognormal_toy_make(&t, PDMC_RARE_BOTH);
    CHECK_OK(toy_run(&t.base, &one_thread, &whole));
    for (int allowed = 1; allowed <= 20; allowed += 19) { // the samples; and all of importance sampling
        pdmc_results r;
        patience p = {0, allowed};
        CHECK_OK(toy_run(&t.base, &(pdmc_run_options){.threads = 1, .progress = lose_patience, .context = &p}, &r));
        assert_int_equal(r.status, PDMC_RUN_INTERRUPTED);
        assert_int_equal(r.sample_count, 100);
        assert_int_equal(r.reliability.record_count, allowed > 1);
        if (allowed > 1)
            assert_memory_equal(&r.reliability.records[0].found.probability,
                                &whole.reliability.records[0].found.probability, sizeof(pdmc_estimate));
        pdmc_results_clear(&r);
    }
    pdmc_results_clear(&whole);
}

// g at points of one's own: log of 9 ring_weight c x^2 / G_c with x = S / c, NaN where the toy cannot be solved.
static void growth_is_the_log_of_the_largest_energy_over_the_toughness(void **state)
{
    (void)state;
    enum { COUNT = 130, VARIABLES = 3 }; // more than two blocks
    toy t;
    pdmc_variables variables;
    pdmc_growth growth;
    pdmc_results r = {.sample_count = 1, .tip_count = 1, .angle_count = ANGLES};
    const pdmc_run_options options = {.threads = 2};
    double z[COUNT * VARIABLES], g[COUNT];
    int unsolved = 0;
    toy_make(&t, 0.5, 0.0);
    pdmc_uncertainty quantities[] = {toy_scalar(PDMC_QUANTITY_LOAD, PDMC_LOGNORMAL, 0.0, 0.2),
                                     toy_scalar(PDMC_QUANTITY_FRACTURE_ENERGY, PDMC_NORMAL, 1.0, 0.5),
                                     t.uncertainties[0]};
    t.problem.uncertainties = quantities;
    t.problem.uncertainty_count = VARIABLES;
    t.problem.sampling.inverse = PDMC_INVERSE_DIRECT;
    CHECK_OK(pdmc_variables_create(&t.problem, &t.model, &variables));
    CHECK_OK(pdmc_growth_create(&variables, &t.model, &t.model, &options, &r, &growth));
    const pdmc_limit_state limit = pdmc_growth_limit(&growth);
    assert_int_equal(limit.dimension, VARIABLES);
    for (int k = 0; k < COUNT; k++) {
        z[3 * k] = 2.0 * sin(k);                     // of the load
        z[3 * k + 1] = -2.5 + 4.0 * (k % 10) / 10.0; // of the toughness, some below -2
        z[3 * k + 2] = -2.3 + 4.0 * (k / 10) / 13.0; // of c, some within 0.05 of 0
    }
    CHECK_OK(limit.evaluate(limit.context, COUNT, z, g));
    for (int k = 0; k < COUNT; k++) {
        const double load = exp(0.2 * z[3 * k]), toughness = 1.0 + 0.5 * z[3 * k + 1], c = 1.0 + 0.5 * z[3 * k + 2];
        const double energy = fmax(0.0, 9.0 * t.ring_weight * c * pow(load / c, 2));
        unsolved += fabs(c) < 0.05;
        if (fabs(c) < 0.05) assert_true(isnan(g[k]));
        else if (toughness <= 0.0) assert_true(g[k] == 50.0);
        else if (energy == 0.0) assert_true(g[k] == -50.0);
        else CHECK_NEAR(g[k], log(energy / toughness), 1e-13 * fmax(1.0, fabs(log(energy / toughness))));
    }
    assert_true(unsolved > 0);
    pdmc_growth_clear(&growth);
    pdmc_variables_clear(&variables);
}

// P = P(S^2 / c > 4 and solved), c normal: 2.2 % of the points have no answer, and may be in the event or not.
static void points_without_an_answer_are_counted(void **state)
{
    (void)state;
    toy t;
    pdmc_results r;
    toy_make(&t, 0.3, 0.1);
    t.ring_weight = 1.0 / 36.0;
    t.problem.sampling.inverse = PDMC_INVERSE_DIRECT;
    t.problem.sampling.samples = 100;
    t.problem.reliability = (pdmc_reliability_request){PDMC_RARE_SUBSET, 0.1, 1000000, 0};
    CHECK_OK(toy_run(&t, &one_thread, &r));
    const pdmc_reliability_record *subset = &r.reliability.records[0];
    // half a bin of c about 0 is unsolved: Phi(-(1 - 0.05) / 0.3) - Phi(-(1 + 0.05) / 0.3)
    const double unsolved = gsl_cdf_ugaussian_P(-0.95 / 0.3) - gsl_cdf_ugaussian_P(-1.05 / 0.3);
    assert_true(subset->failed > 0.0);
    assert_true(subset->found.probability.upper > subset->found.probability.value + unsolved);
    pdmc_results_clear(&r);
}

static pdmc_status run_and_clear(lognormal_toy *t)
{
    pdmc_results r;
    const pdmc_status status = toy_run(&t->base, &one_thread, &r);
    pdmc_results_clear(&r);
    return status;
}

static void memory_that_is_missing_is_reported(void **state)
{
    (void)state;
    lognormal_toy t;
    lognormal_toy_make(&t, PDMC_RARE_IMPORTANCE);
    t.base.problem.sampling.samples = 3;
    t.base.problem.reliability.evaluations = 1000;
    t.base.problem.reliability.sensitivity = 2;
    CHECK_FAILS_CLEANLY(run_and_clear(&t), (void)0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_methods_find_the_closed_form),
        cmocka_unit_test(each_tip_has_its_design_point),
        cmocka_unit_test(nothing_is_computed_that_was_not_asked_for),
        cmocka_unit_test(few_evaluations_are_not_exceeded_by_far),
        cmocka_unit_test(threads_change_no_bit),
        cmocka_unit_test(a_stop_keeps_what_is_done),
        cmocka_unit_test(growth_is_the_log_of_the_largest_energy_over_the_toughness),
        cmocka_unit_test(points_without_an_answer_are_counted),
        cmocka_unit_test(memory_that_is_missing_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
