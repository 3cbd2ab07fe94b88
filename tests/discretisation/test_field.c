// SPDX-License-Identifier: GPL-3.0-or-later
#include "check.h"
#include "discretisation/field.h"

// A crack along x that opens by 1 above and 2 below, seen through the anchor.
static pdmc_status opened(const void *method, const double x[2], const double anchor[2], double u[2])
{
    (void)method;
    u[0] = x[0];
    u[1] = anchor[1] > 0.0 ? 1.0 : anchor[1] < 0.0 ? -2.0 : 0.0;
    return PDMC_OK;
}

static void free_arrays(pdmc_displacement_field *field)
{
    pdmc_free(field->node_position);
    pdmc_free(field->node_displacement);
    pdmc_free(field->face_position);
    pdmc_free(field->face_displacement);
}

static void nodes_and_both_faces_are_asked_for(void **state)
{
    (void)state;
    pdmc_crack crack = {"c", {-0.5, 0.0}, {1.5, 0.0}};
    const pdmc_problem problem = {.plate = {8.0, 8.0, 1.0}, .crack_count = 1, .cracks = &crack};
    const double nodes[6] = {0.0, 0.0, 1.0, 3.0, 2.0, -1.0};
    pdmc_displacement_field field;
    CHECK_OK(pdmc_field_fill(&problem, 3, nodes, opened, NULL, &field));
    assert_int_equal(field.node_count, 3);
    assert_memory_equal(field.node_position, nodes, sizeof nodes);
    CHECK_NEAR(field.node_displacement[3], 1.0, 0.0);
    CHECK_NEAR(field.node_displacement[5], -2.0, 0.0);
    for (int i = 0; i < field.face_points; i++) {
        const double *x = &field.face_position[2 * i], *u = &field.face_displacement[4 * i];
        assert_true(-0.5 < x[0] && x[0] < 1.5 && x[1] == 0.0); // a tip itself belongs to both faces
        assert_true(i == 0 || x[0] > x[-2]);
        CHECK_NEAR(u[0], x[0], 0.0);
        CHECK_NEAR(u[1], 1.0, 0.0);  // left of from -> to
        CHECK_NEAR(u[3], -2.0, 0.0); // right
    }
    free_arrays(&field);
    CHECK_FAILS_CLEANLY(pdmc_field_fill(&problem, 3, nodes, opened, NULL, &field), free_arrays(&field));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(nodes_and_both_faces_are_asked_for)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
