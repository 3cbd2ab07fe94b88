// SPDX-License-Identifier: GPL-3.0-or-later

/// The toy solved directly, with its own expansion of a low order as control.

#include "stochastic/controlled.h"
#include "stochastic/toy.h"

enum { OWN = 100, CHEAPER = 2000, LAST = ANGLES - 1 };

static const double variation = 0.1, threshold = 2.7; // of c(r) and of the load; G is 2.25 at the mean

static void make(toy *t, uint64_t seed)
{
    toy_make(t, variation, variation);
    t->problem.sampling.seed = seed;
    t->problem.sampling.inverse = PDMC_INVERSE_DIRECT;
    t->problem.sampling.samples = OWN;
    t->problem.material.fracture_energy = threshold;
    t->problem.energy.measure = PDMC_MEASURE_BOND;
}

/// Results of the toy with a control of that order; free both.
static pdmc_status run_pair(uint64_t seed, int order, pdmc_results *own, pdmc_results *cheaper)
{
    toy t, c;
    pdmc_sample_counts *counts = NULL;
    make(&t, seed);
    make(&c, seed);
    *cheaper = (pdmc_results){0};
    c.problem.sampling.inverse = PDMC_INVERSE_NEUMANN;
    c.problem.sampling.order = order;
    c.problem.sampling.samples = CHEAPER;
    c.problem.sampling.keep = OWN;
    pdmc_status status = toy_run(&t, &one_thread, own);
    if (status != PDMC_OK) return status;
    *cheaper = (pdmc_results){.confidence = 0.95,
                              .bin_count = 1,
                              .tip_count = 1,
                              .angle_count = ANGLES,
                              .measure = PDMC_MEASURE_BOND,
                              .histogram_bins = 10};
    cheaper->tips = pdmc_calloc(1, sizeof *cheaper->tips);
    cheaper->angles = pdmc_calloc(ANGLES, sizeof *cheaper->angles);
    status = cheaper->tips && cheaper->angles ? PDMC_OK : PDMC_ERR_NOMEM;
    if (status == PDMC_OK) status = pdmc_monte_carlo(&c.problem, &c.model, &one_thread, cheaper, &counts);
    if (status == PDMC_OK) status = pdmc_control_samples(cheaper, counts, own);
    pdmc_sample_counts_destroy(&counts);
    return status;
}

/// Of a million samples: 2000 times the effective ones of a repetition, so that its error is 2 % of theirs.
static void find_truth(double *mean, double *probability)
{
    toy t;
    pdmc_results r;
    make(&t, 99);
    t.problem.sampling.samples = 1000000;
    t.problem.sampling.keep = 1;
    CHECK_OK(toy_run(&t, &one_thread, &r));
    *mean = r.statistics[PDMC_MEASURE_BOND].mean[LAST].value;
    *probability = r.probability[0].value;
    pdmc_results_clear(&r);
}

static bool holds(pdmc_estimate interval, double truth)
{
    return interval.lower <= truth && truth <= interval.upper;
}

typedef struct {
    double mean, probability, gain, reported; // shares held; variance of the plain mean over that of this one
} outcome;

static outcome repeat(int order, double mean, double probability, int repetitions)
{
    outcome found = {0};
    double squares = 0.0, plain = 0.0;
    for (int r = 0; r < repetitions; r++) {
        pdmc_results own, cheaper;
        CHECK_OK(run_pair((uint64_t)r, order, &own, &cheaper));
        found.mean += holds(own.control.mean[LAST], mean) / (double)repetitions;
        found.probability += holds(own.control.probability[0], probability) / (double)repetitions;
        found.reported += own.control.mean_gain[LAST] / repetitions;
        squares += pow(own.control.mean[LAST].value - mean, 2);
        plain += pow(own.statistics[PDMC_MEASURE_BOND].mean[LAST].value - mean, 2);
        pdmc_results_clear(&own);
        pdmc_results_clear(&cheaper);
    }
    found.gain = plain / squares;
    return found;
}

/// A control that is nearly the same, and one that knows of c(r) what is wrong: 1 + xi for 1 / (1 + xi).
static void intervals_hold_for_good_and_bad_controls(void **state)
{
    (void)state;
    enum { REPETITIONS = 300 };
    const double allowed = 4.0 * sqrt(0.95 * 0.05 / REPETITIONS); // passed by chance once in 16 000
    double mean, probability;
    find_truth(&mean, &probability);
    for (int order = 0; order < 2; order++) {
        const outcome got = repeat(order, mean, probability, REPETITIONS);
        print_message("order %d: mean held %.3f, P %.3f; gain %.2f, reported %.2f\n", order, got.mean, got.probability,
                      got.gain, got.reported);
        CHECK_NEAR(got.mean, 0.95, allowed);
        assert_true(got.probability >= 0.95 - allowed);
        assert_true(order == 0 ? got.gain > 1.2 : got.gain > 8.0); // at most CHEAPER / OWN
        // each variance has an error of sqrt(2 / 300), and they belong together
        CHECK_NEAR(got.reported / got.gain, 1.0, 4.0 * sqrt(4.0 / REPETITIONS));
    }
}

static void failed_samples_leave_it_open(void **state)
{
    (void)state;
    pdmc_results own, cheaper;
    CHECK_OK(run_pair(1, 1, &own, &cheaper));
    pdmc_results other = own;
    other.failed_count = 1;
    CHECK_OK(pdmc_control_samples(&cheaper, NULL, &other));
    assert_true(isnan(other.control.mean[0].value) && isnan(other.control.probability[0].upper));
    assert_true(isnan(pdmc_control_advice(&other, 10.0)));
    pdmc_free(own.control.mean);
    pdmc_free(own.control.correlation);
    pdmc_free(own.control.mean_gain);
    pdmc_free(own.control.probability);
    pdmc_free(own.control.probability_gain);
    pdmc_results_clear(&other);
    pdmc_results_clear(&cheaper);
}

/// n sqrt(w R^2 / (1 - R^2)), and never less than n.
static void the_advice_grows_with_the_ratio_of_costs(void **state)
{
    (void)state;
    pdmc_results own, cheaper;
    CHECK_OK(run_pair(1, 1, &own, &cheaper));
    const double r = own.control.correlation[LAST];
    CHECK_NEAR(pdmc_control_advice(&own, 50.0), OWN * sqrt(50.0 * r * r / (1.0 - r * r)), 1e-9);
    CHECK_NEAR(pdmc_control_advice(&own, 1e-9), OWN, 0.0);
    pdmc_results_clear(&own);
    pdmc_results_clear(&cheaper);
}

static pdmc_status pair_and_clear(void)
{
    pdmc_results own, cheaper;
    const pdmc_status status = run_pair(1, 1, &own, &cheaper);
    pdmc_results_clear(&own);
    pdmc_results_clear(&cheaper);
    return status;
}

static void memory_that_is_missing_is_reported(void **state)
{
    (void)state;
    CHECK_FAILS_CLEANLY(pair_and_clear(), (void)0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(intervals_hold_for_good_and_bad_controls),
        cmocka_unit_test(failed_samples_leave_it_open),
        cmocka_unit_test(the_advice_grows_with_the_ratio_of_costs),
        cmocka_unit_test(memory_that_is_missing_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
