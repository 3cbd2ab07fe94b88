// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/captured.h"

#include "results/made_up.h"

#include <jansson.h>
#include <string.h>

static json_t *parsed(const pdmc_results *results)
{
    json_error_t error;
    char *text = captured(pdmc_view_json, results);
    json_t *object = json_loads(text, JSON_REJECT_DUPLICATES, &error);
    if (!object) fail_msg("%s at column %d of %.80s", error.text, error.column, text);
    free(text);
    return object;
}

static void it_has_what_programs_ask(void **state)
{
    (void)state;
    pdmc_results results = made_up_results(made_up_small);
    json_t *object = parsed(&results), *tips = json_object_get(object, "tips"), *tip = json_array_get(tips, 0);
    assert_string_equal(json_string_value(json_object_get(object, "title")), results.title);
    assert_int_equal(json_integer_value(json_object_get(object, "samples")), 40);
    assert_int_equal(json_integer_value(json_object_get(object, "kept")), 40);
    assert_int_equal(json_integer_value(json_object_get(object, "failed")), 2);
    assert_int_equal(json_integer_value(json_object_get(object, "seed")), 20110614);
    assert_string_equal(json_string_value(json_object_get(object, "measure")), "griffith_energy");
    assert_string_equal(json_string_value(json_object_get(json_object_get(object, "units"), "energy")), "N/cm");
    assert_int_equal(json_array_size(tips), 2);
    assert_string_equal(json_string_value(json_object_get(tip, "name")), "center.from");

    json_t *energy = json_object_get(tip, "bond_energy"), *mean = json_object_get(energy, "mean");
    const pdmc_energy_statistics *s = &results.statistics[PDMC_MEASURE_BOND];
    assert_int_equal(json_array_size(mean), results.angle_count);
    CHECK_NEAR(json_real_value(json_array_get(mean, 3)), s->mean[3].value, 0.0);
    json_t *interval = json_array_get(json_object_get(energy, "mean_interval"), 3);
    CHECK_NEAR(json_real_value(json_array_get(interval, 0)), s->mean[3].lower, 0.0);
    CHECK_NEAR(json_real_value(json_array_get(interval, 1)), s->mean[3].upper, 0.0);
    json_t *median = json_object_get(json_object_get(energy, "quantiles"), "0.50");
    CHECK_NEAR(json_real_value(json_array_get(median, 3)), s->quantiles[3 * PDMC_QUANTILES + 1].value, 0.0);
    json_t *direction = json_object_get(tip, "direction");
    assert_int_equal(json_array_size(json_object_get(direction, "upper")), results.angle_count);
    CHECK_NEAR(json_real_value(json_object_get(json_object_get(tip, "probability"), "lower")),
               results.probability[0].lower, 0.0);
    assert_int_equal(json_integer_value(json_object_get(json_object_get(object, "solver"), "rank")), 650);
    CHECK_NEAR(json_real_value(json_object_get(json_object_get(object, "runtime"), "total")), 6.7, 0.0);
    CHECK_NEAR(json_real_value(json_object_get(json_object_get(object, "runtime"), "peak_memory")), 8.1e7, 0.0);
    json_decref(object);
    pdmc_results_clear(&results);
}

static void check_estimate(const json_t *object, const char *key, const pdmc_estimate *want)
{
    const json_t *got = json_object_get(object, key);
    CHECK_NEAR(json_real_value(json_object_get(got, "value")), want->value, 0.0);
    CHECK_NEAR(json_real_value(json_object_get(got, "lower")), want->lower, 0.0);
    CHECK_NEAR(json_real_value(json_object_get(got, "upper")), want->upper, 0.0);
}

static void the_models_error_is_there(void **state)
{
    (void)state;
    pdmc_results results = made_up_results(made_up_small);
    results.accuracy.mean_error[PDMC_MEASURE_GRIFFITH] = 0.003;
    results.accuracy.quantile_error[PDMC_MEASURE_GRIFFITH][2] = 0.006;
    results.accuracy.quantile_error[PDMC_MEASURE_BOND][1] = INFINITY;
    json_t *object = parsed(&results), *accuracy = json_object_get(object, "accuracy");
    const json_t *griffith = json_object_get(accuracy, "griffith_energy_model_error");
    const json_t *bond = json_object_get(accuracy, "bond_energy_model_error");
    CHECK_NEAR(json_real_value(json_object_get(griffith, "mean")), 0.003, 0.0);
    CHECK_NEAR(json_real_value(json_object_get(griffith, "0.95")), 0.006, 0.0);
    assert_true(json_is_null(json_object_get(bond, "0.50")));
    json_decref(object);
    pdmc_results_clear(&results);
}

static void rare_growth_is_there(void **state)
{
    (void)state;
    pdmc_results results = made_up_results(made_up_small);
    const pdmc_reliability_results *r = &results.reliability;
    results.reliability.groups[0].importance = NAN;
    json_t *object = parsed(&results), *reliability = json_object_get(object, "reliability");
    const json_t *methods = json_object_get(reliability, "methods"), *subset = json_array_get(methods, 1);
    const json_t *quantities = json_object_get(reliability, "quantities"), *load = json_array_get(quantities, 0);
    const json_t *first_order = json_object_get(reliability, "first_order");
    assert_int_equal(json_array_size(methods), 2);
    assert_string_equal(json_string_value(json_object_get(subset, "method")), "subset simulation");
    check_estimate(subset, "probability", &r->records[1].found.probability);
    check_estimate(subset, "index", &r->records[1].found.index);
    CHECK_NEAR(json_real_value(json_object_get(subset, "evaluations")), 153160.0, 0.0);
    CHECK_NEAR(json_real_value(json_object_get(subset, "failed")), 2.0, 0.0);
    CHECK_NEAR(json_real_value(json_object_get(subset, "coefficient_of_variation")), 0.047, 0.0);
    assert_true(json_is_true(json_object_get(subset, "complete")));
    assert_int_equal(json_array_size(quantities), 2);
    assert_string_equal(json_string_value(json_object_get(load, "name")), "load");
    check_estimate(load, "first_index", &r->groups[0].first);
    check_estimate(load, "total_index", &r->groups[0].total);
    assert_true(json_is_null(json_object_get(load, "importance")));
    CHECK_NEAR(json_real_value(json_object_get(first_order, "index")), 3.719, 0.0);
    assert_int_equal(json_array_size(json_object_get(first_order, "design_point")), 1 + made_up_small.radial_bins);
    check_estimate(json_array_get(json_object_get(object, "tips"), 1), "conditional_probability",
                   &results.conditional_probability[1]);
    CHECK_NEAR(json_real_value(json_object_get(json_object_get(object, "runtime"), "reliability")), 0.83, 0.0);
    const json_t *tip = json_array_get(json_object_get(object, "tips"), 0), *controlled = json_object_get(tip, "controlled");
    CHECK_NEAR(json_real_value(json_array_get(json_object_get(controlled, "mean"), 1)), results.control.mean[1].value, 0.0);
    CHECK_NEAR(json_real_value(json_array_get(json_object_get(controlled, "mean_gain"), 1)), 86.5, 0.0);
    CHECK_NEAR(json_real_value(json_object_get(json_object_get(controlled, "probability"), "value")), 0.35, 0.0);
    CHECK_NEAR(json_real_value(json_object_get(json_object_get(object, "control"), "samples")), 100000.0, 0.0);
    json_decref(object);
    pdmc_results_clear(&results);
}

static void a_motion_is_there_where_there_is_one(void **state)
{
    (void)state;
    pdmc_results results = made_up_results(made_up_motion);
    json_t *object = parsed(&results), *motion = json_object_get(object, "motion");
    assert_string_equal(json_string_value(json_object_get(object, "kind")), "dynamic");
    assert_string_equal(json_string_value(json_object_get(json_object_get(object, "units"), "work")), "N cm");
    assert_int_equal(json_array_size(json_object_get(motion, "time")), 201);
    CHECK_NEAR(json_real_value(json_array_get(json_object_get(motion, "kinetic"), 7)), results.motion.kinetic[7], 0.0);
    CHECK_NEAR(json_real_value(json_object_get(motion, "balance_error")), 0.0, 1e-15);
    json_t *probes = json_object_get(motion, "probes"), *probe = json_array_get(probes, 1);
    assert_int_equal(json_array_size(probes), 2);
    assert_string_equal(json_string_value(json_object_get(probe, "name")), "probe2");
    assert_string_equal(json_string_value(json_object_get(json_array_get(probes, 0), "side")), "left");
    CHECK_NEAR(json_real_value(json_array_get(json_object_get(probe, "y"), 200)),
               results.motion.displacement[200 * 4 + 3], 0.0);
    json_decref(object);
    pdmc_results_clear(&results);
    results = made_up_results(made_up_small);
    object = parsed(&results);
    assert_string_equal(json_string_value(json_object_get(object, "kind")), "static");
    assert_null(json_object_get(object, "motion"));
    json_decref(object);
    pdmc_results_clear(&results);
}

static void what_is_no_number_is_null(void **state)
{
    (void)state;
    pdmc_results results = made_up_results(made_up_small);
    results.statistics[0].mean[0] = (pdmc_estimate){1.0, -INFINITY, NAN};
    json_t *object = parsed(&results), *tip = json_array_get(json_object_get(object, "tips"), 0);
    json_t *interval = json_array_get(json_object_get(json_object_get(tip, "bond_energy"), "mean_interval"), 0);
    assert_true(json_is_null(json_array_get(interval, 0)));
    assert_true(json_is_null(json_array_get(interval, 1)));
    json_decref(object);
    pdmc_results_clear(&results);
}

static void odd_texts_and_seeds_are_written(void **state)
{
    (void)state;
    pdmc_results results = made_up_results((made_up_size){0});
    results.title[0] = (char)0xff; // not UTF-8
    results.seed = UINT64_MAX;
    json_t *object = parsed(&results);
    assert_int_equal(json_string_value(json_object_get(object, "title"))[0], '?');
    assert_string_equal(json_string_value(json_object_get(object, "seed")), "18446744073709551615");
    assert_int_equal(json_array_size(json_object_get(object, "tips")), 0);
    json_decref(object);
    pdmc_results_clear(&results);
}

static void a_full_disk_is_seen(void **state)
{
    (void)state;
    pdmc_results results = made_up_results(made_up_small);
    check_full(pdmc_view_json, &results);
    pdmc_results_clear(&results);
}

static long countdown;

static void *malloc_until(size_t size)
{
    return countdown-- > 0 ? malloc(size) : NULL;
}

/// jansson has its own memory: each of its allocations is refused in turn.
static void refuse_memory(made_up_size size)
{
    pdmc_results results = made_up_results(size);
    FILE *stream = fopen("/dev/null", "w");
    pdmc_status status = PDMC_ERR_NOMEM;
    json_set_alloc_funcs(malloc_until, free);
    for (long allowed = 0; status == PDMC_ERR_NOMEM && allowed < 10000; allowed++) {
        countdown = allowed;
        status = pdmc_view_json(&results, stream);
    }
    json_set_alloc_funcs(malloc, free);
    if (status != PDMC_OK) fail_msg("%s", pdmc_last_error());
    fclose(stream);
    pdmc_results_clear(&results);
}

static void refused_memory_is_reported(void **state)
{
    (void)state;
    refuse_memory((made_up_size){.cracks = 1, .angles = 2, .samples = 3, .histogram_bins = 1});
    refuse_memory((made_up_size){.times = 2, .probes = 2});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_has_what_programs_ask),
        cmocka_unit_test(what_is_no_number_is_null),
        cmocka_unit_test(odd_texts_and_seeds_are_written),
        cmocka_unit_test(a_full_disk_is_seen),
        cmocka_unit_test(the_models_error_is_there),
        cmocka_unit_test(rare_growth_is_there),
        cmocka_unit_test(a_motion_is_there_where_there_is_one),
        cmocka_unit_test(refused_memory_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
