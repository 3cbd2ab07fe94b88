// SPDX-License-Identifier: GPL-3.0-or-later

/// Dynamic studies: what is recorded, that it balances and settles, and what an early stop keeps.

#include "run/studies.h"

#include "pdmc/discretisation.h"
#include "pdmc/results.h"

#define CRACK "cracks = ( { name = \"c\"; from = [-0.5, 0.0]; to = [0.5, 0.0]; } );"
#define PROBES                                                                                                         \
    "probes = ( { name = \"upper\"; at = [0.1, 0.0]; side = \"left\"; },\n"                                            \
    "           { name = \"lower\"; at = [0.1, 0.0]; side = \"right\"; }, { at = [2.5, 2.5]; } );"

static void read_dynamic(const char *settings, pdmc_study *study)
{
    char text[2048];
    snprintf(text, sizeof text,
             "kind = \"dynamic\"; plate = { width = 5.0; height = 5.0; thickness = 0.5; };\n"
             "material = { youngs_modulus = 1.5; fracture_energy = 2.0; };\n" CRACK "\n"
             "loads = ( { side = \"top\"; traction = [0, 1]; }, { side = \"bottom\"; traction = [0, -1]; } );\n"
             "solver = { spacing = 0.5; };\n" PROBES "\n%s\n",
             settings);
    CHECK_OK(read_text(text, study));
}

static void run_dynamic(const char *settings, const pdmc_run_options *options, pdmc_results *results)
{
    pdmc_study study;
    read_dynamic(settings, &study);
    CHECK_OK(pdmc_run(&study, options, results));
    pdmc_study_clear(&study);
}

static void expect_static(const pdmc_study *study, const pdmc_motion_record *m)
{
    pdmc_discretisation plate;
    const double anchors[3][2] = {{0.1, 0.02}, {0.1, -0.02}, {2.5, 2.5}};
    const double *last = &m->displacement[(m->time_count - 1) * m->probe_count * 2];
    CHECK_OK(pdmc_discretise(&study->problem, 2, &plate));
    for (int p = 0; p < 3; p++) {
        double u[2];
        CHECK_OK(plate.verbs->displacement(plate.method, study->problem.probes[p].at, anchors[p], u));
        for (int k = 0; k < 2; k++)
            CHECK_NEAR(last[2 * p + k], u[k], 1e-2 * hypot(u[0], u[1])); // collocation at this spacing is 0.7 % off
    }
    pdmc_discretisation_clear(&plate);
}

static void a_damped_plate_settles_and_balances(void **state)
{
    (void)state;
    const pdmc_run_options options = {.threads = 2};
    pdmc_study study;
    pdmc_results r;
    read_dynamic("dynamics = { density = 1.0; damping = 0.8; step = 0.25; duration = 75.0; };", &study);
    CHECK_OK(pdmc_run(&study, &options, &r));
    const pdmc_motion_record *m = &r.motion;
    assert_int_equal(r.kind, PDMC_DYNAMIC);
    assert_int_equal(r.status, PDMC_RUN_COMPLETE);
    assert_int_equal(m->time_count, 301);
    assert_int_equal(m->probe_count, 3);
    assert_string_equal(m->probes[2].name, "probe3");
    CHECK_NEAR(m->time[300], 75.0, 1e-12);
    CHECK_NEAR(m->load_factor[0], 0.0, 0.0);
    CHECK_NEAR(m->load_factor[1], 1.0, 0.0);
    for (int i = 0; i < m->time_count; i++)
        CHECK_NEAR(m->kinetic[i] + m->elastic[i] + m->dissipated[i], m->work[i], 1e-9 * m->work[300]);
    // half of the load times the way, of which the first step went under half of the load
    CHECK_NEAR(m->elastic[300], 0.5 * (m->work[300] + m->work[1]), 1e-3 * m->elastic[300]);
    assert_true(m->kinetic[300] < 1e-4 * m->work[300]);
    expect_static(&study, m);
    pdmc_results_clear(&r);
    pdmc_study_clear(&study);
}

// Displacements go with the load, energies with its square.
static void the_history_scales_the_motion(void **state)
{
    (void)state;
    const pdmc_run_options options = {.threads = 1};
    pdmc_results one, half;
    const char dynamics[] = "dynamics = { density = 1.0; step = 0.25; duration = 2.0; };";
    char halved[256];
    snprintf(halved, sizeof halved, "%s history = ( { time = 0; factor = 0.5; } );", dynamics);
    run_dynamic(dynamics, &options, &one);
    run_dynamic(halved, &options, &half);
    assert_int_equal(one.motion.time_count, 9);
    for (int i = 0; i < 9; i++) {
        CHECK_NEAR(half.motion.work[i], 0.25 * one.motion.work[i], 1e-12 * one.motion.work[8]);
        for (int k = 0; k < 6; k++)
            CHECK_NEAR(half.motion.displacement[6 * i + k], 0.5 * one.motion.displacement[6 * i + k], 1e-10);
    }
    pdmc_results_clear(&one);
    pdmc_results_clear(&half);
}

static bool stop_at(void *context, int done, int total)
{
    assert_int_equal(total, 40);
    return done < *(const int *)context;
}

static void a_stopped_motion_is_a_prefix(void **state)
{
    (void)state;
    const char dynamics[] = "dynamics = { density = 1.0; step = 0.1; duration = 4.0; };";
    int limit = 11;
    const pdmc_run_options all = {.threads = 1}, some = {.threads = 2, .progress = stop_at, .context = &limit};
    pdmc_results full, stopped;
    run_dynamic(dynamics, &all, &full);
    run_dynamic(dynamics, &some, &stopped);
    assert_int_equal(stopped.status, PDMC_RUN_INTERRUPTED);
    assert_int_equal(stopped.motion.time_count, 12); // the start and 11 steps
    assert_same("displacement", full.motion.displacement, stopped.motion.displacement, 12 * 6 * sizeof(double));
    CHECK_OK(pdmc_results_write(&stopped, "stopped.h5", true)); // arrays longer than the count
    pdmc_results_clear(&stopped);
    CHECK_OK(pdmc_results_read("stopped.h5", &stopped));
    assert_int_equal(stopped.motion.time_count, 12);
    assert_same("work", full.motion.work, stopped.motion.work, 12 * sizeof(double));
    pdmc_results_clear(&stopped);
    limit = 40;
    run_dynamic(dynamics, &some, &stopped);
    assert_int_equal(stopped.status, PDMC_RUN_COMPLETE);
    pdmc_results_clear(&stopped);
    pdmc_results_clear(&full);
}

// Within the order of it: sanitizers and loaded machines are slow.
static void the_cost_counts_steps(void **state)
{
    (void)state;
    const pdmc_run_options options = {.threads = 1};
    pdmc_study study;
    pdmc_results r;
    read_dynamic("dynamics = { density = 1.0; step = 0.1; duration = 100.0; };", &study);
    const pdmc_cost cost = pdmc_run_cost(&study.problem, 1);
    CHECK_OK(pdmc_run(&study, &options, &r));
    const double times = r.runtime.total / cost.seconds;
    if (!(0.1 < times && times < 50.0)) fail_msg("took %g times the estimate", times);
    assert_int_equal(cost.nodes, r.solver.nodes);
    study.problem.dynamics.duration = 10000.0;
    assert_true(pdmc_run_cost(&study.problem, 1).seconds > 10.0 * cost.seconds);
    pdmc_results_clear(&r);
    pdmc_study_clear(&study);
}

static void nothing_to_save(void **state)
{
    (void)state;
    pdmc_study study;
    pdmc_results r;
    int limit = 0;
    const pdmc_run_options options = {.threads = 1, .progress = stop_at, .context = &limit};
    read_dynamic("dynamics = { density = 1.0; step = 0.1; duration = 4.0; };", &study);
    CHECK_STATUS(pdmc_run(&study, &options, &r), PDMC_ERR_INTERRUPTED);
    assert_string_equal(pdmc_last_error(), "stopped before the first time step: there is nothing to save");
    pdmc_study_clear(&study);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_damped_plate_settles_and_balances),
        cmocka_unit_test(the_history_scales_the_motion),
        cmocka_unit_test(a_stopped_motion_is_a_prefix),
        cmocka_unit_test(the_cost_counts_steps),
        cmocka_unit_test(nothing_to_save),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
