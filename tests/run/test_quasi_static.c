// SPDX-License-Identifier: GPL-3.0-or-later

/// Quasi-static studies: load and displacement in closed form, threads, and what is kept where bodies do not come to rest.

#include "run/studies.h"

#include "pdmc/results.h"

#define GRID "grid = { dimension = 2; spacing = 1.0; offset = [0.5, 0.5]; thickness = 0.25; };\n"
#define GLASS "materials = ( { density = 2.0; youngs_modulus = 3.0; critical_stretch = 0.02; } );\n"

static void read_quasi_static(const char *settings, pdmc_study *study)
{
    char text[4096];
    snprintf(text, sizeof text, "kind = \"quasi_static\";\n%s\n", settings);
    CHECK_OK(read_text(text, study));
}

static void run_quasi_static(const char *settings, const pdmc_run_options *options, pdmc_results *results)
{
    pdmc_study study;
    read_quasi_static(settings, &study);
    CHECK_OK(pdmc_run(&study, options, results));
    pdmc_study_clear(&study);
}

// A plate with a notch that is pulled until it breaks.
static const char torn[] = GRID GLASS
    "bodies = ( { from = [0, 0]; to = [16, 16]; } );\n"
    "cracks = ( { name = \"c\"; from = [-1, 8]; to = [6, 8]; } );\n"
    "conditions = ( { name = \"foot\"; prescribed = \"displacement\"; from = [0, 0]; to = [16, 3]; x = 0; y = 0; },\n"
    "               { name = \"head\"; prescribed = \"displacement\"; from = [0, 13]; to = [16, 16]; x = 0; y = 0.6; } "
    ");\n"
    "loading = { steps = 6; }; record = { snapshots = 3; };";

// One bond of |xi| = 1 between two nodes of volume V = 1/4, once by the default history, and once by one that unloads: F = c V^2 s,
// c = 9 E / (pi d^3 t) = 4 / pi, as long as it holds, and W = c V^2 s^2 / 2.
static void one_bond_in_closed_form(void **state)
{
    (void)state;
    const double stiffness = 9.0 * 3.0 / (M_PI * 27.0 * 0.25) / 16.0;
    const char *histories[] = {"", "times = [0, 1, 2]; factors = [0, 1, 0];"};
    for (int h = 0; h < 2; h++) {
        char text[1024];
        snprintf(
            text, sizeof text,
            GRID
            "materials = ( { density = 2.0; youngs_modulus = 3.0; } ); bodies = ( { from = [0, 0]; to = [2, 1]; } );\n"
            "conditions = ( { prescribed = \"displacement\"; from = [0, 0]; to = [1, 1]; x = 0; y = 0; },\n"
            "               { name = \"end\"; prescribed = \"displacement\"; from = [1, 0]; to = [2, 1]; x = 0.04; y = "
            "0; %s } );\nloading = { steps = 4; end = 2.0; }; record = { snapshots = 2; };",
            histories[h]);
        pdmc_results r;
        run_quasi_static(text, &(pdmc_run_options){.threads = 1}, &r);
        const pdmc_explicit_record *p = &r.particles;
        assert_int_equal(r.status, PDMC_RUN_COMPLETE);
        assert_int_equal(p->record_count, 5);
        assert_int_equal(p->snapshot_count, 2);
        assert_string_equal(p->conditions[1].name, "end");
        for (int i = 0; i < 5; i++) {
            const double load = 0.5 * i, stretch = 0.04 * (h ? fmin(load, 2.0 - load) : 0.5 * load);
            CHECK_NEAR(p->time[i], load, 0.0);
            CHECK_NEAR(p->condition_displacement[6 * i + 3], stretch, 1e-15);
            CHECK_NEAR(p->condition_force[6 * i + 3], stiffness * stretch, 1e-15);
            CHECK_NEAR(p->condition_force[6 * i], -stiffness * stretch, 1e-15);
            CHECK_NEAR(p->elastic[i], 0.5 * stiffness * stretch * stretch, 1e-16);
            CHECK_NEAR(p->work[i], p->elastic[i], 1e-16);
        }
        pdmc_results_clear(&r);
    }
}

// Torn, the head carries little any more; the balance is of the second order in the loads.
static void a_plate_is_torn(void **state)
{
    (void)state;
    pdmc_results r;
    run_quasi_static(torn, &(pdmc_run_options){.threads = 1}, &r);
    const pdmc_explicit_record *p = &r.particles;
    const int last = p->record_count - 1;
    double largest = 0.0, breakages = 0.0;
    for (int i = 0; i <= last; i++) {
        largest = fmax(largest, p->condition_force[6 * i + 4]);
        breakages += p->breakages[i];
        assert_true(p->residual[i] <= 1e-4);
        CHECK_NEAR(p->elastic[i] + p->fracture[i] + p->dissipated[i], p->work[i], 1e-3 * p->work[last]);
        CHECK_NEAR(p->condition_force[6 * i + 4], -p->condition_force[6 * i + 1], 1e-3 * largest + 1e-12);
    }
    assert_true(largest > 0.0 && p->condition_force[6 * last + 4] < 0.2 * largest);
    assert_true(breakages > 3.0 && p->tip_advance[2 * last + 1] > 5.0);
    assert_true(p->dissipated[last] > 0.0 && p->kinetic[last] == 0.0);
    pdmc_results_clear(&r);
}

static void results_do_not_depend_on_threads(void **state)
{
    (void)state;
    pdmc_results one, two;
    run_quasi_static(torn, &(pdmc_run_options){.threads = 1}, &one);
    run_quasi_static(torn, &(pdmc_run_options){.threads = 2}, &two);
    const pdmc_explicit_record *a = &one.particles, *b = &two.particles;
    const size_t n = (size_t)a->record_count * sizeof(double);
    assert_int_equal(a->record_count, b->record_count);
    assert_same("work", a->work, b->work, n);
    assert_same("fracture", a->fracture, b->fracture, n);
    assert_same("relaxation_steps", a->relaxation_steps, b->relaxation_steps, n);
    assert_same("condition_force", a->condition_force, b->condition_force, 6 * n);
    assert_same("displacement", a->displacement, b->displacement, 3 * (size_t)a->state_count * sizeof(double));
    pdmc_results_clear(&one);
    pdmc_results_clear(&two);
}

// Pulled by a force, the plate has no rest any more once its crack runs: what was at rest until then is kept, in the file too.
static void what_finds_no_rest_keeps_the_last_state(void **state)
{
    (void)state;
    char text[2048];
    pdmc_results r;
    snprintf(text, sizeof text,
             GRID GLASS
             "bodies = ( { from = [0, 0]; to = [16, 16]; } );\n"
             "cracks = ( { name = \"c\"; from = [-1, 8]; to = [6, 8]; } );\n"
             "conditions = ( { prescribed = \"displacement\"; from = [0, 0]; to = [16, 3]; x = 0; y = 0; },\n"
             "               { prescribed = \"force\"; from = [0, 13]; to = [16, 16]; y = 0.006; } );\n"
             "loading = { steps = 6; most_steps = 2000; }; record = { snapshots = 2; };");
    run_quasi_static(text, &(pdmc_run_options){.threads = 1}, &r);
    assert_int_equal(r.status, PDMC_RUN_NO_REST);
    assert_non_null(strstr(r.particles.stop, "not at rest after 2000 steps of relaxation, the residual is "));
    CHECK_OK(pdmc_results_write(&r, "no_rest.h5", true));
    pdmc_results_clear(&r);
    CHECK_OK(pdmc_results_read("no_rest.h5", &r));
    const pdmc_explicit_record *p = &r.particles;
    const int last = p->record_count - 1;
    assert_int_equal(r.kind, PDMC_QUASI_STATIC);
    assert_int_equal(r.status, PDMC_RUN_NO_REST);
    assert_in_range(p->record_count, 2, 6);
    CHECK_NEAR(p->snapshot_time[p->snapshot_count - 1], p->time[last], 0.0);
    assert_true(p->residual[last] <= 1e-4);
    CHECK_NEAR(p->condition_force[6 * last + 4], 16 * 3 * 0.25 * 0.006 * p->time[last], 1e-12);
    pdmc_results_clear(&r);
}

static bool stop_at(void *context, int done, int total)
{
    assert_int_equal(total, 6);
    return done < *(const int *)context;
}

static void a_stopped_run_is_a_prefix(void **state)
{
    (void)state;
    int limit = 3;
    pdmc_results full, stopped;
    run_quasi_static(torn, &(pdmc_run_options){.threads = 1}, &full);
    run_quasi_static(torn, &(pdmc_run_options){.threads = 1, .progress = stop_at, .context = &limit}, &stopped);
    assert_int_equal(stopped.status, PDMC_RUN_INTERRUPTED);
    assert_int_equal(stopped.particles.record_count, 4);
    assert_same("work", full.particles.work, stopped.particles.work, 4 * sizeof(double));
    CHECK_NEAR(stopped.particles.snapshot_time[stopped.particles.snapshot_count - 1], 0.5, 0.0);
    pdmc_results_clear(&full);
    pdmc_results_clear(&stopped);
    limit = 0;
    pdmc_study study;
    read_quasi_static(torn, &study);
    const pdmc_run_options none = {.threads = 1, .progress = stop_at, .context = &limit};
    CHECK_STATUS(pdmc_run(&study, &none, &stopped), PDMC_ERR_INTERRUPTED);
    pdmc_study_clear(&study);
}

// Two rows of four nodes, with bonds of one spacing alone: c V^2 = 9 E / (pi d^3 t) V^2, pulled apart by 0.04.
static const char drawn[] =
    "grid = { dimension = 2; spacing = 1.0; horizon_ratio = 1.0; offset = [0.5, 0.5]; volume = \"whole\"; };\n"
    "materials = ( { density = 2.0; youngs_modulus = 3.0; critical_stretch = %s; } );\n"
    "bodies = ( { from = [0, 0]; to = [4, 2]; } );\n"
    "conditions = ( { name = \"foot\"; prescribed = \"displacement\"; from = [0, 0]; to = [4, 1]; x = 0; y = 0; },\n"
    "               { name = \"head\"; prescribed = \"displacement\"; from = [0, 1]; to = [4, 2]; x = 0; y = 0.04; } "
    ");\n"
    "loading = { steps = 40; }; record = { snapshots = 2; };\n"
    "random = ( %s ); sampling = { samples = 60; };";

static void run_drawn(const char *stretch, const char *random, int threads, pdmc_results *results)
{
    char text[2048];
    snprintf(text, sizeof text, drawn, stretch, random);
    run_quasi_static(text, &(pdmc_run_options){.threads = threads}, results);
}

// Factors of load and modulus are factors of the force; statistics are counted again; the file has them.
static void samples_are_of_the_largest_force(void **state)
{
    (void)state;
    const double whole = 4 * 9.0 * 3.0 / M_PI * 0.04;
    double mean = 0.0;
    pdmc_results r, read;
    run_drawn("1.0", "{ quantity = \"load\"; variation = 0.1; }, { quantity = \"youngs_modulus\"; variation = 0.2; }",
              1, &r);
    const pdmc_ensemble_results *e = &r.ensemble;
    assert_int_equal(e->sample_count, 60);
    assert_int_equal(e->condition_count, 2);
    assert_int_equal(e->failed_count, 0);
    for (int s = 0; s < 60; s++) {
        for (int c = 0; c < 2; c++)
            CHECK_NEAR(e->largest_force[2 * s + c], whole * e->load[s] * e->youngs_modulus[s], 1e-12 * whole);
        CHECK_NEAR(e->load_of_force[2 * s], 1.0, 0.0);
        mean += e->largest_force[2 * s + 1] / 60.0;
    }
    CHECK_NEAR(e->mean_force[1].value, mean, 1e-13 * whole);
    assert_true(e->mean_force[1].lower < mean && mean < e->mean_force[1].upper);
    CHECK_OK(pdmc_results_write(&r, "drawn.h5", true));
    CHECK_OK(pdmc_results_read("drawn.h5", &read));
    assert_same("largest_force", e->largest_force, read.ensemble.largest_force, 120 * sizeof(double));
    assert_same("load_of_force", e->load_of_force, read.ensemble.load_of_force, 120 * sizeof(double));
    assert_same("mean_force", e->mean_force, read.ensemble.mean_force, 2 * sizeof *e->mean_force);
    assert_same("force_quantiles", e->force_quantiles, read.ensemble.force_quantiles, 6 * sizeof *e->mean_force);
    pdmc_results_clear(&read);
    pdmc_results_clear(&r);
}

// Of bonds that break one after the other the largest force is before the end. The bits are those of one thread.
static void samples_break(void **state)
{
    (void)state;
    pdmc_results one, two;
    const char *random = "{ quantity = \"bond_strength\"; distribution = \"weibull\"; variation = 0.3; }";
    run_drawn("0.015", random, 1, &one);
    run_drawn("0.015", random, 2, &two);
    const pdmc_ensemble_results *e = &one.ensemble;
    assert_same("largest_force", e->largest_force, two.ensemble.largest_force, 120 * sizeof(double));
    for (int s = 0; s < 60; s++) assert_true(e->load_of_force[2 * s] > 0.0 && e->load_of_force[2 * s] < 1.0);
    assert_true(e->force_quantiles[0].value < e->force_quantiles[1].value);
    pdmc_results_clear(&one);
    pdmc_results_clear(&two);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_bond_in_closed_form),
        cmocka_unit_test(a_plate_is_torn),
        cmocka_unit_test(results_do_not_depend_on_threads),
        cmocka_unit_test(what_finds_no_rest_keeps_the_last_state),
        cmocka_unit_test(a_stopped_run_is_a_prefix),
        cmocka_unit_test(samples_are_of_the_largest_force),
        cmocka_unit_test(samples_break),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
