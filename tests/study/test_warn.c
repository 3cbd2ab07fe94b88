// SPDX-License-Identifier: GPL-3.0-or-later

/// What is allowed and deserves a word.

#include "study/folder.h"

static void expect(int line, const char *text, const char *warnings)
{
    pdmc_study study;
    CHECK_OK(read_with(line, text, &study));
    assert_string_equal(study.warnings, warnings);
    pdmc_study_clear(&study);
}

static void negative_micromoduli(void **state)
{
    (void)state;
    // Phi(-1) = 0.158655, and 1 - 0.841345^2 = 0.292139
    expect(LINE_RANDOM, "random = ( { quantity = \"micromodulus\"; bins = 2; variation = 1; } );",
           "study.cfg:8: warning: random[0].variation: 1 in 2 bins makes c(r) negative somewhere with "
           "probability 0.292 a sample\n");
    // Phi(-5) = 2.8665e-7: a hundred bins are worth a word, one is not
    expect(LINE_RANDOM, "random = ( { quantity = \"micromodulus\"; } );",
           "study.cfg:8: warning: random[0].variation: 0.2 in 100 bins makes c(r) negative somewhere with "
           "probability 2.87e-05 a sample\n");
    expect(LINE_RANDOM, "random = ( { quantity = \"micromodulus\"; bins = 1; } );", "");
    expect(LINE_RANDOM, "random = ( { quantity = \"micromodulus\"; variation = 0; } );", "");
    expect(LINE_RANDOM, "random = ( { quantity = \"load\"; variation = 1; } );", "");
}

static void shapes_outside_the_sound_range(void **state)
{
    (void)state;
    expect(LINE_SOLVER, "solver = { spacing = 0.2; shape = 0.3; };",
           "study.cfg:7: warning: solver.shape: 0.3 is 1.5 spacings: advised are 2 to 8, less is inaccurate, "
           "more is near singular\n");
    expect(LINE_SOLVER, "solver = { spacing = 0.2; shape = 2; };",
           "study.cfg:7: warning: solver.shape: 2 is 10 spacings: advised are 2 to 8, less is inaccurate, more "
           "is near singular\n");
    expect(LINE_SOLVER, "solver = { spacing = 0.2; shape = 0.4; };", "");
    expect(LINE_SOLVER, "solver = { spacing = 0.2; shape = 1.6; };", "");
}

static void the_recipe_that_is_there_for_the_record(void **state)
{
    (void)state;
    expect(
        LINE_SOLVER, "solver = { crack_model = \"paper\"; };",
        "study.cfg:7: warning: solver.crack_model: \"paper\" does not converge and is there for the record: its stress "
        "intensity factors are tens to hundreds of percent off\n");
}

static void triangles_that_are_coarse_at_cracks(void **state)
{
    (void)state;
    expect(LINE_SOLVER, "solver = { method = \"galerkin\"; spacing = 0.05; horizon = 0.1; };",
           "study.cfg:7: warning: solver.spacing: 0.05 is 0.5 of the horizon: at cracks a third at most is advised\n");
    expect(LINE_SOLVER, "solver = { method = \"galerkin\"; spacing = 0.03; horizon = 0.09; };", "");
}

static void energy_lengths_that_do_not_fit(void **state)
{
    (void)state;
    expect(LINE_ENERGY, "energy = { horizon = 0.02; extension = 0.1; };",
           "study.cfg:10: warning: energy.extension: extension 0.1 is 5 times the energy horizon 0.02: G_E then "
           "measures the field at a distance from the tip, not at it (advised: at most 0.25 of the horizon); "
           "the paper's own case has extension = crack half length\n");
    expect(LINE_ENERGY, "energy = { horizon = 0.3; tips = [\"a.to\"]; };",
           "study.cfg:10: warning: energy.horizon: 0.3 is 0.6 of the crack's half length 0.5 at a.to: G_E "
           "then sees the whole crack, "
           "not the tip (advised: at most 0.1)\n");
    expect(LINE_ENERGY, "energy = { horizon = 0.25; extension = 0.0625; };", "");
    expect(LINE_ENERGY, "energy = { horizon = 0.02; extension = 0.1; tips = []; };", "");
}

static void each_tip_has_its_own_crack(void **state)
{
    (void)state;
    expect(LINE_CRACKS,
           "cracks = ( { name = \"a\"; from = [-0.5, 0.0]; to = [0.5, 0.0]; }, { name = \"b\"; from = [1.0, 0.0]; "
           "to = [1.2, 0.0]; } );\nenergy = { horizon = 0.06; };",
           "study.cfg:5: warning: energy.horizon: 0.06 is 0.6 of the crack's half length 0.1 at b.from: G_E "
           "then sees the whole crack, not the tip (advised: at most 0.1)\n"
           "study.cfg:5: warning: energy.horizon: 0.06 is 0.6 of the crack's half length 0.1 at b.to: G_E "
           "then sees the whole crack, not the tip (advised: at most 0.1)\n");
}

static void cracks_that_may_not_be(void **state)
{
    (void)state;
    expect(LINE_RANDOM, "random = ( { quantity = \"crack_length\"; variation = 0.1; } );", "");
    // four horizons of min(a / 5, height / 50) = 0.08, of a length uniform on [0.12, 1.12]: 0.2
    expect(
        LINE_RANDOM,
        "random = ( { quantity = \"crack_length\"; distribution = \"uniform\"; lower = 0.12; upper = 1.12; } );",
        "study.cfg:8: warning: random[0].distribution: is below 0.32, too short for the solver, with probability 0.2: "
        "such samples fail\n");
    expect(LINE_CRACKS,
           "cracks = ( { from = [-3, 0]; to = [-2, 0]; } ); solver = { crack_model = \"visible\"; };\n"
           "random = ( { quantity = \"crack_y\"; location = 0; scale = 0.1; } );",
           "study.cfg:5: warning: random[0].quantity: moves the end of \"crack1\" that is on an edge: samples in which "
           "it is "
           "inside the plate fail, an end well beyond the edge stays outside\n");
    expect(
        LINE_RANDOM,
        "solver = { method = \"bond\"; spacing = 0.1; horizon = 0.2; }; energy = { extension = 0.1; };\n"
        "random = ( { quantity = \"crack_x\"; location = 0; scale = 0.1; },\n"
        "           { quantity = \"crack_y\"; location = 0; scale = 0.1; } );",
        "study.cfg:9: warning: random[0].quantity: moves the crack between the nodes of a grid: energies jump by the "
        "bonds that it cuts, so that design points and small changes are those of the grid\n"
        "study.cfg:8: warning: energy.extension: extension 0.1 is 0.5 times the energy horizon 0.2: G_E then measures "
        "the field at a distance from the tip, not at it (advised: at most 0.25 of the horizon); the paper's own case "
        "has extension = crack half length\n");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(negative_micromoduli),
        cmocka_unit_test(shapes_outside_the_sound_range),
        cmocka_unit_test(the_recipe_that_is_there_for_the_record),
        cmocka_unit_test(triangles_that_are_coarse_at_cracks),
        cmocka_unit_test(energy_lengths_that_do_not_fit),
        cmocka_unit_test(each_tip_has_its_own_crack),
        cmocka_unit_test(cracks_that_may_not_be),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
