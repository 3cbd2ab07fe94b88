// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/results.h"

#include "check.h"
#include "results/layout.h"
#include "results/made_up.h"
#include "results/scratch.h"

#include <hdf5.h>

/// NaN is equal to itself here, and nothing is compared by ==: the file must return every bit.
static void check_equal(const pdmc_results *a, const pdmc_results *b)
{
    for (size_t i = 0; i < pdmc_dataset_count; i++) {
        const pdmc_dataset *dataset = &pdmc_datasets[i];
        if (!pdmc_dataset_belongs(a, dataset)) continue; // of another kind of study
        const size_t size = pdmc_dataset_size(a, dataset), bytes = size * pdmc_kind_size(dataset->kind);
        assert_int_equal(size, pdmc_dataset_size(b, dataset));
        char *left = calloc(bytes + 1, 1), *right = calloc(bytes + 1, 1);
        if (dataset->stride == 0) {
            memcpy(left, pdmc_dataset_memory(a, dataset), bytes);
            memcpy(right, pdmc_dataset_memory(b, dataset), bytes);
        } else {
            pdmc_dataset_gather(dataset, size, pdmc_dataset_memory(a, dataset), left);
            pdmc_dataset_gather(dataset, size, pdmc_dataset_memory(b, dataset), right);
        }
        if (memcmp(left, right, bytes) != 0) fail_msg("%s is not what was written", dataset->path);
        free(left);
        free(right);
    }
}

/// Field by field, without the table, so that a wrong row of the table is seen.
static void check_fields(const pdmc_results *a, const pdmc_results *b)
{
    assert_string_equal(a->title, b->title);
    assert_string_equal(a->length_unit, b->length_unit);
    assert_string_equal(a->force_unit, b->force_unit);
    assert_string_equal(a->time_unit, b->time_unit);
    assert_int_equal(a->kind, b->kind);
    assert_string_equal(a->input, b->input);
    assert_string_equal(a->resolved, b->resolved);
    assert_string_equal(a->date_and_time, b->date_and_time);
    assert_string_equal(a->pdmc_version, b->pdmc_version);
    assert_string_equal(a->git_sha1, b->git_sha1);
    assert_true(a->seed == b->seed && a->status == b->status && a->measure == b->measure && a->bonds == b->bonds);
    assert_memory_equal(&a->confidence, &b->confidence, sizeof(double));
    assert_int_equal(a->failed_count, b->failed_count);
    assert_memory_equal(&a->plate_width, &b->plate_width, 5 * sizeof(double));
    assert_int_equal(a->solver.rank, b->solver.rank);
    assert_memory_equal(&a->solver, &b->solver, sizeof a->solver);
    assert_int_equal(a->runtime.threads, b->runtime.threads);
    assert_memory_equal(&a->runtime.assembly, &b->runtime.assembly, 9 * sizeof(double));
    assert_memory_equal(&a->runtime.peak_memory, &b->runtime.peak_memory, sizeof(double));
    const size_t samples = (size_t)a->sample_count, tips = (size_t)a->tip_count, angles = (size_t)a->angle_count;
    for (size_t t = 0; t < tips; t++) {
        assert_string_equal(a->tips[t].name, b->tips[t].name);
        assert_memory_equal(a->tips[t].position, b->tips[t].position, sizeof a->tips[t].position);
        assert_memory_equal(&a->tips[t].direction, &b->tips[t].direction, 7 * sizeof(double));
    }
    assert_memory_equal(a->field.face_displacement, b->field.face_displacement,
                        (size_t)(a->crack_count * a->field.face_points) * 4 * sizeof(double));
    assert_memory_equal(a->failure, b->failure, samples);
    assert_memory_equal(a->energy[1], b->energy[1], samples * tips * angles * sizeof(double));
    assert_memory_equal(a->direction, b->direction, tips * angles * sizeof(pdmc_estimate));
    assert_memory_equal(a->probability, b->probability, tips * sizeof(pdmc_estimate));
    for (int m = 0; m < PDMC_MEASURES; m++) {
        const pdmc_energy_statistics *x = &a->statistics[m], *y = &b->statistics[m];
        const size_t bins = (size_t)a->histogram_bins;
        assert_memory_equal(x->mean, y->mean, tips * angles * sizeof(pdmc_estimate));
        assert_memory_equal(x->quantiles, y->quantiles, tips * angles * PDMC_QUANTILES * sizeof(pdmc_estimate));
        assert_memory_equal(x->histogram_counts, y->histogram_counts, tips * angles * (bins + 2) * sizeof(int64_t));
        assert_memory_equal(x->density, y->density, tips * angles * bins * sizeof(pdmc_estimate));
    }
}

static void check_reliability(const pdmc_results *a, const pdmc_results *b)
{
    const pdmc_reliability_results *x = &a->reliability, *y = &b->reliability;
    const size_t tips = (size_t)a->tip_count, given = (size_t)a->sample_count * tips;
    assert_memory_equal(a->growth_given_rest, b->growth_given_rest, given * sizeof(double));
    assert_memory_equal(a->conditional_probability, b->conditional_probability, tips * sizeof(pdmc_estimate));
    assert_int_equal(x->record_count, y->record_count);
    for (int i = 0; i < x->record_count; i++) {
        assert_string_equal(x->records[i].name, y->records[i].name);
        assert_memory_equal(&x->records[i].found.probability, &y->records[i].found.probability, sizeof(pdmc_estimate));
        assert_memory_equal(&x->records[i].found.index, &y->records[i].found.index, sizeof(pdmc_estimate));
        assert_memory_equal(&x->records[i].found.variation, &y->records[i].found.variation, 3 * sizeof(double));
        assert_memory_equal(&x->records[i].evaluations, &y->records[i].evaluations, 2 * sizeof(double));
        assert_int_equal(x->records[i].complete, y->records[i].complete);
    }
    assert_int_equal(x->group_count, y->group_count);
    for (int g = 0; g < x->group_count; g++) {
        assert_string_equal(x->groups[g].name, y->groups[g].name);
        assert_int_equal(x->groups[g].variables, y->groups[g].variables);
        assert_memory_equal(&x->groups[g].importance, &y->groups[g].importance, sizeof(double));
        assert_memory_equal(&x->groups[g].first, &y->groups[g].first, 2 * sizeof(pdmc_estimate));
    }
    assert_int_equal(x->variable_count, y->variable_count);
    assert_memory_equal(x->design_point, y->design_point, (size_t)x->variable_count * sizeof(double));
    assert_memory_equal(&x->first_order_index, &y->first_order_index, 4 * sizeof(double));
    assert_memory_equal(&a->runtime.reliability, &b->runtime.reliability, sizeof(double));
}

static void check_control(const pdmc_results *a, const pdmc_results *b)
{
    const pdmc_control_results *x = &a->control, *y = &b->control;
    const size_t tips = (size_t)a->tip_count, directions = tips * (size_t)a->angle_count;
    assert_int_equal(x->tip_count, y->tip_count);
    assert_memory_equal(&x->samples, &y->samples, 3 * sizeof(double));
    assert_memory_equal(x->mean, y->mean, directions * sizeof(pdmc_estimate));
    assert_memory_equal(x->correlation, y->correlation, directions * sizeof(double));
    assert_memory_equal(x->mean_gain, y->mean_gain, directions * sizeof(double));
    assert_memory_equal(x->probability, y->probability, tips * sizeof(pdmc_estimate));
    assert_memory_equal(x->probability_gain, y->probability_gain, tips * sizeof(double));
    assert_memory_equal(&a->runtime.control, &b->runtime.control, sizeof(double));
}

static void check_motion(const pdmc_motion_record *a, const pdmc_motion_record *b)
{
    const size_t n = (size_t)a->time_count * sizeof(double), probes = (size_t)a->probe_count;
    assert_int_equal(a->time_count, b->time_count);
    assert_int_equal(a->probe_count, b->probe_count);
    assert_memory_equal(a->time, b->time, n);
    assert_memory_equal(a->load_factor, b->load_factor, n);
    assert_memory_equal(a->kinetic, b->kinetic, n);
    assert_memory_equal(a->elastic, b->elastic, n);
    assert_memory_equal(a->dissipated, b->dissipated, n);
    assert_memory_equal(a->work, b->work, n);
    assert_memory_equal(a->displacement, b->displacement, 2 * n * probes);
    for (size_t p = 0; p < probes; p++) {
        assert_string_equal(a->probes[p].name, b->probes[p].name);
        assert_memory_equal(a->probes[p].position, b->probes[p].position, sizeof a->probes[p].position);
        assert_int_equal(a->probes[p].face, b->probes[p].face);
    }
}

static void what_is_written_is_read(void **state)
{
    (void)state;
    const made_up_size sizes[] = {
        made_up_small,
        made_up_motion,
        {.times = 1},
        {.cracks = 2, .angles = 3, .samples = 7, .failed = 7, .radial_bins = 1, .histogram_bins = 1},
        {.cracks = 1, .angles = 4, .samples = 5, .radial_bins = 0, .histogram_bins = 0},
        {.cracks = 0, .angles = 4, .samples = 5, .radial_bins = 2, .histogram_bins = 3},
        {0},
    };
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        pdmc_results a = made_up_results(sizes[i]), b;
        a.status = i % 2 ? PDMC_RUN_INTERRUPTED : PDMC_RUN_COMPLETE;
        CHECK_OK(pdmc_results_write(&a, scratch_path("results.h5"), true));
        CHECK_OK(pdmc_results_read(scratch_path("results.h5"), &b));
        check_equal(&a, &b);
        check_fields(&a, &b);
        if (a.kind == PDMC_STATIC) check_reliability(&a, &b);
        if (a.kind == PDMC_STATIC) check_control(&a, &b);
        if (a.kind == PDMC_DYNAMIC) check_motion(&a.motion, &b.motion);
        pdmc_results_clear(&a);
        pdmc_results_clear(&b);
    }
    assert_int_equal(scratch_empty(scratch), 1);
}

static void long_texts_survive(void **state)
{
    (void)state;
    pdmc_results a = made_up_results(made_up_small), b;
    pdmc_free(a.input);
    a.input = pdmc_calloc(300000, 1); // an attribute would end at 64 kB
    memset(a.input, 'x', 299999);
    CHECK_OK(pdmc_results_write(&a, scratch_path("results.h5"), false));
    CHECK_OK(pdmc_results_read(scratch_path("results.h5"), &b));
    assert_string_equal(a.input, b.input);
    pdmc_results_clear(&a);
    pdmc_results_clear(&b);
    scratch_empty(scratch);
}

static void equal_results_make_equal_files(void **state)
{
    (void)state;
    pdmc_results a = made_up_results(made_up_small);
    size_t sizes[2];
    CHECK_OK(pdmc_results_write(&a, scratch_path("first.h5"), false));
    sleep(1); // a time in the file would differ
    CHECK_OK(pdmc_results_write(&a, scratch_path("second.h5"), false));
    char *first = scratch_read(scratch_path("first.h5"), &sizes[0]);
    char *second = scratch_read(scratch_path("second.h5"), &sizes[1]);
    assert_int_equal(sizes[0], sizes[1]);
    assert_memory_equal(first, second, sizes[0]);
    free(first);
    free(second);
    pdmc_results_clear(&a);
    scratch_empty(scratch);
}

static void impossible_results_are_refused(void **state)
{
    (void)state;
    pdmc_results a = made_up_results(made_up_small);
    const char *path = scratch_path("results.h5");
    a.failed_count++;
    CHECK_STATUS(pdmc_results_write(&a, path, false), PDMC_ERR_ARG);
    a.failed_count--;
    a.kept_count = a.sample_count + 1;
    CHECK_STATUS(pdmc_results_write(&a, path, false), PDMC_ERR_ARG);
    a.kept_count = a.sample_count;
    a.failure[3] = 200;
    CHECK_STATUS(pdmc_results_write(&a, path, false), PDMC_ERR_ARG);
    a.failure[3] = PDMC_SAMPLE_OK;
    a.measure = (pdmc_measure)PDMC_MEASURES;
    CHECK_STATUS(pdmc_results_write(&a, path, false), PDMC_ERR_ARG);
    a.measure = PDMC_MEASURE_BOND;
    a.angle_count = -a.angle_count;
    CHECK_STATUS(pdmc_results_write(&a, path, false), PDMC_ERR_ARG);
    a.angle_count = -a.angle_count;
    pdmc_free(a.direction);
    a.direction = NULL;
    CHECK_STATUS(pdmc_results_write(&a, path, false), PDMC_ERR_ARG);
    assert_non_null(strstr(pdmc_last_error(), "/statistics/direction"));
    pdmc_results_clear(&a);
    assert_int_equal(scratch_empty(scratch), 0);
}

static void refused_memory_is_reported(void **state)
{
    (void)state;
    pdmc_results a = made_up_results(made_up_small), b;
    const char *path = scratch_path("results.h5");
    CHECK_FAILS_CLEANLY(pdmc_results_write(&a, path, true), (void)0);
    assert_int_equal(scratch_empty(scratch), 1);
    CHECK_OK(pdmc_results_write(&a, path, true));
    CHECK_FAILS_CLEANLY(pdmc_results_read(path, &b), pdmc_results_clear(&b));
    pdmc_results_clear(&a);
    scratch_empty(scratch);
}

static herr_t count_units(hid_t file, const char *name, const H5O_info_t *info, void *count)
{
    const bool is_document = strcmp(name, "input") == 0 || strcmp(name, "resolved") == 0;
    if (info->type != H5O_TYPE_DATASET || is_document) return 0;
    if (H5Aexists_by_name(file, name, "units", H5P_DEFAULT) <= 0) fail_msg("%s has no units", name);
    if (H5Aexists_by_name(file, name, "description", H5P_DEFAULT) <= 0) fail_msg("%s has no description", name);
    ++*(size_t *)count;
    return 0;
}

static void every_dataset_says_its_unit(void **state)
{
    (void)state;
    pdmc_results a = made_up_results(made_up_motion); // which has every dataset but those of an explicit study
    size_t count = 0, expected = 0;
    for (size_t i = 0; i < pdmc_dataset_count; i++) expected += pdmc_dataset_belongs(&a, &pdmc_datasets[i]);
    assert_true(expected > 100);
    CHECK_OK(pdmc_results_write(&a, scratch_path("results.h5"), false));
    const hid_t file = H5Fopen(scratch_path("results.h5"), H5F_ACC_RDONLY, H5P_DEFAULT);
    assert_true(H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_NATIVE, count_units, &count, H5O_INFO_BASIC) >= 0);
    assert_int_equal(count, expected);
    H5Fclose(file);
    pdmc_results_clear(&a);
    scratch_empty(scratch);
}

static void a_static_study_has_no_motion(void **state)
{
    (void)state;
    pdmc_results a = made_up_results(made_up_small);
    CHECK_OK(pdmc_results_write(&a, scratch_path("results.h5"), false));
    const hid_t file = H5Fopen(scratch_path("results.h5"), H5F_ACC_RDONLY, H5P_DEFAULT);
    assert_int_equal(H5Lexists(file, "/motion", H5P_DEFAULT), 0);
    H5Fclose(file);
    pdmc_results_clear(&a);
    scratch_empty(scratch);
}

static void impossible_probes_are_refused(void **state)
{
    (void)state;
    pdmc_results a = made_up_results(made_up_motion);
    a.motion.probes[1].face = 3;
    CHECK_STATUS(pdmc_results_write(&a, scratch_path("results.h5"), false), PDMC_ERR_ARG);
    assert_string_equal(pdmc_last_error(), "probe 1: unknown face 3");
    a.motion.probes[1].face = PDMC_FACE_NONE;
    memset(a.motion.probes[0].name, 'n', sizeof a.motion.probes[0].name);
    CHECK_STATUS(pdmc_results_write(&a, scratch_path("results.h5"), false), PDMC_ERR_ARG);
    assert_string_equal(pdmc_last_error(), "the name of probe 0 has no end");
    pdmc_results_clear(&a);
    assert_int_equal(scratch_empty(scratch), 0);
}

static void units_are_the_studys(void **state)
{
    (void)state;
    char unit[PDMC_UNIT_SIZE], few[4];
    const pdmc_results results = {.length_unit = "mm", .force_unit = "kN", .time_unit = "ms"};
    pdmc_results_unit(&results, PDMC_UNIT_STRESS_INTENSITY, sizeof unit, unit);
    assert_string_equal(unit, "kN/mm^(3/2)");
    pdmc_results_unit(&results, PDMC_UNIT_DENSITY, sizeof unit, unit);
    assert_string_equal(unit, "mm/kN");
    pdmc_results_unit(&results, PDMC_UNIT_WORK, sizeof unit, unit);
    assert_string_equal(unit, "kN mm");
    pdmc_results_unit(&results, PDMC_UNIT_STUDY_TIME, sizeof unit, unit);
    assert_string_equal(unit, "ms");
    pdmc_results_unit(&results, PDMC_UNIT_NONE, sizeof unit, unit);
    assert_string_equal(unit, "1");
    pdmc_results_unit(&results, PDMC_UNIT_STRESS, sizeof few, few);
    assert_string_equal(few, "kN/");
}

static void hdf5_is_silent_only_while_we_use_it(void **state)
{
    (void)state;
    H5E_auto2_t before, after;
    void *data;
    pdmc_results results;
    H5Eget_auto2(H5E_DEFAULT, &before, &data);
    CHECK_STATUS(pdmc_results_read(scratch_path("missing.h5"), &results), PDMC_ERR_NO_INPUT);
    H5Eget_auto2(H5E_DEFAULT, &after, &data);
    assert_non_null(before);
    assert_true(before == after);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_written_is_read),        cmocka_unit_test(long_texts_survive),
        cmocka_unit_test(equal_results_make_equal_files), cmocka_unit_test(impossible_results_are_refused),
        cmocka_unit_test(refused_memory_is_reported),     cmocka_unit_test(every_dataset_says_its_unit),
        cmocka_unit_test(a_static_study_has_no_motion),   cmocka_unit_test(impossible_probes_are_refused),
        cmocka_unit_test(units_are_the_studys),           cmocka_unit_test(hdf5_is_silent_only_while_we_use_it),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
