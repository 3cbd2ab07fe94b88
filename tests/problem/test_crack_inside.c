// SPDX-License-Identifier: GPL-3.0-or-later
#include "check.h"
#include "pdmc/problem.h"

static void expect(pdmc_crack crack, double x0, double y0, double x1, double y1)
{
    const pdmc_problem problem = {.plate = {4.0, 2.0, 1.0}, .crack_count = 1, .cracks = &crack};
    double ends[2][2];
    pdmc_problem_crack_inside(&problem, 0, ends);
    CHECK_NEAR(ends[0][0], x0, 1e-15);
    CHECK_NEAR(ends[0][1], y0, 1e-15);
    CHECK_NEAR(ends[1][0], x1, 1e-15);
    CHECK_NEAR(ends[1][1], y1, 1e-15);
}

static void cracks_end_at_the_edge(void **state)
{
    (void)state;
    expect((pdmc_crack){"a", {-0.5, 0.25}, {0.3, -0.1}}, -0.5, 0.25, 0.3, -0.1);
    expect((pdmc_crack){"a", {-3.0, 0.5}, {1.0, 0.5}}, -2.0, 0.5, 1.0, 0.5);
    expect((pdmc_crack){"a", {0.5, 0.0}, {0.5, 5.0}}, 0.5, 0.0, 0.5, 1.0);
    expect((pdmc_crack){"a", {0.0, 0.0}, {4.0, 4.0}}, 0.0, 0.0, 1.0, 1.0);  // through the top
    expect((pdmc_crack){"a", {4.0, 2.0}, {0.0, 0.0}}, 2.0, 1.0, 0.0, 0.0); // through a corner
}

static void tips_are_inside(void **state)
{
    (void)state;
    pdmc_crack cracks[2] = {{"a", {-2.0, 0.5}, {1.0, 0.5}}, {"b", {0.0, 0.0}, {0.0, 3.0}}};
    const pdmc_problem problem = {.plate = {4.0, 2.0, 1.0}, .crack_count = 2, .cracks = cracks};
    assert_false(pdmc_problem_is_tip(&problem, 0)); // on the edge
    assert_true(pdmc_problem_is_tip(&problem, 1));
    assert_true(pdmc_problem_is_tip(&problem, 2));
    assert_false(pdmc_problem_is_tip(&problem, 3));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cracks_end_at_the_edge),
        cmocka_unit_test(tips_are_inside),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
