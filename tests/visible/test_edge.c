// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/drawn_block.h"
#include "visible/cracked.h"

#include <gsl/gsl_math.h>

// A 5 x 5 plate under unit tension across a crack of length a that begins `outside` beyond the middle of a side.
static void make(plate *p, pdmc_side side, double a, double outside, double horizon)
{
    const bool is_along_x = side == PDMC_SIDE_LEFT || side == PDMC_SIDE_RIGHT;
    const double turn = side == PDMC_SIDE_LEFT ? 0.0 : side == PDMC_SIDE_BOTTOM ? 0.5 * M_PI : M_PI;
    const double from_middle = 2.5 + 0.5 * (outside - a);
    const double tension[3] = {is_along_x ? 0.0 : 1.0, is_along_x ? 1.0 : 0.0, 0.0};
    cracked_make(p, 5.0, horizon, 4);
    cracked_load(p, tension);
    plate_crack(p, -from_middle * cos(turn), -from_middle * sin(turn), 0.5 * (a + outside), turn);
    p->problem.energy.tip_count = 1; // the "to"
    p->tips[0] = 1;
}

static double factor_of(pdmc_side side, double a, double outside, double horizon, double spacing)
{
    plate p;
    pdmc_visible *visible = NULL;
    pdmc_tip tip;
    make(&p, side, a, outside, horizon);
    p.problem.solver.spacing = spacing;
    CHECK_OK(pdmc_visible_create(&p.problem, NULL, 1, &visible));
    CHECK_OK(pdmc_visible_tip(visible, 1, &tip));
    CHECK_NEAR(tip.stress_intensity[1], 0.0, 0.01 * tip.stress_intensity[0]);
    pdmc_visible_destroy(&visible);
    return tip.stress_intensity[0] / sqrt(M_PI * a);
}

// F = K_I / (sigma sqrt(pi a)) of a square plate, 1.229, 1.489 and 1.846 in the local limit, known to 0.5 %: a horizon
// of 0.1 a adds a little, as it does inside a plate. With twice the spacing they are 0.2, 1.1 and 1.8 % above it.
static void stress_intensity_has_its_local_limit(void **state)
{
    (void)state;
    const double cases[3][2] = {{0.5, 1.229}, {1.0, 1.489}, {1.5, 1.846}};
    for (int i = 0; i < 3; i++) {
        const double a = cases[i][0], F = factor_of(PDMC_SIDE_LEFT, a, 0.0, 0.1 * a, 0.125);
        printf("  a / W = %.1f: F = %.4f, local limit %.3f\n", a / 5.0, F, cases[i][1]);
        CHECK_NEAR(F, 1.005 * cases[i][1], 0.01 * cases[i][1]);
    }
}

// Other nodes at every side; how far outside the crack begins does not matter.
static void sides_are_alike(void **state)
{
    (void)state;
    const double left = factor_of(PDMC_SIDE_LEFT, 1.0, 0.0, 0.2, 0.25);
    CHECK_NEAR(factor_of(PDMC_SIDE_LEFT, 1.0, 0.7, 0.2, 0.25), left, 1e-9);
    CHECK_NEAR(factor_of(PDMC_SIDE_RIGHT, 1.0, 0.1, 0.2, 0.25), left, 0.005 * left);
    CHECK_NEAR(factor_of(PDMC_SIDE_BOTTOM, 1.0, 0.1, 0.2, 0.25), left, 0.005 * left);
}

// The faces' points end at the mouth, where the crack is open widest.
static void the_field_ends_at_the_mouth(void **state)
{
    (void)state;
    plate p;
    pdmc_visible *visible = NULL;
    pdmc_displacement_field field;
    pdmc_tip tip;
    double before = INFINITY;
    make(&p, PDMC_SIDE_LEFT, 1.0, 0.3, 0.2);
    CHECK_OK(pdmc_visible_create(&p.problem, NULL, 1, &visible));
    CHECK_STATUS(pdmc_visible_tip(visible, 0, &tip), PDMC_ERR_ARG);
    CHECK_OK(pdmc_visible_field(visible, &field));
    CHECK_NEAR(field.face_position[0], -2.5, 1e-4);
    CHECK_NEAR(field.face_position[2 * (field.face_points - 1)], -1.5, 1e-4);
    for (int i = 0; i < field.face_points; i++) {
        const double *u = &field.face_displacement[4 * i], opening = u[1] - u[3];
        assert_true(opening > 0.0 && opening < before + 1e-3);
        before = opening;
    }
    pdmc_free(field.node_position);
    pdmc_free(field.node_displacement);
    pdmc_free(field.face_position);
    pdmc_free(field.face_displacement);
    pdmc_visible_destroy(&visible);
}

// Oblique mouths, whose ghosts lean and whose wedges are sharp, and a tip near a side: solutions with four and with six
// nodes a horizon are the same to 0.3 %, at a mouth of 45 degrees to 2.2 %. Conditions on a side that are not stable
// differed by factors.
static void refinement_changes_little(void **state)
{
    (void)state;
    const double cracks[5][4] = {{-2.5, 0.2, -1.5, 0.0},
                                 {-2.5, 0.6, -1.5, 0.0},
                                 {-2.7, -1.2, -1.5, 0.0},
                                 {0.3, -2.5, 0.0, -1.6},
                                 {1.3, 0.0, 2.3, 0.0}};
    for (int i = 0; i < 5 - 3 * FINEST_LEFT_OUT; i++) {
        double K[2][2];
        for (int k = 0; k < 2; k++) {
            const double tension[3] = {0.3, 1.0, 0.0};
            plate p;
            pdmc_visible *visible = NULL;
            pdmc_tip tip;
            cracked_make(&p, 5.0, 0.12, 4 + 2 * k);
            cracked_load(&p, tension);
            plate_crack(&p, 0.0, 0.0, 0.5, 0.0);
            for (int d = 0; d < 2; d++) {
                p.cracks[0].from[d] = cracks[i][d];
                p.cracks[0].to[d] = cracks[i][2 + d];
            }
            CHECK_OK(pdmc_visible_create(&p.problem, NULL, 2, &visible));
            CHECK_OK(pdmc_visible_tip(visible, 1, &tip));
            for (int m = 0; m < 2; m++) K[k][m] = tip.stress_intensity[m];
            pdmc_visible_destroy(&visible);
        }
        printf("  K_I %.4f, %.4f; K_II %.4f, %.4f\n", K[0][0], K[1][0], K[0][1], K[1][1]);
        for (int m = 0; m < 2; m++) CHECK_NEAR(K[1][m], K[0][m], 0.03 * K[0][0]);
    }
}

// Bond energies at the tip: none back along the crack, and the same on both sides of straight ahead but for the nodes.
static void energies_are_symmetric(void **state)
{
    (void)state;
    plate p;
    pdmc_visible *visible = NULL;
    pdmc_affine model;
    drawn_block drawn;
    make(&p, PDMC_SIDE_LEFT, 1.0, 0.3, 0.2);
    CHECK_OK(pdmc_visible_create(&p.problem, NULL, 1, &visible));
    CHECK_OK(pdmc_visible_affine(visible, &model));
    pdmc_block *block = drawn_block_begin(&drawn, &p.problem, &model, 1);
    CHECK_OK(pdmc_block_solve(block, 1));
    pdmc_block_energies(block, PDMC_BONDS_ALL);
    for (int k = 1; k < 4; k++) {
        const double left = block->energy[k * PDMC_BLOCK], right = block->energy[(8 - k) * PDMC_BLOCK];
        printf("  at +-%d degrees: %.4f, %.4f\n", 45 * k, left, right);
        CHECK_NEAR(left, right, 0.02 * right);
    }
    assert_true(block->energy[4 * PDMC_BLOCK] == 0.0);
    drawn_block_end(&drawn);
    pdmc_affine_clear(&model);
    pdmc_visible_destroy(&visible);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stress_intensity_has_its_local_limit),
        cmocka_unit_test(sides_are_alike),
        cmocka_unit_test(refinement_changes_little),
        cmocka_unit_test(the_field_ends_at_the_mouth),
        cmocka_unit_test(energies_are_symmetric),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
