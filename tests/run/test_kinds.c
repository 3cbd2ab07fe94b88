// SPDX-License-Identifier: GPL-3.0-or-later

/// Studies that lack something: cracks, random quantities, one of the two. Each goes from its file to the JSON of its
/// results and back.

#include "run/studies.h"

#include "pdmc/results.h"
#include "pdmc/views.h"

#include <jansson.h>

static const pdmc_run_options options = {.threads = 2};

// Runs a study, sends its results through a file, and parses what the views make of them.
static json_t *run_to_json(const char *cracks, const char *random, pdmc_results *results)
{
    json_error_t error;
    run_study(cracks, random, "samples = 70;", &options, results);
    CHECK_OK(pdmc_results_write(results, "results.h5", true));
    pdmc_results_clear(results);
    CHECK_OK(pdmc_results_read("results.h5", results));
    FILE *stream = fopen("results.json", "w");
    assert_non_null(stream);
    CHECK_OK(pdmc_view_json(results, stream));
    assert_int_equal(fclose(stream), 0);
    json_t *json = json_load_file("results.json", 0, &error);
    if (!json) fail_msg("%d:%d: %s", error.line, error.column, error.text);
    return json;
}

static void expect_reals(const json_t *object, const char *key, size_t count)
{
    const json_t *array = json_object_get(object, key);
    if (json_array_size(array) != count) fail_msg("%s: %zu values, want %zu", key, json_array_size(array), count);
    for (size_t i = 0; i < count; i++) assert_true(json_is_number(json_array_get(array, i)));
}

static void expect_number(const json_t *object, const char *key)
{
    if (!json_is_number(json_object_get(object, key))) fail_msg("%s: not a number", key);
}

static void expect_energy(const json_t *tip, const char *measure)
{
    const json_t *energy = json_object_get(tip, measure), *quantiles = json_object_get(energy, "quantiles");
    expect_reals(energy, "mean", 8);
    expect_reals(energy, "standard_deviation", 8);
    assert_int_equal(json_object_size(quantiles), PDMC_QUANTILES);
    const char *level;
    const json_t *values;
    json_object_foreach((json_t *)quantiles, level, values) expect_reals(quantiles, level, 8);
}

// The keys that programs may count on.
static void expect_tip(const json_t *tip, const char *name, double x)
{
    const json_t *nominal = json_object_get(tip, "nominal"), *probability = json_object_get(tip, "probability");
    assert_string_equal(json_string_value(json_object_get(tip, "name")), name);
    expect_reals(tip, "position", 2);
    CHECK_NEAR(json_number_value(json_array_get(json_object_get(tip, "position"), 0)), x, 1e-15);
    expect_number(nominal, "K_I");
    expect_number(nominal, "K_II");
    expect_reals(tip, "angles", 8);
    CHECK_NEAR(json_number_value(json_array_get(json_object_get(tip, "angles"), 1)), 0.785398163397448, 1e-14);
    for (int m = 0; m < PDMC_MEASURES; m++) expect_energy(tip, pdmc_measure_names[m]);
    assert_true(json_is_object(json_object_get(tip, "direction")));
    expect_number(probability, "value");
    expect_number(probability, "lower");
    expect_number(probability, "upper");
}

static void expect_study(const json_t *json, size_t tips)
{
    assert_int_equal(json_integer_value(json_object_get(json, "samples")), 70);
    assert_int_equal(json_integer_value(json_object_get(json, "failed")), 0);
    const json_t *array = json_object_get(json, "tips");
    assert_int_equal(json_array_size(array), tips);
    if (tips == 0) return;
    expect_tip(json_array_get(array, 0), "c.from", -0.5);
    expect_tip(json_array_get(array, 1), "c.to", 0.5);
}

// Whether the samples of a quantity differ.
static bool varies(const double x[], int count)
{
    for (int i = 1; i < count; i++)
        if (x[i] != x[0]) return true;
    return false;
}

static void run_kind(const char *cracks, const char *random, size_t tips, bool modulus, bool load)
{
    pdmc_results results;
    json_t *json = run_to_json(cracks, random, &results);
    expect_study(json, tips);
    assert_int_equal(results.bin_count, modulus ? 100 : 0);
    assert_int_equal(varies(results.effective_modulus, 70), modulus);
    assert_int_equal(varies(results.load_factor, 70), load);
    for (int s = 0; s < 70 && tips > 0; s++) {
        const double *k = &results.stress_intensity[4 * s], *at_mean = results.tips[0].stress_intensity;
        const double factor = results.load_factor[s];
        CHECK_NEAR(k[0], factor * at_mean[0], modulus ? 0.2 : 1e-9); // the modulus alone changes K but little
    }
    json_decref(json);
    pdmc_results_clear(&results);
}

static void everything(void **state)
{
    (void)state;
    run_kind(ONE_CRACK, BOTH, 2, true, true);
}

static void without_cracks(void **state)
{
    (void)state;
    run_kind("", BOTH, 0, true, true);
}

static void without_random_quantities(void **state)
{
    (void)state;
    run_kind(ONE_CRACK, "", 2, false, false);
}

static void only_the_micromodulus(void **state)
{
    (void)state;
    run_kind(ONE_CRACK, MICROMODULUS, 2, true, false);
}

static void only_the_load(void **state)
{
    (void)state;
    run_kind(ONE_CRACK, LOAD, 2, false, true);
}

static void nothing_at_all(void **state)
{
    (void)state;
    run_kind("", "", 0, false, false);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(everything),
        cmocka_unit_test(without_cracks),
        cmocka_unit_test(without_random_quantities),
        cmocka_unit_test(only_the_micromodulus),
        cmocka_unit_test(only_the_load),
        cmocka_unit_test(nothing_at_all),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
