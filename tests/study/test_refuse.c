// SPDX-License-Identifier: GPL-3.0-or-later

/// Every class of mistake, and what is said about it.

#include "study/folder.h"

#define SIDES(quantity)                                                                                                \
    "\"" quantity "_left\", \"" quantity "_right\", \"" quantity "_bottom\", \"" quantity "_top\", "
#define QUANTITIES                                                                                                     \
    "\"micromodulus\", \"stiffness\", " SIDES("load_noise") "\"load\", \"youngs_modulus\", \"fracture_energy\", "         \
    "\"thickness\", \"velocity\", \"bond_strength\", " SIDES("load") SIDES("load_direction") "\"crack_length\", \"crack_angle\", \"crack_x\" or "            \
    "\"crack_y\""

typedef struct {
    int line; // which is replaced
    const char *text, *message;
} mistake;

static void expect(const mistake mistakes[], size_t count)
{
    static const pdmc_study zero;
    for (size_t i = 0; i < count; i++) {
        pdmc_study study;
        CHECK_STATUS(read_with(mistakes[i].line, mistakes[i].text, &study), PDMC_ERR_CONFIG);
        assert_string_equal(pdmc_last_error(), mistakes[i].message);
        assert_memory_equal(&study, &zero, sizeof study);
    }
}

#define EXPECT(mistakes) expect((mistakes), sizeof(mistakes) / sizeof *(mistakes))

static void unknown_settings(void **state)
{
    (void)state;
    const mistake mistakes[] = {
        {LINE_PLATE, "plate = { widht = 6.0; height = 4.0; };",
         "study.cfg:2: plate.widht: unknown setting, did you mean \"width\"?"},
        {LINE_PLATE, "plate = { width = 6.0; height = 4.0; colour = 1; };",
         "study.cfg:2: plate.colour: unknown setting, must be one of width, height, thickness"},
        {LINE_SOLVER, "slover = { };", "study.cfg:7: slover: unknown setting, did you mean \"solver\"?"},
        {LINE_TOP, "sed = 3;", "study.cfg:11: sed: unknown setting, did you mean \"seed\"?"},
        {LINE_CRACKS, "cracks = ( {\n from = [0, 0];\n too = [1, 0]; } );",
         "study.cfg:6: cracks[0].too: unknown setting, did you mean \"to\"?"},
        {LINE_SUPPORTS, "supports = ( { side = \"left\"; z = 0; } );",
         "study.cfg:6: supports[0].z: unknown setting, did you mean \"x\"?"},
    };
    EXPECT(mistakes);
}

static void missing_settings(void **state)
{
    (void)state;
    const mistake mistakes[] = {
        {LINE_PLATE, "", "study.cfg: plate.width: is missing, must be a real > 0"},
        {LINE_PLATE, "plate = { width = 6.0; };", "study.cfg:2: plate.height: is missing, must be a real > 0"},
        {LINE_MATERIAL, "material = { youngs_modulus = 2.0; };",
         "study.cfg:3: material.fracture_energy: is missing, must be a real > 0"},
        {LINE_CRACKS, "cracks = ( { from = [0, 0]; to = [1, 0]; },\n { from = [1, 1]; } );",
         "study.cfg:5: cracks[1].to: is missing, must be two reals [x, y], each finite"},
        {LINE_LOADS, "loads = ( { traction = [0, 1]; } );",
         "study.cfg:5: loads[0].side: is missing, must be \"left\", \"right\", \"bottom\" or \"top\""},
        {LINE_LOADS, "loads = ( { side = \"top\"; } );",
         "study.cfg:5: loads[0].traction: is missing, must be two reals [x, y], each finite"},
        {LINE_RANDOM, "random = ( { variation = 0.1; } );",
         "study.cfg:8: random[0].quantity: is missing, must be " QUANTITIES},
    };
    EXPECT(mistakes);
}

static void wrong_kinds(void **state)
{
    (void)state;
    const mistake mistakes[] = {
        {LINE_PLATE, "plate = { width = \"6\"; height = 4.0; };",
         "study.cfg:2: plate.width: \"6\" is not allowed, must be a real > 0"},
        {LINE_PLATE, "plate = 5;", "study.cfg:2: plate: 5 is not allowed, must be a group, { ... }"},
        {LINE_CRACKS, "cracks = { };",
         "study.cfg:4: cracks: a group is not allowed, must be a list of groups, ( { ... }, { ... } )"},
        {LINE_CRACKS, "cracks = ( 1.5 );", "study.cfg:4: cracks[0]: 1.5 is not allowed, must be a group, { ... }"},
        {LINE_CRACKS, "cracks = ( { from = [0, 0, 0]; to = [1, 0]; } );",
         "study.cfg:4: cracks[0].from: an array of 3 is not allowed, must be two reals [x, y], each finite"},
        {LINE_CRACKS, "cracks = ( { from = 0; to = [1, 0]; } );",
         "study.cfg:4: cracks[0].from: 0 is not allowed, must be two reals [x, y], each finite"},
        {LINE_CRACKS, "cracks = ( { from = (0, \"a\"); to = [1, 0]; } );",
         "study.cfg:4: cracks[0].from: \"a\" is not allowed, must be two reals [x, y], each finite"},
        {LINE_CRACKS, "cracks = ( { name = 1; from = [0, 0]; to = [1, 0]; } );",
         "study.cfg:4: cracks[0].name: 1 is not allowed, must be a text of 1 to 63 letters, digits, _ or -"},
        {LINE_SUPPORTS, "supports = ( { side = \"left\"; x = true; } );",
         "study.cfg:6: supports[0].x: true is not allowed, must be a real that is finite"},
        {LINE_SAMPLING, "sampling = { samples = 1e3; };",
         "study.cfg:9: sampling.samples: 1000.0 is not allowed, must be an integer from 1 to 100000000"},
        {LINE_MATERIAL, "material = { youngs_modulus = 2.0; fracture_energy = 0.5; assumption = 1; };",
         "study.cfg:3: material.assumption: 1 is not allowed, must be \"plane_stress\" or \"plane_strain\""},
        {LINE_ENERGY, "energy = { tips = \"a.from\"; };",
         "study.cfg:10: energy.tips: \"a.from\" is not allowed, must be an array of names of tips"},
        {LINE_ENERGY, "energy = { tips = [0]; };",
         "study.cfg:10: energy.tips: an element is no text, must be the name of a tip"},
        {LINE_TOP, "title = ();",
         "study.cfg:11: title: a list of 0 is not allowed, must be a text, not empty and without control characters"},
    };
    EXPECT(mistakes);
}

static void values_out_of_range(void **state)
{
    (void)state;
    const mistake mistakes[] = {
        {LINE_SOLVER, "solver = { spacing = -0.25; };",
         "study.cfg:7: solver.spacing: -0.25 is not allowed, must be > 0"},
        {LINE_SOLVER, "solver = { horizon = 0; };", "study.cfg:7: solver.horizon: 0 is not allowed, must be > 0"},
        {LINE_SOLVER, "solver = { shape = 1e999; };",
         "study.cfg:7: solver.shape: inf is not allowed, must be a finite real > 0"},
        {LINE_SOLVER, "solver = { polynomial_degree = 7; };",
         "study.cfg:7: solver.polynomial_degree: 7 is not allowed, must be from 0 to 6"},
        {LINE_SOLVER, "solver = { crack_orders = 0; };",
         "study.cfg:7: solver.crack_orders: 0 is not allowed, must be from 1 to 20"},
        {LINE_SOLVER, "solver = { radial_points = 13; };",
         "study.cfg:7: solver.radial_points: 13 is not allowed, must be from 3 to 12"},
        {LINE_CRACKS, "cracks = ( { from = [-1e999, 0.0]; to = [1, 0]; } );",
         "study.cfg:4: cracks[0].from: -inf is not allowed, must be finite"},
        {LINE_SUPPORTS, "supports = ( { side = \"left\"; x = 1e999; } );",
         "study.cfg:6: supports[0].x: inf is not allowed, must be finite"},
        {LINE_RANDOM, "random = ( { quantity = \"load\"; variation = -0.1; } );",
         "study.cfg:8: random[0].variation: -0.1 is not allowed, must be >= 0"},
        {LINE_RANDOM, "random = ( { quantity = \"micromodulus\"; bins = 10001; } );",
         "study.cfg:8: random[0].bins: 10001 is not allowed, must be from 1 to 10000"},
        {LINE_SAMPLING, "sampling = { samples = 4294967297; };", // libconfig would read 1
         "study.cfg:9: sampling.samples: 4294967297 is not allowed, must be from 1 to 100000000"},
        {LINE_SAMPLING, "sampling = { order = 9; };",
         "study.cfg:9: sampling.order: 9 is not allowed, must be from 0 to 8"},
        {LINE_ENERGY, "energy = { angles = 3; };",
         "study.cfg:10: energy.angles: 3 is not allowed, must be from 4 to 3600"},
        {LINE_TOP, "seed = -1;", "study.cfg:11: seed: -1 is not allowed, must be >= 0"},
    };
    EXPECT(mistakes);
}

static void defaults_out_of_range(void **state)
{
    (void)state;
    pdmc_study study;
    // the smallest reals there are: a twentieth is zero
    CHECK_STATUS(read_text("plate = { width = 5e-324; height = 5e-324; };\n"
                           "material = { youngs_modulus = 1; fracture_energy = 1; };\n"
                           "supports = ( { side = \"left\"; x = 1; } );\n"
                           "solver = { };\n",
                           &study),
                 PDMC_ERR_CONFIG);
    assert_string_equal(pdmc_last_error(),
                        "study.cfg:4: solver.spacing: the default, min(width, height) / 20, / 100 of "
                        "the bond method, / 80 of finite elements, is not allowed, must be > 0");
}

static void wrong_words(void **state)
{
    (void)state;
    char long_name[PDMC_NAME_SIZE + 1], line[256], message[256];
    memset(long_name, 'n', PDMC_NAME_SIZE);
    long_name[PDMC_NAME_SIZE] = 0;
    snprintf(line, sizeof line, "cracks = ( { name = \"%s\"; from = [0, 0]; to = [1, 0]; } );", long_name);
    snprintf(message, sizeof message,
             "study.cfg:4: cracks[0].name: \"%s\" is not allowed, must be a text of 1 to 63 "
             "letters, digits, _ or -",
             long_name);
    const mistake mistakes[] = {
        {LINE_MATERIAL, "material = { youngs_modulus = 2.0; fracture_energy = 0.5; assumption = \"plane\"; };",
         "study.cfg:3: material.assumption: \"plane\" is not allowed, must be \"plane_stress\" or \"plane_strain\""},
        {LINE_LOADS, "loads = ( { side = \"up\"; traction = [0, 1]; } );",
         "study.cfg:5: loads[0].side: \"up\" is not allowed, must be \"left\", \"right\", \"bottom\" or \"top\""},
        {LINE_SOLVER, "solver = { method = \"fem\"; };",
         "study.cfg:7: solver.method: \"fem\" is not allowed, must be \"kansa\", \"bond\" or \"galerkin\""},
        {LINE_SOLVER, "solver = { crack_model = \"blind\"; };",
         "study.cfg:7: solver.crack_model: \"blind\" is not allowed, must be \"analytic\", \"paper\" or \"visible\""},
        {LINE_CRACKS, line, message},
        {LINE_CRACKS, "cracks = ( { name = \"a.b\"; from = [0, 0]; to = [1, 0]; } );",
         "study.cfg:4: cracks[0].name: \"a.b\" is not allowed, must be a text of 1 to 63 letters, digits, _ or -"},
        {LINE_UNITS, "units = { length = \"\"; };",
         "study.cfg:1: units.length: \"\" is not allowed, must be a text, not empty and without control characters"},
        {LINE_UNITS, "units = { force = \"k\\nN\"; };",
         "study.cfg:1: units.force: \"k?N\" is not allowed, must be a text, not empty and without control characters"},
    };
    EXPECT(mistakes);
}

static void uncertain_quantities(void **state)
{
    (void)state;
    const mistake mistakes[] = {
        {LINE_RANDOM, "random = ( { quantity = \"modulus\"; } );",
         "study.cfg:8: random[0].quantity: \"modulus\" is not allowed, must be " QUANTITIES},
        {LINE_RANDOM, "random = ( { quantity = \"load\"; bins = 3; } );",
         "study.cfg:8: random[0].bins: is no setting of the quantity \"load\""},
        {LINE_RANDOM, "random = ( { quantity = \"load\"; model = \"radial_noise\"; } );",
         "study.cfg:8: random[0].model: is no setting of the quantity \"load\""},
        {LINE_RANDOM, "random = ( { quantity = \"micromodulus\"; distribution = \"normal\"; } );",
         "study.cfg:8: random[0].distribution: is no setting of the quantity \"micromodulus\""},
        {LINE_RANDOM, "random = ( { quantity = \"load\"; },\n { quantity = \"load\"; } );",
         "study.cfg:9: random[1].quantity: there already, must be once for each quantity"},
    };
    EXPECT(mistakes);
}

static void random_cracks(void **state)
{
    (void)state;
    const mistake mistakes[] = {
        {LINE_RANDOM, "random = ( { quantity = \"load\"; crack = \"a\"; } );",
         "study.cfg:8: random[0].crack: is no setting of the quantity \"load\""},
        {LINE_RANDOM, "random = ( { quantity = \"crack_length\"; crack = \"b\"; } );",
         "study.cfg:8: random[0].crack: no crack \"b\", did you mean \"a\"?"},
        {LINE_RANDOM, "random = ( { quantity = \"crack_length\"; crack = 1; } );",
         "study.cfg:8: random[0].crack: 1 is not allowed, must be the name of a crack"},
        {LINE_RANDOM, "random = ( { quantity = \"crack_angle\"; } );",
         "study.cfg:8: random[0].distribution: has the mean 0, of which there is no variation, must have location and scale"},
        {LINE_RANDOM, "random = ( { quantity = \"crack_x\"; distribution = \"uniform\"; variation = 0.1; } );",
         "study.cfg:8: random[0].distribution: has the mean 0, of which there is no variation, must have lower and upper"},
        {LINE_RANDOM,
         "random = ( { quantity = \"crack_length\"; }, { quantity = \"stiffness\"; correlation_length = 1; } );",
         "study.cfg:8: random[0].quantity: makes another plate of every sample, with other modes of the stiffness: one of "
         "the two must go"},
        {LINE_RANDOM, "solver = { crack_model = \"paper\"; }; random = ( { quantity = \"crack_length\"; } );",
         "study.cfg:8: random[0].quantity: needs a solution that converges, must not be with crack_model = \"paper\""},
        {LINE_RANDOM, "random = ( { quantity = \"crack_length\"; } ); sampling = { inverse = \"reduced\"; };",
         "study.cfg:8: sampling.inverse: \"reduced\" has one model for all samples, and cracks that move have one each, "
         "must be \"direct\", \"neumann\" or \"krylov\""},
        {LINE_CRACKS, "cracks = ( ); random = ( { quantity = \"crack_length\"; } );",
         "study.cfg:4: random[0].crack: there are no cracks"},
    };
    EXPECT(mistakes);
}

static void settings_of_another_solver(void **state)
{
    (void)state;
    const mistake mistakes[] = {
        {LINE_SOLVER, "solver = { method = \"bond\"; crack_model = \"analytic\"; };",
         "study.cfg:7: solver.crack_model: is no setting of the method \"bond\""},
        {LINE_SOLVER, "solver = { area = \"full\"; };",
         "study.cfg:7: solver.area: is no setting of the crack_model \"analytic\""},
        {LINE_SOLVER, "solver = { crack_model = \"visible\"; shape = 1; };",
         "study.cfg:7: solver.shape: is no setting of the crack_model \"visible\""},
        {LINE_SAMPLING, "sampling = { inverse = \"reduced\"; };",
         "study.cfg:9: sampling.inverse: \"reduced\" needs a symmetric matrix, as of method = \"bond\" or of a random "
         "stiffness, must be \"direct\" or \"neumann\""},
        {LINE_SAMPLING, "sampling = { inverse = \"krylov\"; };",
         "study.cfg:9: sampling.inverse: \"krylov\" needs a symmetric matrix, as of method = \"bond\" or of a random "
         "stiffness, must be \"direct\" or \"neumann\""},
    };
    EXPECT(mistakes);
    pdmc_study study; // outside of the solver's own section
    CHECK_STATUS(read_text("plate = { width = 6.0; height = 4.0; };\n"
                           "material = { youngs_modulus = 1.0; fracture_energy = 1.0; };\n"
                           "loads = ( { side = \"top\"; traction = [0.0, 1.0]; },\n"
                           "          { side = \"bottom\"; traction = [0.0, -1.0]; } );\n"
                           "cracks = ( { from = [-0.5, 0.0]; to = [0.5, 0.0]; } );\n"
                           "solver = { method = \"bond\"; };\n"
                           "energy = { line = \"segment\"; };\n",
                           &study),
                 PDMC_ERR_CONFIG);
    assert_string_equal(pdmc_last_error(), "study.cfg:7: energy.line: is no setting of the method \"bond\"");
}

static void grids_that_do_not_fit(void **state)
{
    (void)state;
    const mistake mistakes[] = {
        {LINE_SOLVER, "solver = { method = \"bond\"; spacing = 0.3; };",
         "study.cfg:7: solver.spacing: 0.3 does not divide the plate's height 4, must be such as 0.30769230769230771"},
        {LINE_SOLVER, "solver = { method = \"bond\"; spacing = 1e-3; };",
         "study.cfg:7: solver.spacing: 0.001 gives 24000000 nodes, must be at most 4000000"},
        {LINE_SOLVER, "solver = { method = \"bond\"; spacing = 0.05; horizon = 0.2; horizon_ratio = 5; };",
         "study.cfg:7: solver.horizon_ratio: 5 spacings are 0.25, but the horizon is 0.2: give one"},
        {LINE_SOLVER, "solver = { method = \"bond\"; spacing = 0.05; horizon = 0.04; };",
         "study.cfg:7: solver.horizon: 0.04 is too small, must be at least 0.05, the spacing"},
        {LINE_SOLVER, "solver = { method = \"bond\"; spacing = 0.01; horizon = 1.1; };",
         "study.cfg:7: solver.horizon: 1.1 is too large, must be at most 1, 100 spacings"},
        {LINE_SOLVER, "solver = { method = \"bond\"; spacing = 0.05; horizon = 2.6; };",
         "study.cfg:7: solver.horizon: 2.6 is too large, must be at most 2, half of the shorter side"},
        {LINE_SOLVER, "solver = { method = \"bond\"; spacing = 0.05; load_layer = 0.07; };",
         "study.cfg:7: solver.load_layer: 0.07 is not a whole number of spacings of 0.05"},
        {LINE_SOLVER, "solver = { method = \"bond\"; spacing = 0.05; load_layer = 3; };",
         "study.cfg:7: solver.load_layer: 3 is too thick, must be at most 2, half of the shorter side"},
    };
    EXPECT(mistakes);
}

static void triangles_that_do_not_fit(void **state)
{
    (void)state;
    const mistake mistakes[] = {
        {LINE_SOLVER, "solver = { method = \"galerkin\"; spacing = 0.3; horizon = 0.2; };",
         "study.cfg:7: solver.spacing: 0.3 is too large, must be at most 0.2, the horizon"},
        {LINE_SOLVER, "solver = { method = \"galerkin\"; spacing = 0.01; };",
         "study.cfg:7: solver.spacing: 0.01 gives 240000 values, must be at most 200000"},
        {LINE_SOLVER, "solver = { method = \"galerkin\"; spacing = 0.025; space = \"discontinuous\"; };",
         "study.cfg:7: solver.spacing: 0.025 gives 230400 values, must be at most 200000"},
        {LINE_SOLVER, "solver = { method = \"galerkin\"; spacing = 0.05; horizon = 0.2; horizon_ratio = 5; };",
         "study.cfg:7: solver.horizon_ratio: 5 spacings are 0.25, but the horizon is 0.2: give one"},
        {LINE_SOLVER, "solver = { method = \"galerkin\"; spacing = 0.05; horizon = 2.6; };",
         "study.cfg:7: solver.horizon: 2.6 is too large, must be at most 2, half of the shorter side"},
        {LINE_SOLVER, "solver = { method = \"galerkin\"; spacing = 0.05; load_layer = 3; };",
         "study.cfg:7: solver.load_layer: 3 is too thick, must be at most 2, half of the shorter side"},
        {LINE_SOLVER, "solver = { method = \"galerkin\"; area = \"full\"; };",
         "study.cfg:7: solver.area: is no setting of the method \"galerkin\""},
        {LINE_SOLVER, "solver = { method = \"galerkin\"; }; random = ( { quantity = \"crack_angle\"; location = 0; scale = 1; } );",
         "study.cfg:7: random[0].quantity: turns a crack, and the elements of method = \"galerkin\" need it parallel to a side"},
        {LINE_SOLVER, "solver = { method = \"galerkin\"; }; random = ( { quantity = \"stiffness\"; correlation_length = 1; } );",
         "study.cfg:7: random[0].quantity: \"stiffness\" is not known to method = \"galerkin\" yet, must be with method = "
         "\"bond\" or crack_model = \"analytic\""},
        {LINE_CRACKS, "cracks = ( { from = [0, 0]; to = [0.5, 0.1]; } ); solver = { method = \"galerkin\"; };",
         "study.cfg:4: cracks[0]: \"crack1\" is at an angle to the sides of the plate: that needs mesh = \"triangles\", method "
         "= \"kansa\" or \"bond\", or a crack parallel to a side"},
        {LINE_SOLVER, "solver = { method = \"galerkin\"; mesh = \"triangles\"; }; supports = ( { side = \"left\"; x = 0.0; } );",
         "study.cfg:7: solver.mesh: \"triangles\" is not available with supports yet, must be \"cells\""},
        {LINE_SOLVER, "solver = { method = \"galerkin\"; mesh = \"triangles\"; }; random = ( { quantity = \"crack_angle\"; location = 0; scale = 1; } );",
         "study.cfg:7: random[0].quantity: makes another mesh of every sample, which mesh = \"triangles\" does not yet"},
        {LINE_SOLVER, "solver = { method = \"kansa\"; mesh = \"triangles\"; };",
         "study.cfg:7: solver.mesh: is no setting of the crack_model \"analytic\""},
    };
    EXPECT(mistakes);
}

static void cracks_in_wrong_places(void **state)
{
    (void)state;
    const mistake mistakes[] = {
        {LINE_CRACKS, "cracks = ( { from = [0.5, 0.5]; to = [0.5, 0.5]; } );",
         "study.cfg:4: cracks[0]: \"crack1\" has zero length"},
        {LINE_CRACKS, "cracks = ( { from = [-4, 0]; to = [4, 0]; } );",
         "study.cfg:4: cracks[0]: \"crack1\" has no tip inside the plate, must have at least one"},
        {LINE_CRACKS, "cracks = ( { name = \"edge\"; from = [-3, 0]; to = [0, 0]; } );",
         "study.cfg:4: cracks[0].from: \"edge\" ends outside the plate or on its edge: that needs crack_model = "
         "\"visible\" or method = \"bond\", or a tip inside"},
        {LINE_CRACKS, "cracks = ( { from = [0.0, 0.0]; to = [0.0, 2.1]; } );",
         "study.cfg:4: cracks[0].to: \"crack1\" ends outside the plate or on its edge: that needs crack_model = "
         "\"visible\" or method = \"bond\", or a tip inside"},
        {LINE_CRACKS, "cracks = ( { from = [-1, 0]; to = [1, 0]; },\n { from = [0, -1]; to = [0, 1]; } );",
         "study.cfg:5: cracks[1]: \"crack2\" crosses or touches \"crack1\": that needs method = \"bond\", or cracks "
         "apart"},
        {LINE_CRACKS, "cracks = ( { from = [-1, 0]; to = [1, 0]; }, { from = [1, 0]; to = [2, 1]; } );",
         "study.cfg:4: cracks[1]: \"crack2\" crosses or touches \"crack1\": that needs method = \"bond\", or cracks "
         "apart"},
        {LINE_CRACKS,
         "cracks = ( { name = \"crack2\"; from = [-1, 0]; to = [1, 0]; }, { from = [-1, 1]; to = [1, 1]; } );",
         "study.cfg:4: cracks[1].name: \"crack2\" is the name of an earlier crack too, must be another"},
    };
    EXPECT(mistakes);
}

static void sides_loaded_or_held_wrongly(void **state)
{
    (void)state;
    const mistake mistakes[] = {
        {LINE_LOADS, "", "study.cfg: loads: no load: every traction and every prescribed displacement is zero"},
        {LINE_LOADS, "loads = ( { side = \"top\"; traction = [0, 0]; } );",
         "study.cfg:5: loads: no load: every traction and every prescribed displacement is zero"},
        {LINE_LOADS, "loads = ( { side = \"top\"; traction = [0, 1]; },\n { side = \"top\"; traction = [0, -1]; } );",
         "study.cfg:6: loads[1].side: loaded already, must be once for each side"},
        {LINE_LOADS, "loads = ( { side = \"top\"; traction = [0, 1]; } );",
         "study.cfg:5: loads: the loads are not in equilibrium, resultant (0, 6) and moment 0 a unit of thickness act "
         "on a "
         "plate that is free to follow; balance the tractions or hold a side by supports"},
        {LINE_SUPPORTS, "supports = ( { side = \"left\"; } );",
         "study.cfg:6: supports[0]: holds nothing, must have x or y or both"},
        {LINE_SUPPORTS, "supports = ( { side = \"left\"; x = 0; },\n { side = \"left\"; x = 1; y = 0; } );",
         "study.cfg:7: supports[1].side: held in x by an earlier support already"},
        {LINE_SUPPORTS, "supports = ( { side = \"left\"; y = 0; }, { side = \"left\"; y = 1; } );",
         "study.cfg:6: supports[1].side: held in y by an earlier support already"},
        {LINE_SUPPORTS, "supports = ( { side = \"bottom\"; x = 0; y = 0; } );",
         "study.cfg:5: loads[1].traction: acts in y, in which a support holds the side; one of the two must go"},
    };
    EXPECT(mistakes);
}

static void solver_lengths_that_do_not_fit(void **state)
{
    (void)state;
    const mistake mistakes[] = {
        {LINE_SOLVER, "solver = { spacing = 1.01; };",
         "study.cfg:7: solver.spacing: 1.01 is too large, must be at most 1, a quarter of the shorter side"},
        {LINE_SOLVER, "solver = { spacing = 0.05; };", // 6 * 4 / 0.0025
         "study.cfg:7: solver.spacing: 0.05 gives 9600 nodes, must be at most 5000: the unknowns grow as 1/h^2, the "
         "cost as "
         "1/h^6"},
        {LINE_SOLVER, "solver = { horizon = 0.26; };", // the crack's half length is 0.5
         "study.cfg:7: solver.horizon: 0.26 is too large, must be at most 0.25, half of the shortest crack's half "
         "length: "
         "beyond it stress intensity factors are wrong while the residual stays small (33 % at 0.8)"},
        {LINE_CRACKS, "cracks = ();\nsolver = { horizon = 1.3; };",
         "study.cfg:5: solver.horizon: 1.3 is too large, must be at most 1.2, 0.3 of the shorter side"},
    };
    EXPECT(mistakes);
}

static void tips_that_do_not_exist(void **state)
{
    (void)state;
    const mistake mistakes[] = {
        {LINE_ENERGY, "energy = { tips = [\"a.to\", \"a.form\"]; };",
         "study.cfg:10: energy.tips: no tip \"a.form\", did you mean \"a.from\"? (the tips are a.from, a.to)"},
        {LINE_ENERGY, "energy = { tips = [\"centre\"]; };",
         "study.cfg:10: energy.tips: no tip \"centre\", the tips are a.from, a.to"},
        {LINE_ENERGY, "energy = { tips = [\"a.to\", \"a.to\"]; };",
         "study.cfg:10: energy.tips: \"a.to\" is there twice"},
        {LINE_CRACKS, "energy = { tips = [\"a.to\"]; };",
         "study.cfg:4: energy.tips: no tip \"a.to\", there are no cracks"},
    };
    EXPECT(mistakes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(unknown_settings),
        cmocka_unit_test(missing_settings),
        cmocka_unit_test(wrong_kinds),
        cmocka_unit_test(values_out_of_range),
        cmocka_unit_test(defaults_out_of_range),
        cmocka_unit_test(wrong_words),
        cmocka_unit_test(uncertain_quantities),
        cmocka_unit_test(random_cracks),
        cmocka_unit_test(settings_of_another_solver),
        cmocka_unit_test(grids_that_do_not_fit),
        cmocka_unit_test(triangles_that_do_not_fit),
        cmocka_unit_test(cracks_in_wrong_places),
        cmocka_unit_test(sides_loaded_or_held_wrongly),
        cmocka_unit_test(solver_lengths_that_do_not_fit),
        cmocka_unit_test(tips_that_do_not_exist),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
