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
        {MOTION, "motion = { duration = 1; }; convergence = { vary = \"horizon\"; };",
         "study.cfg:7: motion.duration: motion is for convergence.vary = \"spacing\" only"},
    };
    for (size_t i = 0; i < sizeof mistakes / sizeof mistakes[0]; i++) {
        pdmc_study study;
        CHECK_STATUS(read_scalar(mistakes[i].part, mistakes[i].line, &study), PDMC_ERR_CONFIG);
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(everything_is_read_and_reads_back),
        cmocka_unit_test(levels_are_halved),
        cmocka_unit_test(defaults_are_filled_in),
        cmocka_unit_test(mistakes_are_told),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
