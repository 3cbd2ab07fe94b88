// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology.h"

#include <gsl/gsl_math.h>
#include <omp.h>
#include <string.h>

static const double rounding = 1e-12; // of areas and lengths that are sums of some thousand

static pdmc_mesh_plate plate_of(double spacing)
{
    return (pdmc_mesh_plate){.width = 2.0, .height = 1.0, .spacing = spacing, .fine_spacing = spacing};
}

// Its edges on the hole are chords, no longer than 1.5 spacings, so that the polygon lacks at most a share of
// (chord / R)^2 / 6 of the circle's area.
static void check_hole(double radius, int euler)
{
    const pdmc_hole hole = {{0.3, -0.05}, radius};
    pdmc_mesh_plate plate = plate_of(0.1);
    pdmc_mesh mesh;
    double width;
    plate.hole_count = 1, plate.holes = &hole, plate.layer = 0.15;
    plate.fine_spacing = 0.04, plate.near = 0.05;
    CHECK_OK(pdmc_mesh_triangles(&plate, &mesh));
    const topology t = topology_of(&mesh);
    const double circle = M_PI * radius * radius, lacking = gsl_pow_2(1.5 * 0.04 / radius) / 6.0 * circle;
    assert_int_equal(t.euler, euler);
    assert_int_equal(t.most_elements_of_an_edge, 2);
    CHECK_NEAR(t.body_area, 2.0 - circle + 0.5 * lacking, 0.5 * lacking);
    if (euler == 1) CHECK_NEAR(t.area, 2.3 * 1.3, rounding);
    CHECK_OK(pdmc_mesh_layer_width(&mesh, &width));
    CHECK_NEAR(width, 0.15, rounding);
    assert_memory_equal(mesh.generator, "Gmsh 4.", 7);
    pdmc_mesh_clear(&mesh);
}

static void a_hole_is_filled_by_the_layer(void **state)
{
    (void)state;
    check_hole(0.12, 1); // the layer fills it
    check_hole(0.30, 0); // and this one by a ring
}

// An edge is as long as the size at its middle, give or take what Gmsh allows itself: half and one and a half.
static void edges_are_short_near_holes_and_cracks(void **state)
{
    (void)state;
    const pdmc_slit slit = {{-0.6, -0.1}, {-0.1, 0.2}};
    pdmc_mesh_plate plate = plate_of(0.2);
    pdmc_mesh mesh;
    pdmc_edges edges;
    plate.slit_count = 1, plate.slits = &slit, plate.fine_spacing = 0.02, plate.near = 0.05;
    CHECK_OK(pdmc_mesh_triangles(&plate, &mesh));
    CHECK_OK(pdmc_edges_create(&mesh, &edges));
    double largest = 0.0, total = 0.0;
    for (int i = 0; i < edges.count; i++) {
        const double *a = &mesh.x[2 * edges.node[i][0]], *b = &mesh.x[2 * edges.node[i][1]];
        const double middle[2] = {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
        const double t = GSL_MAX(0.0, GSL_MIN(1.0, ((middle[0] + 0.6) * 0.5 + (middle[1] + 0.1) * 0.3) / 0.34));
        const double away = hypot(middle[0] + 0.6 - 0.5 * t, middle[1] + 0.1 - 0.3 * t);
        const double size = GSL_MIN(0.2, 0.02 + 0.25 * GSL_MAX(0.0, away - 0.05)),
                     length = hypot(a[0] - b[0], a[1] - b[1]);
        largest = GSL_MAX(largest, fabs(log(length / size)));
        total += log(length / size);
    }
    assert_true(largest < log(2.2));
    CHECK_NEAR(total / edges.count, 0.0, 0.1);
    pdmc_edges_clear(&edges);
    pdmc_mesh_clear(&mesh);
}

static void cracks_part_the_nodes_but_for_their_tips(void **state)
{
    (void)state;
    const pdmc_slit slits[] = {{{-0.5, -0.2}, {0.1, 0.2}}, {{1.0, 0.1}, {0.5, 0.1}}, {{-0.6, 0.5}, {-0.7, 0.1}}};
    const double length = hypot(0.6, 0.4) + 0.5 + hypot(0.1, 0.4);
    pdmc_mesh_plate plate = plate_of(0.1);
    pdmc_mesh mesh;
    plate.slit_count = 3, plate.slits = slits, plate.fine_spacing = 0.05;
    CHECK_OK(pdmc_mesh_triangles(&plate, &mesh));
    const topology t = topology_of(&mesh);
    assert_int_equal(t.euler, 0); // the crack inside is a hole; those from edges are not
    assert_int_equal(t.most_elements_of_an_edge, 2);
    CHECK_NEAR(t.area, 2.0, rounding);
    CHECK_NEAR(t.rim, 6.0 + 2.0 * length, rounding);
    pdmc_mesh_clear(&mesh);
}

static void the_same_plate_has_the_same_mesh(void **state)
{
    (void)state;
    const pdmc_hole hole = {{0.0, 0.0}, 0.2};
    pdmc_mesh_plate plate = plate_of(0.1);
    pdmc_mesh first, second;
    plate.hole_count = 1, plate.holes = &hole;
    omp_set_num_threads(2);
    CHECK_OK(pdmc_mesh_triangles(&plate, &first));
    assert_int_equal(omp_get_max_threads(), 2); // Gmsh has it at 1
    CHECK_OK(pdmc_mesh_triangles(&plate, &second));
    assert_int_equal(first.node_count, second.node_count);
    assert_int_equal(first.element_count, second.element_count);
    assert_memory_equal(first.x, second.x, 2 * (size_t)first.node_count * sizeof *first.x);
    assert_memory_equal(first.corner, second.corner, 3 * (size_t)first.element_count * sizeof *first.corner);
    pdmc_mesh_clear(&first);
    pdmc_mesh_clear(&second);
}

static void plates_that_cannot_be_are_refused(void **state)
{
    (void)state;
    const pdmc_hole over_the_edge = {{0.9, 0.0}, 0.2}, two[] = {{{0.0, 0.0}, 0.2}, {{0.3, 0.0}, 0.1}};
    const pdmc_slit outside = {{0.0, 0.0}, {0.0, 0.6}}, through_hole = {{-0.5, 0.1}, {0.5, 0.1}};
    const pdmc_slit crossing[] = {{{-0.5, 0.0}, {0.5, 0.0}}, {{0.0, -0.3}, {0.0, 0.3}}};
    pdmc_mesh_plate plate = plate_of(0.1);
    pdmc_mesh mesh;
    plate.hole_count = 1, plate.holes = &over_the_edge;
    CHECK_STATUS(pdmc_mesh_triangles(&plate, &mesh), PDMC_ERR_ARG);
    plate.hole_count = 2, plate.holes = two;
    CHECK_STATUS(pdmc_mesh_triangles(&plate, &mesh), PDMC_ERR_ARG);
    plate.hole_count = 1, plate.slit_count = 1, plate.slits = &through_hole;
    CHECK_STATUS(pdmc_mesh_triangles(&plate, &mesh), PDMC_ERR_ARG);
    plate.hole_count = 0, plate.slits = &outside;
    CHECK_STATUS(pdmc_mesh_triangles(&plate, &mesh), PDMC_ERR_ARG);
    plate.slit_count = 2, plate.slits = crossing;
    CHECK_STATUS(pdmc_mesh_triangles(&plate, &mesh), PDMC_ERR_ARG);
    plate.slit_count = 1, plate.layer = 0.1;
    CHECK_STATUS(pdmc_mesh_triangles(&plate, &mesh), PDMC_ERR_ARG);
    plate = plate_of(0.0);
    CHECK_STATUS(pdmc_mesh_triangles(&plate, &mesh), PDMC_ERR_ARG);
    assert_null(mesh.x);
}

static void refining_halves_every_edge(void **state)
{
    (void)state;
    const pdmc_hole hole = {{0.0, 0.0}, 0.3};
    pdmc_mesh_plate plate = plate_of(0.2);
    pdmc_mesh mesh, finer;
    plate.hole_count = 1, plate.holes = &hole, plate.layer = 0.1;
    CHECK_OK(pdmc_mesh_triangles(&plate, &mesh));
    CHECK_OK(pdmc_mesh_refine(&mesh, &finer));
    const topology before = topology_of(&mesh), after = topology_of(&finer);
    assert_int_equal(finer.element_count, 4 * mesh.element_count);
    assert_int_equal(after.euler, before.euler);
    assert_int_equal(after.most_elements_of_an_edge, 2);
    CHECK_NEAR(after.body_area, before.body_area, rounding);
    CHECK_NEAR(after.rim, before.rim, rounding);
    CHECK_NEAR(pdmc_mesh_spacing(&finer), 0.5 * pdmc_mesh_spacing(&mesh), rounding);
    assert_string_equal(finer.generator, mesh.generator);
    pdmc_mesh_clear(&mesh);
    pdmc_mesh_clear(&finer);
}

// The box's own layer, 3 cells of 0.1, and what lies between it and the body.
static void the_layer_is_found_by_its_width(void **state)
{
    (void)state;
    pdmc_mesh mesh;
    double width;
    CHECK_OK(pdmc_mesh_box(2, (double[]){1.0, 0.8}, (int[]){10, 8}, 0.3, &mesh));
    uint8_t *own = pdmc_calloc((size_t)mesh.element_count, 1);
    memcpy(own, mesh.layer, (size_t)mesh.element_count);
    CHECK_OK(pdmc_mesh_layer_width(&mesh, &width));
    CHECK_NEAR(width, 0.3, rounding);
    CHECK_OK(pdmc_mesh_mark_layer(&mesh, 0.3));
    assert_memory_equal(mesh.layer, own, (size_t)mesh.element_count);
    CHECK_OK(pdmc_mesh_mark_layer(&mesh, 0.3 + 1e-6));
    CHECK_OK(pdmc_mesh_layer_width(&mesh, &width));
    CHECK_NEAR(width, 0.4, rounding);
    CHECK_STATUS(pdmc_mesh_mark_layer(&mesh, 1.0), PDMC_ERR_ARG);
    pdmc_free(own);
    pdmc_mesh_clear(&mesh);
}

static void memory_that_runs_out_is_said(void **state)
{
    (void)state;
    const pdmc_slit slit = {{-0.2, 0.0}, {0.2, 0.0}};
    pdmc_mesh_plate plate = plate_of(0.5);
    pdmc_mesh mesh, finer;
    double width;
    plate.slit_count = 1, plate.slits = &slit;
    CHECK_FAILS_CLEANLY(pdmc_mesh_triangles(&plate, &mesh), );
    CHECK_FAILS_CLEANLY(pdmc_mesh_refine(&mesh, &finer), pdmc_mesh_clear(&finer));
    CHECK_FAILS_CLEANLY(pdmc_mesh_mark_layer(&mesh, 0.01), );
    CHECK_FAILS_CLEANLY(pdmc_mesh_layer_width(&mesh, &width), );
    pdmc_mesh_clear(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_hole_is_filled_by_the_layer),
        cmocka_unit_test(edges_are_short_near_holes_and_cracks),
        cmocka_unit_test(cracks_part_the_nodes_but_for_their_tips),
        cmocka_unit_test(the_same_plate_has_the_same_mesh),
        cmocka_unit_test(plates_that_cannot_be_are_refused),
        cmocka_unit_test(refining_halves_every_edge),
        cmocka_unit_test(the_layer_is_found_by_its_width),
        cmocka_unit_test(memory_that_runs_out_is_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
