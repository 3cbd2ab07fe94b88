// SPDX-License-Identifier: GPL-3.0-or-later

/// Meshes of scalar studies: what is read, what domain a file has, and what does not fit.

#include "study/folder.h"

#define HEAD                                                                                                           \
    "kind = \"scalar\";\nkernel = { horizon = 0.25; };\nwave = { length = 3; };\nconvergence = { levels = 2; };\n"
#define SQUARE "domain = { dimension = 2; width = 2; height = 1; };\n"
#define PLANE "domain = { dimension = 2; };\n"
#define FROM_FILE "elements = { mesh = \"file\"; file = \"a.msh\"; };\n"

// n by n cells of side 1 / 4, those of which are in the layer that are nearer to the edge than so many cells.
static void write_mesh(int n, int layer, bool has_group)
{
    FILE *file = fopen("a.msh", "w");
    assert_non_null(file);
    fprintf(file, "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n");
    if (has_group) fprintf(file, "$PhysicalNames\n1\n2 1 \"layer\"\n$EndPhysicalNames\n");
    fprintf(file, "$Nodes\n%d\n", (n + 1) * (n + 1));
    for (int i = 0; i < (n + 1) * (n + 1); i++)
        fprintf(file, "%d %g %g 0\n", i + 1, 0.25 * (i % (n + 1)), 0.25 * (i / (n + 1)));
    fprintf(file, "$EndNodes\n$Elements\n%d\n", 2 * n * n);
    for (int c = 0; c < n * n; c++) {
        const int i = c % n, j = c / n, sw = j * (n + 1) + i + 1, nw = sw + n + 1;
        const bool is_layer = i < layer || j < layer || i >= n - layer || j >= n - layer;
        const int entity = is_layer ? 1 : 2;
        fprintf(file, "%d 2 2 %d %d %d %d %d\n", 2 * c + 1, entity, entity, sw, sw + 1, nw + 1);
        fprintf(file, "%d 2 2 %d %d %d %d %d\n", 2 * c + 2, entity, entity, sw, nw + 1, nw);
    }
    fprintf(file, "$EndElements\n");
    assert_int_equal(fclose(file), 0);
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
        write_mesh(6, has_group ? 2 : 0, has_group);
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
    write_mesh(2, 0, false);
    CHECK_STATUS(read_text(HEAD PLANE FROM_FILE, &study), PDMC_ERR_CONFIG);
    assert_string_equal(pdmc_last_error(),
                        "study.cfg:6: elements.file: no element of the mesh is further from its edge than "
                        "the horizon, 0.25");
    write_mesh(3, 2, true);
    CHECK_STATUS(read_text(HEAD PLANE FROM_FILE, &study), PDMC_ERR_CONFIG);
    assert_string_equal(pdmc_last_error(), "study.cfg:6: elements.file: all elements of the mesh are in the layer");
    write_mesh(4, 1, true);
    CHECK_STATUS(
        read_text("kernel = { horizon = 0.26; };\nkind = \"scalar\";\nwave = { length = 3; };\n" PLANE FROM_FILE,
                  &study),
        PDMC_ERR_CONFIG);
    assert_string_equal(
        pdmc_last_error(),
        "study.cfg:5: elements.file: the layer of the mesh is 0.25 wide, must be at least kernel.horizon = 0.26");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(holes_and_their_spacing_are_read),
        cmocka_unit_test(the_spacing_at_holes_is_that_elsewhere_by_default),
        cmocka_unit_test(a_file_has_its_domain_and_layer),
        cmocka_unit_test(mistakes_are_told),
        cmocka_unit_test(files_that_do_not_fit_are_refused),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
