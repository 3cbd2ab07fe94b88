// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/geometry.h"

#include "check.h"

static bool cross(double px, double py, double qx, double qy, double ax, double ay, double bx, double by)
{
    const double p[2] = {px, py}, q[2] = {qx, qy}, a[2] = {ax, ay}, b[2] = {bx, by};
    const bool answer = pdmc_segments_cross(p, q, a, b);
    assert_int_equal(answer, pdmc_segments_cross(q, p, a, b));
    assert_int_equal(answer, pdmc_segments_cross(a, b, p, q));
    return answer;
}

static void segments_cross_where_they_share_a_point(void **state)
{
    (void)state;
    assert_true(cross(0, -1, 0, 1, -1, 0, 1, 0));
    assert_false(cross(0, 1, 0, 2, -1, 0, 1, 0));      // stops short of the line
    assert_false(cross(2, -1, 2, 1, -1, 0, 1, 0));     // passes the end
    assert_false(cross(-1, 0.5, 1, 0.5, -1, 0, 1, 0)); // parallel
    assert_true(cross(0, 0, 0, 1, -1, 0, 1, 0));       // touches inside
    assert_true(cross(1, 0, 3, 5, -1, 0, 1, 0));       // touches an end
    assert_true(cross(0.5, 0, 3, 0, -1, 0, 1, 0));     // overlaps
    assert_false(cross(1.5, 0, 3, 0, -1, 0, 1, 0));    // on one line, apart
    assert_true(cross(0.25, 0, 0.25, 0, -1, 0, 1, 0)); // a point on it
    assert_false(cross(0.25, 1, 0.25, 1, -1, 0, 1, 0));
}

static void distance_is_to_the_nearest_point_of_the_segment(void **state)
{
    (void)state;
    const double a[2] = {0, 0}, b[2] = {2, 0};
    CHECK_NEAR(pdmc_point_segment_distance((double[2]){1, 3}, a, b), 3, 0);
    CHECK_NEAR(pdmc_point_segment_distance((double[2]){5, 4}, a, b), 5, 1e-15);
    CHECK_NEAR(pdmc_point_segment_distance((double[2]){-3, -4}, a, b), 5, 1e-15);
    CHECK_NEAR(pdmc_point_segment_distance((double[2]){3, 4}, a, a), 5, 1e-15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(segments_cross_where_they_share_a_point),
        cmocka_unit_test(distance_is_to_the_nearest_point_of_the_segment),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
