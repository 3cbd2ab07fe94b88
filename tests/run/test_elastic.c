// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/elastic.h"

#include "check.h"

#include <string.h>

static pdmc_elastic_condition conditions[] = {
    {PDMC_FACE_Y_LOW, 1, {{0.0}, {0.0}}},
    {PDMC_FACE_Y_HIGH, 1, {{0.0}, {0.0}}},
};
static const pdmc_elastic BLOCK = {
    .nodes = {5, 9, 4},
    .spacing = 1.0,
    .horizon = 2.0,
    .youngs_modulus = 100.0,
    .tolerance = 1e-11,
    .most_steps = 5000,
    .compensation = PDMC_COMPENSATION_SUM,
    .strain = {-2.5e-4, 1e-3, -2.5e-4},
    .condition_count = 2,
    .conditions = conditions,
};

static pdmc_results run(const pdmc_elastic *study, int threads)
{
    pdmc_results results = {.kind = PDMC_ELASTIC};
    const pdmc_run_options options = {.threads = threads};
    CHECK_OK(pdmc_run_elastic(study, &options, &results));
    return results;
}

/// The forces that hold the two ends are opposite. Where the layers move along y alone, by one distance each, these forces
/// do all of the work, which is the elastic energy.
static void ends_balance(void **state)
{
    (void)state;
    pdmc_elastic study = BLOCK;
    study.strain[0] = study.strain[2] = 0.0;
    pdmc_results r = run(&study, 1);
    const pdmc_elastic_record *e = &r.elastic;
    const double *low = &e->face_force[3 * PDMC_FACE_Y_LOW], *high = &e->face_force[3 * PDMC_FACE_Y_HIGH];
    for (int k = 0; k < 3; k++) CHECK_NEAR(low[k] + high[k], 0.0, 1e-9 * high[1]);
    assert_true(high[1] > 0.0);
    CHECK_NEAR(e->energy, 0.5 * (high[1] - low[1]) * 4e-3, 1e-9 * e->energy);
    assert_int_equal(e->node_count, 180);
    assert_int_equal(e->axis, 1);
    assert_int_equal(e->line_count, 9);
    CHECK_NEAR(e->line_position[0], -4.0, 0.0);
    CHECK_NEAR(e->line_displacement[8], 4e-3, 1e-17);
    CHECK_NEAR(e->line_strain[4], e->line_displacement[4] - e->line_displacement[3], 1e-17);
    CHECK_NEAR(e->face_displacement[3 * PDMC_FACE_Y_HIGH + 1], 4e-3, 1e-17);
    pdmc_results_clear(&r);
}

static void three_ways_and_threads(void **state)
{
    (void)state;
    pdmc_elastic study = BLOCK;
    pdmc_results still = run(&study, 1), other = run(&study, 3);
    const size_t n = 3 * (size_t)still.elastic.node_count;
    assert_memory_equal(still.elastic.displacement, other.elastic.displacement, n * sizeof(double));
    pdmc_results_clear(&other);
    study.method = PDMC_ELASTIC_RELAXATION;
    other = run(&study, 2);
    for (size_t i = 0; i < n; i++) CHECK_NEAR(other.elastic.displacement[i], still.elastic.displacement[i], 1e-11);
    pdmc_results_clear(&other);
    study.method = PDMC_ELASTIC_DAMPED;
    study.density = 1.0;
    study.damping = 1.0;
    study.safety = 0.5;
    study.steps = 600;
    other = run(&study, 1);
    for (size_t i = 0; i < n; i++) CHECK_NEAR(other.elastic.displacement[i], still.elastic.displacement[i], 1e-9);
    assert_int_equal(other.elastic.energy_count, 601);
    CHECK_NEAR(other.elastic.time[600], 600.0 * 0.5 / sqrt(100.0 / 1.5), 1e-9);
    CHECK_NEAR(other.elastic.elastic[600], still.elastic.energy, 1e-7 * still.elastic.energy);
    pdmc_results_clear(&still);
    pdmc_results_clear(&other);
}

static void failures(void **state)
{
    (void)state;
    pdmc_elastic study = BLOCK;
    pdmc_results results = {.kind = PDMC_ELASTIC};
    const pdmc_run_options options = {.threads = 1};
    study.method = PDMC_ELASTIC_RELAXATION;
    study.most_steps = 3;
    CHECK_STATUS(pdmc_run_elastic(&study, &options, &results), PDMC_ERR_SINGULAR);
    assert_non_null(strstr(pdmc_last_error(), "no rest after 3 steps"));
    pdmc_results_clear(&results);
    study = BLOCK;
    study.rule = PDMC_SOLID_GAUSS;
    study.gauss_points = 2;
    study.support = 1.0;
    results = (pdmc_results){.kind = PDMC_ELASTIC};
    CHECK_STATUS(pdmc_run_elastic(&study, &options, &results), PDMC_ERR_CONFIG);
    assert_non_null(strstr(pdmc_last_error(), "of node (0, 0, 0)"));
    pdmc_results_clear(&results);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(ends_balance), cmocka_unit_test(three_ways_and_threads),
                                       cmocka_unit_test(failures)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
