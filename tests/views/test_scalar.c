// SPDX-License-Identifier: GPL-3.0-or-later

/// Views of a scalar study, of errors that were made up: of the second order in the spacing, and of the first in the
/// horizon.

#include "views/captured.h"
#include "views/scalar.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

enum { LEVELS = 3, VALUES = 5 };

static double *row(double first, double factor)
{
    double *values = pdmc_calloc(LEVELS, sizeof *values);
    for (int i = 0; i < LEVELS; i++) values[i] = first * pow(factor, i);
    return values;
}

static pdmc_results made_up_scalar(int dimension, bool varies_horizon)
{
    pdmc_results r = {
        .kind = PDMC_SCALAR, .confidence = 0.95, .runtime = {.threads = 2, .total = 1.5, .peak_memory = NAN}};
    r.title = pdmc_strdup("A made-up wave");
    r.length_unit = pdmc_strdup("mm");
    r.force_unit = pdmc_strdup("N");
    r.time_unit = pdmc_strdup("s");
    r.date_and_time = pdmc_strdup("2026-01-01T00:00:00Z");
    r.pdmc_version = pdmc_strdup("0.1.0");
    r.git_sha1 = pdmc_strdup("");
    pdmc_scalar_record *s = &r.scalar;
    *s = (pdmc_scalar_record){.dimension = dimension, .power = 1.0, .wave_number = 5.0, .level_count = LEVELS};
    s->spacing = row(0.2, varies_horizon ? 1.0 : 0.5);
    s->horizon = row(0.1, varies_horizon ? 0.5 : 1.0);
    s->elements = row(24, 2.0);
    s->unknowns = row(20, 2.0);
    s->entries = row(100, 4.0);
    s->error = row(0.04, varies_horizon ? 1.0 : 0.25);
    s->classical = row(varies_horizon ? 0.03 : NAN, 0.5);
    s->stable_step = row(varies_horizon ? NAN : 0.125, 1.0);
    s->stable_step_error = row(varies_horizon ? NAN : 1e-9, 1.0);
    s->motion_error = row(varies_horizon ? NAN : 0.08, 0.25);
    s->steps = row(varies_horizon ? NAN : 10, 2.0);
    s->drift = row(NAN, 1.0);
    s->iterations = row(NAN, 1.0);
    s->residual = row(NAN, 1.0);
    s->seconds = row(0.25, 2.0);
    s->value_count = VALUES;
    s->position = pdmc_calloc(2 * VALUES, sizeof *s->position);
    s->value = pdmc_calloc(VALUES, sizeof *s->value);
    s->wave = pdmc_calloc(VALUES, sizeof *s->wave);
    s->moved = pdmc_calloc(VALUES, sizeof *s->moved);
    for (int i = 0; i < VALUES; i++) {
        s->position[2 * i] = 0.5 * i;
        s->position[2 * i + 1] = dimension == 2 ? 0.25 * i : 0.0;
        s->value[i] = 0.125 * i;
    }
    return r;
}

static void the_table_has_levels_and_rates(void **state)
{
    (void)state;
    pdmc_results r = made_up_scalar(1, false);
    char *text = captured(pdmc_view_table, &r);
    expect_line(text, "  scalar field in one dimension, kernel r^-1, wave number 5 1/mm\n");
    expect_line(text, "         0.2        0.1        24        20        0.04      -     0.25\n");
    expect_line(text, "        0.05        0.1        96        80      0.0025   2.00     1.00\n");
    expect_line(text, "        0.05        0.125    1.0e-09        40       0.005   2.00\n");
    assert_null(strstr(text, "classical"));
    free(text);
    pdmc_results_clear(&r);

    r = made_up_scalar(2, true);
    text = captured(pdmc_view_table, &r);
    expect_line(text, "         0.2      0.025        96        80        0.04   0.00       0.0075   1.00     1.00\n");
    assert_null(strstr(text, "motion"));
    for (char *line = strtok(text, "\n"); line; line = strtok(NULL, "\n")) assert_true(strlen(line) <= 100);
    free(text);
    pdmc_results_clear(&r);
}

// Bonds with a law under a source of the study's own: no wave, iterations, and the drift of the energy.
static void a_study_without_a_wave_says_so(void **state)
{
    (void)state;
    pdmc_results r = made_up_scalar(1, false);
    r.scalar.wave_number = NAN;
    r.scalar.error[0] = r.scalar.motion_error[0] = NAN;
    for (int i = 0; i < LEVELS; i++) {
        r.scalar.drift[i] = 2e-4;
        r.scalar.iterations[i] = 6;
        r.scalar.residual[i] = 3e-15;
    }
    char *text = captured(pdmc_view_table, &r);
    expect_line(text, "  scalar field in one dimension, kernel r^-1, under the study's own source\n");
    expect_line(text, "     spacing    horizon  elements  unknowns  to coarser   rate  seconds\n");
    expect_line(text, "         0.2        0.1        24        20           -      -     0.25\n");
    expect_line(text, "         0.1        0.1        48        40        0.01      -     0.50\n");
    expect_line(text, "        0.05          6        3.0e-15\n");
    expect_line(text, "        0.05        0.125    1.0e-09        40       0.005   2.00          2.0e-04\n");
    assert_null(strstr(text, "the wave"));
    free(text);
    check_drawn(&r, 2, (const char *const[]){"convergence", "field"});
    pdmc_results_clear(&r);
}

static void the_json_has_all_levels(void **state)
{
    (void)state;
    pdmc_results r = made_up_scalar(1, false);
    char *text = captured(pdmc_view_json, &r);
    json_t *all = json_loads(text, 0, NULL);
    const json_t *levels = json_object_get(json_object_get(all, "scalar"), "levels");
    assert_string_equal(json_string_value(json_object_get(all, "kind")), "scalar");
    CHECK_NEAR(json_number_value(json_array_get(json_object_get(levels, "error"), 2)), 0.0025, 1e-17);
    CHECK_NEAR(json_number_value(json_array_get(json_object_get(levels, "error_rate"), 2)), 2.0, 1e-14);
    CHECK_NEAR(json_number_value(json_array_get(json_object_get(levels, "motion_error"), 1)), 0.02, 1e-17);
    assert_true(json_is_null(json_array_get(json_object_get(levels, "classical"), 0)));
    assert_true(json_is_null(json_array_get(json_object_get(levels, "error_rate"), 0)));
    json_decref(all);
    free(text);
    pdmc_results_clear(&r);
}

static void the_csv_has_levels_and_values(void **state)
{
    (void)state;
    size_t size;
    pdmc_results r = made_up_scalar(2, false);
    CHECK_OK(pdmc_view_export(&r, scratch_path("csv")));
    char *levels = scratch_read(scratch_path("csv/levels.csv"), &size);
    char *values = scratch_read(scratch_path("csv/values.csv"), &size);
    assert_true(levels && values);
    expect_line(levels, "level,spacing[mm],horizon[mm],elements,unknowns,entries,error,error_rate,");
    expect_line(levels, "\n2,0.10000000000000001,0.10000000000000001,48,40,400,0.01,2,nan,nan,0.125,");
    expect_line(values, "value,x[mm],y[mm],field,wave,moved\n");
    expect_line(values, "\n4,2,1,0.5,0,0\n");
    free(levels);
    free(values);
    assert_int_equal(scratch_empty(scratch_path("csv")), 2);
    scratch_empty(scratch);
    pdmc_results_clear(&r);
}

static void every_picture_is_drawn(void **state)
{
    (void)state;
    for (int dimension = 1; dimension <= 2; dimension++) {
        pdmc_results r = made_up_scalar(dimension, dimension == 2);
        check_drawn(&r, 2, (const char *const[]){"convergence", "field"});
        pdmc_results_clear(&r);
    }
}

static void it_is_not_compared(void **state)
{
    (void)state;
    pdmc_results a = made_up_scalar(1, false), b = made_up_scalar(1, false);
    pdmc_comparison *comparison;
    const pdmc_comparison_request request = {.labels = {"a.h5", "b.h5"}};
    CHECK_STATUS(pdmc_comparison_create(&a, &b, &request, &comparison), PDMC_ERR_DATA);
    assert_string_equal(pdmc_last_error(), "a.h5 is of a scalar study, which is not compared yet");
    pdmc_results_clear(&a);
    pdmc_results_clear(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_table_has_levels_and_rates),
        cmocka_unit_test(a_study_without_a_wave_says_so),
        cmocka_unit_test(the_json_has_all_levels),
        cmocka_unit_test(the_csv_has_levels_and_values),
        cmocka_unit_test(every_picture_is_drawn),
        cmocka_unit_test(it_is_not_compared),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
