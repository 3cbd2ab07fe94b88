// SPDX-License-Identifier: GPL-3.0-or-later

/// Views of an explicit study: the figures that are read off its records, and that all of it is shown.

#include "results/made_up.h"
#include "views/captured.h"
#include "views/csv.h"
#include "views/explicit.h"

#include <jansson.h>

// 3 mm in 1 ms, from the first record with growth at 0.5 to the first with all of it at 1.4.
static void growth_is_read_off_the_records(void **state)
{
    (void)state;
    pdmc_results r = made_up_explicit(2);
    const pdmc_tip_growth none = pdmc_results_growth(&r.particles, 0), some = pdmc_results_growth(&r.particles, 1);
    CHECK_NEAR(none.growth, 0.0, 0.0);
    assert_true(isnan(none.begin) && isnan(none.end) && isnan(none.mean_speed));
    CHECK_NEAR(some.growth, 3.0, 0.0);
    CHECK_NEAR(some.begin, 0.5, 1e-15);
    CHECK_NEAR(some.end, 1.4, 1e-15);
    CHECK_NEAR(some.mean_speed, 3.0, 1e-14); // the 0.3 mm of the first record do not count

    CHECK_NEAR(some.most_speed, 3.0, 0.0);
    pdmc_results_clear(&r);
}

// The made-up energies balance but for rounding; 0.1 that is missing at the end is 0.1 of 4.
static void the_balance_is_of_what_came_in(void **state)
{
    (void)state;
    pdmc_results r = made_up_explicit(2);
    CHECK_NEAR(pdmc_explicit_balance_error(&r.particles), 0.0, 1e-15);
    r.particles.elastic[20] -= 0.1;
    r.particles.contact[20] += 0.2;
    CHECK_NEAR(pdmc_explicit_balance_error(&r.particles), 0.1 / 4.1, 1e-15);
    pdmc_results_clear(&r);
}

static void the_table_has_tips_and_spheres(void **state)
{
    (void)state;
    pdmc_results r = made_up_explicit(2);
    r.status = PDMC_RUN_NOT_FINITE;
    r.particles.stop = pdmc_strdup("step 201");
    char *text = captured(pdmc_view_table, &r);
    expect_line(text, "A made-up impact\n");
    expect_line(text, "  STOPPED, these are the steps until then: step 201\n");
    expect_line(text, "  32 nodes and 321 bonds in the plane, spacing 0.5, horizon 1.5 mm\n");
    expect_line(text, "  200 steps of 0.01 ms, 0.8 of the largest stable one; forces by portable\n");
    expect_line(text, "at 2 ms\n  first 2 + work 2 = kinetic 1 + elastic 2 + fracture 0.25 + contact 0.5 kN mm\n"
                      "  and dissipated 0.25 by damping\n");
    expect_line(text, "  end2                   369        372        375       -0.123     -0.124     -0.125\n");
    expect_line(text, "  200 bonds are broken, the mean damage is 0.2\n");
    expect_line(text, "  3 pieces of two nodes or more, the largest of 5 kN ms^2/mm; 1 nodes without bonds\n");
    expect_line(text, "  centre.from                  -1          0          0          -          -           -");
    expect_line(
        text, "  centre.to                     1          0          3        0.5        1.4           3          3\n");
    expect_line(text, "  sphere2");
    expect_line(text, "  glue2                      101           62       0.6089\n"); // 61.5 of 101, in whole bonds
    for (char *line = strtok(text, "\n"); line; line = strtok(NULL, "\n")) assert_true(strlen(line) <= 100);
    free(text);
    pdmc_results_clear(&r);
}

static void the_json_has_all_records(void **state)
{
    (void)state;
    pdmc_results r = made_up_explicit(3);
    char *text = captured(pdmc_view_json, &r);
    json_t *all = json_loads(text, 0, NULL);
    const json_t *object = json_object_get(all, "explicit");
    assert_string_equal(json_string_value(json_object_get(all, "kind")), "explicit");
    assert_int_equal(json_integer_value(json_object_get(object, "nodes")), 96);
    const json_t *tip = json_array_get(json_object_get(object, "tips"), 1);
    CHECK_NEAR(json_number_value(json_object_get(tip, "growth")), 3.0, 0.0);
    assert_int_equal(json_array_size(json_object_get(tip, "advance")), 21);
    const json_t *sphere = json_array_get(json_object_get(object, "spheres"), 1);
    assert_true(json_is_null(json_object_get(sphere, "mass"))); // infinite
    CHECK_NEAR(json_number_value(json_array_get(json_array_get(json_object_get(sphere, "centre"), 20), 2)),
               0.25 * (6 * 20 + 5), 0.0);
    CHECK_NEAR(json_number_value(json_array_get(json_array_get(json_object_get(sphere, "force"), 20), 2)),
               7.0 * (6 * 20 + 5), 0.0);
    const json_t *interface = json_array_get(json_object_get(object, "interfaces"), 1);
    assert_string_equal(json_string_value(json_object_get(interface, "name")), "glue2");
    CHECK_NEAR(json_number_value(json_object_get(interface, "bonds")), 101.0, 0.0);
    CHECK_NEAR(json_number_value(json_array_get(json_object_get(interface, "broken"), 20)), 1.5 * 41, 0.0);
    const json_t *condition = json_array_get(json_object_get(object, "conditions"), 1);
    assert_string_equal(json_string_value(json_object_get(condition, "name")), "end2");
    CHECK_NEAR(json_number_value(json_array_get(json_array_get(json_object_get(condition, "force"), 20), 1)),
               3.0 * (6 * 20 + 4), 0.0);
    const json_t *records = json_object_get(object, "records");
    CHECK_NEAR(json_number_value(json_array_get(json_object_get(records, "broken"), 20)), 200.0, 0.0);
    assert_string_equal(json_string_value(json_object_get(object, "precision")), "single");
    CHECK_NEAR(json_number_value(json_object_get(object, "force_error")), 20 / 4194304.0, 0.0);
    CHECK_NEAR(json_number_value(json_array_get(json_object_get(records, "force_error"), 4)), 4 / 4194304.0, 0.0);
    const json_t *pieces = json_object_get(object, "fragments");
    assert_int_equal(json_array_size(pieces), 2); // without the single node
    assert_int_equal(json_integer_value(json_object_get(json_array_get(pieces, 0), "nodes")), 93);
    CHECK_NEAR(json_number_value(json_object_get(json_array_get(pieces, 1), "mass")), 0.5, 0.0);
    CHECK_NEAR(json_number_value(json_object_get(json_object_get(object, "last"), "largest_fragment")), 5.0, 0.0);
    json_decref(all);
    free(text);
    pdmc_results_clear(&r);
}

static void single_precision_is_told(void **state)
{
    (void)state;
    pdmc_results r = made_up_explicit(3);
    char *table = captured(pdmc_view_table, &r), *records = captured(pdmc_csv_records, &r);
    expect_line(table, "  single precision changes no force by more than 4.768e-06 of the largest one\n");
    expect_line(records, "displacement.z[mm],glue1.broken,glue2.broken,force_error\n");
    expect_line(records, ",4.76837158203125e-06\n");
    free(table);
    free(records);
    pdmc_results_clear(&r);
    r = made_up_explicit(2);
    table = captured(pdmc_view_table, &r);
    assert_null(strstr(table, "precision"));
    free(table);
    pdmc_results_clear(&r);
}

static int lines_of(const char *text)
{
    int lines = 0;
    for (; *text; text++) lines += *text == '\n';
    return lines;
}

static void the_csv_has_records_and_nodes(void **state)
{
    (void)state;
    pdmc_results r = made_up_explicit(2);
    size_t size;
    CHECK_OK(pdmc_view_export(&r, scratch_path("csv")));
    char *records = scratch_read(scratch_path("csv/records.csv"), &size);
    char *nodes = scratch_read(scratch_path("csv/nodes.csv"), &size);
    char *fragments = scratch_read(scratch_path("csv/fragments.csv"), &size);
    assert_non_null(fragments);
    assert_non_null(records);
    assert_non_null(nodes);
    expect_line(records, "record,time[ms],kinetic[kN mm],elastic[kN mm],fracture[kN mm],contact[kN mm],dissipated[kN mm],work[kN mm],"
                         "momentum.x[kN ms],momentum.y[kN ms],momentum.z[kN ms],mean_damage,broken,fragments,"
                         "loose_nodes,largest_fragment[kN ms^2/mm],"
                         "centre.from.advance[mm],centre.from.speed[mm/ms],");
    expect_line(records, "\n20,2,1,2,0.25,0.5,0.25,2,0,-2,0,");
    expect_line(records, ",60,61.5"); // of interfaces
    assert_int_equal(lines_of(records), 22);
    expect_line(nodes, "body,position.x[mm],");
    expect_line(nodes, "\nbody2,3.5,1.5,0,"); // the last node
    expect_line(nodes, ",1,2\n");             // its damage, and its piece
    assert_int_equal(lines_of(nodes), 33);
    free(records);
    expect_line(fragments, "fragment,nodes,mass[kN ms^2/mm],centre.x[mm],");
    expect_line(fragments, "\n1,2,0.5,1,1.5,0,0,-1,2\n");
    assert_int_equal(lines_of(fragments), 4);
    free(nodes);
    free(fragments);
    assert_int_equal(scratch_empty(scratch_path("csv")), 3);
    scratch_empty(scratch);
    pdmc_results_clear(&r);
}

static void every_picture_is_drawn(void **state)
{
    (void)state;
    for (int dimension = 2; dimension <= 3; dimension++) {
        pdmc_results r = made_up_explicit(dimension);
        check_drawn(&r, 5, (const char *const[]){"energies", "tips", "damage", "fragments", "fragment_masses"});
        pdmc_results_clear(&r);
    }
}

static void samples_are_in_every_view(void **state)
{
    (void)state;
    size_t size;
    pdmc_results r = made_up_explicit(2);
    made_up_samples(&r);
    char *table = captured(pdmc_view_table, &r), *json = captured(pdmc_view_json, &r);
    expect_line(table, "4 samples of seed 0, 1 failed; in mm, with intervals at 0.95; above is the study at its means\n");
    expect_line(table, "\n  centre.to\n    P(still)        4.5 [4.25, 4.75]\n    P(arrested)     5.5 [5.25, 5.75]\n");
    expect_line(table, "    mean growth     21 [20.75, 21.25]\n    deviation       31 [30.75, 31.25]\n");
    expect_line(table, "    95 % quantile   45 [44.75, 45.25]\n");
    json_t *all = json_loads(json, 0, NULL);
    const json_t *tip = json_array_get(json_object_get(json_object_get(all, "ensemble"), "tips"), 1);
    const json_t *samples = json_object_get(tip, "samples");
    const json_t *through = json_object_get(json_object_get(tip, "probability"), "through");
    CHECK_NEAR(json_number_value(json_object_get(through, "lower")), 7.25, 0.0);
    CHECK_NEAR(json_number_value(json_array_get(json_object_get(samples, "growth"), 2)), 10.625, 0.0);
    assert_string_equal(json_string_value(json_array_get(json_object_get(samples, "outcome"), 1)), "through");
    assert_true(json_is_null(json_array_get(json_object_get(samples, "outcome"), 3))); // it failed
    CHECK_NEAR(json_number_value(json_array_get(json_object_get(samples, "end_y"), 0)), -0.625, 0.0);
    const json_t *high = json_object_get(json_object_get(tip, "path"), "high");
    CHECK_NEAR(json_number_value(json_object_get(json_array_get(high, 2), "value")), 60.0 + 17.0, 0.0);
    json_decref(all);
    CHECK_OK(pdmc_view_export(&r, scratch_path("csv")));
    char *draws = scratch_read(scratch_path("csv/samples.csv"), &size);
    char *paths = scratch_read(scratch_path("csv/paths.csv"), &size);
    expect_line(draws, "sample,failure,load,velocity,youngs_modulus,fracture_energy,fracture[kN mm],tip,outcome,growth[mm],");
    expect_line(draws, "\n1,0,1.125,2.125,3.125,4.125,5.125,centre.to,through,10.375,20.375,30.375,40.375,-0.25,-0.125\n");
    assert_int_equal(lines_of(draws), 9);
    expect_line(paths, "\ncentre.to,0.125,3.5,54,53.75,54.25,72,71.75,72.25,73,72.75,73.25,74,73.75,74.25\n");
    assert_int_equal(lines_of(paths), 7);
    assert_int_equal(scratch_empty(scratch_path("csv")), 5);
    if (system("gnuplot --version >/dev/null 2>&1") == 0) {
        CHECK_OK(pdmc_view_plot(&r, scratch_path("plots")));
        assert_int_equal(scratch_empty(scratch_path("plots")), 10 + 6);
    }
    free(table);
    free(json);
    free(draws);
    free(paths);
    scratch_empty(scratch);
    pdmc_results_clear(&r);
}

static void it_is_not_compared(void **state)
{
    (void)state;
    pdmc_results a = made_up_explicit(2), b = made_up_results(made_up_small);
    pdmc_comparison *comparison;
    const pdmc_comparison_request request = {.labels = {"a.h5", "b.h5"}};
    CHECK_STATUS(pdmc_comparison_create(&a, &b, &request, &comparison), PDMC_ERR_DATA);
    assert_string_equal(pdmc_last_error(), "a.h5 is of an explicit study, which is not compared yet");
    pdmc_results_clear(&a);
    pdmc_results_clear(&b);
}

// The same records as if they were of loads: forces grow to the end, 2.52 mm at 0.75 mm or so.
static pdmc_results made_up_loads(void)
{
    pdmc_results r = made_up_explicit(2);
    pdmc_explicit_record *p = &r.particles;
    r.kind = PDMC_QUASI_STATIC;
    p->residual = pdmc_calloc((size_t)p->record_count, sizeof(double));
    p->relaxation_steps = pdmc_calloc((size_t)p->record_count, sizeof(double));
    p->breakages = pdmc_calloc((size_t)p->record_count, sizeof(double));
    assert_true(p->residual && p->relaxation_steps && p->breakages);
    for (int i = 0; i < p->record_count; i++) {
        p->residual[i] = i / 1024.0;
        p->relaxation_steps[i] = 10.0;
        p->breakages[i] = i % 2;
    }
    return r;
}

static void loads_are_shown(void **state)
{
    (void)state;
    pdmc_results r = made_up_loads();
    r.status = PDMC_RUN_NO_REST;
    r.particles.stop = pdmc_strdup("load 2.1");
    char *text = captured(pdmc_view_table, &r);
    expect_line(text, "  STOPPED, these are the loads until then: load 2.1\n");
    expect_line(text, "  20 loads, residuals up to 0.02; 200 steps of relaxation; bonds broke 10 times\n  forces by portable\n");
    expect_line(text, "\nat 2 of the load\n");
    expect_line(text, "  and dissipated 0.25, where bonds broke\n");
    expect_line(text, "  centre.to                     1          0          3        0.5        1.4\n");
    expect_line(text, "\nspheres                           centre                            force\n");
    expect_line(text, "        861        868        875\n");
    // sqrt(369^2 + 372^2 + 375^2), and a 3000th of it
    expect_line(text, "  end2            largest force 644.3 at the displacement 0.2148, load 2\n");
    for (char *line = strtok(text, "\n"); line; line = strtok(NULL, "\n")) assert_true(strlen(line) <= 100);
    free(text);

    text = captured(pdmc_view_json, &r);
    json_t *all = json_loads(text, 0, NULL);
    const json_t *object = json_object_get(all, "quasi_static"), *records = json_object_get(object, "records");
    assert_string_equal(json_string_value(json_object_get(all, "kind")), "quasi_static");
    assert_null(json_object_get(records, "time"));
    CHECK_NEAR(json_number_value(json_array_get(json_object_get(records, "load"), 20)), 2.0, 1e-15);
    CHECK_NEAR(json_number_value(json_array_get(json_object_get(records, "residual"), 20)), 20 / 1024.0, 0.0);
    const json_t *condition = json_array_get(json_object_get(object, "conditions"), 1);
    CHECK_NEAR(json_number_value(json_object_get(condition, "largest_force")), sqrt(369. * 369 + 372 * 372 + 375 * 375),
               1e-12);
    json_decref(all);
    free(text);
    pdmc_results_clear(&r);
}

/// F_i u_(i+1) / u_i is 2, 3, 2 of the first three, and the last one's force is 1.6: of a displacement, not of a force.
static void the_force_between_loads(void **state)
{
    (void)state;
    pdmc_results r = made_up_loads();
    pdmc_explicit_record *p = &r.particles;
    const double force[] = {1.0, 2.0, 1.5, 1.6};
    p->record_count = 4;
    for (int i = 0; i < 4; i++)
        for (int a = 0; a < 3; a++) {
            p->condition_force[6 * i + 3 + a] = a == 1 ? -force[i] : 0.0;
            p->condition_displacement[6 * i + 3 + a] = a == 1 ? 0.5 * (i + 1.0) : 0.0;
        }
    assert_true(isnan(pdmc_results_force_between(p, 1)));
    p->conditions[1].kind = PDMC_CONDITION_DISPLACEMENT;
    CHECK_NEAR(pdmc_results_force_between(p, 1), 3.0, 1e-15);
    double largest;
    assert_int_equal(pdmc_results_largest_force(p, 1, &largest), 1);
    CHECK_NEAR(largest, 2.0, 0.0);
    p->record_count = 21;
    pdmc_results_clear(&r);
}

static void csv_and_pictures_of_loads(void **state)
{
    (void)state;
    pdmc_results r = made_up_loads();
    char *text = captured(pdmc_csv_records, &r);
    expect_line(text, "record,load,kinetic[kN mm],");
    expect_line(text, "displacement.z[mm],glue1.broken,glue2.broken,residual,relaxation_steps,breakages\n");
    expect_line(text, ",0.01953125,10,0\n");
    free(text);
    CHECK_OK(pdmc_view_plot(&r, scratch_path("plots")));
    size_t size = 0;
    char *bytes = scratch_read(scratch_path("plots/load_displacement.png"), &size);
    assert_true(size > 1000 && memcmp(bytes, "\x89PNG", 4) == 0);
    free(bytes);
    scratch_empty(scratch_path("plots"));
    scratch_empty(scratch);
    pdmc_results_clear(&r);
}

/// Three samples of the loads, the last of which failed.
static void make_up_forces(pdmc_results *r)
{
    pdmc_ensemble_results *e = &r->ensemble;
    *e = (pdmc_ensemble_results){.sample_count = 3, .failed_count = 1, .condition_count = r->particles.condition_count};
    const size_t conditions = (size_t)e->condition_count, values = 3 * conditions;
    double **arrays[] = {&e->load, &e->velocity, &e->youngs_modulus, &e->fracture_energy, &e->fracture};
    for (size_t k = 0; k < 5; k++) *arrays[k] = pdmc_calloc(3, sizeof(double));
    e->failure = pdmc_calloc(3, 1);
    e->failure[2] = PDMC_SAMPLE_DIVERGED;
    e->largest_force = pdmc_calloc(values, sizeof(double));
    e->load_of_force = pdmc_calloc(values, sizeof(double));
    for (size_t i = 0; i < values; i++) e->largest_force[i] = 10.5 + (double)i, e->load_of_force[i] = 0.25;
    e->mean_force = pdmc_calloc(conditions, sizeof *e->mean_force);
    e->force_deviation = pdmc_calloc(conditions, sizeof *e->mean_force);
    e->force_quantiles = pdmc_calloc(PDMC_QUANTILES * conditions, sizeof *e->mean_force);
    for (size_t c = 0; c < conditions; c++) e->mean_force[c] = (pdmc_estimate){100.0 + (double)c, 90.0, 110.0};
    for (size_t q = 0; q < PDMC_QUANTILES * conditions; q++)
        e->force_quantiles[q] = (pdmc_estimate){(double)q, (double)q - 0.5, (double)q + 0.5};
}

static void largest_forces_are_in_every_view(void **state)
{
    (void)state;
    size_t size = 0;
    pdmc_results r = made_up_loads();
    make_up_forces(&r);
    char *text = captured(pdmc_view_table, &r);
    expect_line(text, "\n  end2, largest force, kN\n    mean            101 [90, 110]\n");
    expect_line(text, "    95 % quantile   5 [4.5, 5.5]\n");
    free(text);
    text = captured(pdmc_view_json, &r);
    json_t *all = json_loads(text, 0, NULL);
    const json_t *condition =
        json_array_get(json_object_get(json_object_get(all, "ensemble"), "conditions"), 1);
    CHECK_NEAR(json_number_value(json_array_get(json_object_get(condition, "largest_force"), 1)), 13.5, 0.0);
    CHECK_NEAR(json_number_value(json_object_get(json_object_get(condition, "mean_largest_force"), "lower")), 90.0, 0.0);
    json_decref(all);
    free(text);
    CHECK_OK(pdmc_view_export(&r, scratch_path("csv")));
    text = scratch_read(scratch_path("csv/forces.csv"), &size);
    expect_line(text, "condition,largest_force[kN],load_of_largest_force\n0,0,0,0,0,end1,10.5,0.25\n0,0,0,0,0,end2,11.5,0.25\n");
    assert_int_equal(lines_of(text), 7);
    free(text);
    scratch_empty(scratch_path("csv"));
    CHECK_OK(pdmc_view_plot(&r, scratch_path("plots")));
    text = scratch_read(scratch_path("plots/forces_end2.png"), &size);
    assert_true(size > 1000 && memcmp(text, "\x89PNG", 4) == 0);
    free(text);
    scratch_empty(scratch_path("plots"));
    scratch_empty(scratch);
    pdmc_results_clear(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(growth_is_read_off_the_records),
        cmocka_unit_test(the_balance_is_of_what_came_in),
        cmocka_unit_test(the_table_has_tips_and_spheres),
        cmocka_unit_test(the_json_has_all_records),
        cmocka_unit_test(single_precision_is_told),
        cmocka_unit_test(the_csv_has_records_and_nodes),
        cmocka_unit_test(every_picture_is_drawn),
        cmocka_unit_test(samples_are_in_every_view),
        cmocka_unit_test(it_is_not_compared),
        cmocka_unit_test(loads_are_shown),
        cmocka_unit_test(the_force_between_loads),
        cmocka_unit_test(csv_and_pictures_of_loads),
        cmocka_unit_test(largest_forces_are_in_every_view),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
