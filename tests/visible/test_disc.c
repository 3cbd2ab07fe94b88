// SPDX-License-Identifier: GPL-3.0-or-later
#include "check.h"
#include "visible/disc.h"

#define PI 3.14159265358979323846

// A crack along the x axis, from `from` to 10.
typedef struct {
    pdmc_crack crack;
    pdmc_problem problem;
    pdmc_cuts cuts;
} cracked;

static void cracked_along_x(cracked *c, double from)
{
    *c = (cracked){.crack = {"crack", {from, 0.0}, {10.0, 0.0}}};
    c->problem = (pdmc_problem){.plate = {100.0, 100.0, 1.0}, .crack_count = 1, .cracks = &c->crack};
    CHECK_OK(pdmc_cuts_create(&c->problem, &c->cuts));
}

// int int r, r cos^2, r cos sin, r sin^2 dr dtheta
static void add_moments(void *context, const pdmc_disc_point *p)
{
    double *moment = context;
    moment[0] += p->weight * p->r;
    moment[1] += p->weight * p->r * p->cosine * p->cosine;
    moment[2] += p->weight * p->r * p->cosine * p->sine;
    moment[3] += p->weight * p->r * p->sine * p->sine;
}

static void take_moments(const cracked *c, const pdmc_view *centre, int angular, double moment[4])
{
    pdmc_disc_rule rule;
    for (int k = 0; k < 4; k++) moment[k] = 0.0;
    CHECK_OK(pdmc_disc_rule_create(&c->cuts, NULL, 1.0, 4, angular, &rule));
    pdmc_disc_visit(&rule, centre, add_moments, moment);
    pdmc_disc_rule_clear(&rule);
}

static void a_face_sees_half_a_disc(void **state)
{
    (void)state;
    cracked c;
    cracked_along_x(&c, -10.0);
    for (int side = -1; side <= 1; side += 2) {
        const pdmc_view face = {{0.3, 0.0}, 0, side};
        double moment[4];
        take_moments(&c, &face, 4, moment);
        CHECK_NEAR(moment[0], 0.5 * PI, 1e-12);
        CHECK_NEAR(moment[1], 0.25 * PI, 1e-9);
        CHECK_NEAR(moment[2], 0.0, 1e-12);
        CHECK_NEAR(moment[3], 0.25 * PI, 1e-9);
    }
    pdmc_cuts_clear(&c.cuts);
}

// A long crack at a distance d cuts a circular segment off: within b = acos(d) of straight down r ends at d / |sin|.
static void a_long_crack_cuts_a_segment_off(void **state)
{
    (void)state;
    const double distances[4] = {0.02, 0.3, 0.7, 0.99};
    cracked c;
    cracked_along_x(&c, -10.0);
    for (int i = 0; i < 4; i++) {
        const double d = distances[i], b = acos(d), s = sin(b) * cos(b);
        const pdmc_view centre = {{0.4, d}, -1, 0};
        double moment[4];
        take_moments(&c, &centre, 2, moment);
        CHECK_NEAR(moment[0], PI - b + d * sqrt(1.0 - d * d), 1e-3);
        CHECK_NEAR(moment[3], 0.5 * PI - 0.5 * (b + s) + d * d * b, 1e-3);
        CHECK_NEAR(moment[2], 0.0, 1e-12);
        take_moments(&c, &centre, 8, moment);
        CHECK_NEAR(moment[0], PI - b + d * sqrt(1.0 - d * d), 1e-8);
        CHECK_NEAR(moment[1] + moment[3], moment[0], 1e-12);
    }
    pdmc_cuts_clear(&c.cuts);
}

// Below a tip the shadow of the crack begins: half of the segment is lost, and both cos sin terms of it.
static void a_tip_throws_a_shadow(void **state)
{
    (void)state;
    const double d = 0.3, b = acos(d);
    cracked c;
    cracked_along_x(&c, 0.0);
    const pdmc_view above = {{0.0, d}, -1, 0}, below = {{0.0, -d}, -1, 0};
    double moment[4], mirrored[4];
    take_moments(&c, &above, 8, moment);
    take_moments(&c, &below, 8, mirrored);
    CHECK_NEAR(moment[0], PI - 0.5 * b + 0.5 * d * sqrt(1.0 - d * d), 1e-8);
    // int over the lost directions of cos sin (1 - d^2 / sin^2) / 2, with sin = -cos b', cos = sin b'
    CHECK_NEAR(moment[2], 0.25 * (1.0 - d * d) + 0.5 * d * d * log(d), 1e-8);
    CHECK_NEAR(mirrored[0], moment[0], 1e-12);
    CHECK_NEAR(mirrored[2], -moment[2], 1e-12);
    pdmc_cuts_clear(&c.cuts);
}

static void a_crack_out_of_reach_changes_nothing(void **state)
{
    (void)state;
    cracked c;
    cracked_along_x(&c, -10.0);
    const pdmc_view centre = {{0.0, 1.5}, -1, 0};
    double moment[4];
    take_moments(&c, &centre, 4, moment);
    CHECK_NEAR(moment[0], PI, 1e-12);
    pdmc_cuts_clear(&c.cuts);
}

static void faces_see_their_own_side(void **state)
{
    (void)state;
    cracked c;
    cracked_along_x(&c, -10.0);
    const pdmc_view left = {{0.0, 0.0}, 0, 1}, right = {{0.0, 0.0}, 0, -1}, other = {{1.0, 0.0}, 0, 1};
    const pdmc_view above = {{0.2, 1.0}, -1, 0}, below = {{0.2, -1.0}, -1, 0}, beyond = {{12.0, -1.0}, -1, 0};
    assert_true(pdmc_view_sees(&c.cuts, &left, &above));
    assert_false(pdmc_view_sees(&c.cuts, &left, &below));
    assert_true(pdmc_view_sees(&c.cuts, &below, &right));
    assert_true(pdmc_view_sees(&c.cuts, &left, &other));
    assert_false(pdmc_view_sees(&c.cuts, &right, &other));
    assert_false(pdmc_view_sees(&c.cuts, &above, &below));
    assert_true(pdmc_view_sees(&c.cuts, &below, &beyond));
    const double x[2] = {3.0, 0.0}, up[2] = {3.0, 0.1}, down[2] = {3.0, -0.1};
    assert_int_equal(pdmc_view_at(&c.cuts, x, up).side, 1);
    assert_int_equal(pdmc_view_at(&c.cuts, x, down).side, -1);
    assert_int_equal(pdmc_view_at(&c.cuts, up, down).crack, -1);
    pdmc_cuts_clear(&c.cuts);
}

static void every_refused_allocation_is_reported(void **state)
{
    (void)state;
    cracked c;
    cracked_along_x(&c, -10.0);
    pdmc_disc_rule rule;
    CHECK_FAILS_CLEANLY(pdmc_disc_rule_create(&c.cuts, NULL, 1.0, 4, 2, &rule), pdmc_disc_rule_clear(&rule));
    pdmc_cuts_clear(&c.cuts);
    CHECK_FAILS_CLEANLY(pdmc_cuts_create(&c.problem, &c.cuts), pdmc_cuts_clear(&c.cuts));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_face_sees_half_a_disc),  cmocka_unit_test(a_long_crack_cuts_a_segment_off),
        cmocka_unit_test(a_tip_throws_a_shadow),    cmocka_unit_test(a_crack_out_of_reach_changes_nothing),
        cmocka_unit_test(faces_see_their_own_side), cmocka_unit_test(every_refused_allocation_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
