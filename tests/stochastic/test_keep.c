// SPDX-License-Identifier: GPL-3.0-or-later

/// Samples whose energies are not kept: their statistics are those of kept ones, within what a tally resolves.

#include "stochastic/same.h"
#include "stochastic/toy.h"

enum { SAMPLES = 5000, KEPT = 300 };

static void keep_run(toy *t, int samples, int keep, int threads, pdmc_results *r)
{
    const pdmc_run_options options = {.threads = threads};
    t->problem.sampling.samples = samples;
    t->problem.sampling.keep = keep;
    CHECK_OK(toy_run(t, &options, r));
    assert_int_equal(r->sample_count, samples);
    assert_int_equal(r->kept_count, keep < samples ? keep : samples);
}

// Means and deviations to rounding: the sums have 5000 terms. A quantile is the middle of a bin, off by 2^-12 of itself, and its
// interval reaches to the edges of bins, 2^-11.
static void check_near_statistics(const pdmc_energy_statistics *tallied, const pdmc_energy_statistics *kept, int d)
{
    CHECK_NEAR(tallied->mean[d].value, kept->mean[d].value, 1e-13 * kept->mean[d].value);
    CHECK_NEAR(tallied->mean[d].lower, kept->mean[d].lower, 1e-12 * kept->mean[d].value);
    CHECK_NEAR(tallied->standard_deviation[d].value, kept->standard_deviation[d].value, 1e-12 * kept->mean[d].value);
    for (int q = 0; q < PDMC_QUANTILES; q++) {
        const pdmc_estimate *a = &tallied->quantiles[d * PDMC_QUANTILES + q],
                            *b = &kept->quantiles[d * PDMC_QUANTILES + q];
        CHECK_NEAR(a->value, b->value, 0x1p-12 * b->value);
        assert_true(a->lower <= b->lower && b->upper <= a->upper);
        CHECK_NEAR(a->lower, b->lower, 0x1p-11 * b->lower);
        CHECK_NEAR(a->upper, b->upper, 0x1p-11 * b->upper);
    }
}

// Every edge of the tally's histogram is one of its bins', so that counts of the energies themselves are the same.
static void check_histogram(const pdmc_results *tallied, const pdmc_results *kept, pdmc_measure measure, int d)
{
    const int bins = tallied->histogram_bins;
    const double *edges = &tallied->statistics[measure].histogram_edges[d * (bins + 1)];
    const int64_t *counts = &tallied->statistics[measure].histogram_counts[d * (bins + 2)];
    int64_t total = 0;
    for (int b = 0; b < bins + 2; b++) {
        int64_t inside = 0;
        for (int s = 0; s < kept->kept_count; s++) {
            const double energy = kept->energy[measure][s * ANGLES + d];
            inside += (b == 0 || energy >= edges[b - 1]) && (b == bins + 1 || energy < edges[b]);
        }
        assert_int_equal(counts[b], inside);
        total += counts[b];
    }
    assert_int_equal(total, kept->sample_count - kept->failed_count);
}

static void tallies_agree_with_what_is_kept(void **state)
{
    (void)state;
    for (int measure = 0; measure < PDMC_MEASURES; measure++) {
        toy t;
        pdmc_results kept, tallied;
        toy_make(&t, 0.2, 0.1);
        t.row[1] = -3.0; // two equal directions, which share
        t.problem.energy.measure = (pdmc_measure)measure;
        keep_run(&t, SAMPLES, SAMPLES, 1, &kept);
        keep_run(&t, SAMPLES, KEPT, 1, &tallied);
        check_same_samples(&kept, &tallied, SAMPLES, KEPT);
        for (int d = 0; d < ANGLES; d++) {
            for (int m = 0; m < PDMC_MEASURES; m++) {
                check_near_statistics(&tallied.statistics[m], &kept.statistics[m], d);
                check_histogram(&tallied, &kept, (pdmc_measure)m, d);
            }
            CHECK_NEAR(tallied.direction[d].value, kept.direction[d].value, 1e-12);
            CHECK_NEAR(tallied.direction[d].upper, kept.direction[d].upper, 0.0);
        }
        assert_memory_equal(tallied.probability, kept.probability, sizeof(pdmc_estimate));
        assert_memory_equal(tallied.conditional_probability, kept.conditional_probability, sizeof(pdmc_estimate));
        assert_true(kept.probability[0].value > 0.0 && kept.probability[0].value < 1.0);
        pdmc_results_clear(&kept);
        pdmc_results_clear(&tallied);
    }
}

static void threads_change_nothing(void **state)
{
    (void)state;
    toy t;
    pdmc_results one, many;
    toy_make(&t, 0.2, 0.1);
    keep_run(&t, SAMPLES, KEPT, 1, &one);
    for (int threads = 2; threads <= 5; threads++) {
        keep_run(&t, SAMPLES, KEPT, threads, &many);
        check_same_samples(&one, &many, SAMPLES, KEPT);
        check_same_statistics(&one, &many);
        pdmc_results_clear(&many);
    }
    pdmc_results_clear(&one);
}

static void failed_samples_are_not_counted(void **state)
{
    (void)state;
    toy t;
    pdmc_results kept, tallied;
    toy_make(&t, 0.5, 0.1);
    t.problem.sampling.inverse = PDMC_INVERSE_DIRECT;
    keep_run(&t, SAMPLES, SAMPLES, 1, &kept);
    keep_run(&t, SAMPLES, 1, 2, &tallied);
    assert_true(tallied.failed_count > 0);
    assert_int_equal(tallied.failed_count, kept.failed_count);
    check_same_samples(&kept, &tallied, SAMPLES, 1);
    check_histogram(&tallied, &kept, PDMC_MEASURE_BOND, 3);
    assert_memory_equal(tallied.probability, kept.probability, sizeof(pdmc_estimate));
    CHECK_NEAR(tallied.direction[3].value, kept.direction[3].value, 1e-12);
    pdmc_results_clear(&kept);
    pdmc_results_clear(&tallied);
}

static bool stop_after_1500(void *context, int done, int total)
{
    (void)context;
    (void)total;
    return done < 1500;
}

// What a stopped run has is what a shorter one would have, statistics included.
static void an_early_stop_has_the_statistics_of_what_is_done(void **state)
{
    (void)state;
    for (int threads = 1; threads <= 3; threads++) {
        const pdmc_run_options options = {.threads = threads, .progress = stop_after_1500};
        toy t;
        pdmc_results stopped, shorter;
        toy_make(&t, 0.2, 0.1);
        t.problem.sampling.samples = 10000;
        t.problem.sampling.keep = KEPT;
        CHECK_OK(toy_run(&t, &options, &stopped));
        assert_int_equal(stopped.status, PDMC_RUN_INTERRUPTED);
        assert_true(1500 <= stopped.sample_count && stopped.sample_count < 10000);
        assert_int_equal(stopped.kept_count, KEPT);
        keep_run(&t, stopped.sample_count, KEPT, 1, &shorter);
        check_same_samples(&stopped, &shorter, stopped.sample_count, KEPT);
        check_same_statistics(&stopped, &shorter);
        pdmc_results_clear(&stopped);
        pdmc_results_clear(&shorter);
    }
}

static bool stop_at_once(void *context, int done, int total)
{
    (void)context;
    (void)total;
    return done == 0;
}

static void a_stop_before_all_are_there_that_were_to_be_kept(void **state)
{
    (void)state;
    const pdmc_run_options options = {.threads = 2, .progress = stop_at_once};
    toy t;
    pdmc_results r;
    toy_make(&t, 0.2, 0.1);
    t.problem.sampling.samples = 20000;
    t.problem.sampling.keep = 15000;
    CHECK_OK(toy_run(&t, &options, &r));
    assert_int_equal(r.kept_count, r.sample_count);
    assert_true(0 < r.sample_count && r.sample_count < 15000);
    pdmc_results_clear(&r);
}

// Its intervals are those of replicates, in the order of the samples.
static void all_of_a_design_are_kept(void **state)
{
    (void)state;
    toy t;
    pdmc_results r;
    toy_make(&t, 0.2, 0.1);
    t.problem.sampling.design = PDMC_DESIGN_LATIN_HYPERCUBE;
    t.problem.sampling.replicates = 10;
    t.problem.sampling.samples = 500;
    t.problem.sampling.keep = 100;
    CHECK_OK(toy_run(&t, &one_thread, &r));
    assert_int_equal(r.kept_count, 500);
    pdmc_results_clear(&r);
}

static pdmc_status run_or_clear(toy *t)
{
    pdmc_results r;
    const pdmc_status status = toy_run(t, &one_thread, &r);
    pdmc_results_clear(&r);
    return status;
}

static void memory_may_be_short(void **state)
{
    (void)state;
    toy t;
    toy_make(&t, 0.2, 0.1);
    t.problem.sampling.samples = 200;
    t.problem.sampling.keep = 100;
    CHECK_FAILS_CLEANLY(run_or_clear(&t), (void)0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tallies_agree_with_what_is_kept),
        cmocka_unit_test(threads_change_nothing),
        cmocka_unit_test(failed_samples_are_not_counted),
        cmocka_unit_test(an_early_stop_has_the_statistics_of_what_is_done),
        cmocka_unit_test(a_stop_before_all_are_there_that_were_to_be_kept),
        cmocka_unit_test(all_of_a_design_are_kept),
        cmocka_unit_test(memory_may_be_short),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
