// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/views.h"

#include "check.h"
#include "results/made_up.h"
#include "results/scratch.h"

#include <jansson.h>
#include <string.h>

static const pdmc_comparison_request plain = {.labels = {"first.h5", "second.h5"}};

static void replace_text(char **text, const char *by)
{
    pdmc_free(*text);
    *text = pdmc_strdup(by);
}

/// The same study with other energies: those of sample s are `factor` times the first's.
static pdmc_results scaled(double factor)
{
    pdmc_results r = made_up_results(made_up_small);
    for (int m = 0; m < PDMC_MEASURES; m++)
        for (int i = 0; i < r.sample_count * r.tip_count * r.angle_count; i++) r.energy[m][i] *= factor;
    return r;
}

static json_t *compared(const pdmc_results *a, const pdmc_results *b, const pdmc_comparison_request *request)
{
    pdmc_comparison *comparison = NULL;
    char *text = NULL;
    size_t size;
    FILE *stream = open_memstream(&text, &size);
    CHECK_OK(pdmc_comparison_create(a, b, request, &comparison));
    CHECK_OK(pdmc_view_comparison_json(comparison, stream));
    fclose(stream);
    pdmc_comparison_destroy(&comparison);
    json_t *object = json_loads(text, JSON_REJECT_DUPLICATES, NULL);
    if (!object) fail_msg("no JSON: %.80s", text);
    free(text);
    return object;
}

static char *shown(const pdmc_results *a, const pdmc_results *b, const pdmc_comparison_request *request)
{
    pdmc_comparison *comparison = NULL;
    char *text = NULL;
    size_t size;
    FILE *stream = open_memstream(&text, &size);
    CHECK_OK(pdmc_comparison_create(a, b, request, &comparison));
    CHECK_OK(pdmc_view_comparison_table(comparison, stream));
    fputs(pdmc_comparison_notes(comparison), stream);
    fclose(stream);
    pdmc_comparison_destroy(&comparison);
    return text;
}

static void check_says(const char *text, const char *part)
{
    if (!strstr(text, part)) fail_msg("\"%s\" is not in:\n%s", part, text);
}

static double real_at(json_t *object, const char *key, const char *part)
{
    json_t *value = json_object_get(object, key);
    return json_number_value(part ? json_object_get(value, part) : value);
}

static json_t *first_angle(json_t *object)
{
    return json_array_get(json_object_get(json_array_get(json_object_get(object, "tips"), 0), "angles"), 0);
}

/// Energies that are 3 times those of the first, sample by sample, without the two that failed.
static void samples_of_equal_seeds_are_pairs(void **state)
{
    (void)state;
    pdmc_results a = made_up_results(made_up_small), b = scaled(3.0);
    json_t *object = compared(&a, &b, &plain), *angle = first_angle(object), *pairs = json_object_get(angle, "pairs");
    assert_true(json_is_true(json_object_get(object, "paired")));
    assert_true(json_is_true(json_object_get(object, "same_load_factors")));
    assert_true(json_is_true(json_object_get(object, "same_micromodulus")));
    assert_int_equal(json_integer_value(json_object_get(pairs, "count")), 38);
    CHECK_NEAR(real_at(pairs, "correlation", "value"), 1.0, 1e-14);
    CHECK_NEAR(real_at(pairs, "relative_difference", "value"), 1.0, 1e-14); // (3 - 1) / 2
    CHECK_NEAR(real_at(angle, "ratio_of_means", "value"), 3.0, 1e-14);
    CHECK_NEAR(real_at(angle, "ratio_of_means", "upper"), 3.0, 1e-14);
    // Of the two means, of 38 samples, which the made-up statistics take from the same samples.
    const double mean = real_at(json_object_get(angle, "a"), "mean", "value");
    CHECK_NEAR(real_at(angle, "wasserstein", "value") / mean, 2.0, 1e-13); // all mass is moved to the right
    CHECK_NEAR(real_at(angle, "difference_of_means", "value") / mean, 2.0, 1e-13);
    json_decref(object);
    b.seed++;
    object = compared(&a, &b, &plain);
    assert_true(json_is_false(json_object_get(object, "paired")));
    assert_true(json_is_null(json_object_get(first_angle(object), "pairs")));
    json_decref(object);
    pdmc_results_clear(&b);
    pdmc_results_clear(&a);
}

/// The largest difference is told by the number of its sample, failed ones counted.
static void a_sample_is_found_by_its_number(void **state)
{
    (void)state;
    pdmc_results a = made_up_results(made_up_small), b = made_up_results(made_up_small);
    const int sample = 17, ahead = 4; // 180 degrees of eight angles, straight ahead of the first tip
    b.energy[PDMC_MEASURE_GRIFFITH][sample * b.tip_count * b.angle_count + ahead] *= 2.0;
    b.failure[20] = PDMC_SAMPLE_SINGULAR; // not in the first
    b.load_factor[3] = 7.0;
    json_t *object = compared(&a, &b, &plain), *pairs = json_object_get(first_angle(object), "pairs");
    assert_int_equal(json_integer_value(json_object_get(pairs, "largest_sample")), sample);
    assert_int_equal(json_integer_value(json_object_get(pairs, "count")), 37);
    CHECK_NEAR(real_at(pairs, "largest_relative_difference", NULL), 2.0 / 3.0, 1e-15);
    CHECK_NEAR(real_at(first_angle(object), "angle", NULL), a.angles[ahead], 0.0);
    assert_true(json_is_false(json_object_get(object, "same_load_factors")));
    json_decref(object);
    pdmc_results_clear(&b);
    pdmc_results_clear(&a);
}

static void numbers_of_both_are_side_by_side(void **state)
{
    (void)state;
    pdmc_results a = made_up_results(made_up_small), b = scaled(1.5);
    replace_text(&b.title, "Another");
    replace_text(&b.resolved, "solver = { method = \"kansa\"; crack_model = \"visible\"; };");
    b.tips[0].stress_intensity[0] = 2.5;
    b.tips[1].t_stress = NAN;
    b.runtime.peak_memory = NAN;
    const double angles[] = {3.14159, -2.356194490192345}; // typed to half a hundredth of a degree; -135
    pdmc_comparison_request request = plain;
    request.angle_count = 2;
    request.angles = angles;
    char *text = shown(&a, &b, &request);
    const char *const parts[] = {
        "  file                first.h5                               second.h5\n",
        "  title               Centre crack under uncertain tension   Another\n",
        "  method              -                                      kansa, visible\n",
        "  samples             40, 2 failed, seed 20110614            40, 2 failed, seed 20110614\n",
        "  K_I                 1.323 +- 0.00041                       2.5 +- 0.00041\n",
        "  T                   -1.04 +- 0.003                         -\n",
        "center.from, Griffith energy at 180 deg, N/cm\n",
        "center.from, Griffith energy at 225 deg, N/cm\n",
        "  means, B / A        1.50",
        "], p <= 0.001\n",
        "  total               6.70                                   6.70\n",
        "  peak memory, MB     81                                     -\n",
        "A and B are taken as pairs",
    };
    for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++) check_says(text, parts[i]);
    for (const char *line = text; *line; line += strcspn(line, "\n") + 1)
        if (strcspn(line, "\n") > 100) fail_msg("too long: %s", line);
    free(text);
    pdmc_results_clear(&b);
    pdmc_results_clear(&a);
}

/// G is proportional to K_I^2 + K_II^2.
static void the_error_of_g_is_that_of_k(void **state)
{
    (void)state;
    pdmc_results a = made_up_results(made_up_small);
    const double *k = a.tips[0].stress_intensity, *e = a.tips[0].stress_intensity_error;
    json_t *object = compared(&a, &a, &plain), *tip = json_array_get(json_object_get(object, "tips"), 0);
    const double g = real_at(tip, "a", "G"), error = real_at(tip, "b", "G_error"), square = k[0] * k[0] + k[1] * k[1];
    const double up[] = {fabs(k[0]) + e[0], fabs(k[1]) + e[1]};
    CHECK_NEAR(g, a.nominal_griffith_energy[4], 0.0);
    CHECK_NEAR(error / g, (up[0] * up[0] + up[1] * up[1]) / square - 1.0, 2e-7); // to the square of 4.1e-4 / 1.32
    json_decref(object);
    pdmc_results_clear(&a);
}

// Files that keep some of their samples: pairs are those that both keep.
static void what_is_kept_is_compared(void **state)
{
    (void)state;
    pdmc_results a = made_up_results(made_up_small), b = made_up_results(made_up_small);
    a.kept_count = 10;
    b.kept_count = 20;
    char *text = shown(&a, &b, &plain);
    check_says(text, "energies are compared of the first 10 of the 40 samples of first.h5\n");
    check_says(text, "energies are compared of the first 10 of the 40 samples of second.h5\n");
    free(text);
    b.seed++;
    text = shown(&a, &b, &plain);
    check_says(text, "energies are compared of the first 20 of the 40 samples of second.h5\n");
    free(text);
    pdmc_results_clear(&a);
    pdmc_results_clear(&b);
}

static void what_differs_is_said(void **state)
{
    (void)state;
    pdmc_results a = made_up_results((made_up_size){.cracks = 2, .angles = 8, .samples = 30, .histogram_bins = 4});
    pdmc_results b = made_up_results((made_up_size){.cracks = 1, .angles = 12, .samples = 40, .histogram_bins = 4});
    b.fracture_energy = 0.4;
    b.measure = PDMC_MEASURE_BOND;
    b.extension = 0.05;
    b.plate_width = 6.0;
    pdmc_comparison_request request = plain;
    request.has_measure = true;
    request.measure = PDMC_MEASURE_BOND;
    char *text = shown(&a, &b, &request);
    const char *const parts[] = {
        "the tip upper.from is in first.h5 only\n",
        "8 and 12 angles: energies are compared at the 4 that both have\n",
        "G_c is 0.2 and 0.4 N/cm: P(G > G_c) differs with it\n",
        "P(G > G_c) and the direction are of the Griffith and of the bond energy\n",
        "the plate's width is 5 and 6 cm: other plates\n",
        "the extension is 0.02 and 0.05 cm: bond energies depend on it\n",
        "the same seed, but different numbers of samples: taken as independent",
        "A and B are taken as independent samples\n",
    };
    for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++) check_says(text, parts[i]);
    free(text);
    text = shown(&b, &b, &plain);
    assert_null(strstr(text, " only\n"));
    assert_null(strstr(text, "differs"));
    free(text);
    pdmc_results_clear(&b);
    pdmc_results_clear(&a);
}

static void check_refused(const pdmc_results *a, const pdmc_results *b, const pdmc_comparison_request *request,
                          pdmc_status want, const char *message)
{
    pdmc_comparison *comparison = NULL;
    CHECK_STATUS(pdmc_comparison_create(a, b, request, &comparison), want);
    assert_null(comparison);
    assert_string_equal(pdmc_last_error(), message);
}

static void what_cannot_be_compared_is_refused(void **state)
{
    (void)state;
    pdmc_results a = made_up_results(made_up_small), b = made_up_results(made_up_small);
    pdmc_results motion = made_up_results(made_up_motion);
    const char *const tips[] = {"center.to", "nowhere"};
    const double angles[] = {0.0, 0.8};
    pdmc_comparison_request request = plain;
    check_refused(&a, &motion, &plain, PDMC_ERR_DATA, "first.h5 is of a static study and second.h5 of a dynamic one");
    request.tip_count = 2;
    request.tips = tips;
    check_refused(&a, &b, &request, PDMC_ERR_ARG, "nowhere is no tip of both files");
    request.tip_count = 1;
    request.angle_count = 2;
    request.angles = angles;
    check_refused(&a, &b, &request, PDMC_ERR_ARG, "45.8366 deg is no angle of both files; the nearest is 45 deg");
    strcpy(b.tips[0].name, "left");
    strcpy(b.tips[1].name, "ri\aght");
    check_refused(&a, &b, &plain, PDMC_ERR_DATA,
                  "first.h5 and second.h5 have no tip in common: center.from, center.to; left, ri ght");
    replace_text(&b.force_unit, "kN");
    check_refused(&a, &b, &plain, PDMC_ERR_DATA, "first.h5 and second.h5 have different units of force, N and kN");
    pdmc_results_clear(&motion);
    pdmc_results_clear(&b);
    pdmc_results_clear(&a);
}

static void odd_results_are_compared(void **state)
{
    (void)state;
    const made_up_size sizes[] = {
        {.times = 3, .probes = 1},
        {.cracks = 1},
        {.cracks = 1, .angles = 1, .samples = 2, .failed = 2, .histogram_bins = 1},
        {.cracks = 1, .angles = 3, .samples = 1, .radial_bins = 1, .histogram_bins = 0},
        {.cracks = 1, .angles = 8, .samples = 5, .histogram_bins = 2},
    };
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++)
        for (size_t j = 1; j < sizeof sizes / sizeof sizes[0]; j++) {
            pdmc_results a = made_up_results(sizes[i]), b = made_up_results(sizes[i == 0 ? 0 : j]);
            char *text = shown(&a, &b, &plain);
            assert_null(strstr(text, "nan"));
            free(text);
            json_decref(compared(&a, &b, &plain));
            pdmc_results_clear(&b);
            pdmc_results_clear(&a);
        }
}

/// Two panels in one picture, of a tip whose name is no name of a file, with labels that are no commands.
static void densities_are_drawn(void **state)
{
    (void)state;
    if (system("gnuplot --version >/dev/null 2>&1") != 0) skip();
    pdmc_results a = made_up_results(made_up_small), b = scaled(1.2);
    strcpy(a.tips[1].name, "it's/{a}");
    strcpy(b.tips[1].name, "it's/{a}");
    const double angles[] = {0.0, 0.78539816339744830962, 1.5707963267948966};
    const char *const tips[] = {"it's/{a}"};
    pdmc_comparison_request request = {.labels = {"x/`touch harm`'s.h5", "y/b_{c}.h5"}, 1, tips, 3, angles, false, 0};
    pdmc_comparison *comparison = NULL;
    size_t size;
    CHECK_OK(pdmc_comparison_create(&a, &b, &request, &comparison));
    CHECK_OK(pdmc_view_comparison_plot(comparison, scratch_path("plots")));
    char *bytes = scratch_read(scratch_path("plots/compare_it's_{a}_griffith_energy.png"), &size);
    assert_true(bytes && size > 1000);
    assert_int_equal(((unsigned char)bytes[22] << 8) + (unsigned char)bytes[23], 1650); // three panels of 550
    free(bytes);
    bytes = scratch_read(scratch_path("plots/compare_it's_{a}_griffith_energy.svg"), &size);
    check_says(bytes, "</svg>");
    check_says(bytes, "b_{c}.h5");
    check_says(bytes, "φ = 90°");
    free(bytes);
    assert_int_equal(scratch_empty(scratch_path("plots")), 2);
    pdmc_comparison_destroy(&comparison);
    pdmc_results_clear(&b);
    pdmc_results_clear(&a);
    scratch_empty(scratch);
}

static pdmc_status compare_and_forget(const pdmc_results *a, const pdmc_results *b)
{
    pdmc_comparison *comparison = NULL;
    const pdmc_status status = pdmc_comparison_create(a, b, &plain, &comparison);
    pdmc_comparison_destroy(&comparison);
    return status;
}

static void refused_memory_is_reported(void **state)
{
    (void)state;
    pdmc_results a = made_up_results(made_up_small);
    CHECK_FAILS_CLEANLY(compare_and_forget(&a, &a), (void)0);
    pdmc_results_clear(&a);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(samples_of_equal_seeds_are_pairs),
        cmocka_unit_test(a_sample_is_found_by_its_number),
        cmocka_unit_test(numbers_of_both_are_side_by_side),
        cmocka_unit_test(the_error_of_g_is_that_of_k),
        cmocka_unit_test(what_is_kept_is_compared),
        cmocka_unit_test(what_differs_is_said),
        cmocka_unit_test(what_cannot_be_compared_is_refused),
        cmocka_unit_test(odd_results_are_compared),
        cmocka_unit_test(densities_are_drawn),
        cmocka_unit_test(refused_memory_is_reported),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
