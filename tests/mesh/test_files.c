// SPDX-License-Identifier: GPL-3.0-or-later
#define _GNU_SOURCE // mkstemps()
#include "topology.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#ifdef __SANITIZE_ADDRESS__
// Gmsh 4.8 itself loses a part of a file of version 2 that it cannot read to the end.
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void)
{
    return "leak:GModel::_readMSH2\n";
}
#endif

static char path[] = "/tmp/pdmc_mesh_XXXXXX.msh";

static int take_name(void **state)
{
    (void)state;
    const int file = mkstemps(path, 4);
    return file < 0 ? -1 : close(file);
}

static int remove_file(void **state)
{
    (void)state;
    return remove(path);
}

static void write_file(const char *text)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    assert_true(fputs(text, file) >= 0);
    assert_int_equal(fclose(file), 0);
}

// A square of side 2 in two triangles, the second of which goes round the wrong way; node 9 is no corner. The first is of the
// group "layer" in the versions that have groups.
#define NODES_OF_SQUARE "1 0 0 0\n2 2 0 0\n9 5 5 0\n3 2 2 0\n4 0 2 0\n"
static const char version_1[] = "$NOD\n5\n" NODES_OF_SQUARE "$ENDNOD\n"
                                "$ELM\n2\n1 2 1 1 3 1 2 3\n2 2 2 2 3 1 4 3\n$ENDELM\n";
static const char version_2[] = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                                "$PhysicalNames\n2\n2 1 \"layer\"\n2 2 \"body\"\n$EndPhysicalNames\n"
                                "$Nodes\n5\n" NODES_OF_SQUARE "$EndNodes\n"
                                "$Elements\n3\n1 1 2 7 7 1 2\n2 2 2 1 1 1 2 3\n3 2 2 2 2 1 4 3\n$EndElements\n";
static const char version_4[] =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
    "$PhysicalNames\n1\n2 5 \"layer\"\n$EndPhysicalNames\n"
    "$Entities\n0 0 2 0\n1 0 0 0 2 2 0 1 5 0\n2 0 0 0 2 2 0 0 0\n$EndEntities\n"
    "$Nodes\n1 5 1 9\n2 1 0 5\n1\n2\n9\n3\n4\n0 0 0\n2 0 0\n5 5 0\n2 2 0\n0 2 0\n$EndNodes\n"
    "$Elements\n2 2 1 2\n2 1 2 1\n1 1 2 3\n2 2 2 1\n2 1 4 3\n$EndElements\n";

static void check_square(const char *text, bool has_layer)
{
    static const double x[] = {0.0, 0.0, 2.0, 0.0, 2.0, 2.0, 0.0, 2.0};
    static const int corner[] = {0, 1, 2, 0, 2, 3};
    pdmc_mesh mesh;
    write_file(text);
    CHECK_OK(pdmc_mesh_read(path, 2, &mesh));
    assert_int_equal(mesh.dimension, 2);
    assert_int_equal(mesh.node_count, 4);
    assert_int_equal(mesh.element_count, 2);
    assert_memory_equal(mesh.x, x, sizeof x);
    assert_memory_equal(mesh.corner, corner, sizeof corner);
    assert_int_equal(mesh.layer[0], has_layer);
    assert_int_equal(mesh.layer[1], 0);
    pdmc_mesh_clear(&mesh);
}

static void files_of_all_versions_are_read(void **state)
{
    (void)state;
    check_square(version_1, false);
    check_square(version_2, true);
    check_square(version_4, true);
}

static void tetrahedra_are_read_in_space(void **state)
{
    (void)state;
    pdmc_mesh mesh;
    write_file("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
               "$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n$EndNodes\n"
               "$Elements\n3\n1 2 2 0 1 1 2 3\n2 4 2 0 1 1 2 3 4\n3 4 2 0 1 2 3 4 5\n$EndElements\n");
    CHECK_OK(pdmc_mesh_read(path, 3, &mesh));
    assert_int_equal(mesh.element_count, 2);
    CHECK_NEAR(pdmc_mesh_extent(&mesh, 0), 1.0 / 6.0, 1e-15);
    CHECK_NEAR(pdmc_mesh_extent(&mesh, 1), 1.0 / 3.0, 1e-15);
    pdmc_mesh_clear(&mesh);
    CHECK_STATUS(pdmc_mesh_read(path, 2, &mesh), PDMC_ERR_DATA);
    assert_non_null(strstr(pdmc_last_error(), "has tetrahedra, must have triangles"));
}

static void check_refused(const char *text, pdmc_status status, const char *message)
{
    pdmc_mesh mesh;
    write_file(text);
    CHECK_STATUS(pdmc_mesh_read(path, 2, &mesh), status);
    if (!strstr(pdmc_last_error(), message)) fail_msg("\"%s\" is not in: %s", message, pdmc_last_error());
    assert_non_null(strstr(pdmc_last_error(), path));
    assert_null(mesh.x);
}

#define FORMAT "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
#define CORNERS "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n"

static void what_is_wrong_with_a_file_is_said(void **state)
{
    (void)state;
    pdmc_mesh mesh;
    check_refused("", PDMC_ERR_DATA, "is no mesh of Gmsh");
    check_refused("Point(1) = {0, 0, 0};\n", PDMC_ERR_DATA, "is no mesh of Gmsh");
    check_refused("$MeshFormat\n7.0 0 8\n$EndMeshFormat\n", PDMC_ERR_DATA, "version 7");
    check_refused(FORMAT "$Nodes\n4\n1 0 0 0\n2 1", PDMC_ERR_DATA, "");
    check_refused(FORMAT CORNERS, PDMC_ERR_DATA, "has no triangle");
    check_refused(FORMAT CORNERS "$Elements\n2\n1 3 2 0 1 1 2 3 4\n2 2 2 0 1 1 2 3\n$EndElements\n", PDMC_ERR_DATA,
                  "Quadrilateral");
    check_refused(FORMAT
                  "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 2 0 0\n$EndNodes\n$Elements\n1\n1 2 2 0 1 1 2 3\n$EndElements\n",
                  PDMC_ERR_DATA, "no extent");
    check_refused(FORMAT
                  "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 2 1 0.5\n$EndNodes\n$Elements\n1\n1 2 2 0 1 1 2 3\n$EndElements\n",
                  PDMC_ERR_DATA, "z = 0.5");
    CHECK_STATUS(pdmc_mesh_read("/tmp/pdmc/no/such.msh", 2, &mesh), PDMC_ERR_NO_INPUT);
    CHECK_STATUS(pdmc_mesh_read("/dev/null", 2, &mesh), PDMC_ERR_DATA);
}

static void memory_that_runs_out_is_said(void **state)
{
    (void)state;
    pdmc_mesh mesh;
    write_file(version_2);
    CHECK_FAILS_CLEANLY(pdmc_mesh_read(path, 2, &mesh), pdmc_mesh_clear(&mesh));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(files_of_all_versions_are_read),
        cmocka_unit_test(tetrahedra_are_read_in_space),
        cmocka_unit_test(what_is_wrong_with_a_file_is_said),
        cmocka_unit_test(memory_that_runs_out_is_said),
    };
    return cmocka_run_group_tests(tests, take_name, remove_file);
}
