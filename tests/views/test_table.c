// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/captured.h"

#include "results/made_up.h"

#include <locale.h>
#include <string.h>

enum { COLUMNS = 100 };

static void check_width(const char *text)
{
    for (const char *line = text; *line;) {
        const size_t length = strcspn(line, "\n");
        if (length > COLUMNS) fail_msg("%zu columns: %.*s", length, (int)length, line);
        line += length + (line[length] == '\n');
    }
}

static void it_says_what_a_person_asks(void **state)
{
    (void)state;
    pdmc_results results = made_up_results(made_up_small);
    char *text = captured(pdmc_view_table, &results);
    const char *const parts[] = {
        "Centre crack under uncertain tension\n",
        "40 samples from seed 20110614, 2 failed",
        "the Griffith energy decides",
        "G_c = 0.2 N/cm",
        "\ncenter.from at (-0.5, 0) cm, straight ahead 180 deg",
        "K_I = 1.323 +- 0.00041",
        "N/cm^(3/2)",
        "P(G > G_c) = ",
        "most likely direction 180 deg 100.0 %",
        "rank 650\n",
        "horizon 0.1",
        "sampling 3.80",
        "memory   81 MB at most\n",
    };
    for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++)
        if (!strstr(text, parts[i])) fail_msg("the table does not say \"%s\":\n%s", parts[i], text);
    assert_null(strstr(text, "INTERRUPTED"));
    assert_null(strstr(text, "DEFICIENT"));
    free(text);
    results.status = PDMC_RUN_INTERRUPTED;
    results.solver.rank--;
    text = captured(pdmc_view_table, &results);
    assert_non_null(strstr(text, "INTERRUPTED"));
    assert_non_null(strstr(text, "rank 649 (DEFICIENT)"));
    free(text);
    pdmc_results_clear(&results);
}

static void expect_parts(const pdmc_results *results, const char *const parts[], size_t count)
{
    char *text = captured(pdmc_view_table, results);
    for (size_t i = 0; i < count; i++)
        if (!strstr(text, parts[i])) fail_msg("the table does not say \"%s\":\n%s", parts[i], text);
    check_width(text);
    free(text);
}

#define EXPECT_PARTS(results, ...)                                                                                     \
    do {                                                                                                               \
        const char *const parts_[] = {__VA_ARGS__};                                                                    \
        expect_parts((results), parts_, sizeof parts_ / sizeof parts_[0]);                                             \
    } while (0)

static void rare_growth_is_told_by_every_method(void **state)
{
    (void)state;
    pdmc_results results = made_up_results(made_up_small);
    pdmc_reliability_results *r = &results.reliability;
    EXPECT_PARTS(&results, "  P(G > G_c) = 0.31 [0.303, 0.317] with the load integrated analytically\n",
                 "\ngrowth of any tip, and the margin log G / G_c\n",
                 "first order          P = 0.0001, index 3.719 after 22 points; no error known\n",
                 "importance sampling  P = 0.0001014 [9.126e-05, 0.0001115], index 3.7 [3.6, 3.8]\n",
                 "coefficient of variation 0.047 after 4000 points\n", "after 153160 points, 2 failed\n",
                 "  load                     0.95       0.95 [0.93, 0.97]               0.96 [0.94, 0.98]\n",
                 "rare growth 0.83, ");
    r->records[0].complete = 0;
    r->records[1].found.probability.lower = 2e-4;
    r->first_order_index = NAN;
    r->solved_in_full = 17.0;
    for (int g = 0; g < r->group_count; g++) r->groups[g].total = r->groups[g].first = (pdmc_estimate){NAN, NAN, NAN};
    for (int t = 0; t < results.tip_count; t++) results.conditional_probability[t].value = NAN;
    EXPECT_PARTS(&results, "no design point found after 22 points\n", "after 4000 points, NOT CONVERGED\n",
                 "  THE INTERVALS ARE APART: ", "  load                     0.95\n", "  17 points solved in full\n");
    char *text = captured(pdmc_view_table, &results);
    assert_null(strstr(text, "integrated"));
    assert_null(strstr(text, "Sobol'"));
    free(text);
    pdmc_results_clear(&results);
}

static void a_control_is_beside_what_it_controls(void **state)
{
    (void)state;
    pdmc_results results = made_up_results(made_up_small);
    char want[200];
    const pdmc_estimate *mean = &results.control.mean[results.angle_count - 1]; // the largest, at the last angle
    snprintf(want, sizeof want, "  mean Griffith at %.4g deg = %.4g [%.4g, %.4g], worth %.4g samples (R 0.",
             results.angles[results.angle_count - 1] * 180.0 / 3.14159265358979, mean->value, mean->lower, mean->upper,
             results.sample_count * results.control.mean_gain[results.angle_count - 1]);
    EXPECT_PARTS(&results, want, "  P(G > G_c) = 0.35 [0.33, 0.37], worth 128 samples with the control\n", "control  100000 samples of a cheaper",
                 "with some 5.1e+04 of them\n");
    results.control.tip_count = 0;
    char *text = captured(pdmc_view_table, &results);
    assert_null(strstr(text, "control"));
    free(text);
    results.control.tip_count = results.tip_count;
    pdmc_results_clear(&results);
}

static void the_models_error_is_beside_the_intervals(void **state)
{
    (void)state;
    pdmc_results results = made_up_results(made_up_small);
    results.accuracy.reduced_unknowns = 30.0;
    results.accuracy.mean_error[PDMC_MEASURE_BOND] = 0.02;
    results.accuracy.mean_error[PDMC_MEASURE_GRIFFITH] = 0.003;
    for (int q = 0; q < PDMC_QUANTILES; q++) {
        results.accuracy.quantile_error[PDMC_MEASURE_BOND][q] = INFINITY;
        results.accuracy.quantile_error[PDMC_MEASURE_GRIFFITH][q] = 0.004 + 0.001 * q;
    }
    EXPECT_PARTS(&results, "         bond      mean 0.02, 5 % inf, 50 % inf, 95 % inf\n",
                 "         Griffith  mean 0.003, 5 % 0.004, 50 % 0.005, 95 % 0.006\n",
                 "none in the share of G > G_c");
    results.accuracy = pdmc_no_accuracy;
    char *text = captured(pdmc_view_table, &results);
    assert_null(strstr(text, "model error"));
    free(text);
    pdmc_results_clear(&results);
}

static void a_random_toughness_has_a_range(void **state)
{
    (void)state;
    pdmc_results results = made_up_results(made_up_small);
    for (int t = 0; t < 2; t++) {
        results.sample_fracture_energy[2 * 3 + t] = 0.1;
        results.sample_fracture_energy[2 * 4 + t] = 0.25;
    }
    EXPECT_PARTS(&results, "decides P(G > G_c) and the direction; G_c from 0.1 to 0.25 N/cm\n");
    results.sample_fracture_energy[2 * 4] = 0.24;
    EXPECT_PARTS(&results, "decides P(G > G_c) and the direction; G_c of each tip from 0.1 to 0.25 N/cm\n");
    pdmc_results_clear(&results);
}

static void a_motion_ends_somewhere(void **state)
{
    (void)state;
    pdmc_results results = made_up_results(made_up_motion);
    results.status = PDMC_RUN_INTERRUPTED;
    char *text = captured(pdmc_view_table, &results);
    const char *const parts[] = {
        "INTERRUPTED: these are the steps",
        "a motion of 200 time steps",
        "at 30 ms, load factor 1",
        "work 1.004 = kinetic 6.1e-05 + elastic 0.5037 + dissipated 0.4999 N cm",
        "  probe1          left           0         0",
        "probes, in cm and ms",
    };
    for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++)
        if (!strstr(text, parts[i])) fail_msg("the table does not say \"%s\":\n%s", parts[i], text);
    assert_null(strstr(text, "P(G"));
    check_width(text);
    free(text);
    pdmc_results_clear(&results);
}

static void scale_energies(pdmc_results *results, double factor)
{
    for (int m = 0; m < PDMC_MEASURES; m++)
        for (int i = 0; i < results->tip_count * results->angle_count; i++) {
            pdmc_energy_statistics *s = &results->statistics[m];
            pdmc_estimate *const estimates[] = {&s->mean[i], &s->standard_deviation[i], &s->quantiles[3 * i],
                                                &s->quantiles[3 * i + 1], &s->quantiles[3 * i + 2]};
            for (int e = 0; e < 5; e++) {
                estimates[e]->value *= factor;
                estimates[e]->lower *= factor;
                estimates[e]->upper *= factor;
            }
        }
}

static void it_fits_whatever_the_numbers(void **state)
{
    (void)state;
    const double factors[] = {1.0, 1e-9, 1e3, 1e9};
    for (size_t i = 0; i < sizeof factors / sizeof factors[0]; i++) {
        pdmc_results results = made_up_results(made_up_paper);
        scale_energies(&results, factors[i]);
        for (int k = 0; k < results.tip_count * results.angle_count; k++)
            results.nominal_griffith_energy[k] *= factors[i];
        for (int k = 0; k < results.tip_count * results.angle_count; k++)
            results.nominal_bond_energy_tensile[k] *= factors[i];
        results.seed = UINT64_MAX;
        results.reliability.records[0].found.probability = (pdmc_estimate){1.234567e-12, 1.123456e-12, 1.345678e-12};
        results.reliability.groups[0].first = (pdmc_estimate){-1.234567e-12, -1.345678e-12, -1.123456e-12};
        results.reliability.groups[0].total = results.reliability.groups[0].first;
        for (int k = 0; k < results.tip_count * results.angle_count; k++) {
            results.control.mean[k] = (pdmc_estimate){1.234567e-12, 1.123456e-12, 1.345678e-12};
            results.control.correlation[k] = 0.0999321;
            results.control.mean_gain[k] = 1234.567;
        }
        char *text = captured(pdmc_view_table, &results);
        check_width(text);
        free(text);
        pdmc_results_clear(&results);
    }
}

static void odd_results_are_shown(void **state)
{
    (void)state;
    const made_up_size sizes[] = {
        {0},
        {.cracks = 1},
        {.times = 1, .probes = 1},
        {.cracks = 1, .angles = 5, .samples = 3, .failed = 3, .radial_bins = 1, .histogram_bins = 1},
    };
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        pdmc_results results = made_up_results(sizes[i]);
        char *text = captured(pdmc_view_table, &results);
        assert_null(strstr(text, "nan"));
        check_width(text);
        free(text);
        pdmc_results_clear(&results);
    }
}

static void texts_cannot_drive_the_terminal(void **state)
{
    (void)state;
    pdmc_results results = made_up_results(made_up_small);
    strcpy(results.title, "\033[2Jtwo\nlines");
    strcpy(results.tips[0].name, "a\rb");
    char *text = captured(pdmc_view_table, &results);
    assert_memory_equal(text, " [2Jtwo lines\n", 14);
    assert_null(strchr(text, '\033'));
    assert_null(strchr(text, '\r'));
    free(text);
    pdmc_results_clear(&results);
}

static void a_full_disk_is_seen(void **state)
{
    (void)state;
    pdmc_results results = made_up_results(made_up_small);
    check_full(pdmc_view_table, &results);
    pdmc_results_clear(&results);
}

/// Only where the machine has a locale with a comma.
static void numbers_have_a_point_in_every_locale(void **state)
{
    (void)state;
    if (!setlocale(LC_ALL, "de_DE.UTF-8") && !setlocale(LC_ALL, "fr_FR.UTF-8")) skip();
    pdmc_results results = made_up_results(made_up_small);
    char *text = captured(pdmc_view_table, &results);
    assert_non_null(strstr(text, "G_c = 0.2 N/cm"));
    free(text);
    pdmc_results_clear(&results);
    setlocale(LC_ALL, "C");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_says_what_a_person_asks),
        cmocka_unit_test(it_fits_whatever_the_numbers),
        cmocka_unit_test(rare_growth_is_told_by_every_method),
        cmocka_unit_test(a_control_is_beside_what_it_controls),
        cmocka_unit_test(the_models_error_is_beside_the_intervals),
        cmocka_unit_test(a_random_toughness_has_a_range),
        cmocka_unit_test(a_motion_ends_somewhere),
        cmocka_unit_test(odd_results_are_shown),
        cmocka_unit_test(texts_cannot_drive_the_terminal),
        cmocka_unit_test(a_full_disk_is_seen),
        cmocka_unit_test(numbers_have_a_point_in_every_locale),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
