// SPDX-License-Identifier: GPL-3.0-or-later

/// A study with a control against its two studies by themselves.

#include "run/studies.h"

#include <gsl/gsl_statistics.h>

enum { OWN = 40, CHEAPER = 400, ANGLES = 8 };

#define FINE ONE_CRACK
#define CONTROL "control = { method = \"kansa\"; spacing = 1.0; samples = 400; };"
#define SAMPLING "samples = 40; inverse = \"direct\";"

static const pdmc_run_options two_threads = {.threads = 2};

/// The cheaper study by itself: another spacing.
static void run_cheaper(pdmc_results *results)
{
    pdmc_study study;
    read_study(FINE, BOTH, "samples = 400;", &study);
    study.problem.solver.spacing = 1.0;
    study.problem.solver.shape = 6.0; // the default of that spacing
    CHECK_OK(pdmc_run(&study, &two_threads, results));
    pdmc_study_clear(&study);
}

static pdmc_results both, cheaper; // a study with its control, and the control by itself

static int run_both(void **state)
{
    if (enter_folder(state) != 0) return -1;
    run_study(FINE CONTROL, BOTH, SAMPLING, &two_threads, &both);
    run_cheaper(&cheaper);
    return 0;
}

static int clear_both(void **state)
{
    pdmc_results_clear(&both);
    pdmc_results_clear(&cheaper);
    return leave_folder(state);
}

static void column(const pdmc_results *r, int samples, int direction, double x[])
{
    const int directions = r->tip_count * r->angle_count;
    for (int s = 0; s < samples; s++) x[s] = r->energy[r->measure][s * directions + direction];
}

static void means_are_those_of_the_regression(void **state)
{
    (void)state;
    double x[OWN], c[CHEAPER];
    assert_int_equal(both.control.tip_count, 2);
    assert_true(both.control.samples == CHEAPER && both.control.failed == 0.0);
    for (int d = 0; d < 2 * ANGLES; d++) {
        column(&both, OWN, d, x);
        column(&cheaper, CHEAPER, d, c);
        const double slope = gsl_stats_covariance(x, 1, c, 1, OWN) / gsl_stats_variance(c, 1, OWN);
        const double shift = gsl_stats_mean(c, 1, OWN) - gsl_stats_mean(c, 1, CHEAPER);
        const double want = gsl_stats_mean(x, 1, OWN) - slope * shift, size = gsl_stats_sd(x, 1, OWN);
        CHECK_NEAR(both.control.mean[d].value, want, 1e-9 * size);
        CHECK_NEAR(both.control.correlation[d], fabs(gsl_stats_correlation(x, 1, c, 1, OWN)), 1e-9);
        assert_true(both.control.mean[d].lower < want && want < both.control.mean[d].upper);
    }
    assert_true(both.control.correlation[ANGLES] > 0.99 &&
                both.control.mean_gain[ANGLES] > 5.0); // c.to, straight ahead
    assert_true(both.control.advised_samples >= OWN && both.runtime.control > 0.0);
}

/// The event of the cheaper plate is at the ratio of the energies of the mean plates.
static void probabilities_are_stratified(void **state)
{
    (void)state;
    for (int t = 0; t < 2; t++) {
        size_t hits[2] = {0}, trials[2] = {0}, known = 0;
        double own = 0.0, other = 0.0;
        for (int a = 0; a < ANGLES; a++) {
            own = fmax(own, both.nominal_griffith_energy[t * ANGLES + a]);
            other = fmax(other, cheaper.nominal_griffith_energy[t * ANGLES + a]);
        }
        for (int s = 0; s < CHEAPER; s++) {
            const bool control = cheaper.largest_energy[PDMC_MEASURE_GRIFFITH][2 * s + t] > other / own * 2.0;
            known += control;
            if (s >= OWN) continue;
            trials[control]++;
            hits[control] += both.largest_energy[PDMC_MEASURE_GRIFFITH][2 * s + t] > 2.0;
        }
        const pdmc_estimate want = pdmc_statistics_stratified_proportion(hits, trials, known, CHEAPER, 0.95);
        assert_memory_equal(&both.control.probability[t], &want, sizeof want);
        assert_true(both.control.probability_gain[t] > 1.0);
    }
}

/// The samples of the study are those without a control, and threads change no bit.
static void nothing_else_changes(void **state)
{
    (void)state;
    pdmc_results without, other;
    const pdmc_run_options one_thread = {.threads = 1};
    run_study(FINE CONTROL, BOTH, SAMPLING, &one_thread, &other);
    run_study(FINE, BOTH, SAMPLING, &two_threads, &without);
    assert_int_equal(without.control.tip_count, 0);
    assert_same("probability", both.probability, without.probability, 2 * sizeof(pdmc_estimate));
    assert_same("energies", both.energy[0], without.energy[0], OWN * 2 * ANGLES * sizeof(double));
    assert_same("controlled means", both.control.mean, other.control.mean, 2 * ANGLES * sizeof(pdmc_estimate));
    assert_same("controlled P", both.control.probability, other.control.probability, 2 * sizeof(pdmc_estimate));
    pdmc_results_clear(&other);
    pdmc_results_clear(&without);
}

static bool stop_after_own(void *context, int done, int total)
{
    (void)context;
    return total == 100 || done == 0; // the study's own are let through
}

static void a_stop_keeps_what_there_is(void **state)
{
    (void)state;
    pdmc_results results;
    const pdmc_run_options stopped = {.threads = 1, .progress = stop_after_own};
    run_study(FINE "control = { spacing = 1.0; samples = 100000; };", BOTH, "samples = 100;", &stopped, &results);
    assert_true(results.status == PDMC_RUN_INTERRUPTED && results.sample_count == 100);
    assert_int_equal(results.control.tip_count, 2);
    assert_true(results.control.samples > 100.0 && results.control.samples < 100000.0);
    pdmc_results_clear(&results);
}

static void expect_refusal(const char *top, const char *random, const char *sampling, const char *message)
{
    pdmc_study study;
    char text[2048];
    snprintf(
        text, sizeof text,
        "plate = { width = 5.0; height = 5.0; };\nmaterial = { youngs_modulus = 1.5; fracture_energy = 2.0; };\n%s\n"
        "loads = ( { side = \"top\"; traction = [0, 1]; }, { side = \"bottom\"; traction = [0, -1]; } );\n"
        "solver = { spacing = 0.5; };\nrandom = ( %s );\nsampling = { %s };\n",
        top, random, sampling);
    CHECK_STATUS(read_text(text, &study), PDMC_ERR_CONFIG);
    if (!strstr(pdmc_last_error(), message)) fail_msg("\"%s\" does not say \"%s\"", pdmc_last_error(), message);
}

static void what_cannot_be_is_refused(void **state)
{
    (void)state;
    expect_refusal(FINE CONTROL, "", SAMPLING, "control.samples: nothing is random");
    expect_refusal(FINE CONTROL, BOTH, "samples = 400;", "control.samples: 400 is not allowed, must be more than");
    expect_refusal(FINE CONTROL, BOTH, "samples = 2;", "must be from 3 to the 20000");
    expect_refusal(FINE CONTROL, BOTH, "samples = 40; keep = 30;", "must be from 3 to the 30");
    expect_refusal(FINE CONTROL, BOTH, "samples = 32; design = \"sobol\";", "a control needs design = \"monte_carlo\"");
    expect_refusal(FINE "control = { spacing = 2.0; samples = 400; };", BOTH, SAMPLING, "2 is too large");
    expect_refusal(FINE "control = { method = \"bond\"; samples = 400; };", BOTH, SAMPLING, "is too short");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(means_are_those_of_the_regression),
        cmocka_unit_test(probabilities_are_stratified),
        cmocka_unit_test(nothing_else_changes),
        cmocka_unit_test(a_stop_keeps_what_there_is),
        cmocka_unit_test(what_cannot_be_is_refused),
    };
    return cmocka_run_group_tests(tests, run_both, clear_both);
}
