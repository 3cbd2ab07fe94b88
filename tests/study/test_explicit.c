// SPDX-License-Identifier: GPL-3.0-or-later

/// Explicit studies: what is read, that the resolved study reads back to it, and the mistakes that only they allow.

#include "study/folder.h"

#include "base/base_impl.h"

enum { GRID, MATERIALS, BODIES, CRACKS, CONDITIONS, SPHERES, TIME, REST, PARTS };

// One group a line, from line 2 on, of which one is replaced.
static pdmc_status read_explicit(int part, const char *replacement, pdmc_study *study)
{
    const char *lines[PARTS] = {
        [GRID] = "grid = { dimension = 3; spacing = 0.5; };",
        [MATERIALS] = "materials = ( { density = 2; youngs_modulus = 3; } );",
        [BODIES] = "bodies = ( { from = [0, 0, 0]; to = [4, 4, 4]; } );",
        [CRACKS] = "",
        [CONDITIONS] = "",
        [SPHERES] = "",
        [TIME] = "time = { duration = 10; };",
        [REST] = "",
    };
    char text[4096] = "kind = \"explicit\";\n";
    lines[part] = replacement;
    for (int i = 0; i < PARTS; i++) {
        strcat(text, lines[i]);
        strcat(text, "\n");
    }
    return read_text(text, study);
}

static const char plane[] =
    "kind = \"explicit\"; title = \"plane\"; units = { length = \"mm\"; force = \"kN\"; time = \"ms\"; };\n"
    "grid = { dimension = 2; spacing = 0.5; offset = [0.25, 0.125]; horizon_ratio = 3.2; volume = \"whole\"; stretch = \"linear\"; precision = \"single\";\n"
    "         thickness = 0.1; assumption = \"plane_strain\"; };\n"
    "materials = ( { name = \"steel\"; density = 8.0; bulk_modulus = 192.0; critical_stretch = 0.02; fibre = [1, 1]; fibre_ratio = 4; },\n"
    "              { name = \"glass\"; density = 2.5; micromodulus = 7e3; fracture_energy = 1e-3; strengthening = "
    "0.25; } );\n"
    "bodies = ( { name = \"plate\"; from = [-25, -25]; to = [25, 25]; material = \"glass\"; velocity = [0, -1]; },\n"
    "           { name = \"disc\"; shape = \"ball\"; centre = [0, 30]; radius = 2; },\n"
    "           { name = \"grain\"; inside = \"plate\"; from = [-25, -25]; to = [0, 0]; } );\n"
    "interfaces = ( { first_material = \"steel\"; second_material = \"glass\"; fracture_energy = 1e-4; },\n"
    "               { name = \"glue\"; between = \"bodies\"; first_body = \"plate\"; second_body = \"disc\"; youngs_modulus = 3; \n"
    "                 critical_stretch = 0.1; } );\n"
    "cracks = ( { name = \"middle\"; from = [-5, 0]; to = [5, 0]; } );\n"
    "no_fail = ( { from = [-25, 20]; to = [25, 25]; }, { shape = \"ball\"; centre = [0, 30]; radius = 2.5; } );\n"
    "conditions = ( { from = [-25.0, 23.4]; to = [25.0, 25.0]; y = 20; times = [5, 5, 10, 10]; factors = [1, -1, -1, "
    "0]; },\n"
    "               { prescribed = \"force\"; shape = \"ball\"; centre = [0, 0]; radius = 0.3; x = -1; },\n"
    "               { name = \"grip\"; prescribed = \"displacement\"; from = [-25, -25]; to = [-24, 25]; x = 0;\n"
    "                 x_gradient = [0.0, 1e-3]; } );\n"
    "damping = { absolute = 3.5; relative = 0.25; };\n"
    "spheres = ( { name = \"ram\"; radius = 5; centre = [0, 40]; velocity = [0.0, -35.5]; mass = 4.16; stiffness = "
    "1e26; },\n"
    "            { radius = 1; centre = [0, -40]; stiffness = 1e26; } );\n"
    "contact = { distance = 0; stiffness = 14; }; time = { duration = 16; step = 0.0015; safety = 0.7; };\n"
    "record = { interval = 0.3; snapshots = 7; tip_damage = 0.35; speed_window = 1.2; };\n";

static const char space[] =
    "kind = \"explicit\"; grid = { dimension = 3; spacing = 0.5; };\n"
    "materials = ( { density = 2; youngs_modulus = 3; } );\n"
    "bodies = ( { shape = \"cylinder\"; from = [1, 0, 2]; to = [1, 8, 2]; radius = 3; velocity = [1, 2, 3]; } );\n"
    "cracks = ( { shape = \"disc\"; centre = [1, 4, 2]; normal = [0, 2, 0]; radius = 1; },\n"
    "           { shape = \"rectangle\"; centre = [1, 4, 2]; first_side = [1, 0, 0]; second_side = [0.0, 0.5, 0.5]; } "
    ");\n"
    "conditions = ( { from = [-9, 0, -9]; to = [9, 0, 9]; x = 0; y = 0; z = 0; } );\n"
    "time = { duration = 10; };\n";

static void what_is_given_is_kept(void **state)
{
    (void)state;
    pdmc_study study;
    CHECK_OK(read_text(plane, &study));
    const pdmc_explicit *m = &study.motion;
    assert_int_equal(study.problem.kind, PDMC_EXPLICIT);
    assert_string_equal(study.problem.time_unit, "ms");
    CHECK_NEAR(m->horizon, 1.6, 1e-15);
    CHECK_NEAR(m->offset[1], 0.125, 0.0);
    assert_int_equal(m->volume_rule, PDMC_VOLUME_WHOLE);
    assert_int_equal(m->stretch, PDMC_STRETCH_LINEAR);
    assert_int_equal(m->precision, PDMC_PRECISION_SINGLE);
    assert_int_equal(m->no_fail_count, 2);
    CHECK_NEAR(m->no_fail[1].radius, 2.5, 0.0);
    CHECK_NEAR(m->materials[0].fibre[1], 1.0, 0.0);
    CHECK_NEAR(m->materials[0].fibre_ratio, 4.0, 0.0);
    CHECK_NEAR(m->materials[1].fibre_ratio, 1.0, 0.0);
    assert_int_equal(m->assumption, PDMC_PLANE_STRAIN);
    assert_true(m->materials[0].has_bulk_modulus && m->materials[0].has_critical_stretch);
    assert_false(m->materials[0].has_youngs_modulus || m->materials[0].has_fracture_energy);
    assert_int_equal(m->bodies[0].body.material, 1);
    assert_int_equal(m->bodies[1].body.material, 0);
    assert_int_equal(m->bodies[1].body.shape.kind, PDMC_SHAPE_BALL);
    CHECK_NEAR(m->bodies[0].body.velocity[1], -1.0, 0.0);
    assert_int_equal(m->body_count, 3);
    assert_true(m->bodies[2].body.is_part && !m->bodies[1].body.is_part);
    assert_int_equal(m->bodies[2].body.host, 0);
    assert_int_equal(m->interface_count, 2);
    const pdmc_explicit_interface *by_material = &m->interfaces[0], *glue = &m->interfaces[1];
    assert_int_equal(by_material->between, PDMC_BETWEEN_MATERIALS);
    assert_int_equal(by_material->second_material, 1);
    assert_true(by_material->bonds.has_fracture_energy && !by_material->bonds.has_youngs_modulus);
    assert_int_equal(glue->between, PDMC_BETWEEN_BODIES);
    assert_int_equal(glue->second_body, 1);
    CHECK_NEAR(glue->bonds.critical_stretch, 0.1, 0.0);
    CHECK_NEAR(glue->bonds.youngs_modulus, 3.0, 0.0);
    assert_string_equal(glue->bonds.name, "glue");
    CHECK_NEAR(pdmc_explicit_nodes(m, &m->bodies[2].body), 0.0, 0.0);
    assert_int_equal(m->crack_count, 1);
    CHECK_NEAR(m->cracks[0].to[0], 5.0, 0.0);
    const pdmc_layer_condition *strip = &m->conditions[0].layer, *force = &m->conditions[1].layer;
    assert_false(strip->along[0] || strip->along[2]);
    assert_true(strip->along[1]);
    assert_int_equal(strip->history.count, 4);
    CHECK_NEAR(strip->history.factor[2], -1.0, 0.0);
    assert_int_equal(force->kind, PDMC_CONDITION_FORCE);
    assert_int_equal(force->history.count, 0);
    const pdmc_layer_condition *grip = &m->conditions[2].layer;
    assert_string_equal(force->name, "condition2");
    assert_string_equal(grip->name, "grip");
    assert_int_equal(grip->kind, PDMC_CONDITION_DISPLACEMENT);
    CHECK_NEAR(grip->gradient[0][1], 1e-3, 0.0);
    CHECK_NEAR(m->damping, 3.5, 0.0);
    CHECK_NEAR(m->bond_damping, 0.25, 0.0);
    assert_true(m->spheres[0].has_mass);
    assert_false(m->spheres[1].has_mass);
    assert_string_equal(m->spheres[1].sphere.name, "sphere2");
    CHECK_NEAR(m->speed_window, 1.2, 0.0);
    pdmc_study_clear(&study);
}

static void defaults_are_of_the_first_step(void **state)
{
    (void)state;
    pdmc_study study;
    CHECK_OK(read_text(space, &study));
    const pdmc_explicit *m = &study.motion;
    CHECK_NEAR(m->horizon, 1.5, 0.0);
    assert_int_equal(m->volume_rule, PDMC_VOLUME_PARTIAL);
    CHECK_NEAR(m->contact_distance, 1.35, 0.0);
    CHECK_NEAR(m->damping + m->bond_damping, 0.0, 0.0);
    CHECK_NEAR(m->contact_stiffness, 15.0, 0.0);
    assert_false(m->has_step);
    CHECK_NEAR(m->safety, 0.8, 0.0);
    CHECK_NEAR(m->interval, 0.1, 1e-16);
    CHECK_NEAR(m->speed_window, 1.0, 1e-15);
    CHECK_NEAR(m->tip_damage, 0.3, 0.0);
    assert_int_equal(m->snapshots, 10);
    pdmc_study_clear(&study);
}

// With every real in digits that read back, equal texts are equal problems.
static void the_resolved_study_reads_back(void **state)
{
    (void)state;
    const char *const studies[] = {plane, space};
    for (size_t i = 0; i < sizeof studies / sizeof studies[0]; i++) {
        pdmc_study first, second;
        CHECK_OK(read_text(studies[i], &first));
        CHECK_OK(read_text(first.resolved, &second));
        assert_string_equal(first.resolved, second.resolved);
        assert_int_equal(first.motion.body_count, second.motion.body_count);
        assert_memory_equal(first.motion.bodies, second.motion.bodies,
                            (size_t)first.motion.body_count * sizeof *first.motion.bodies);
        assert_int_equal(first.motion.interface_count, second.motion.interface_count);
        assert_memory_equal(first.motion.cracks, second.motion.cracks,
                            (size_t)first.motion.crack_count * sizeof *first.motion.cracks);
        assert_memory_equal(first.motion.materials, second.motion.materials,
                            (size_t)first.motion.material_count * sizeof *first.motion.materials);
        pdmc_study_clear(&first);
        pdmc_study_clear(&second);
    }
}

// What begins with a part of the study gets its line; everything else stays as it is.
static void what_is_found_out_later_has_its_line(void **state)
{
    (void)state;
    static const char text[] = "kind = \"explicit\"; grid = { dimension = 2; spacing = 0.5; };\n"
                               "materials = ( { density = 2; youngs_modulus = 3; } );\n"
                               "bodies = ( { from = [0, 0]; to = [4, 4]; },\n"
                               "           { from = [5, 0];\n"
                               "             to = [9, 4]; } );\n"
                               "time = { duration = 10;\n"
                               "         safety = 0.5; };\n";
    const char *const messages[][2] = {
        {"bodies[1]: holds nothing", "study.cfg:4: bodies[1]: holds nothing"},
        {"bodies[1].to: is far", "study.cfg:5: bodies[1].to: is far"},
        {"bodies[7]: is not there", "study.cfg:3: bodies[7]: is not there"},
        {"bodies: are none", "study.cfg:3: bodies: are none"},
        {"time.step: is by default", "study.cfg:6: time.step: is by default"},
        {"time.safety: is low", "study.cfg:7: time.safety: is low"},
        {"cracks[0]: is missing", "study.cfg: cracks[0]: is missing"},
        {"plate: is of another kind", "plate: is of another kind"},
        {"bodies[1].too: is no setting", "bodies[1].too: is no setting"},
        {"bodies[1: is odd", "bodies[1: is odd"},
        {"bodies are odd: all", "bodies are odd: all"},
        {": nothing", ": nothing"},
    };
    pdmc_study study;
    CHECK_OK(read_text(text, &study));
    for (size_t i = 0; i < sizeof messages / sizeof messages[0]; i++) {
        CHECK_STATUS(pdmc_study_place(&study, pdmc_raise(PDMC_ERR_CONFIG, "%s", messages[i][0])), PDMC_ERR_CONFIG);
        assert_string_equal(pdmc_last_error(), messages[i][1]);
    }
    CHECK_STATUS(pdmc_study_place(&study, pdmc_raise(PDMC_ERR_IO, "bodies[1]: full")), PDMC_ERR_IO);
    assert_string_equal(pdmc_last_error(), "bodies[1]: full");
    CHECK_OK(pdmc_study_place(&study, PDMC_OK));
    pdmc_study_clear(&study);
}

// A box of 3 x 5, or 3 x 5 x 7; a cylinder; a ball.
static void extents_are_those_of_geometry(void **state)
{
    (void)state;
    const double pi = 3.14159265358979323846;
    const pdmc_explicit in_plane = {.dimension = 2}, in_space = {.dimension = 3};
    const pdmc_shape box = {.kind = PDMC_SHAPE_BOX, .from = {-1, 2, 3}, .to = {2, 7, 10}};
    const pdmc_shape cylinder = {.kind = PDMC_SHAPE_CYLINDER, .from = {1, 2, 3}, .to = {1, -4, 3}, .radius = 0.5};
    const pdmc_shape ball = {.kind = PDMC_SHAPE_BALL, .radius = 2.0};
    CHECK_NEAR(pdmc_explicit_extent(&in_plane, &box), 15.0, 0.0);
    CHECK_NEAR(pdmc_explicit_extent(&in_space, &box), 105.0, 0.0);
    CHECK_NEAR(pdmc_explicit_extent(&in_space, &cylinder), 1.5 * pi, 1e-15);
    CHECK_NEAR(pdmc_explicit_extent(&in_plane, &ball), 4.0 * pi, 1e-14);
    CHECK_NEAR(pdmc_explicit_extent(&in_space, &ball), 32.0 / 3.0 * pi, 1e-14);
}

typedef struct {
    int part;
    const char *settings, *message;
} mistake;

static void expect(size_t count, const mistake mistakes[])
{
    static const pdmc_study zero;
    for (size_t i = 0; i < count; i++) {
        pdmc_study study;
        CHECK_STATUS(read_explicit(mistakes[i].part, mistakes[i].settings, &study), PDMC_ERR_CONFIG);
        assert_string_equal(pdmc_last_error(), mistakes[i].message);
        assert_memory_equal(&study, &zero, sizeof study);
    }
}

#define EXPECT(mistakes) expect(sizeof(mistakes) / sizeof *(mistakes), (mistakes))
#define CYLINDER_FROM_ORIGIN "bodies = ( { shape = \"cylinder\"; radius = 1; from = [0, 0, 0]; "

static void grids_and_materials_that_cannot_be(void **state)
{
    (void)state;
    const mistake mistakes[] = {
        {GRID, "", "study.cfg: grid.dimension: is missing, must be an integer from 2 to 3"},
        {GRID, "grid = { dimension = 4; spacing = 1.0; };",
         "study.cfg:2: grid.dimension: 4 is not allowed, must be from 2 to 3"},
        {GRID, "grid = { dimension = 3; spacing = 1.0; thickness = 2; };",
         "study.cfg:2: grid.thickness: is no setting of the dimension 3"},
        {GRID, "grid = { dimension = 3; spacing = 1.0; offset = [1, 2]; };",
         "study.cfg:2: grid.offset: an array of 2 is not allowed, must be as many reals as grid.dimension, [x, y] or "
         "[x, y, z], each finite"},
        {GRID, "grid = { dimension = 3; spacing = 1.0; horizon = 3; horizon_ratio = 3; };",
         "study.cfg:2: grid.horizon_ratio: is given beside a horizon, must be one of the two"},
        {GRID, "grid = { dimension = 3; spacing = 1.0; horizon = 0.5; };",
         "study.cfg:2: grid.horizon: 0.5 is too small, must be at least 1, the spacing"},
        {GRID, "grid = { dimension = 3; spacing = 1.0; horizon = 21; };",
         "study.cfg:2: grid.horizon: 21 is too large, must be at most 20, 20 spacings"},
        {GRID, "grid = { dimension = 3; spacing = 1e-3; };",
         "study.cfg:2: grid.spacing: 0.001 gives the bodies 6.4e+10 nodes, must be at most 2e+08"},
        {MATERIALS, "", "study.cfg: materials: no material, must be one at least"},
        {MATERIALS, "materials = ( { density = 1; youngs_modulus = 1; fibre_ratio = 2; } );",
         "study.cfg:3: materials[0].fibre_ratio: is given without a direction, must have `fibre` beside it"},
        {REST, "no_fail = ( { from = [0, 0, 0]; to = [1, -1, 1]; } );",
         "study.cfg:9: no_fail[0].to: -1 in y is below from, 0, must be at least that"},
        {MATERIALS, "materials = ( { density = 1; } );",
         "study.cfg:3: materials[0]: \"material1\" has 0 moduli, must have one of youngs_modulus, bulk_modulus, "
         "micromodulus"},
        {MATERIALS, "materials = ( { density = 1; youngs_modulus = 1; micromodulus = 1; } );",
         "study.cfg:3: materials[0]: \"material1\" has 2 moduli, must have one of youngs_modulus, bulk_modulus, "
         "micromodulus"},
        {MATERIALS, "materials = ( { density = 1; youngs_modulus = 1; critical_stretch = 1; fracture_energy = 1; } );",
         "study.cfg:3: materials[0]: \"material1\" has a fracture_energy and a critical_stretch, must have one or "
         "none"},
        {MATERIALS,
         "materials = ( { name = \"a\"; density = 1; youngs_modulus = 1; }, { name = \"a\"; density = 1; "
         "youngs_modulus = 1; } );",
         "study.cfg:3: materials[1].name: \"a\" is the name of an earlier material too, must be another"},
    };
    EXPECT(mistakes);
}

static void bodies_and_cracks_that_cannot_be(void **state)
{
    (void)state;
    const mistake mistakes[] = {
        {BODIES, "", "study.cfg: bodies: no body, must be one at least"},
        {BODIES, "bodies = ( { from = [0, 0, 0]; to = [1, -1, 1]; } );",
         "study.cfg:4: bodies[0].to: -1 in y is below from, 0, must be at least that"},
        {BODIES, "bodies = ( { from = [0, 0, 0]; to = [1, 1, 1]; radius = 1; } );",
         "study.cfg:4: bodies[0].radius: is no setting of the shape \"box\""},
        {BODIES, "bodies = ( { from = [0, 0, 0]; to = [1, 1, 1]; material = \"glas\"; } );",
         "study.cfg:4: bodies[0].material: \"glas\" is not allowed, must be the name of one of the materials"},
        {BODIES, CYLINDER_FROM_ORIGIN "to = [1, 1, 0]; } );",
         "study.cfg:4: bodies[0].to: differs from `from` in 2 coordinates, must differ in one"},
        {BODIES, "bodies = ( { shape = \"ball\"; radius = 1; } );",
         "study.cfg:4: bodies[0].centre: is missing, must be as many reals as grid.dimension, [x, y] or [x, y, z], "
         "each "
         "finite"},
        {CRACKS, "cracks = ( { from = [0, 0]; to = [0, 0]; } );",
         "study.cfg:5: cracks[0].to: is where from is, must be elsewhere"},
        {CRACKS, "cracks = ( { shape = \"disc\"; centre = [0, 0, 0]; radius = 1; normal = [0, 0, 0]; } );",
         "study.cfg:5: cracks[0].normal: is zero, must have a direction"},
        {CRACKS,
         "cracks = ( { shape = \"rectangle\"; centre = [0, 0, 0]; first_side = [1, 2, 3]; second_side = [-2, -4, -6]; "
         "} );",
         "study.cfg:5: cracks[0].second_side: makes no rectangle with first_side, must have another direction"},
        {CRACKS,
         "cracks = ( { name = \"c\"; from = [0, 0]; to = [1, 0]; }, { name = \"c\"; from = [0, 0]; to = [0, 1]; } );",
         "study.cfg:5: cracks[1].name: \"c\" is the name of an earlier crack too, must be another"},
    };
    EXPECT(mistakes);
}

#define TWO_BODIES "bodies = ( { from = [0, 0, 0]; to = [4, 4, 4]; }, { from = [5, 0, 0]; to = [9, 4, 4]; } ); "
#define PART "bodies = ( { from = [0, 0, 0]; to = [4, 4, 4]; }, { inside = \"body1\"; from = [3, 0, 0]; to = [9, 4, 4]; } "
#define BETWEEN_BODIES "between = \"bodies\"; first_body = \"body1\"; second_body = \"body2\"; "

static void parts_and_interfaces_that_cannot_be(void **state)
{
    (void)state;
    const mistake mistakes[] = {
        {BODIES, "bodies = ( { from = [0, 0, 0]; to = [4, 4, 4]; inside = \"body2\"; } );",
         "study.cfg:4: bodies[0].inside: \"body2\" is not allowed, must be the name of an earlier body"},
        {BODIES, "bodies = ( { from = [0, 0, 0]; to = [4, 4, 4]; inside = \"body1\"; } );",
         "study.cfg:4: bodies[0].inside: \"body1\" is not allowed, must be an earlier body that is not inside another"},
        {BODIES, PART ", { inside = \"body2\"; from = [3, 0, 0]; to = [9, 4, 4]; } );",
         "study.cfg:4: bodies[2].inside: \"body2\" is not allowed, must be an earlier body that is not inside another"},
        {BODIES, PART ", { inside = \"body1\"; from = [3, 0, 0]; to = [9, 4, 4]; velocity = [0, 1, 0]; } );",
         "study.cfg:4: bodies[2].velocity: is given inside another body, must be left to that"},
        {BODIES, TWO_BODIES "interfaces = ( { between = \"bodies\"; first_body = \"body1\"; } );",
         "study.cfg:4: interfaces[0].second_body: is missing, must be the name of one of the bodies"},
        {BODIES, TWO_BODIES "interfaces = ( { between = \"bodies\"; first_body = \"body1\"; second_body = \"body1\"; } );",
         "study.cfg:4: interfaces[0].second_body: is the first body too, must be another"},
        {BODIES, TWO_BODIES "interfaces = ( { first_material = \"material1\"; second_material = \"material1\"; first_body = \"body1\"; } );",
         "study.cfg:4: interfaces[0].first_body: is no setting of the between \"materials\""},
        {BODIES, TWO_BODIES "interfaces = ( { " BETWEEN_BODIES "}, { " BETWEEN_BODIES "} );",
         "study.cfg:4: interfaces[1]: is between the same two as an earlier one, must be between others"},
        {BODIES, TWO_BODIES "interfaces = ( { " BETWEEN_BODIES "youngs_modulus = 1; micromodulus = 1; } );",
         "study.cfg:4: interfaces[0].micromodulus: is given beside youngs_modulus, must be one of the two or none"},
        {BODIES, TWO_BODIES "interfaces = ( { " BETWEEN_BODIES "critical_stretch = 1; fracture_energy = 1; } );",
         "study.cfg:4: interfaces[0].critical_stretch: is given beside fracture_energy, must be one of the two or none"},
    };
    EXPECT(mistakes);
}

static void conditions_and_times_that_cannot_be(void **state)
{
    (void)state;
    const char *layer = "conditions = ( { from = [0, 0, 0]; to = [1, 1, 1]; %s } );";
    const struct {
        const char *settings, *message;
    } layers[] = {
        {"x = 1; y_gradient = [0, 1, 0];",
         "study.cfg:6: conditions[0].y_gradient: is given without y, must have it, 0 for instance"},
        {"", "study.cfg:6: conditions[0]: prescribes nothing, must have x or y or z"},
        {"x = 1; times = [0, 1]; factors = [1, 2, 3];",
         "study.cfg:6: conditions[0].factors: 3 factors are given at 2 times, must be as many"},
        {"x = 1; times = [2, 1]; factors = [1, 2];",
         "study.cfg:6: conditions[0].times: 1 stands behind 2, must ascend"},
    };
    const mistake mistakes[] = {
        {SPHERES, "spheres = ( { radius = 1; centre = [0, 0, 9]; } );",
         "study.cfg:7: spheres[0].stiffness: is missing, must be a real > 0"},
        {TIME, "", "study.cfg: time.duration: is missing, must be a real > 0"},
        {TIME, "time = { duration = 1; step = 2; };",
         "study.cfg:8: time.step: 2 is too large, must be at most 1, the duration"},
        // sqrt(2 rho / (c h^3 sum)), c = 12 E / (pi horizon^4) = 2.2635, 108.915 the sum over 178 neighbours of share / |xi|
        {TIME, "time = { duration = 10; step = 1; };",
         "study.cfg:8: time.step: 1 is too large, must be at most 0.360278, the largest stable one"},
        {TIME, "time = { duration = 1; safety = 1.5; };",
         "study.cfg:8: time.safety: 1.5 is not allowed, must be > 0 and <= 1"},
        {REST, "record = { interval = 11; };",
         "study.cfg:9: record.interval: 11 is too large, must be at most 10, the duration"},
        {REST, "record = { tip_damage = 1; };",
         "study.cfg:9: record.tip_damage: 1 is not allowed, must be > 0 and < 1"},
        {REST, "plate = { width = 1; };", "study.cfg:9: plate: is not part of a study of kind \"explicit\""},
        {REST, "reliability = { };", "study.cfg:9: reliability: is not part of a study of kind \"explicit\""},
        {REST, "sampling = { order = 3; };", "study.cfg:9: sampling.order: is no setting of a study of kind \"explicit\""},
        {REST, "random = ( { quantity = \"thickness\"; } );",
         "study.cfg:9: random[0].quantity: is not known of bodies of bonds, must be \"stiffness\", \"youngs_modulus\", "
         "\"fracture_energy\", \"bond_strength\", \"load\" or \"velocity\""},
        {REST, "random = ( { quantity = \"bond_strength\"; variation = 0.5; } );",
         "study.cfg:9: random[0].distribution: the distribution of strengths: its least is -0.648597, needs to be > 0"},
        {REST,
         "random = ( { quantity = \"fracture_energy\"; correlation_length = 1.0; }, { quantity = \"load\"; } ); "
         "correlations = ( { first = \"load\"; second = \"fracture_energy\"; correlation = 0.5; } );",
         "study.cfg:9: correlations[0].second: differs from place to place, must have one value a sample in a study of bodies of "
         "bonds"},
    };
    for (size_t i = 0; i < sizeof layers / sizeof layers[0]; i++) {
        char settings[512];
        snprintf(settings, sizeof settings, layer, layers[i].settings);
        expect(1, &(mistake){CONDITIONS, settings, layers[i].message});
    }
    EXPECT(mistakes);
}

static void the_plane_has_no_depth(void **state)
{
    (void)state;
    pdmc_study study;
    const char *const changes[][2] = {
        {"conditions = ( { from = [0, 0]; to = [1, 1]; z = 1; } );",
         "study.cfg:4: conditions[0].z: is not allowed in two dimensions, must be x or y"},
        {"cracks = ( { shape = \"disc\"; centre = [0, 0]; radius = 1; normal = [1, 0]; } );",
         "study.cfg:4: cracks[0].shape: must be \"segment\" in two dimensions"},
        {"conditions = ( { shape = \"cylinder\"; from = [0, 0]; to = [1, 0]; radius = 1; x = 1; } );",
         "study.cfg:4: conditions[0].shape: \"cylinder\" is not allowed in two dimensions, must be \"box\" or "
         "\"ball\""},
    };
    for (size_t i = 0; i < sizeof changes / sizeof changes[0]; i++) {
        char text[1024];
        snprintf(text, sizeof text,
                 "kind = \"explicit\"; grid = { dimension = 2; spacing = 0.1; };\n"
                 "materials = ( { density = 1; youngs_modulus = 1; } );\n"
                 "bodies = ( { from = [0, 0]; to = [1, 1]; } ); time = { duration = 1; };\n%s\n",
                 changes[i][0]);
        CHECK_STATUS(read_text(text, &study), PDMC_ERR_CONFIG);
        assert_string_equal(pdmc_last_error(), changes[i][1]);
    }
}

static const char with_nodes[] =
    "kind = \"explicit\"; grid = { dimension = 2; spacing = 0.5; };\n"
    "materials = ( { density = 2; youngs_modulus = 3; } ); time = { duration = 10; };\n"
    "bodies = ( { from = [9, 9]; to = [10, 10]; }, { shape = \"nodes\"; file = \"%s\"; velocity = [1, 2]; } );\n";

static pdmc_status read_nodes(const char *nodes, pdmc_study *study)
{
    char text[512];
    snprintf(text, sizeof text, with_nodes, "plate.txt");
    write_text("plate.txt", nodes);
    return read_text(text, study);
}

static void nodes_come_from_a_file(void **state)
{
    (void)state;
    pdmc_study study, again;
    CHECK_OK(read_nodes("# a plate\n\n0.25 -1e-1 2.5e-2 # the corner\n\t-3 4\t0.5\r\n", &study));
    const pdmc_explicit_body *plate = &study.motion.bodies[1];
    assert_string_equal(plate->file, "plate.txt");
    assert_int_equal(plate->body.node_count, 2);
    const pdmc_node first = {{0.25, -0.1, 0.0}, 0.025}, second = {{-3.0, 4.0, 0.0}, 0.5};
    assert_memory_equal(&plate->body.nodes[0], &first, sizeof first);
    assert_memory_equal(&plate->body.nodes[1], &second, sizeof second);
    CHECK_NEAR(pdmc_explicit_nodes(&study.motion, &plate->body), 2.0, 0.0);
    CHECK_NEAR(pdmc_explicit_nodes(&study.motion, &study.motion.bodies[0].body), 4.0, 0.0);
    CHECK_OK(read_text(study.resolved, &again));
    assert_string_equal(study.resolved, again.resolved);
    assert_memory_equal(plate->body.nodes, again.motion.bodies[1].body.nodes, 2 * sizeof first);
    pdmc_study_clear(&study);
    pdmc_study_clear(&again);
}

static void memory_for_nodes_that_runs_out_is_said(void **state)
{
    (void)state;
    pdmc_study study;
    CHECK_FAILS_CLEANLY(read_nodes("0 0 1\n1 0 1\n", &study), pdmc_study_clear(&study));
}

/// A file is beside the one that names it, also where that is included from another folder.
static void files_are_beside_the_study(void **state)
{
    (void)state;
    char text[512];
    pdmc_study study;
    assert_int_equal(mkdir("inner", 0700), 0);
    write_text("inner/plate.txt", "1 2 3\n");
    snprintf(text, sizeof text, with_nodes, "plate.txt");
    write_text("inner/study.cfg", text);
    CHECK_OK(pdmc_study_read("inner/study.cfg", &study));
    assert_int_equal(study.motion.bodies[1].body.node_count, 1);
    pdmc_study_clear(&study);
    CHECK_OK(read_text("@include \"inner/study.cfg\"\n", &study));
    assert_int_equal(study.motion.bodies[1].body.node_count, 1);
    pdmc_study_clear(&study);
}

static void nodes_that_cannot_be(void **state)
{
    (void)state;
    pdmc_study study;
    static const char *const mistakes[][2] = {
        {"0 0 1\n1 0\n", "plate.txt:2: is no node, must be three numbers, x y volume"},
        {"0 0 1\n# ...\n1 0 0 1\n", "plate.txt:3: is no node, must be three numbers, x y volume"},
        {"0 0 1\n1 0 one\n", "plate.txt:2: is no node, must be three numbers, x y volume"},
        {"0 0 1,5\n", "plate.txt:1: is no node, must be three numbers, x y volume"},
        {"0 0 1\n1 nan 1\n", "plate.txt:2: nan, must be finite"},
        {"0 inf 1\n", "plate.txt:1: inf, must be finite"},
        {"0 0 1\n1 0 0\n", "plate.txt:2: the volume is 0, must be > 0"},
        {"0 0 -1\n", "plate.txt:1: the volume is -1, must be > 0"},
        {"5 6 1\n0 0 1\n7 8 1\n5 6 2\n", "plate.txt:4: the node is in the place of that of line 1"},
        {"# nothing\n", "plate.txt: has no node"},
    };
    for (size_t i = 0; i < sizeof mistakes / sizeof mistakes[0]; i++) {
        CHECK_STATUS(read_nodes(mistakes[i][0], &study), PDMC_ERR_DATA);
        assert_string_equal(pdmc_last_error(), mistakes[i][1]);
    }
    char text[512];
    snprintf(text, sizeof text, with_nodes, "missing.txt");
    CHECK_STATUS(read_text(text, &study), PDMC_ERR_NO_INPUT);
    assert_string_equal(pdmc_last_error(), "missing.txt: No such file or directory");
    const mistake others[] = {
        {BODIES, "bodies = ( { shape = \"nodes\"; } );",
         "study.cfg:4: bodies[0].file: is missing, must be a text, not empty and without control characters"},
        {BODIES, "bodies = ( { from = [0, 0, 0]; to = [1, 1, 1]; file = \"a\"; } );",
         "study.cfg:4: bodies[0].file: is no setting of the shape \"box\""},
        {CONDITIONS, "conditions = ( { shape = \"nodes\"; x = 1; } );",
         "study.cfg:6: conditions[0].shape: \"nodes\" is not allowed, must be \"box\", \"cylinder\" or \"ball\""},
    };
    EXPECT(others);
}

static void plates_have_no_bodies(void **state)
{
    (void)state;
    pdmc_study study;
    CHECK_STATUS(read_with(LINE_TOP, "bodies = ();", &study), PDMC_ERR_CONFIG);
    assert_string_equal(pdmc_last_error(), "study.cfg:11: bodies: is not part of a study of kind \"static\"");
    CHECK_OK(read_with(LINE_TOP, "", &study));
    assert_null(strstr(study.resolved, "bodies"));
    pdmc_study_clear(&study);
}

static void memory_that_is_refused_is_told(void **state)
{
    (void)state;
    pdmc_study study;
    CHECK_FAILS_CLEANLY(read_text(plane, &study), pdmc_study_clear(&study));
}

static const char slow[] =
    "kind = \"quasi_static\"; grid = { dimension = 2; spacing = 0.5; };\n"
    "materials = ( { density = 2; youngs_modulus = 3; critical_stretch = 0.02; } );\n"
    "bodies = ( { from = [0, 0]; to = [8, 8]; } );\n"
    "conditions = ( { prescribed = \"displacement\"; from = [0, 0]; to = [8, 1]; y = 0; },\n"
    "               { prescribed = \"force\"; from = [0, 7]; to = [8, 8]; y = 1; times = [0, 3]; factors = [0, 2]; } );\n"
    "spheres = ( { radius = 2; centre = [4, 10]; displacement = [0.0, -0.25]; stiffness = 5; } );\n"
    "loading = { steps = 7; end = 3.0; tolerance = 1e-5; most_steps = 500; }; record = { snapshots = 4; };\n";

static void loads_are_read(void **state)
{
    (void)state;
    pdmc_study first, second;
    CHECK_OK(read_text(slow, &first));
    const pdmc_explicit *m = &first.motion;
    assert_int_equal(first.problem.kind, PDMC_QUASI_STATIC);
    assert_int_equal(m->load_steps, 7);
    CHECK_NEAR(m->load_ends[0], 0.0, 0.0);
    CHECK_NEAR(m->load_ends[1], 3.0, 0.0);
    CHECK_NEAR(m->rest_tolerance, 1e-5, 0.0);
    assert_int_equal(m->most_relaxation_steps, 500);
    CHECK_NEAR(m->contact_distance, 1.35, 0.0);
    assert_int_equal(m->sphere_count, 1);
    CHECK_NEAR(m->spheres[0].displacement[1], -0.25, 0.0);
    assert_int_equal(m->snapshots, 4);
    assert_false(m->has_interval || m->has_speed_window || m->has_step);
    CHECK_OK(read_text(first.resolved, &second));
    assert_string_equal(first.resolved, second.resolved);
    const pdmc_explicit_amounts amounts = pdmc_explicit_count(m);
    CHECK_NEAR(amounts.steps, 7.0, 0.0);
    pdmc_study_clear(&first);
    pdmc_study_clear(&second);
}

// What only moves has no place in it.
static void what_moves_is_not_at_rest(void **state)
{
    (void)state;
    const struct {
        const char *settings, *message;
    } mistakes[] = {
        {"conditions = ( { from = [0, 0]; to = [1, 1]; x = 1; } );",
         "study.cfg:4: conditions[0].prescribed: \"velocity\" is not allowed in a quasi-static study, must be \"displacement\" or "
         "\"force\""},
        {"time = { duration = 1; };", "study.cfg:4: time: is not part of a study of kind \"quasi_static\""},
        {"random = ( { quantity = \"velocity\"; variation = 0.1; } );",
         "study.cfg:4: random[0].quantity: is of what moves, a quasi-static study has none"},
        {"spheres = ( { radius = 1; centre = [0, 0]; stiffness = 1; velocity = [1, 0]; } );", "study.cfg:4: spheres[0].velocity: is no setting of a study of kind \"quasi_static\""},
        {"spheres = ( { radius = 1; centre = [0, 0]; stiffness = 1; mass = 1; } );", "study.cfg:4: spheres[0].mass: is no setting of a study of kind \"quasi_static\""},
        {"damping = { absolute = 1; };", "study.cfg:4: damping: is not part of a study of kind \"quasi_static\""},
        {"loading = { steps = 0; };", "study.cfg:4: loading.steps: 0 is not allowed, must be from 1 to 1000000"},
        {"loading = { tolerance = 0.0; };",
         "study.cfg:4: loading.tolerance: 0.0 is not allowed, must be > 0 and <= 0.1"},
        {"record = { interval = 1; };",
         "study.cfg:4: record.interval: is no setting of a quasi-static study, which has no time"},
        {"record = { speed_window = 1; };",
         "study.cfg:4: record.speed_window: is no setting of a quasi-static study, which has no time"},
    };
    for (size_t i = 0; i < sizeof mistakes / sizeof mistakes[0]; i++) {
        char text[1024];
        pdmc_study study;
        snprintf(text, sizeof text,
                 "kind = \"quasi_static\"; grid = { dimension = 2; spacing = 0.5; };\n"
                 "materials = ( { density = 2; youngs_modulus = 3; } );\nbodies = ( { from = [0, 0]; to = [8, 8]; } );\n%s\n",
                 mistakes[i].settings);
        CHECK_STATUS(read_text(text, &study), PDMC_ERR_CONFIG);
        assert_string_equal(pdmc_last_error(), mistakes[i].message);
    }
    pdmc_study study;
    CHECK_STATUS(read_text("kind = \"quasi_static\"; grid = { dimension = 2; spacing = 0.5; };\n"
                           "materials = ( { density = 2; youngs_modulus = 3; } );\n"
                           "bodies = ( { from = [0, 0]; to = [8, 8]; velocity = [1, 0]; } );\n",
                           &study),
                 PDMC_ERR_CONFIG);
    assert_string_equal(pdmc_last_error(), "study.cfg:3: bodies[0].velocity: is not zero, must be in a quasi-static study");
    CHECK_STATUS(read_text("kind = \"quasi_static\"; grid = { dimension = 2; spacing = 0.5;\n"
                           "precision = \"single\"; };\nmaterials = ( { density = 2; youngs_modulus = 3; } );\n"
                           "bodies = ( { from = [0, 0]; to = [8, 8]; } );\n",
                           &study),
                 PDMC_ERR_CONFIG);
    assert_string_equal(pdmc_last_error(),
                        "study.cfg:2: grid.precision: \"single\" is not allowed in a quasi-static study, must be \"double\": "
                        "rounded displacements keep forces from being in balance");
    CHECK_STATUS(read_explicit(REST, "loading = { steps = 3; };", &study), PDMC_ERR_CONFIG);
    assert_string_equal(pdmc_last_error(), "study.cfg:9: loading: is not part of a study of kind \"explicit\"");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_given_is_kept),
        cmocka_unit_test(defaults_are_of_the_first_step),
        cmocka_unit_test(the_resolved_study_reads_back),
        cmocka_unit_test(what_is_found_out_later_has_its_line),
        cmocka_unit_test(extents_are_those_of_geometry),
        cmocka_unit_test(grids_and_materials_that_cannot_be),
        cmocka_unit_test(bodies_and_cracks_that_cannot_be),
        cmocka_unit_test(parts_and_interfaces_that_cannot_be),
        cmocka_unit_test(conditions_and_times_that_cannot_be),
        cmocka_unit_test(the_plane_has_no_depth),
        cmocka_unit_test(nodes_come_from_a_file),
        cmocka_unit_test(files_are_beside_the_study),
        cmocka_unit_test(memory_for_nodes_that_runs_out_is_said),
        cmocka_unit_test(nodes_that_cannot_be),
        cmocka_unit_test(plates_have_no_bodies),
        cmocka_unit_test(memory_that_is_refused_is_told),
        cmocka_unit_test(loads_are_read),
        cmocka_unit_test(what_moves_is_not_at_rest),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
