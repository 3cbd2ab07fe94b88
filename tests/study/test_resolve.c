// SPDX-License-Identifier: GPL-3.0-or-later

/// The resolved study is a study file that reads back to the same problem.

#include "study/folder.h"
#include "study/study_impl.h"

static const char everything[] =
    "title = \"a \\\"quoted\\\" back\\\\nslash, \xc2\xb5\"; seed = 9223372036854775807;\n"
    "units = { length = \"\xc2\xb5m\"; force = \"kN\"; };\n"
    "plate = { width = 6.25; height = 4.1; thickness = 0.3; };\n"
    "material = { youngs_modulus = 1e22; assumption = \"plane_strain\"; fracture_energy = 1e-300; };\n"
    "cracks = ( { name = \"left-1\"; from = [-2.0, 0.1]; to = [-1.0, 0.33333333333333331]; },\n"
    "           { from = [1, 0]; to = [2, 0]; } );\n"
    "loads = ( { side = \"top\"; traction = [0.1, 0.3]; } );\n"
    "supports = ( { side = \"left\"; x = 0; y = 1e-3; }, { side = \"right\"; y = -0.125; } );\n"
    "solver = { method = \"kansa\"; crack_model = \"analytic\"; spacing = 0.30000000000000004; horizon = 0.07;\n"
    "           shape = 1.7; polynomial_degree = 2; crack_orders = 8; radial_points = 4; };\n"
    "random = ( { quantity = \"load\"; distribution = \"lognormal\"; variation = 0.15; },\n"
    "           { quantity = \"micromodulus\"; model = \"radial_process\"; bins = 17; variation = 0.05; modes = 9;\n"
    "             covariance = \"matern\"; correlation_length = 0.02; smoothness = 1.5; },\n"
    "           { quantity = \"stiffness\"; distribution = \"lognormal\"; correlation_length = 0.5; },\n"
    "           { quantity = \"fracture_energy\"; distribution = \"weibull\"; scale = 0.3; shape = 7; most = 0.4;\n"
    "             covariance = \"matern\"; correlation_length = 0.25; smoothness = 0.7; },\n"
    "           { quantity = \"thickness\"; distribution = \"triangular\"; lower = 0.2; mode = 0.3; upper = 0.5; },\n"
    "           { quantity = \"youngs_modulus\"; distribution = \"empirical\"; values = [3.0, 1.5, 2e3, 0.1]; } );\n"
    "correlations = ( { first = \"load\"; second = \"thickness\"; correlation = -0.3; } );\n"
    "sampling = { samples = 12345; inverse = \"direct\"; order = 2; };\n"
    "energy = { tips = [\"crack2.to\", \"left-1.from\"]; angles = 36; horizon = 0.04; extension = 0.005;\n"
    "           bonds = \"tensile\"; measure = \"bond\"; };\n";

// The law by its values, the rest bit for bit once the pointers are gone.
static void check_same_uncertainty(const pdmc_uncertainty *a, const pdmc_uncertainty *b)
{
    pdmc_uncertainty x = *a, y = *b;
    assert_int_equal(a->value_count, b->value_count);
    if (a->value_count > 0) assert_memory_equal(a->values, b->values, (size_t)a->value_count * sizeof *a->values);
    for (int z = -2; z <= 2 && a->quantity >= PDMC_FIRST_SCALAR; z++)
        CHECK_NEAR(pdmc_distribution_value(&a->law, z), pdmc_distribution_value(&b->law, z), 0.0);
    memset(&x.law, 0, sizeof x.law);
    memset(&y.law, 0, sizeof y.law);
    x.values = y.values = NULL;
    assert_memory_equal(&x, &y, sizeof x);
}

static void check_same_items(const pdmc_problem *a, const pdmc_problem *b)
{
#define SAME_ITEMS(items, count)                                                                                       \
    do {                                                                                                               \
        assert_int_equal(a->count, b->count);                                                                          \
        if (a->count > 0) assert_memory_equal(a->items, b->items, (size_t)a->count * sizeof *a->items);                \
    } while (0)
    SAME_ITEMS(cracks, crack_count);
    SAME_ITEMS(loads, load_count);
    SAME_ITEMS(supports, support_count);
    SAME_ITEMS(correlations, correlation_count);
    assert_int_equal(a->uncertainty_count, b->uncertainty_count);
    for (int i = 0; i < a->uncertainty_count; i++) check_same_uncertainty(&a->uncertainties[i], &b->uncertainties[i]);
    SAME_ITEMS(history, history_count);
    SAME_ITEMS(probes, probe_count);
    SAME_ITEMS(energy.tips, energy.tip_count);
#undef SAME_ITEMS
}

static void check_same(const pdmc_problem *a, const pdmc_problem *b)
{
    assert_string_equal(a->title, b->title);
    assert_string_equal(a->length_unit, b->length_unit);
    assert_string_equal(a->force_unit, b->force_unit);
    assert_string_equal(a->time_unit, b->time_unit);
    check_same_items(a, b);
    // What is left is plain once the pointers are gone: bit for bit, padding included, since problems begin as zeros.
    pdmc_problem x = *a, y = *b;
    pdmc_problem *both[2] = {&x, &y};
    for (int i = 0; i < 2; i++) {
        both[i]->title = both[i]->length_unit = both[i]->force_unit = both[i]->time_unit = NULL;
        both[i]->cracks = NULL;
        both[i]->loads = NULL;
        both[i]->supports = NULL;
        both[i]->uncertainties = NULL;
        both[i]->correlations = NULL;
        both[i]->history = NULL;
        both[i]->probes = NULL;
        both[i]->energy.tips = NULL;
    }
    assert_memory_equal(&x, &y, sizeof x);
}

static void expect_round_trip(const pdmc_study *study)
{
    pdmc_study again;
    CHECK_OK(read_text(study->resolved, &again));
    check_same(&study->problem, &again.problem);
    assert_string_equal(study->resolved, again.resolved);
    pdmc_study_clear(&again);
}

static void every_setting_survives(void **state)
{
    (void)state;
    pdmc_study study;
    CHECK_OK(read_text(everything, &study));
    assert_string_equal(study.problem.title, "a \"quoted\" back\\nslash, \xc2\xb5");
    CHECK_NEAR(study.problem.solver.spacing, 0.1 + 0.2, 0.0);
    CHECK_NEAR(study.problem.cracks[0].to[1], 1.0 / 3.0, 0.0);
    assert_int_equal(study.problem.energy.measure, PDMC_MEASURE_BOND);
    assert_int_equal(study.problem.sampling.inverse, PDMC_INVERSE_DIRECT);
    assert_non_null(strstr(study.resolved, "seed = 9223372036854775807L;\n")); // any libconfig reads it
    expect_round_trip(&study);
    pdmc_study_clear(&study);
}

static void settings_of_every_solver_survive(void **state)
{
    (void)state;
    const char *const solvers[] = {
        "solver = { crack_model = \"paper\"; tip_functions = \"off\"; edge_layer = 0.01; };",
        "solver = { crack_model = \"visible\"; refinement = 5; stencil = \"polyharmonic\"; };",
        "solver = { method = \"bond\"; spacing = 0.05; horizon_ratio = 4; area = \"full\";\n"
        "           surface_correction = \"off\"; micromodulus = \"at_nodes\"; load_layer = 0.1; };",
    };
    for (size_t i = 0; i < sizeof solvers / sizeof solvers[0]; i++) {
        pdmc_study study;
        CHECK_OK(read_with(LINE_SOLVER, solvers[i], &study));
        expect_round_trip(&study);
        pdmc_study_clear(&study);
    }
}

static void random_cracks_survive(void **state)
{
    (void)state;
    pdmc_study study;
    CHECK_OK(read_with(LINE_CRACKS,
                       "cracks = ( { from = [-1, 0]; to = [0, 0]; }, { name = \"b\"; from = [1, 0]; to = [1.0, 1.5]; } );\n"
                       "random = ( { quantity = \"crack_angle\"; crack = \"b\"; location = 1; scale = 10; },\n"
                       "           { quantity = \"crack_x\"; distribution = \"uniform\"; lower = -1; upper = 0.5; },\n"
                       "           { quantity = \"crack_length\"; crack = \"b\"; } );",
                       &study));
    const pdmc_uncertainty *uncertain = study.problem.uncertainties;
    assert_int_equal(uncertain[0].crack, 1);
    assert_int_equal(uncertain[1].crack, 0);
    CHECK_NEAR(pdmc_distribution_value(&uncertain[2].law, 1.0), 1.2 * 1.5, 1e-15); // the crack's length, and 20 % of it
    expect_round_trip(&study);
    pdmc_study_clear(&study);
}

static void defaults_survive(void **state)
{
    (void)state;
    pdmc_study study;
    CHECK_OK(read_with(LINE_TOP, "", &study));
    expect_round_trip(&study);
    pdmc_study_clear(&study);
    CHECK_OK(read_with(LINE_CRACKS, "", &study)); // no tips
    expect_round_trip(&study);
    pdmc_study_clear(&study);
}

static void shipped_studies_survive(void **state)
{
    (void)state;
    const char *const paths[] = {STUDIES "/center_crack/study.cfg", STUDIES "/sudden_load/study.cfg"};
    for (size_t i = 0; i < sizeof paths / sizeof paths[0]; i++) {
        pdmc_study study;
        CHECK_OK(pdmc_study_read(paths[i], &study));
        expect_round_trip(&study);
        pdmc_study_clear(&study);
    }
}

static void a_dynamic_study_survives(void **state)
{
    (void)state;
    const char dynamic[] =
        "kind = \"dynamic\"; units = { time = \"ms\"; };\n"
        "plate = { width = 6.0; height = 4.0; };\n"
        "material = { youngs_modulus = 2.0; fracture_energy = 0.5; };\n"
        "cracks = ( { name = \"a\"; from = [-0.5, 0.0]; to = [0.5, 0.0]; } );\n"
        "loads = ( { side = \"top\"; traction = [0, 1]; }, { side = \"bottom\"; traction = [0, -1]; } );\n"
        "dynamics = { density = 7.85e-9; damping = 0.1; step = 0.01; duration = 3.0; };\n"
        "history = ( { time = 0.5; factor = 1; }, { time = 0.7; factor = -0.1; } );\n"
        "probes = ( { at = [0.1, 0.0]; side = \"left\"; }, { name = \"corner\"; at = [3, 2]; } );\n";
    pdmc_study study;
    CHECK_OK(read_text(dynamic, &study));
    const pdmc_problem *p = &study.problem;
    assert_int_equal(p->kind, PDMC_DYNAMIC);
    assert_int_equal(p->history_count, 2);
    CHECK_NEAR(p->history[1].factor, -0.1, 0.0);
    assert_string_equal(p->probes[0].name, "probe1");
    assert_int_equal(p->probes[0].face, PDMC_FACE_LEFT);
    assert_int_equal(p->probes[1].face, PDMC_FACE_NONE);
    assert_int_equal(pdmc_problem_steps(p), 300);
    assert_non_null(strstr(study.resolved, "    density = 7.85e-09; # N ms^2/m^4\n"));
    assert_non_null(strstr(study.resolved, "    damping = 0.1; # 1/ms\n"));
    assert_null(strstr(study.resolved, "sampling"));
    expect_round_trip(&study);
    pdmc_study_clear(&study);
    write_text("study.cfg", dynamic);
    CHECK_FAILS_CLEANLY(pdmc_study_read("study.cfg", &study), pdmc_study_clear(&study));
}

static void changes_are_written(void **state)
{
    (void)state;
    pdmc_study study, again;
    CHECK_OK(read_with(LINE_TOP, "seed = 1;", &study));
    study.problem.sampling.seed = 99;
    study.problem.sampling.samples = 5;
    CHECK_OK(pdmc_study_resolve(&study));
    CHECK_OK(read_text(study.resolved, &again));
    assert_true(again.problem.sampling.seed == 99);
    assert_int_equal(again.problem.sampling.samples, 5);
    pdmc_study_clear(&again);
    pdmc_study_clear(&study);
}

static void units_stand_beside_the_numbers(void **state)
{
    (void)state;
    pdmc_study study;
    CHECK_OK(read_with(LINE_TOP, "", &study));
    assert_non_null(strstr(study.resolved, "    width = 6.0; # mm\n"));
    assert_non_null(strstr(study.resolved, "    youngs_modulus = 2.0; # N/mm^2\n"));
    assert_non_null(strstr(study.resolved, "    fracture_energy = 0.5; # N/mm\n"));
    assert_non_null(strstr(study.resolved, "    to = [0.5, 0.0]; # mm\n"));
    assert_non_null(strstr(study.resolved, "    samples = 1000;\n"));
    pdmc_study_clear(&study);
}

static void every_setting_is_described_on_its_line(void **state)
{
    (void)state;
    char *text, *rest;
    CHECK_OK(pdmc_study_describe(&text));
    pdmc_study_section_id section = SECTIONS;
    const pdmc_study_setting *s = pdmc_study_settings;
    rest = text;
    for (char *line = strtok_r(text, "\n", &rest); line; line = strtok_r(NULL, "\n", &rest)) {
        if (*line != ' ') { // a section, in the order of the table
            section = section == SECTIONS ? SECTION_TOP : section + 1;
            continue;
        }
        assert_int_equal(s->section, section);
        assert_ptr_equal(strstr(line, s->key), line + 4);
        assert_true(line[4 + strlen(s->key)] == ' ');
        assert_non_null(strstr(line, s->fallback ? s->fallback : "required"));
        assert_non_null(strstr(line, s->doc));
        s++;
    }
    assert_null(s->key);
    free(text);
}

static void a_line_of_the_description_says_it_all(void **state)
{
    (void)state;
    char *text;
    CHECK_OK(pdmc_study_describe(&text));
    assert_non_null(strstr(text, "    thickness          a real > 0; length; default 1.0; extent out of the plane\n"));
    assert_non_null(strstr(text, "    youngs_modulus     a real > 0; force/length^2; required; Young's modulus E\n"));
    free(text);
}

static void the_table_is_in_order(void **state)
{
    (void)state;
    for (const pdmc_study_setting *s = pdmc_study_settings; s[1].key; s++) assert_true(s->section <= s[1].section);
}

static pdmc_status resolve_or_keep(pdmc_study *study)
{
    char *before = study->resolved;
    const pdmc_status status = pdmc_study_resolve(study);
    if (status != PDMC_OK) assert_ptr_equal(study->resolved, before);
    return status;
}

static void allocations_may_be_refused(void **state)
{
    (void)state;
    pdmc_study study;
    write_text("study.cfg", everything);
    CHECK_FAILS_CLEANLY(pdmc_study_read("study.cfg", &study), (void)0);
    CHECK_FAILS_CLEANLY(resolve_or_keep(&study), (void)0);
    pdmc_study_clear(&study);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_setting_survives),
        cmocka_unit_test(settings_of_every_solver_survive),
        cmocka_unit_test(random_cracks_survive),
        cmocka_unit_test(defaults_survive),
        cmocka_unit_test(shipped_studies_survive),
        cmocka_unit_test(a_dynamic_study_survives),
        cmocka_unit_test(changes_are_written),
        cmocka_unit_test(units_stand_beside_the_numbers),
        cmocka_unit_test(every_setting_is_described_on_its_line),
        cmocka_unit_test(a_line_of_the_description_says_it_all),
        cmocka_unit_test(the_table_is_in_order),
        cmocka_unit_test(allocations_may_be_refused),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
