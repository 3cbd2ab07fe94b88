// SPDX-License-Identifier: GPL-3.0-or-later

/// Meshes of scalar studies: what is read, what domain a file has, and what does not fit.

#include "study/folder.h"

#include "mesh/msh_file.h"

#define HEAD                                                                                                           \
    "kind = \"scalar\";\nkernel = { horizon = 0.25; };\nwave = { length = 3; };\nconvergence = { levels = 2; };\n"
#define SQUARE "domain = { dimension = 2; width = 2; height = 1; };\n"
#define PLANE "domain = { dimension = 2; };\n"
#define FROM_FILE "elements = { mesh = \"file\"; file = \"a.msh\"; };\n"

enum { NO_GROUP, OUTER, ALL };

// Cells of side 1 / 4 inside, and round them so wide a layer, which is the group "layer", or all is.
static void write_mesh(int inside, double layer, int group)
{
    pdmc_mesh mesh;
    CHECK_OK(pdmc_mesh_box(2, (double[]){0.25 * inside, 0.25 * inside}, (int[]){inside, inside}, layer, &mesh));
    if (group != OUTER) memset(mesh.layer, group == ALL, (size_t)mesh.element_count);
    write_msh("a.msh", &mesh, group != NO_GROUP);
    pdmc_mesh_clear(&mesh);
}

static void check_reads_back(pdmc_study *study)
{
    pdmc_study again;
    CHECK_OK(read_text(study->resolved, &again));
    assert_string_equal(again.resolved, study->resolved);
    pdmc_study_clear(&again);
}

static void holes_and_their_spacing_are_read(void **state)
{
    (void)state;
    pdmc_study study;
    CHECK_OK(read_text(HEAD SQUARE
                       "elements = { mesh = \"triangles\"; spacing = 0.2; hole_spacing = 0.1; near = 0.05; };\n"
                       "holes = ( { centre = [-0.5, 0.1]; radius = 0.2; }, { centre = [0.5, 0.0]; radius = 0.1; } );",
                       &study));
    const pdmc_mesh_plate plate = pdmc_scalar_plate(&study.scalar);
    assert_int_equal(plate.hole_count, 2);
    CHECK_NEAR(plate.holes[0].centre[0], -0.5, 0.0);
    CHECK_NEAR(plate.holes[1].radius, 0.1, 0.0);
    CHECK_NEAR(plate.layer, 0.25, 0.0);
    CHECK_NEAR(plate.fine_spacing, 0.1, 0.0);
    CHECK_NEAR(plate.near, 0.05, 0.0);
    check_reads_back(&study);
    pdmc_study_clear(&study);
}

static void the_spacing_at_holes_is_that_elsewhere_by_default(void **state)
{
    (void)state;
    pdmc_study study;
    CHECK_OK(read_text(HEAD SQUARE "elements = { mesh = \"triangles\"; spacing = 0.2; };", &study));
    CHECK_NEAR(pdmc_scalar_plate(&study.scalar).fine_spacing, 0.2, 0.0);
    check_reads_back(&study);
    pdmc_study_clear(&study);
}

static int count_layer(const pdmc_mesh *mesh)
{
    int count = 0;
    for (int e = 0; e < mesh->element_count; e++) count += mesh->layer[e];
    return count;
}

static void a_file_has_its_domain_and_layer(void **state)
{
    (void)state;
    for (int has_group = 0; has_group < 2; has_group++) {
        pdmc_study study;
        write_mesh(2, 0.5, has_group ? OUTER : NO_GROUP);
        CHECK_OK(read_text(HEAD PLANE FROM_FILE, &study));
        assert_int_equal(study.scalar.first.element_count, 72);
        assert_int_equal(count_layer(&study.scalar.first), has_group ? 64 : 40); // by the horizon one cell is enough
        CHECK_NEAR(study.scalar.width, has_group ? 0.5 : 1.0, 1e-15);
        CHECK_NEAR(study.scalar.height, has_group ? 0.5 : 1.0, 1e-15);
        check_reads_back(&study);
        pdmc_study_clear(&study);
    }
}

static void mistakes_are_told(void **state)
{
    (void)state;
    static const struct {
        const char *text, *message;
    } mistakes[] = {
        {HEAD PLANE "elements = { cells = 8; };",
         "study.cfg:5: domain.width: is missing, must be a real > 0 where the mesh is not that of a file"},
        {HEAD "domain = { dimension = 2; width = 1; };\nelements = { cells = 8; };",
         "study.cfg:5: domain.height: is missing, must be a real > 0 where the mesh is not that of a file"},
        {HEAD SQUARE FROM_FILE,
         "study.cfg:6: elements.mesh: \"file\" is not allowed with a width, a height or holes of the domain"},
        {HEAD "domain = { dimension = 1; width = 1; };\nelements = { mesh = \"triangles\"; spacing = 0.1; };",
         "study.cfg:6: elements.mesh: triangles are for two dimensions only, must be \"cells\""},
        {HEAD SQUARE "elements = { cells = 8; spacing = 0.1; };",
         "study.cfg:6: elements.spacing: is no setting of the mesh \"cells\""},
        {HEAD SQUARE "elements = { cells = 8; };\nholes = ( { centre = [0.0, 0.0]; radius = 0.2; } );",
         "study.cfg:6: elements.mesh: \"cells\" is not allowed with holes, must be \"triangles\""},
        {HEAD SQUARE
         "elements = { mesh = \"triangles\"; spacing = 0.1; };\nholes = ( { centre = [0.9, 0.0]; radius = 0.2; } );",
         "study.cfg:7: holes: the hole round (0.9, 0) is not inside the plate"},
        {HEAD SQUARE "elements = { mesh = \"triangles\"; spacing = 0.1; hole_spacing = 0.2; };",
         "study.cfg:6: elements.hole_spacing: 0.2 is not allowed, must be at most spacing = 0.1"},
    };
    pdmc_study study;
    for (size_t i = 0; i < sizeof mistakes / sizeof mistakes[0]; i++) {
        CHECK_STATUS(read_text(mistakes[i].text, &study), PDMC_ERR_CONFIG);
        assert_string_equal(pdmc_last_error(), mistakes[i].message);
    }
}

static void files_that_do_not_fit_are_refused(void **state)
{
    (void)state;
    pdmc_study study;
    remove("a.msh");
    CHECK_STATUS(read_text(HEAD PLANE FROM_FILE, &study), PDMC_ERR_NO_INPUT);
    assert_string_equal(pdmc_last_error(), "a.msh: No such file or directory");
    write_mesh(1, 0.125, NO_GROUP);
    CHECK_STATUS(read_text(HEAD PLANE FROM_FILE, &study), PDMC_ERR_CONFIG);
    assert_string_equal(pdmc_last_error(),
                        "study.cfg:6: elements.file: no element of the mesh is further from its edge than "
                        "the horizon, 0.25");
    write_mesh(1, 0.25, ALL);
    CHECK_STATUS(read_text(HEAD PLANE FROM_FILE, &study), PDMC_ERR_CONFIG);
    assert_string_equal(pdmc_last_error(), "study.cfg:6: elements.file: all elements of the mesh are in the layer");
    write_mesh(2, 0.25, OUTER);
    CHECK_STATUS(
        read_text("kernel = { horizon = 0.26; };\nkind = \"scalar\";\nwave = { length = 3; };\n" PLANE FROM_FILE,
                  &study),
        PDMC_ERR_CONFIG);
    assert_string_equal(
        pdmc_last_error(),
        "study.cfg:5: elements.file: the layer of the mesh is 0.25 wide, must be at least kernel.horizon = 0.26");
}

#define BODIES(body)                                                                                                   \
    "kind = \"explicit\"; grid = { dimension = 2; spacing = 0.25; thickness = 0.5; };\n"                               \
    "materials = ( { density = 1.0; youngs_modulus = 1.0; } ); time = { duration = 1.0; };\nbodies = ( { " body        \
    " } );"
#define OF_MESH "shape = \"mesh\"; file = \"a.msh\"; "

// 2 by 2 cells of side 1 / 4, whose diagonals meet in the middle and in no corner: 8, 3 and 1 triangles at a node of each kind.
static void nodes_of_a_body_are_those_of_a_mesh(void **state)
{
    (void)state;
    const double of_triangle = 0.5 * 0.25 * 0.25 * 0.5 / 3.0; // with the thickness
    for (int voronoi = 0; voronoi < 2; voronoi++) {
        pdmc_study study;
        write_mesh(2, 0.25, NO_GROUP); // 4 by 4 cells, all of them the body's
        CHECK_OK(read_text(voronoi ? BODIES(OF_MESH "volumes = \"voronoi\";") : BODIES(OF_MESH), &study));
        const pdmc_body *body = &study.motion.bodies[0].body;
        double sum = 0.0;
        assert_int_equal(body->node_count, 25);
        for (int i = 0; i < 25; i++) {
            const double *x = body->nodes[i].x;
            const int edges = (fabs(x[0]) == 0.5) + (fabs(x[1]) == 0.5);
            const bool is_meeting = ((int)lround(4.0 * (x[0] + x[1])) % 2) == 0;
            const double cell = 0.25 * 0.25 * 0.5 / (1 << edges);
            const double share = of_triangle * (is_meeting ? 8 >> edges : 4 >> edges);
            CHECK_NEAR(body->nodes[i].volume, voronoi ? cell : share, 1e-15);
            sum += body->nodes[i].volume;
        }
        CHECK_NEAR(sum, 0.5, 1e-12);
        assert_memory_equal(study.motion.mesh_generator, "Gmsh ", 5);
        check_reads_back(&study);
        pdmc_study_clear(&study);
    }
}

static void meshes_that_are_no_bodies_are_refused(void **state)
{
    (void)state;
    pdmc_study study;
    pdmc_mesh mesh;
    CHECK_OK(pdmc_mesh_box(2, (double[]){1.0, 1.0}, (int[]){2, 2}, 0.5, &mesh));
    CHECK_OK(pdmc_mesh_cut(&mesh, (double[]){-2.0, 0.0}, (double[]){0.0, 0.0}));
    write_msh("a.msh", &mesh, false);
    pdmc_mesh_clear(&mesh);
    CHECK_STATUS(read_text(BODIES(OF_MESH), &study), PDMC_ERR_DATA);
    assert_string_equal(pdmc_last_error(), "a.msh: two nodes are at (-1, 0, 0), must be in places of their own");
    CHECK_STATUS(read_text(BODIES("from = [0, 0]; to = [1, 1]; volumes = \"voronoi\";"), &study), PDMC_ERR_CONFIG);
    assert_string_equal(pdmc_last_error(), "study.cfg:3: bodies[0].volumes: is no setting of the shape \"box\"");
    write_mesh(1, 0.25, NO_GROUP);
    CHECK_STATUS(read_text(BODIES("from = [-9, -9]; to = [9, 9]; }, { inside = \"body1\"; " OF_MESH), &study),
                 PDMC_ERR_CONFIG);
    assert_string_equal(
        pdmc_last_error(),
        "study.cfg:3: bodies[1].shape: \"mesh\" is not allowed inside another body, whose nodes it has");
    CHECK_FAILS_CLEANLY(read_text(BODIES(OF_MESH), &study), pdmc_study_clear(&study));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(holes_and_their_spacing_are_read),
        cmocka_unit_test(the_spacing_at_holes_is_that_elsewhere_by_default),
        cmocka_unit_test(a_file_has_its_domain_and_layer),
        cmocka_unit_test(mistakes_are_told),
        cmocka_unit_test(files_that_do_not_fit_are_refused),
        cmocka_unit_test(nodes_of_a_body_are_those_of_a_mesh),
        cmocka_unit_test(meshes_that_are_no_bodies_are_refused),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
