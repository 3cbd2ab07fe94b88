// SPDX-License-Identifier: GPL-3.0-or-later
#include "visible/cracked.h"

static void make_loaded(plate *p, double angle, double horizon)
{
    const double tension[3] = {0.0, 1.0, 0.0};
    cracked_make(p, 5.0, horizon, 6);
    cracked_load(p, tension);
    plate_crack(p, 0.0, 0.0, 0.5, angle);
}

// The factors of the field beyond the horizon tend to those of the local limit with the horizon; K_II is less certain.
static void stress_intensity_has_its_local_limit(void **state)
{
    (void)state;
    const struct {
        double angle, horizon, excess[2], tolerance;
    } cases[4] = {{0.0, 0.05, {0.0025, 0.0}, 0.002},
                  {0.0, 0.15, {0.0075, 0.0}, 0.003},
                  {0.0, 0.3, {0.02, 0.0}, 0.005},
                  {0.6, 0.15, {0.0075, 0.021}, 0.004}};
    for (int i = 2 * FINEST_LEFT_OUT; i < 4; i++) {
        plate p, small;
        pdmc_visible *visible = NULL;
        pdmc_kansa *local = NULL;
        make_loaded(&p, cases[i].angle, cases[i].horizon);
        CHECK_OK(pdmc_visible_create(&p.problem, NULL, 1, &visible));
        make_loaded(&small, cases[i].angle, 0.1);
        CHECK_OK(pdmc_kansa_create(&small.problem, NULL, 1, &local));
        for (int t = 0; t < 2; t++) {
            pdmc_tip tip, limit;
            CHECK_OK(pdmc_visible_tip(visible, t, &tip));
            CHECK_OK(pdmc_kansa_tip(local, t, &limit));
            for (int k = 0; k < 2; k++) {
                const double want = (1.0 + cases[i].excess[k]) * limit.stress_intensity[k];
                CHECK_NEAR(tip.stress_intensity[k], want, cases[i].tolerance * limit.stress_intensity[0]);
            }
            CHECK_NEAR(tip.direction, limit.direction, 1e-12);
            CHECK_NEAR(hypot(tip.position[0] - limit.position[0], tip.position[1] - limit.position[1]), 0.0, 1e-12);
            assert_string_equal(tip.name, limit.name);
            assert_true(isnan(tip.t_stress));
        }
        pdmc_kansa_destroy(&local);
        pdmc_visible_destroy(&visible);
    }
}

// Nodes of the plate, none outside; faces from one tip to the other, open, and as displacement() gives them.
static void the_field_holds_nodes_and_faces(void **state)
{
    (void)state;
    plate p;
    pdmc_visible *visible = NULL;
    pdmc_displacement_field field;
    make_loaded(&p, 0.0, 0.2);
    CHECK_OK(pdmc_visible_create(&p.problem, NULL, 1, &visible));
    CHECK_OK(pdmc_visible_field(visible, &field));
    assert_true(field.node_count > 300 && field.node_count < pdmc_visible_report(visible).nodes);
    for (int i = 0; i < 2 * field.node_count; i++) assert_true(fabs(field.node_position[i]) <= 2.5);
    for (int i = 0; i < field.face_points; i++) {
        const double *u = &field.face_displacement[4 * i], *x = &field.face_position[2 * i];
        assert_true(fabs(x[0]) < 0.5 && (i == 0 || x[0] > x[-2]));
        assert_true(u[1] > u[3]);
    }
    double jump[2];
    cracked_jump(cracked_visible, visible, 0.0, field.face_position[2 * 50], jump);
    CHECK_NEAR(field.face_displacement[4 * 50 + 1] - field.face_displacement[4 * 50 + 3], jump[1], 1e-12);
    pdmc_free(field.node_position);
    pdmc_free(field.node_displacement);
    pdmc_free(field.face_position);
    pdmc_free(field.face_displacement);
    pdmc_visible_destroy(&visible);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stress_intensity_has_its_local_limit),
        cmocka_unit_test(the_field_holds_nodes_and_faces),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
