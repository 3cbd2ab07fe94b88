// SPDX-License-Identifier: GPL-3.0-or-later

/// What a user may rely on: the samples are those of the seed, whatever the threads, their number, and whether the run
/// was stopped.

#include "run/studies.h"

#include "pdmc/results.h"

static void run_and_read(const char *sampling, int threads, pdmc_results *results)
{
    pdmc_results made;
    const pdmc_run_options options = {.threads = threads};
    run_study(ONE_CRACK, BOTH, sampling, &options, &made);
    CHECK_OK(pdmc_results_write(&made, "results.h5", true));
    pdmc_results_clear(&made);
    CHECK_OK(pdmc_results_read("results.h5", results));
}

static void threads_change_nothing(void **state)
{
    (void)state;
    const char *inverses[] = {"samples = 300; inverse = \"neumann\";", "samples = 70; inverse = \"direct\";"};
    for (int i = 0; i < 2; i++) {
        pdmc_results one;
        run_and_read(inverses[i], 1, &one);
        for (int threads = 2; threads <= 5; threads += 3) {
            pdmc_results many;
            run_and_read(inverses[i], threads, &many);
            assert_int_equal(many.sample_count, one.sample_count);
            assert_same_samples(&one, &many, one.sample_count);
            for (int m = 0; m < PDMC_MEASURES; m++)
                assert_same("mean", one.statistics[m].mean, many.statistics[m].mean,
                            (size_t)(one.tip_count * one.angle_count) * sizeof(pdmc_estimate));
            assert_same("probability", one.probability, many.probability,
                        (size_t)one.tip_count * sizeof(pdmc_estimate));
            pdmc_results_clear(&many);
        }
        pdmc_results_clear(&one);
    }
}

static void fewer_samples_are_a_prefix(void **state)
{
    (void)state;
    pdmc_results few, many;
    run_and_read("samples = 100;", 2, &few);
    run_and_read("samples = 200;", 2, &many);
    assert_int_equal(few.sample_count, 100);
    assert_int_equal(many.sample_count, 200);
    assert_same_samples(&few, &many, 100);
    pdmc_results_clear(&few);
    pdmc_results_clear(&many);
}

// Not all are kept: the file has the first, and statistics of all.
static void kept_samples_are_a_beginning(void **state)
{
    (void)state;
    const size_t kept = 100;
    pdmc_results all, some;
    run_and_read("samples = 2000;", 2, &all);
    run_and_read("samples = 2000; keep = 100;", 2, &some);
    const size_t directions = (size_t)(all.tip_count * all.angle_count), tips = (size_t)all.tip_count;
    assert_int_equal(all.kept_count, 2000);
    assert_int_equal(some.kept_count, 100);
    assert_int_equal(some.sample_count, 2000);
    assert_same("micromodulus", all.micromodulus, some.micromodulus, kept * (size_t)all.bin_count * sizeof(double));
    assert_same("stress_intensity", all.stress_intensity, some.stress_intensity, 2000 * 2 * tips * sizeof(double));
    for (int m = 0; m < PDMC_MEASURES; m++) {
        assert_same("energy", all.energy[m], some.energy[m], kept * directions * sizeof(double));
        assert_same("largest", all.largest_energy[m], some.largest_energy[m], 2000 * tips * sizeof(double));
        for (size_t d = 0; d < directions; d++)
            CHECK_NEAR(some.statistics[m].mean[d].value, all.statistics[m].mean[d].value,
                       1e-13 * all.statistics[m].mean[d].value);
    }
    assert_same("probability", all.probability, some.probability, tips * sizeof(pdmc_estimate));
    for (size_t d = 0; d < directions; d++) CHECK_NEAR(some.direction[d].value, all.direction[d].value, 1e-12);
    pdmc_results_clear(&all);
    pdmc_results_clear(&some);
}

static void seeds_are_different(void **state)
{
    (void)state;
    const pdmc_run_options options = {.threads = 2};
    pdmc_results seeds[3];
    for (int s = 0; s < 3; s++) {
        char top[512];
        snprintf(top, sizeof top, "seed = %d; " ONE_CRACK, s);
        run_study(top, BOTH, "samples = 20;", &options, &seeds[s]);
        assert_int_equal(seeds[s].seed, s);
    }
    for (int s = 0; s < 3; s++) {
        const pdmc_results *a = &seeds[s], *b = &seeds[(s + 1) % 3];
        for (int i = 0; i < 20; i++) {
            assert_true(a->load_factor[i] != b->load_factor[i]);
            assert_true(a->micromodulus[i * a->bin_count] != b->micromodulus[i * b->bin_count]);
        }
    }
    for (int s = 0; s < 3; s++) pdmc_results_clear(&seeds[s]);
}

// Stops once `limit` samples are done; limit = 0 before there are any.
typedef struct {
    int limit, calls, most;
    bool disorder; // more samples done than there are, or fewer than before
} stopper;

static bool stop_at(void *context, int done, int total)
{
    stopper *s = context;
    if (done < s->most || done > total) s->disorder = true; // not asserted: cmocka must not jump out of a thread
    s->calls++;
    s->most = done;
    return done < s->limit;
}

static void a_stopped_run_is_a_prefix(void **state)
{
    (void)state;
    pdmc_results full, stopped;
    run_and_read("samples = 600;", 2, &full);
    for (int threads = 1; threads <= 3; threads++) {
        stopper stop = {.limit = 150};
        const pdmc_run_options options = {.threads = threads, .progress = stop_at, .context = &stop};
        run_study(ONE_CRACK, BOTH, "samples = 600;", &options, &stopped);
        assert_false(stop.disorder);
        assert_int_equal(stopped.status, PDMC_RUN_INTERRUPTED);
        assert_true(64 <= stopped.sample_count && stopped.sample_count < 600);
        assert_int_equal(stopped.sample_count % 64, 0);
        assert_same_samples(&full, &stopped, stopped.sample_count);
        CHECK_OK(pdmc_results_write(&stopped, "stopped.h5", true)); // arrays longer than the count
        pdmc_results_clear(&stopped);
        CHECK_OK(pdmc_results_read("stopped.h5", &stopped));
        assert_int_equal(stopped.status, PDMC_RUN_INTERRUPTED);
        assert_same_samples(&full, &stopped, stopped.sample_count);
        pdmc_results_clear(&stopped);
    }
    pdmc_results_clear(&full);
}

static void a_run_stopped_at_its_end_is_complete(void **state)
{
    (void)state;
    pdmc_results results;
    stopper stop = {.limit = 100};
    const pdmc_run_options options = {.threads = 1, .progress = stop_at, .context = &stop};
    run_study(ONE_CRACK, BOTH, "samples = 100;", &options, &results);
    assert_int_equal(results.status, PDMC_RUN_COMPLETE);
    assert_int_equal(results.sample_count, 100);
    pdmc_results_clear(&results);
}

static void nothing_to_save(void **state)
{
    (void)state;
    pdmc_study study;
    stopper stop = {.limit = 0};
    const pdmc_run_options options = {.threads = 1, .progress = stop_at, .context = &stop};
    pdmc_results results;
    memset(&results, 1, sizeof results);
    read_study(ONE_CRACK, BOTH, "samples = 100;", &study);
    CHECK_STATUS(pdmc_run(&study, &options, &results), PDMC_ERR_INTERRUPTED);
    assert_int_equal(stop.calls, 1);
    assert_string_equal(pdmc_last_error(), "stopped before the first samples: there is nothing to save");
    const pdmc_results zero = {0};
    assert_memory_equal(&results, &zero, sizeof zero);
    pdmc_study_clear(&study);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(threads_change_nothing),
        cmocka_unit_test(fewer_samples_are_a_prefix),
        cmocka_unit_test(kept_samples_are_a_beginning),
        cmocka_unit_test(seeds_are_different),
        cmocka_unit_test(a_stopped_run_is_a_prefix),
        cmocka_unit_test(a_run_stopped_at_its_end_is_complete),
        cmocka_unit_test(nothing_to_save),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
