// SPDX-License-Identifier: GPL-3.0-or-later

/// A study with a target stops when that is known or at its cap, with the samples of a study that was never told to stop.

#include "stochastic/same.h"
#include "stochastic/toy.h"

enum { MOST_ROUNDS = 32, LARGEST = 3 }; // the direction of the largest stretch

typedef struct {
    int count, stop_at; // 0: never
    pdmc_round found[MOST_ROUNDS];
} record;

static void note(void *context, const pdmc_round *round)
{
    record *rounds = context;
    assert_true(rounds->count < MOST_ROUNDS);
    rounds->found[rounds->count++] = *round;
}

static bool go_on(void *context, int done, int total)
{
    const record *rounds = context;
    (void)total;
    return rounds->stop_at == 0 || done < rounds->stop_at;
}

static void ask_for(toy *t, pdmc_target target, double relative_error, int most)
{
    pdmc_sampling *sampling = &t->problem.sampling;
    toy_make(t, 0.2, 0.1);
    t->problem.material.fracture_energy = 3.0; // the mean of the largest energy is 2.4
    sampling->samples = 100;
    sampling->target = target;
    sampling->relative_error = relative_error;
    sampling->most_samples = most;
}

static void run_rounds(toy *t, int threads, record *rounds, pdmc_results *r)
{
    const pdmc_run_options options = {.threads = threads, .progress = go_on, .round = note, .context = rounds};
    rounds->count = 0;
    CHECK_OK(toy_run(t, &options, r));
}

static void check_same_as_plain(const toy *asked, const pdmc_results *r)
{
    toy t = *asked;
    pdmc_results plain;
    t.problem.sampling.target = PDMC_TARGET_NONE;
    t.problem.sampling.samples = r->sample_count;
    t.problem.energy.tips = &t.tip;
    CHECK_OK(toy_run(&t, &one_thread, &plain));
    assert_int_equal(plain.kept_count, r->kept_count);
    assert_int_equal(plain.failed_count, r->failed_count);
    check_same_samples(&plain, r, r->sample_count, r->kept_count);
    check_same_statistics(&plain, r);
    pdmc_results_clear(&plain);
}

static double error_of(const pdmc_results *r, pdmc_target target)
{
    const pdmc_energy_statistics *energy = &r->statistics[r->measure];
    const pdmc_estimate found = target == PDMC_TARGET_MEAN ? energy->mean[LARGEST]
                                : target == PDMC_TARGET_QUANTILE
                                    ? energy->quantiles[LARGEST * PDMC_QUANTILES + PDMC_QUANTILES - 1]
                                    : r->probability[0];
    return (found.upper - found.lower) / (2.0 * found.value);
}

// The rounds of a target that was met: each says what it knows and foresees, none but the last knows enough.
static void check_rounds(const record *rounds, const pdmc_results *r)
{
    const pdmc_round *last = &rounds->found[rounds->count - 1];
    assert_true(rounds->count >= 3);
    assert_int_equal(last->samples, r->sample_count);
    assert_int_equal(r->status, PDMC_RUN_TARGET_MET);
    CHECK_NEAR(last->error, error_of(r, last->target), 1e-14);
    for (int k = 0; k < rounds->count; k++) {
        const pdmc_round *found = &rounds->found[k];
        assert_true((found->error <= found->wanted) == (found == last));
        CHECK_NEAR(found->needed, found->samples * found->error * found->error / (found->wanted * found->wanted),
                   1e-14 * found->needed);
        assert_int_equal(found->samples % PDMC_BLOCK, 0);
        if (k == 0) continue;
        assert_true(found->samples > found[-1].samples);
        assert_true(found->samples <= 2 * found[-1].samples + 10 * PDMC_BLOCK);
    }
}

static void what_is_found_is_a_plain_study(void **state)
{
    (void)state;
    const double wanted[] = {
        [PDMC_TARGET_MEAN] = 0.01, [PDMC_TARGET_QUANTILE] = 0.02, [PDMC_TARGET_PROBABILITY] = 0.06};
    const int keeps[] = {100, 500, 1000000}; // fewer than the first round has, than the last has, and all
    for (pdmc_target target = PDMC_TARGET_MEAN; target <= PDMC_TARGET_PROBABILITY; target++)
        for (int threads = 1; threads <= 3; threads++) {
            toy t;
            record rounds = {0};
            pdmc_results r;
            ask_for(&t, target, wanted[target], 50000);
            t.problem.sampling.keep = keeps[threads - 1];
            run_rounds(&t, threads, &rounds, &r);
            check_rounds(&rounds, &r);
            check_same_as_plain(&t, &r);
            pdmc_results_clear(&r);
        }
}

// Fewer samples than may be counted, and in the end no more than are kept.
static void kept_in_the_end(void **state)
{
    (void)state;
    toy t;
    record rounds = {0};
    pdmc_results r;
    ask_for(&t, PDMC_TARGET_MEAN, 0.01, 50000);
    t.problem.sampling.keep = 40000;
    run_rounds(&t, 2, &rounds, &r);
    assert_int_equal(r.kept_count, r.sample_count);
    check_rounds(&rounds, &r);
    check_same_as_plain(&t, &r);
    pdmc_results_clear(&r);
}

static void sobol_goes_on_in_whole_replicates(void **state)
{
    (void)state;
    toy t;
    record rounds = {0};
    pdmc_results r;
    ask_for(&t, PDMC_TARGET_PROBABILITY, 0.05, 50000);
    t.problem.sampling.design = PDMC_DESIGN_SOBOL;
    t.problem.sampling.replicates = 10;
    run_rounds(&t, 2, &rounds, &r);
    check_rounds(&rounds, &r);
    for (int k = 0; k < rounds.count; k++) assert_int_equal(rounds.found[k].samples % 320, 0); // of 64 and 10
    check_same_as_plain(&t, &r);
    pdmc_results_clear(&r);
}

static void the_cap_is_the_end(void **state)
{
    (void)state;
    toy t;
    record rounds = {0};
    pdmc_results r;
    ask_for(&t, PDMC_TARGET_MEAN, 1e-6, 1000);
    run_rounds(&t, 2, &rounds, &r);
    assert_int_equal(r.status, PDMC_RUN_SAMPLE_CAP);
    assert_int_equal(r.sample_count, 1000);
    check_same_as_plain(&t, &r);
    pdmc_results_clear(&r);
}

static void what_never_happened_is_not_known(void **state)
{
    (void)state;
    toy t;
    record rounds = {0};
    pdmc_results r;
    ask_for(&t, PDMC_TARGET_PROBABILITY, 1.0, 1000);
    t.problem.material.fracture_energy = 1e6;
    run_rounds(&t, 2, &rounds, &r);
    assert_int_equal(rounds.count, 4); // 128, 256, 512, 1000
    for (int k = 0; k < rounds.count; k++) assert_true(isinf(rounds.found[k].error) && isinf(rounds.found[k].needed));
    assert_int_equal(r.status, PDMC_RUN_SAMPLE_CAP);
    pdmc_results_clear(&r);
}

// The end of a round is not the end of the study.
static void a_stop_between_rounds_is_early(void **state)
{
    (void)state;
    toy t;
    record rounds = {.stop_at = 256};
    pdmc_results r;
    ask_for(&t, PDMC_TARGET_MEAN, 1e-3, 100000);
    run_rounds(&t, 1, &rounds, &r);
    assert_int_equal(r.status, PDMC_RUN_INTERRUPTED);
    assert_int_equal(r.sample_count, 256);
    check_same_as_plain(&t, &r);
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
    ask_for(&t, PDMC_TARGET_QUANTILE, 1e-3, 300);
    t.problem.sampling.keep = 200;
    CHECK_FAILS_CLEANLY(run_or_clear(&t), (void)0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_found_is_a_plain_study),
        cmocka_unit_test(kept_in_the_end),
        cmocka_unit_test(sobol_goes_on_in_whole_replicates),
        cmocka_unit_test(the_cap_is_the_end),
        cmocka_unit_test(what_never_happened_is_not_known),
        cmocka_unit_test(a_stop_between_rounds_is_early),
        cmocka_unit_test(memory_may_be_short),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
