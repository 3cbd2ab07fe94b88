// SPDX-License-Identifier: GPL-3.0-or-later
#include "discretisation/tip.h"

#include "check.h"

#include <gsl/gsl_math.h>
#include <string.h>

enum { UNKNOWNS = 3 };

// K_I counts the solution by 1, 2, 3 and K_II by -1, -2, -3, times the number of the end.
static pdmc_status rows(const void *method, int tip, double row_1[], double row_2[])
{
    (void)method;
    for (int i = 0; i < UNKNOWNS; i++) {
        row_1[i] += tip * (i + 1.0);
        row_2[i] -= tip * (i + 1.0);
    }
    return PDMC_OK;
}

static pdmc_status no_rows(const void *method, int tip, double row_1[], double row_2[])
{
    (void)method, (void)tip, (void)row_1, (void)row_2;
    return pdmc_raise(PDMC_ERR_SINGULAR, "no rows");
}

/// A crack that begins beyond the left edge and ends inside, and one that ends at the right edge.
typedef struct {
    pdmc_problem problem;
    pdmc_crack cracks[2];
} plate;

static void plate_make(plate *p)
{
    *p = (plate){.cracks = {{"left", {-3.0, 0.0}, {-0.5, 0.0}}, {"right", {1.0, 1.0}, {1.0, 2.0}}}};
    p->problem = (pdmc_problem){.plate = {4.0, 4.0, 1.0}, .crack_count = 2, .cracks = p->cracks};
}

static void a_tip_has_its_name_place_and_factors(void **state)
{
    (void)state;
    static const double solution[UNKNOWNS] = {1.0, 10.0, 100.0};
    plate p;
    pdmc_tip tip;
    plate_make(&p);
    CHECK_OK(pdmc_tip_of(&p.problem, 1, UNKNOWNS, solution, rows, NULL, &tip));
    assert_string_equal(tip.name, "left.to");
    assert_true(tip.position[0] == -0.5 && tip.position[1] == 0.0 && tip.direction == 0.0);
    assert_true(tip.stress_intensity[0] == 321.0 && tip.stress_intensity[1] == -321.0 && isnan(tip.t_stress));
    CHECK_OK(pdmc_tip_of(&p.problem, 2, UNKNOWNS, solution, rows, NULL, &tip));
    assert_string_equal(tip.name, "right.from");
    assert_true(tip.direction == -M_PI_2 && tip.stress_intensity[0] == 642.0);
}

static void ends_at_an_edge_or_beyond_are_no_tips(void **state)
{
    (void)state;
    static const int none[] = {-1, 0, 3, 4};
    static const double solution[UNKNOWNS] = {0.0};
    plate p;
    pdmc_tip tip;
    plate_make(&p);
    for (int k = 0; k < 4; k++)
        CHECK_STATUS(pdmc_tip_of(&p.problem, none[k], UNKNOWNS, solution, rows, NULL, &tip), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_tip_of(&p.problem, 1, UNKNOWNS, solution, no_rows, NULL, &tip), PDMC_ERR_SINGULAR);
    CHECK_FAILS_CLEANLY(pdmc_tip_of(&p.problem, 1, UNKNOWNS, solution, rows, NULL, &tip), (void)0);
}

static void the_part_inside_counts(void **state)
{
    (void)state;
    plate p;
    plate_make(&p);
    CHECK_NEAR(pdmc_tip_half_length(&p.problem, 1), 0.75, 1e-15); // from the edge at -2 to -0.5
    CHECK_NEAR(pdmc_tip_half_length(&p.problem, 2), 0.5, 1e-15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_tip_has_its_name_place_and_factors),
        cmocka_unit_test(ends_at_an_edge_or_beyond_are_no_tips),
        cmocka_unit_test(the_part_inside_counts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
