// SPDX-License-Identifier: GPL-3.0-or-later

/// What only a dynamic study has, its defaults, and the mistakes that only it allows.

#include "study/folder.h"

#define DYNAMICS "dynamics = { density = 1.5; duration = 10.0; };"

// A dynamic study with its own settings on the lines from 6 on.
static pdmc_status read_dynamic(const char *settings, pdmc_study *study)
{
    char text[2048];
    snprintf(text, sizeof text,
             "kind = \"dynamic\";\n"
             "plate = { width = 6.0; height = 4.0; };\n"
             "material = { youngs_modulus = 2.0; fracture_energy = 0.5; };\n"
             "cracks = ( { name = \"a\"; from = [-0.5, 0.0]; to = [0.5, 0.0]; } );\n"
             "loads = ( { side = \"top\"; traction = [0, 1]; }, { side = \"bottom\"; traction = [0, -1]; } );\n%s\n",
             settings);
    return read_text(text, study);
}

typedef struct {
    const char *settings, *message;
} mistake;

static void expect(size_t count, const mistake mistakes[])
{
    static const pdmc_study zero;
    for (size_t i = 0; i < count; i++) {
        pdmc_study study;
        CHECK_STATUS(read_dynamic(mistakes[i].settings, &study), PDMC_ERR_CONFIG);
        assert_string_equal(pdmc_last_error(), mistakes[i].message);
        assert_memory_equal(&study, &zero, sizeof study);
    }
}

#define EXPECT(mistakes) expect(sizeof(mistakes) / sizeof *(mistakes), (mistakes))

static void defaults_are_of_the_first_step(void **state)
{
    (void)state;
    pdmc_study study;
    CHECK_OK(read_dynamic(DYNAMICS, &study));
    const pdmc_problem *p = &study.problem;
    assert_int_equal(p->history_count, 1);
    CHECK_NEAR(p->history[0].time, 0.0, 0.0);
    CHECK_NEAR(p->history[0].factor, 1.0, 0.0);
    assert_int_equal(p->probe_count, 0);
    CHECK_NEAR(p->dynamics.damping, 0.0, 0.0);
    assert_string_equal(p->time_unit, "s");
    // mu = 3 E / 8 in plane stress, so that c = sqrt(9/8 * 2 / 1.5); the spacing is 4 / 20
    CHECK_NEAR(p->dynamics.step, 0.05 / sqrt(1.5), 1e-15);
    assert_int_equal(pdmc_problem_steps(p), 245); // 244.9
    assert_string_equal(study.warnings, "");
    pdmc_study_clear(&study);
}

static void a_static_study_has_no_motion(void **state)
{
    (void)state;
    pdmc_study study;
    CHECK_OK(read_with(LINE_TOP, "", &study));
    assert_int_equal(study.problem.kind, PDMC_STATIC);
    assert_null(strstr(study.resolved, "dynamics"));
    pdmc_study_clear(&study);
    CHECK_STATUS(read_with(LINE_TOP, DYNAMICS, &study), PDMC_ERR_CONFIG);
    assert_string_equal(pdmc_last_error(), "study.cfg:11: dynamics: is not part of a study of kind \"static\"");
    CHECK_STATUS(read_with(LINE_TOP, "probes = ();", &study), PDMC_ERR_CONFIG);
    assert_string_equal(pdmc_last_error(), "study.cfg:11: probes: is not part of a study of kind \"static\"");
    CHECK_STATUS(read_with(LINE_TOP, "kind = \"moving\";", &study), PDMC_ERR_CONFIG);
    assert_string_equal(pdmc_last_error(), "study.cfg:11: kind: \"moving\" is not allowed, must be \"static\", "
                                           "\"dynamic\", \"explicit\", \"quasi_static\", "
                                           "\"scalar\", \"elastic\" or \"quadrature\"");
}

static void a_dynamic_study_has_no_samples(void **state)
{
    (void)state;
    const mistake mistakes[] = {
        {DYNAMICS "random = ( { quantity = \"load\"; } );",
         "study.cfg:6: random: is not part of a study of kind \"dynamic\": a dynamic study is deterministic for now"},
        {DYNAMICS "sampling = { samples = 3; };", "study.cfg:6: sampling: is not part of a study of kind \"dynamic\""},
        {DYNAMICS "energy = { angles = 8; };", "study.cfg:6: energy: is not part of a study of kind \"dynamic\""},
    };
    EXPECT(mistakes);
}

static void motions_that_cannot_be_integrated(void **state)
{
    (void)state;
    const mistake mistakes[] = {
        {"", "study.cfg: dynamics.density: is missing, must be a real > 0"},
        {"dynamics = { density = 1; };", "study.cfg:6: dynamics.duration: is missing, must be a real > 0"},
        {"dynamics = { density = 0; duration = 1; };", "study.cfg:6: dynamics.density: 0 is not allowed, must be > 0"},
        {"dynamics = { density = 1; duration = 1; damping = -1; };",
         "study.cfg:6: dynamics.damping: -1 is not allowed, must be >= 0"},
        {"dynamics = { density = 1; duration = 1; step = 2; };",
         "study.cfg:6: dynamics.step: 2 is too large, must be at most 1, the duration"},
        {"dynamics = { density = 1; duration = 1; step = 1e-7; };",
         "study.cfg:6: dynamics.step: 1e-07 makes 1e+07 steps of the duration, must be at most 1e+06"},
        {DYNAMICS "\nsupports = ( { side = \"left\"; x = 0.1; } );",
         "study.cfg:7: supports[0].x: must be 0 in a dynamic study: sides that are moved are not available yet"},
        {DYNAMICS "\nsolver = { crack_model = \"paper\"; };",
         "study.cfg:7: solver.crack_model: has no motion yet, must be \"analytic\" in a dynamic study"},
        {DYNAMICS "\nhistory = ( { time = -1; factor = 0; } );",
         "study.cfg:7: history[0].time: -1 is not allowed, must be >= 0"},
        {DYNAMICS "\nhistory = ( { time = 1; factor = 0; },\n { time = 1; factor = 1; } );",
         "study.cfg:8: history[1].time: 1 is not after 1, times must ascend"},
    };
    EXPECT(mistakes);
}

static void probes_in_wrong_places(void **state)
{
    (void)state;
    const mistake mistakes[] = {
        {DYNAMICS "\nprobes = ( { at = [3.1, 0.0]; } );", "study.cfg:7: probes[0].at: \"probe1\" is outside the plate"},
        {DYNAMICS "\nprobes = ( { at = [0.5, 0.0]; } );",
         "study.cfg:7: probes[0].side: \"probe1\" lies on the crack \"a\", must be \"left\" or \"right\""},
        {DYNAMICS "\nprobes = ( { name = \"p\"; at = [0.6, 0.0]; side = \"left\"; } );",
         "study.cfg:7: probes[0].side: \"p\" lies on no crack, must be \"none\""},
        {DYNAMICS "\nprobes = ( { name = \"p\"; at = [1, 0]; },\n { name = \"p\"; at = [1, 1]; } );",
         "study.cfg:8: probes[1].name: \"p\" is the name of an earlier probe too, must be another"},
    };
    EXPECT(mistakes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(defaults_are_of_the_first_step), cmocka_unit_test(a_static_study_has_no_motion),
        cmocka_unit_test(a_dynamic_study_has_no_samples), cmocka_unit_test(motions_that_cannot_be_integrated),
        cmocka_unit_test(probes_in_wrong_places),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
