// SPDX-License-Identifier: GPL-3.0-or-later

/// Scalar studies: what is read, that the resolved study reads back to it, and the mistakes that only they allow.

#include "study/folder.h"

enum { DOMAIN, KERNEL, ELEMENTS, WAVE, CONVERGENCE, MOTION, PARTS };

// One group a line, from line 2 on, of which one is replaced.
static pdmc_status read_scalar(int part, const char *replacement, pdmc_study *study)
{
    const char *lines[PARTS] = {
        [DOMAIN] = "domain = { dimension = 1; width = 2; };",
        [KERNEL] = "kernel = { horizon = 0.25; };",
        [ELEMENTS] = "elements = { cells = 8; };",
        [WAVE] = "wave = { length = 3; };",
        [CONVERGENCE] = "",
        [MOTION] = "",
    };
    char text[2048] = "kind = \"scalar\";\n";
    lines[part] = replacement;
    for (int i = 0; i < PARTS; i++) {
        strcat(text, lines[i]);
        strcat(text, "\n");
    }
    return read_text(text, study);
}

static const char full[] = "kind = \"scalar\"; title = \"plane\"; units = { length = \"mm\"; };\n"
                           "domain = { dimension = 2; width = 3.0; height = 2.0; };\n"
                           "kernel = { horizon = 0.5; power = 1.5; weights = [1.0, 0.0, 2.5]; };\n"
                           "elements = { space = \"mixed\"; cells = 6; outer = \"edges\"; inner = \"polynomial\"; "
                           "parts = 2; rough_from = -0.5;\n"
                           "             rough_to = 0.75; };\n"
                           "wave = { length = 4.0; angle = 15.0; phase = 70; }; convergence = { levels = 3; };\n"
                           "motion = { duration = 2.5; safety = 0.5; };\n";

static void everything_is_read_and_reads_back(void **state)
{
    (void)state;
    pdmc_study study, again;
    CHECK_OK(read_text(full, &study));
    const pdmc_scalar *s = &study.scalar;
    assert_int_equal(study.problem.kind, PDMC_SCALAR);
    assert_int_equal(s->dimension, 2);
    CHECK_NEAR(s->height, 2.0, 0.0);
    CHECK_NEAR(s->power, 1.5, 0.0);
    assert_int_equal(s->weight_count, 3);
    CHECK_NEAR(s->weights[2], 2.5, 0.0);
    assert_int_equal(s->space, PDMC_SPACE_MIXED);
    assert_int_equal(s->outer, PDMC_OUTER_EDGES);
    assert_int_equal(s->inner, PDMC_INNER_POLYNOMIAL);
    CHECK_NEAR(s->rough_to, 0.75, 0.0);
    CHECK_NEAR(s->angle, 15.0, 0.0);
    assert_int_equal(s->vary, PDMC_VARY_SPACING);
    assert_true(s->has_duration && s->duration == 2.5);
    CHECK_OK(read_text(study.resolved, &again));
    assert_string_equal(again.resolved, study.resolved);
    pdmc_study_clear(&again);
    pdmc_study_clear(&study);
}

static void levels_are_halved(void **state)
{
    (void)state;
    pdmc_study study;
    CHECK_OK(read_text(full, &study));
    pdmc_scalar_level at = pdmc_scalar_level_of(&study.scalar, 2);
    assert_int_equal(at.cells[0], 24);
    assert_int_equal(at.cells[1], 16);
    CHECK_NEAR(at.horizon, 0.5, 0.0);
    study.scalar.vary = PDMC_VARY_HORIZON;
    at = pdmc_scalar_level_of(&study.scalar, 2);
    assert_int_equal(at.cells[0], 6);
    CHECK_NEAR(at.horizon, 0.125, 0.0);
    pdmc_study_clear(&study);
}

static void defaults_are_filled_in(void **state)
{
    (void)state;
    pdmc_study study;
    CHECK_OK(read_scalar(MOTION, "", &study));
    CHECK_NEAR(study.scalar.power, 1.0, 0.0);
    CHECK_NEAR(study.scalar.phase, 30.0, 0.0);
    assert_int_equal(study.scalar.outer, PDMC_OUTER_GAUSS);
    assert_int_equal(study.scalar.levels, 4);
    assert_false(study.scalar.has_duration);
    assert_null(strstr(study.resolved, "height")); // of two dimensions
    pdmc_study_clear(&study);
}

static void mistakes_are_told(void **state)
{
    (void)state;
    static const struct {
        int part;
        const char *line, *message;
    } mistakes[] = {
        {DOMAIN, "domain = { dimension = 1; width = 2; height = 1; };",
         "study.cfg:2: domain.height: is no setting of the dimension 1"},
        {KERNEL, "kernel = { horizon = 0.25; power = 2.0; };",
         "study.cfg:3: kernel.power: 2.0 is not allowed, must be from 0 to 2"},
        {KERNEL, "kernel = { horizon = 0.25; weights = [0.0, 0.0]; };",
         "study.cfg:3: kernel.weights: all are zero, one must be positive"},
        {ELEMENTS, "elements = { cells = 8; outer = \"edges\"; };",
         "study.cfg:4: elements.outer: \"edges\" is not allowed in one dimension with kernel.power = 1: from the end "
         "of an "
         "interval the integral of the kernel is infinite, the power must be < 1"},
        {ELEMENTS, "elements = { cells = 8; outer = \"exact\"; inner = \"careless\"; };",
         "study.cfg:4: elements.inner: the inner integral must be \"exact\" where the outer one is"},
        {ELEMENTS, "elements = { cells = 8; space = \"mixed\"; rough_from = 1.0; rough_to = 0.5; };",
         "study.cfg:4: elements.rough_to: 0.5 is not allowed, must be > rough_from = 1"},
        {ELEMENTS, "elements = { cells = 8; rough_from = 1.0; };",
         "study.cfg:4: elements.rough_from: is no setting of the space \"continuous\""},
        {WAVE, "wave = { length = 3; angle = 10; };",
         "study.cfg:5: wave.angle: 10 is not allowed in one dimension, must be 0"},
        {WAVE, "plate = { width = 1; height = 1; }; wave = { length = 3; };",
         "study.cfg:5: plate: is not part of a study of kind \"scalar\""},
        {KERNEL, "kernel = { horizon = 0.25; law = \"softening\"; };",
         "study.cfg:3: kernel.stretch: is missing, must be a real > 0"},
        {KERNEL, "kernel = { horizon = 0.25; stretch = 1; };",
         "study.cfg:3: kernel.stretch: is no setting of the law \"linear\""},
        {KERNEL, "kernel = { horizon = 0.25; law = \"softening\"; stretch = 1; };",
         "study.cfg:4: elements.inner: \"exact\" is for linear bonds only, must be \"polynomial\" with a kernel.law"},
        {WAVE, "wave = { length = 3; }; source = { value = 1; };",
         "study.cfg:5: wave.length: is not allowed beside source, prescribed or open_sides: the wave has its own"},
        {WAVE, "", "study.cfg: wave.length: is missing: without a wave there must be a source, prescribed values or "
                   "open_sides"},
        {WAVE, "source = { kind = \"polynomial\"; };",
         "study.cfg:5: source.coefficients: is missing, must be an array of 2 reals or more, [x1, x2, ...]"},
        {WAVE, "source = { kind = \"table\"; file = \"none.txt\"; };", "none.txt: No such file or directory"},
        {WAVE, "source = { file = \"none.txt\"; };", "study.cfg:5: source.file: is no setting of the kind \"constant\""},
        {WAVE, "open_sides = ( { side = \"top\"; } );",
         "study.cfg:5: open_sides[0].side: an interval has no such side, must be \"left\" or \"right\""},
        {WAVE, "open_sides = ( { side = \"left\"; }, { side = \"left\"; } );",
         "study.cfg:5: open_sides[1].side: is in the list already, must be another side"},
        {WAVE, "open_sides = ( { side = \"left\"; }, { side = \"right\"; } );",
         "study.cfg:5: open_sides: all sides are open, one must be held: nothing else holds the field"},
        {MOTION, "motion = { duration = 1; }; convergence = { vary = \"horizon\"; };",
         "study.cfg:7: motion.duration: motion is for convergence.vary = \"spacing\" only"},
    };
    for (size_t i = 0; i < sizeof mistakes / sizeof mistakes[0]; i++) {
        pdmc_study study;
        assert_int_not_equal(read_scalar(mistakes[i].part, mistakes[i].line, &study), PDMC_OK);
        assert_string_equal(pdmc_last_error(), mistakes[i].message);
    }
    pdmc_study study;
    CHECK_STATUS(
        read_text("kind = \"scalar\"; domain = { dimension = 2; width = 1; height = 1; };\n"
                  "kernel = { horizon = 0.1; }; elements = { cells = 8; outer = \"exact\"; }; wave = { length = 1; };",
                  &study),
        PDMC_ERR_CONFIG);
    assert_string_equal(pdmc_last_error(), "study.cfg:2: elements.outer: \"exact\" is for one dimension only, must be "
                                           "\"gauss\" or \"edges\"");
    CHECK_STATUS(
        read_scalar(CONVERGENCE, "convergence = { levels = 12; }; domain = { dimension = 1; width = 1e5; };", &study),
        PDMC_ERR_CONFIG);
}

// Of tables: the line that is no point, and points that are no grid.
static void tables_that_are_no_good_are_refused(void **state)
{
    (void)state;
    static const struct {
        int dimension;
        const char *table, *message;
    } mistakes[] = {
        {1, "0 1\n\n1 2 3\n", "t.txt:3: is no point, must be two numbers, x value"},
        {1, "0 1 # a\n0 2\n", "t.txt:2: the point is in the place of that of line 1"},
        {1, "0 1\n", "t.txt: 1 points are no grid of two or more points"},
        {1, "# nothing\n", "t.txt: has no point"},
        {1, "0 inf\n", "t.txt:1: inf, must be finite"},
        {2, "0 0 1\n1 0 1\n0 1 1\n2 1 1\n", "t.txt:4: the points are no grid: each row must have the same x"},
        {2, "0 0 1\n1 0 1\n0 1 1\n", "t.txt: 3 points are no grid of two or more columns and rows"},
        {2, "0 0 1\n1 0 1\n", "t.txt: 2 points are no grid of two or more columns and rows"},
    };
    for (size_t i = 0; i < sizeof mistakes / sizeof mistakes[0]; i++) {
        pdmc_given given = {0};
        write_text("t.txt", mistakes[i].table);
        CHECK_STATUS(pdmc_given_read("t.txt", mistakes[i].dimension, &given), PDMC_ERR_DATA);
        assert_string_equal(pdmc_last_error(), mistakes[i].message);
    }
}

static void open_sides_are_those_of_cells(void **state)
{
    (void)state;
    pdmc_study study;
    CHECK_STATUS(read_text("kind = \"scalar\"; domain = { dimension = 2; width = 3; height = 2; }; kernel = { horizon = 0.5; };\n"
                           "elements = { mesh = \"triangles\"; spacing = 0.5; }; open_sides = ( { side = \"top\"; } );",
                           &study),
                 PDMC_ERR_CONFIG);
    assert_string_equal(pdmc_last_error(), "study.cfg:2: open_sides: open sides are for elements.mesh = \"cells\" only");
}

static const char own[] =
    "kind = \"scalar\"; domain = { dimension = 2; width = 3.0; height = 2.0; };\n"
    "kernel = { horizon = 0.5; law = \"stiffening\"; stretch = 2.5; };\n"
    "elements = { cells = 6; inner = \"polynomial\"; };\n"
    "source = { kind = \"table\"; file = \"t.txt\"; }; prescribed = { kind = \"polynomial\"; coefficients = [1.0, 2.5]; };\n"
    "open_sides = ( { side = \"top\"; flux = 0.5; }, { side = \"left\"; } ); motion = { duration = 1; };";

static void a_source_of_ones_own_is_read_and_reads_back(void **state)
{
    (void)state;
    pdmc_study study, again;
    write_text("t.txt", "0 0 1\n1 0 2\n0 2 3\n1 2 8\n");
    CHECK_OK(read_text(own, &study));
    const pdmc_scalar *s = &study.scalar;
    assert_false(s->has_wave);
    assert_int_equal(s->law.kind, PDMC_LAW_STIFFENING);
    CHECK_NEAR(s->law.stretch, 2.5, 0.0);
    assert_int_equal(s->source.columns, 2);
    CHECK_NEAR(pdmc_given_at(&s->source, 2, (double[2]){0.25, 0.5}), 0.75 * 1.25 + 0.25 * 1.5 + 0.75 * 0.25 + 0.25 * 2.0, 1e-15);
    CHECK_NEAR(pdmc_given_at(&s->source, 2, (double[2]){5.0, 9.0}), 8.0, 0.0); // beyond the table
    CHECK_NEAR(pdmc_given_at(&s->prescribed, 2, (double[2]){2.0, 7.0}), 6.0, 0.0);
    assert_true(pdmc_scalar_holds(s, 1) && pdmc_scalar_holds(s, 2) && !pdmc_scalar_holds(s, 0) && !pdmc_scalar_holds(s, 3));
    CHECK_NEAR(s->open[0].flux, 0.5, 0.0);
    CHECK_OK(read_text(study.resolved, &again));
    assert_string_equal(again.resolved, study.resolved);
    pdmc_study_clear(&again);
    CHECK_FAILS_CLEANLY(pdmc_study_read("study.cfg", &again), pdmc_study_clear(&again));
    pdmc_study_clear(&study);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(everything_is_read_and_reads_back),
        cmocka_unit_test(levels_are_halved),
        cmocka_unit_test(defaults_are_filled_in),
        cmocka_unit_test(mistakes_are_told),
        cmocka_unit_test(tables_that_are_no_good_are_refused),
        cmocka_unit_test(open_sides_are_those_of_cells),
        cmocka_unit_test(a_source_of_ones_own_is_read_and_reads_back),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
