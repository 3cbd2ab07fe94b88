// SPDX-License-Identifier: GPL-3.0-or-later

/// Scalar studies from file to record: the rates that the room's own tests find, the bits of any number of threads,
/// stops.

#include "run/studies.h"

#include "pdmc/results.h"

#define LINE                                                                                                           \
    "kind = \"scalar\"; domain = { dimension = 1; width = 1.0; }; kernel = { horizon = 0.13; };\n"                     \
    "wave = { length = 1.25; phase = 40; };\n"

static void run_scalar(const char *text, const pdmc_run_options *options, pdmc_results *results)
{
    pdmc_study study;
    CHECK_OK(read_text(text, &study));
    CHECK_OK(pdmc_run(&study, options, results));
    pdmc_study_clear(&study);
}

static double rate(const double values[], int level)
{
    return log2(values[level - 1] / values[level]);
}

static void spacings_and_motions_converge_with_the_second_order(void **state)
{
    (void)state;
    const pdmc_run_options options = {.threads = 2};
    pdmc_results r;
    run_scalar(LINE "elements = { cells = 20; outer = \"exact\"; }; convergence = { levels = 3; };\n"
                    "motion = { duration = 1.0; };",
               &options, &r);
    const pdmc_scalar_record *s = &r.scalar;
    assert_int_equal(r.kind, PDMC_SCALAR);
    assert_int_equal(s->level_count, 3);
    CHECK_NEAR(s->spacing[2], 0.0125, 1e-15);
    CHECK_NEAR(s->unknowns[0], 19.0, 0.0);
    CHECK_NEAR(rate(s->error, 2), 2.0, 0.3);
    CHECK_NEAR(rate(s->motion_error, 2), 2.0, 0.3);
    CHECK_NEAR(s->steps[0], ceil(1.0 / (0.2 * s->stable_step[0])), 0.0);
    CHECK_NEAR(s->steps[2], ceil(1.0 / (0.05 * s->stable_step[2])), 0.0);
    assert_true(s->stable_step_error[2] < 1e-7 * s->stable_step[2] && isnan(s->classical[0]));
    double most = 0.0;
    for (int i = 0; i < s->value_count; i++) {
        CHECK_NEAR(s->wave[i], sin(2.0 * M_PI / 1.25 * s->position[2 * i] + 40.0 * M_PI / 180.0), 1e-14);
        most = fmax(most, fabs(s->value[i] - s->wave[i]));
    }
    assert_true(most > 0.5 * s->error[2] && most < 10.0 * s->error[2]);
    pdmc_results_clear(&r);
}

static void a_vanishing_horizon_gives_classical_elements(void **state)
{
    (void)state;
    const pdmc_run_options options = {.threads = 1};
    static const char *const settings[] = {
        LINE "elements = { cells = 8; outer = \"exact\"; space = \"discontinuous\"; };\n"
             "convergence = { vary = \"horizon\"; levels = 7; };",
        "kind = \"scalar\"; domain = { dimension = 2; width = 1; height = 0.5; }; kernel = { horizon = 0.13; };\n"
        "wave = { length = 1.25; angle = 20; }; elements = { cells = 8; };\n"
        "convergence = { vary = \"horizon\"; levels = 7; };"};
    for (int i = 0; i < 2; i++) {
        pdmc_results r;
        run_scalar(settings[i], &options, &r);
        CHECK_NEAR(r.scalar.horizon[6], 0.13 / 64.0, 1e-15);
        CHECK_NEAR(rate(r.scalar.classical, 6), 1.0, 0.15);
        CHECK_NEAR(r.scalar.spacing[6], r.scalar.spacing[0], i == 0 ? 0.13 : 0.0); // the layer has long intervals
        pdmc_results_clear(&r);
    }
}

static const char flat[] =
    "kind = \"scalar\"; domain = { dimension = 2; width = 1; height = 1.5; };\n"
    "kernel = { horizon = 0.3; power = 0.5; weights = [1.0, 3.0]; }; wave = { length = 2; angle = 50; };\n"
    "elements = { space = \"mixed\"; cells = 3; inner = \"polynomial\"; rough_from = -0.2; rough_to = 0.2; };\n"
    "convergence = { levels = 2; }; motion = { duration = 0.3; };";

static void threads_change_no_bit(void **state)
{
    (void)state;
    const pdmc_run_options one = {.threads = 1}, three = {.threads = 3};
    pdmc_results a, b;
    run_scalar(flat, &one, &a);
    run_scalar(flat, &three, &b);
    assert_int_equal(a.scalar.value_count, b.scalar.value_count);
    assert_memory_equal(a.scalar.value, b.scalar.value, (size_t)a.scalar.value_count * sizeof(double));
    assert_memory_equal(a.scalar.motion_error, b.scalar.motion_error, 2 * sizeof(double));
    assert_memory_equal(a.scalar.stable_step, b.scalar.stable_step, 2 * sizeof(double));
    pdmc_results_clear(&a);
    pdmc_results_clear(&b);
}

static bool stop_after_one(void *context, int done, int all)
{
    (void)context, (void)all;
    return done < 1;
}

static bool stop_at_once(void *context, int done, int all)
{
    (void)context, (void)done, (void)all;
    return false;
}

static void stops_keep_the_levels_that_are_done(void **state)
{
    (void)state;
    const pdmc_run_options after = {.threads = 1, .progress = stop_after_one},
                           now = {.threads = 1, .progress = stop_at_once};
    pdmc_results r, again;
    pdmc_study study;
    run_scalar(flat, &after, &r);
    assert_int_equal(r.status, PDMC_RUN_INTERRUPTED);
    assert_int_equal(r.scalar.level_count, 1);
    CHECK_OK(pdmc_results_write(&r, "stopped.h5", true));
    CHECK_OK(pdmc_results_read("stopped.h5", &again)); // the file has it all
    assert_memory_equal(again.scalar.value, r.scalar.value, (size_t)r.scalar.value_count * sizeof(double));
    CHECK_NEAR(again.scalar.error[0], r.scalar.error[0], 0.0);
    pdmc_results_clear(&again);
    pdmc_results_clear(&r);
    CHECK_OK(read_text(flat, &study));
    CHECK_STATUS(pdmc_run(&study, &now, &r), PDMC_ERR_INTERRUPTED);
    pdmc_study_clear(&study);
}

static void what_nothing_holds_is_told(void **state)
{
    (void)state;
    const pdmc_run_options options = {.threads = 1};
    pdmc_results r;
    pdmc_study study;
    CHECK_OK(read_text(LINE "elements = { cells = 8; space = \"discontinuous\"; };\n"
                            "convergence = { vary = \"horizon\"; levels = 6; };",
                       &study));
    CHECK_STATUS(pdmc_run(&study, &options, &r), PDMC_ERR_SINGULAR);
    assert_non_null(strstr(pdmc_last_error(), "not held by others"));
    pdmc_study_clear(&study);
}

static void memory_that_is_refused_is_told(void **state)
{
    (void)state;
    const pdmc_run_options options = {.threads = 1};
    pdmc_results r;
    pdmc_study study;
    CHECK_OK(read_text(LINE "elements = { cells = 3; }; convergence = { levels = 2; }; motion = { duration = 0.01; };",
                       &study));
    CHECK_FAILS_CLEANLY(pdmc_run(&study, &options, &r), pdmc_results_clear(&r));
    study.scalar.has_duration = false;
    study.scalar.vary = PDMC_VARY_HORIZON;
    CHECK_FAILS_CLEANLY(pdmc_run(&study, &options, &r), pdmc_results_clear(&r));
    pdmc_study_clear(&study);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(spacings_and_motions_converge_with_the_second_order),
        cmocka_unit_test(a_vanishing_horizon_gives_classical_elements),
        cmocka_unit_test(threads_change_no_bit),
        cmocka_unit_test(stops_keep_the_levels_that_are_done),
        cmocka_unit_test(what_nothing_holds_is_told),
        cmocka_unit_test(memory_that_is_refused_is_told),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
