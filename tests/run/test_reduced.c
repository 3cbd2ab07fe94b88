// SPDX-License-Identifier: GPL-3.0-or-later

/// Studies of a random stiffness field by the reduced model, against conjugate gradients.

#include "run/studies.h"

#include <math.h>

enum { SAMPLES = FINEST_LEFT_OUT ? 16 : 64 };

static void run_field(int modes, const char *variation, const char *sampling, pdmc_results *results)
{
    const pdmc_run_options options = {.threads = 2};
    char random[256], all[256];
    snprintf(random, sizeof random,
             "{ quantity = \"stiffness\"; correlation_length = 1.0; modes = %d; variation = %s; }, " LOAD, modes,
             variation);
    snprintf(all, sizeof all, "samples = %d; %s", SAMPLES, sampling);
    run_study("cracks = ( { name = \"c\"; from = [-0.5, 0.0]; to = [0.5, 0.2]; } );\n"
              "energy = { angles = 8; measure = \"griffith\"; tips = [\"c.to\"]; };",
              random, all, &options, results);
}

// The largest relative difference of the largest energies; samples that failed must be the same ones.
static double largest_difference(const pdmc_results *a, const pdmc_results *b, pdmc_measure measure)
{
    double worst = 0.0;
    assert_same("failure", a->failure, b->failure, SAMPLES);
    for (int k = 0; k < SAMPLES * a->tip_count; k++)
        if (a->failure[k / a->tip_count] == PDMC_SAMPLE_OK)
            worst = fmax(worst, fabs(b->largest_energy[measure][k] / a->largest_energy[measure][k] - 1.0));
    return worst;
}

// The tolerance is met at the mean's energies with a margin of 2: of the smallest energies the error may be a larger part.
static void a_field_keeps_the_promise(void **state)
{
    (void)state;
    const double tolerance = 0.01;
    pdmc_results full, reduced;
    if (FINEST_LEFT_OUT) skip();
    run_field(6, "0.15", "inverse = \"krylov\"; tolerance = 1e-10;", &full);
    run_field(6, "0.15", "inverse = \"reduced\"; energy_tolerance = 0.01;", &reduced);
    for (int m = 0; m < PDMC_MEASURES; m++) {
        const double worst = largest_difference(&full, &reduced, (pdmc_measure)m);
        print_message("%.0f unknowns, %s: error at most %.1e, said to be %.1e at most, %.1e typically\n",
                      reduced.accuracy.reduced_unknowns, pdmc_measure_names[m], worst, reduced.accuracy.energy_error[m],
                      reduced.accuracy.typical_error[m]);
        assert_true(worst <= reduced.accuracy.energy_error[m]);
    }
    assert_true(reduced.accuracy.energy_error[PDMC_MEASURE_GRIFFITH] < 2.0 * tolerance);
    for (int t = 0; t < full.tip_count; t++) CHECK_NEAR(reduced.probability[t].value, full.probability[t].value, 0.0);
    pdmc_results_clear(&reduced);
    pdmc_results_clear(&full);
}

// A normal stiffness that is negative in places has no bound: such samples are solved in full, as well or badly as without a
// reduced model.
static void samples_without_a_bound_are_solved_in_full(void **state)
{
    (void)state;
    pdmc_results full, reduced;
    int failed = 0;
    run_field(12, "0.5", "inverse = \"krylov\"; tolerance = 1e-10;", &full);
    run_field(12, "0.5", "inverse = \"reduced\"; energy_tolerance = 0.1; tolerance = 1e-10;", &reduced);
    for (int s = 0; s < SAMPLES; s++) failed += full.failure[s] != PDMC_SAMPLE_OK;
    const double worst = largest_difference(&full, &reduced, PDMC_MEASURE_GRIFFITH);
    print_message("%d of %d samples failed, %.0f solved in full; error at most %.1e, said to be %.1e\n", failed,
                  SAMPLES, reduced.accuracy.solved_in_full, worst,
                  reduced.accuracy.energy_error[PDMC_MEASURE_GRIFFITH]);
    assert_true(reduced.accuracy.solved_in_full > failed);
    assert_true(isfinite(reduced.accuracy.energy_error[PDMC_MEASURE_GRIFFITH]));
    assert_true(worst <= reduced.accuracy.energy_error[PDMC_MEASURE_GRIFFITH]);
    pdmc_results_clear(&full);
    pdmc_results_clear(&reduced);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_field_keeps_the_promise),
        cmocka_unit_test(samples_without_a_bound_are_solved_in_full),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
