// SPDX-License-Identifier: GPL-3.0-or-later

/// What a study file says arrives in the problem, and what it does not say is as the table promises.

#include "study/folder.h"

static const char minimal[] =
    "plate = { width = 6; height = 4; };\n"
    "material = { youngs_modulus = 2; fracture_energy = 0.5; };\n"
    "cracks = ( { from = [-0.5, 0.0]; to = [0.5, 0.0]; }, { from = [2, 0]; to = [2, 1]; } );\n"
    "supports = ( { side = \"left\"; x = 0; }, { side = \"right\"; x = 0.1; } );\n";

static void defaults_of_texts_and_choices(void **state)
{
    (void)state;
    pdmc_study study;
    CHECK_OK(read_text(minimal, &study));
    const pdmc_problem *p = &study.problem;
    assert_string_equal(p->title, "untitled");
    assert_string_equal(p->length_unit, "m");
    assert_string_equal(p->force_unit, "N");
    assert_int_equal(p->material.assumption, PDMC_PLANE_STRESS);
    assert_string_equal(p->cracks[0].name, "crack1");
    assert_string_equal(p->cracks[1].name, "crack2");
    assert_int_equal(p->load_count, 0);
    assert_int_equal(p->uncertainty_count, 0);
    assert_int_equal(p->sampling.inverse, PDMC_INVERSE_NEUMANN);
    assert_int_equal(p->energy.bonds, PDMC_BONDS_ALL);
    assert_int_equal(p->energy.measure, PDMC_MEASURE_GRIFFITH);
    assert_string_equal(study.input, minimal);
    assert_string_equal(study.warnings, "");
    pdmc_study_clear(&study);
}

static void defaults_of_numbers(void **state)
{
    (void)state;
    pdmc_study study;
    CHECK_OK(read_text(minimal, &study));
    const pdmc_problem *p = &study.problem;
    assert_true(p->sampling.seed == 1);
    assert_int_equal(p->sampling.samples, 1000);
    assert_int_equal(p->sampling.keep, 20000);
    assert_int_equal(p->sampling.order, 4);
    assert_int_equal(p->solver.polynomial_degree, 3);
    assert_int_equal(p->solver.crack_orders, 6);
    assert_int_equal(p->solver.radial_points, 6);
    assert_int_equal(p->energy.angles, 72);
    assert_int_equal(p->energy.tip_count, 4);
    for (int i = 0; i < 4; i++) assert_int_equal(p->energy.tips[i], i);
    CHECK_NEAR(p->plate.thickness, 1.0, 0.0);
    CHECK_NEAR(p->solver.spacing, 4.0 / 20, 1e-15);       // of the shorter side
    CHECK_NEAR(p->solver.shape, 6 * 0.2, 1e-15);          // of the spacing
    CHECK_NEAR(p->solver.horizon, 0.02 * 4, 1e-15);       // less than 0.2 of the half cracks, 0.5
    CHECK_NEAR(p->energy.horizon, 0.08, 1e-15);          // the solver's
    CHECK_NEAR(p->energy.extension, 0.25 * 0.08, 1e-15); // of the energy horizon
    pdmc_study_clear(&study);
}

static void the_horizon_follows_the_shortest_crack(void **state)
{
    (void)state;
    pdmc_study study;
    CHECK_OK(read_with(LINE_CRACKS,
                       "cracks = ( { from = [-1, 1]; to = [1, 1]; }, { from = [0.0, 0.0]; to = [0.12, 0.16]; } );",
                       &study));
    CHECK_NEAR(study.problem.solver.horizon, 0.2 * 0.1, 1e-15); // half of hypot(0.12, 0.16)
    pdmc_study_clear(&study);
    CHECK_OK(read_with(LINE_CRACKS, "", &study));
    CHECK_NEAR(study.problem.solver.horizon, 0.02 * 4, 1e-15);
    assert_int_equal(study.problem.energy.tip_count, 0);
    pdmc_study_clear(&study);
}

static void defaults_of_uncertainties(void **state)
{
    (void)state;
    pdmc_study study;
    CHECK_OK(
        read_with(LINE_RANDOM, "random = ( { quantity = \"load\"; }, { quantity = \"micromodulus\"; } );", &study));
    const pdmc_uncertainty *load = pdmc_problem_uncertainty(&study.problem, PDMC_QUANTITY_LOAD);
    const pdmc_uncertainty *modulus = pdmc_problem_uncertainty(&study.problem, PDMC_QUANTITY_MICROMODULUS);
    assert_int_equal(study.problem.uncertainty_count, 2);
    assert_int_equal(load->distribution, PDMC_NORMAL);
    assert_int_equal(modulus->bins, 100);
    CHECK_NEAR(load->law.location, 1.0, 0.0);
    CHECK_NEAR(load->law.scale, 0.2, 0.0);
    CHECK_NEAR(modulus->variation, 0.2, 0.0);
    pdmc_study_clear(&study);
}

static void sides_loads_and_supports(void **state)
{
    (void)state;
    pdmc_study study;
    CHECK_OK(read_with(LINE_SUPPORTS,
                       "supports = ( { side = \"left\"; y = -0.25; }, { side = \"right\"; x = 0; y = 0; } );", &study));
    const pdmc_problem *p = &study.problem;
    assert_int_equal(p->load_count, 2);
    assert_int_equal(p->loads[0].side, PDMC_SIDE_TOP);
    assert_int_equal(p->loads[1].side, PDMC_SIDE_BOTTOM);
    CHECK_NEAR(p->loads[1].traction[1], -1.0, 0.0);
    assert_int_equal(p->support_count, 2);
    assert_int_equal(p->supports[0].side, PDMC_SIDE_LEFT);
    assert_false(p->supports[0].held[0]);
    assert_true(p->supports[0].held[1]);
    CHECK_NEAR(p->supports[0].displacement[1], -0.25, 0.0);
    assert_int_equal(p->supports[1].side, PDMC_SIDE_RIGHT);
    assert_true(p->supports[1].held[0] && p->supports[1].held[1]);
    pdmc_study_clear(&study);
}

static void components_of_one_side_may_be_held_apart(void **state)
{
    (void)state;
    pdmc_study study;
    CHECK_OK(
        read_with(LINE_SUPPORTS, "supports = ( { side = \"left\"; x = 0; }, { side = \"left\"; y = 0; } );", &study));
    pdmc_study_clear(&study);
}

static void tips_are_numbered_by_crack(void **state)
{
    (void)state;
    char text[1024];
    pdmc_study study;
    snprintf(text, sizeof text, "%senergy = { tips = [\"crack2.to\", \"crack1.from\"]; };", minimal);
    CHECK_OK(read_text(text, &study));
    assert_int_equal(study.problem.energy.tip_count, 2);
    assert_int_equal(study.problem.energy.tips[0], 3);
    assert_int_equal(study.problem.energy.tips[1], 0);
    pdmc_study_clear(&study);
}

static void expect_seed(const char *line, uint64_t seed)
{
    pdmc_study study;
    CHECK_OK(read_with(LINE_TOP, line, &study));
    assert_true(study.problem.sampling.seed == seed);
    pdmc_study_clear(&study);
}

static void seeds_of_63_bits(void **state)
{
    (void)state;
    expect_seed("seed = 0;", 0);
    expect_seed("seed = 5000000000;", 5000000000U); // libconfig would wrap it
    expect_seed("seed = 5000000000L;", 5000000000U);
    expect_seed("seed = 0xFFFFFFFF;", 4294967295U);
    expect_seed("seed = 010;", 10);
    expect_seed("seed = 9223372036854775807L;", INT64_MAX);
}

static void integers_where_reals_are_wanted(void **state)
{
    (void)state;
    pdmc_study study;
    CHECK_OK(read_with(LINE_MATERIAL, "material = { youngs_modulus = 210000000000; fracture_energy = 1; };", &study));
    CHECK_NEAR(study.problem.material.youngs_modulus, 2.1e11, 0.0);
    pdmc_study_clear(&study);
    CHECK_OK(read_with(LINE_CRACKS, "cracks = ( { from = [-1, 0]; to = (1, 0.5); } );", &study)); // a list may be mixed
    CHECK_NEAR(study.problem.cracks[0].from[0], -1.0, 0.0);
    CHECK_NEAR(study.problem.cracks[0].to[1], 0.5, 0.0);
    pdmc_study_clear(&study);
}

static void limits_written_in_decimals_are_allowed(void **state)
{
    (void)state;
    pdmc_study study;
    // half the half length of [0.3, 0.7] comes out as 0.09999999999999999
    CHECK_OK(read_with(
        LINE_CRACKS, "cracks = ( { from = [0.3, 0.1]; to = [0.7, 0.1]; } ); solver = { horizon = 0.1; spacing = 1; };",
        &study));
    pdmc_study_clear(&study);
}

static void clearing_twice_is_harmless(void **state)
{
    (void)state;
    pdmc_study study = {0};
    pdmc_study_clear(&study);
    CHECK_OK(read_text(minimal, &study));
    pdmc_study_clear(&study);
    pdmc_study_clear(&study);
}

static void every_allocation_may_be_refused(void **state)
{
    (void)state;
    pdmc_study study;
    write_text("study.cfg", minimal);
    CHECK_FAILS_CLEANLY(pdmc_study_read("study.cfg", &study), pdmc_study_clear(&study));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(defaults_of_texts_and_choices),
        cmocka_unit_test(defaults_of_numbers),
        cmocka_unit_test(the_horizon_follows_the_shortest_crack),
        cmocka_unit_test(defaults_of_uncertainties),
        cmocka_unit_test(sides_loads_and_supports),
        cmocka_unit_test(components_of_one_side_may_be_held_apart),
        cmocka_unit_test(tips_are_numbered_by_crack),
        cmocka_unit_test(seeds_of_63_bits),
        cmocka_unit_test(integers_where_reals_are_wanted),
        cmocka_unit_test(limits_written_in_decimals_are_allowed),
        cmocka_unit_test(clearing_twice_is_harmless),
        cmocka_unit_test(every_allocation_may_be_refused),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
