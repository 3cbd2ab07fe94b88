// SPDX-License-Identifier: GPL-3.0-or-later

/// Studies of quadrature from their settings to their views: what is read and refused, what is measured, kept and
/// shown.

#include "run/studies.h"
#include "views/captured.h"

#include <jansson.h>

#define STRESS                                                                                                         \
    "integral = \"stress\"; horizon = 3.0; ratios = [1.5, 2.0]; youngs_modulus = 10.0; xy = 2.0; zz = -1.0; "          \
    "accuracy = 5e-2;"

static pdmc_status read_quadrature(const char *settings, pdmc_study *study)
{
    char text[1024];
    snprintf(text, sizeof text, "kind = \"quadrature\";\nquadrature = {\n%s };\n", settings);
    return read_text(text, study);
}

static void run_quadrature(const char *settings, pdmc_results *results)
{
    const pdmc_run_options options = {.threads = 2};
    pdmc_study study;
    CHECK_OK(read_quadrature(settings, &study));
    CHECK_OK(pdmc_run(&study, &options, results));
    pdmc_study_clear(&study);
}

static void expect_refusal(const char *settings, const char *message)
{
    pdmc_study study;
    CHECK_STATUS(read_quadrature(settings, &study), PDMC_ERR_CONFIG);
    if (!strstr(pdmc_last_error(), message)) fail_msg("\"%s\" is not in \"%s\"", message, pdmc_last_error());
}

static void what_is_read(void **state)
{
    (void)state;
    pdmc_study study, again;
    CHECK_OK(read_quadrature("horizon = 18.0;", &study));
    const pdmc_horizon_study *q = &study.quadrature;
    assert_int_equal(q->integral, PDMC_INTEGRAL_VOLUME);
    assert_int_equal(q->dimension, 3);
    assert_int_equal(q->ratio_count, 6);
    CHECK_NEAR(q->ratios[4], 8.0, 0.0);
    assert_int_equal(q->start, 0);
    assert_int_equal(q->most, 8);
    assert_int_equal(q->extrapolates, 1);
    pdmc_study_clear(&study);

    CHECK_OK(
        read_quadrature(STRESS "profile = \"bell\"; stretch = \"full\"; extrapolation = \"off\"; most = 5;", &study));
    CHECK_OK(read_text(study.resolved, &again));
    assert_string_equal(again.resolved, study.resolved);
    assert_int_equal(again.quadrature.start, 2); // the default of a stress
    assert_int_equal(again.quadrature.most, 5);
    assert_int_equal(again.quadrature.profile, PDMC_PROFILE_BELL);
    assert_int_equal(again.quadrature.stretch, PDMC_BOND_STRETCH_FULL);
    assert_int_equal(again.quadrature.extrapolates, 0);
    CHECK_NEAR(again.quadrature.stress[5], 2.0, 0.0);
    CHECK_NEAR(again.quadrature.stress[2], -1.0, 0.0);
    pdmc_study_clear(&again);
    pdmc_study_clear(&study);
    CHECK_OK(read_quadrature(STRESS "start = 1;", &study));
    assert_int_equal(study.quadrature.start, 1);
    pdmc_study_clear(&study);
}

static void what_is_refused(void **state)
{
    (void)state;
    pdmc_study study;
    expect_refusal("", "quadrature.horizon: is missing");
    expect_refusal("horizon = 1.0; ratios = [3.0, 3.0];", "study.cfg:3: quadrature.ratios: 3 follows 3, must ascend");
    expect_refusal("horizon = 1.0; ratios = [0.5, 3.0];",
                   "is not allowed, must be an array of 2 reals or more, [x1, x2, ...], each from 1 to 100");
    expect_refusal("horizon = 1.0; start = 5; most = 4;", "5 is too large, must be at most 4");
    expect_refusal("horizon = 1.0; xx = 1.0;", "is no setting of the integral \"volume\"");
    expect_refusal("horizon = 1.0; integral = \"stress\"; youngs_modulus = 1.0;", "has no stress");
    expect_refusal("horizon = 1.0; integral = \"stress\"; youngs_modulus = 1.0; dimension = 2; xx = 1.0; zx = 1.0;",
                   "quadrature.zx: is 1, must be 0 in two dimensions");
    CHECK_STATUS(
        read_text("kind = \"quadrature\"; quadrature = { horizon = 1.0; }; plate = { width = 1.0; height = 1.0; };",
                  &study),
        PDMC_ERR_CONFIG);
    CHECK_STATUS(read_with(LINE_TOP, "quadrature = { horizon = 1.0; };", &study), PDMC_ERR_CONFIG);
    char many[1024] = "horizon = 1.0; ratios = [1.0";
    for (int i = 1; i <= 100; i++) snprintf(many + strlen(many), sizeof many - strlen(many), ", %.2f", 1.0 + 0.01 * i);
    strcat(many, "];");
    expect_refusal(many, "has 101, must have at most 100");
}

static double figure(const pdmc_quadrature_record *q, const double values[], int rule, int ratio)
{
    return values[rule * q->ratio_count + ratio];
}

// In the plane: the area of a disc, pi r^2, with 2 spacings to the radius. The cubic rule counts the node, four at one
// spacing and four at sqrt 2 in full or in part, and four at two spacings by half: 5 + 4 (2.5 - sqrt 2) + 4 / 2 where
// 1.5 < sqrt 2 is false, so 9 + 2.
static void volumes_are_measured(void **state)
{
    (void)state;
    pdmc_results r;
    run_quadrature("dimension = 2; horizon = 2.0; ratios = [2.0, 4.0, 8.0];", &r);
    const pdmc_quadrature_record *q = &r.quadrature;
    assert_int_equal(r.kind, PDMC_QUADRATURE);
    assert_int_equal(q->rule_count, PDMC_HORIZON_RULES);
    assert_int_equal(q->ratio_count, 3);
    CHECK_NEAR(figure(q, q->error, 0, 0), 11.0 / 3.14159265358979323846 / 4.0 - 1.0, 1e-14);
    CHECK_NEAR(figure(q, q->points, 0, 0), 13.0, 0.0);
    CHECK_NEAR(figure(q, q->distance, 0, 0), sqrt(3.14159265358979323846 * 4.0 / 13.0), 1e-14);
    for (int k = 0; k < 3; k++) {
        CHECK_NEAR(figure(q, q->error, 4, k), 0.0, 1e-14);
        CHECK_NEAR(figure(q, q->error, 5, k), 0.0, 5e-4);
        for (int rule = 0; rule < q->rule_count; rule++) assert_true(figure(q, q->seconds, rule, k) > 0.0);
    }
    // The slope of a line through three equidistant points is that of its ends.
    for (int rule = 0; rule < 4; rule++) {
        const double slope = log(fabs(figure(q, q->error, rule, 0) / figure(q, q->error, rule, 2))) / log(4.0);
        CHECK_NEAR(q->rules[rule].spacing_order, slope, 1e-12);
    }
    assert_true(isnan(q->rules[4].spacing_order)); // its errors are rounding
    assert_true(isnan(q->stress[0]) && q->state_count == 0);
    pdmc_results_clear(&r);
}

static void stresses_are_measured(void **state)
{
    (void)state;
    pdmc_results r;
    run_quadrature(STRESS, &r);
    const pdmc_quadrature_record *q = &r.quadrature;
    const double exact[9] = {0.0, 2.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0, -1.0};
    for (int i = 0; i < 9; i++) CHECK_NEAR(q->exact_stress[i], exact[i], 0.0);
    for (int k = 0; k < 2; k++) {
        const double *stress = &q->stress[9 * (5 * q->ratio_count + k)];
        double largest = 0.0;
        for (int i = 0; i < 9; i++) largest = fmax(largest, fabs(stress[i] - exact[i]));
        CHECK_NEAR(largest, 0.0, 0.02 * 2.0);
        CHECK_NEAR(figure(q, q->error, 5, k), largest / 2.0, 1e-15);
    }
    CHECK_NEAR(figure(q, q->points, 0, 1), (33.0 + 13.0) / 2.0,
               0.0); // half of the nodes and those of the plane, as in horizon.stress
    pdmc_results_clear(&r);
}

static bool stop_after_three(void *context, int done, int total)
{
    (void)context, (void)total;
    return done < 3;
}

static void a_stopped_run_has_nothing(void **state)
{
    (void)state;
    const pdmc_run_options options = {.threads = 1, .progress = stop_after_three};
    pdmc_study study;
    pdmc_results r;
    CHECK_OK(read_quadrature("horizon = 1.0; ratios = [1.0, 2.0];", &study));
    CHECK_STATUS(pdmc_run(&study, &options, &r), PDMC_ERR_INTERRUPTED);
    assert_null(r.quadrature.error);
    pdmc_study_clear(&study);
}

static void expect_text(char *text, const char *const parts[])
{
    for (int i = 0; parts[i]; i++)
        if (!strstr(text, parts[i])) fail_msg("\"%s\" is not in\n%s", parts[i], text);
    free(text);
}

// What is written reads back to the bit, and all views show it.
static void files_and_views(void **state)
{
    (void)state;
    pdmc_results r, back;
    run_quadrature(STRESS, &r);
    CHECK_OK(pdmc_results_write(&r, "results.h5", true));
    CHECK_OK(pdmc_results_read("results.h5", &back));
    const pdmc_quadrature_record *a = &r.quadrature, *b = &back.quadrature;
    assert_int_equal(back.kind, PDMC_QUADRATURE);
    assert_true(b->state_count == 1 && b->rule_count == 6 && b->ratio_count == 2 && b->dimension == 3);
    assert_same("error", a->error, b->error, 12 * sizeof(double));
    assert_same("seconds", a->seconds, b->seconds, 12 * sizeof(double));
    assert_same("stress", a->stress, b->stress, 108 * sizeof(double));
    assert_string_equal(b->rules[5].name, "adaptive");
    CHECK_NEAR(b->rules[0].distance_order, a->rules[0].distance_order, 0.0);
    expect_text(captured(pdmc_view_table, &back),
                (const char *const[]){"the stress at a node of an infinite body, horizon 3 m in space", "gauss3",
                                      "points, half a horizon", "stress xy, exactly 2 N/m^2", "stress zz, exactly -1",
                                      NULL});
    size_t size;
    CHECK_OK(pdmc_view_export(&back, "csv"));
    expect_text(scratch_read("csv/quadrature.csv", &size),
                (const char *const[]){"rule,horizon_over_spacing,error,points,distance[m],seconds[s],stress_xx[N/m^2]",
                                      "\ncubic,1.5,", "\nadaptive,2,", NULL});
    char *text = captured(pdmc_view_json, &back);
    json_t *all = json_loads(text, 0, NULL);
    const json_t *rule = json_array_get(json_object_get(json_object_get(all, "quadrature"), "rules"), 5);
    CHECK_NEAR(json_number_value(json_array_get(json_object_get(rule, "error"), 1)), a->error[11], 0.0);
    CHECK_NEAR(json_number_value(json_array_get(json_array_get(json_object_get(rule, "stress"), 1), 8)),
               a->stress[9 * 11 + 8], 0.0);
    json_decref(all);
    free(text);
    pdmc_comparison *comparison = NULL;
    const pdmc_comparison_request request = {.labels = {"one", "two"}};
    CHECK_STATUS(pdmc_comparison_create(&r, &back, &request, &comparison), PDMC_ERR_DATA);
    pdmc_results_clear(&back);
    pdmc_results_clear(&r);
}

static void memory_that_is_refused(void **state)
{
    (void)state;
    const pdmc_run_options options = {.threads = 1};
    pdmc_study study;
    pdmc_results r;
    CHECK_OK(read_quadrature("dimension = 2; horizon = 1.0; ratios = [1.0, 1.5]; most = 1;", &study));
    CHECK_FAILS_CLEANLY(pdmc_run(&study, &options, &r), pdmc_results_clear(&r));
    pdmc_study_clear(&study);
    CHECK_FAILS_CLEANLY(read_quadrature("horizon = 1.0;", &study), pdmc_study_clear(&study));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_read),
        cmocka_unit_test(what_is_refused),
        cmocka_unit_test(volumes_are_measured),
        cmocka_unit_test(stresses_are_measured),
        cmocka_unit_test(a_stopped_run_has_nothing),
        cmocka_unit_test(files_and_views),
        cmocka_unit_test(memory_that_is_refused),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
