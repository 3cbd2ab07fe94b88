// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/quadrature.h"

#include "check.h"

static double power_integral(int power, double lower, double upper)
{
    return (pow(upper, power + 1) - pow(lower, power + 1)) / (power + 1);
}

// F(r) = r^2 s^k for k < rings is interpolated exactly, so every bin must integrate it to rounding.
static void each_bin_is_exact_for_polynomials(void **state)
{
    (void)state;
    const double radius = 0.3;
    for (int power = 2; power <= 3; power++) {
        pdmc_ring_rule rule;
        CHECK_OK(pdmc_ring_rule_create(5, 7, power, radius, &rule));
        for (int k = 0; k < 5; k++) {
            for (int b = 0; b < 7; b++) {
                double sum = 0.0;
                for (int q = 0; q < 5; q++) sum += rule.weight[b * 5 + q] * pow(rule.radius[q], 2 + 2 * k);
                const double exact = power_integral(power + 2 * k, radius * b / 7, radius * (b + 1) / 7);
                const double scale = power_integral(power + 2 * k, 0.0, radius);
                CHECK_NEAR(sum, exact, 1e-13 * scale); // the Lagrange polynomials reach some 10 outside their nodes
            }
        }
        pdmc_ring_rule_clear(&rule);
    }
}

// The radii are Gauss points: with a constant weight the degree is 2 rings - 1 in s, and no more.
static void a_constant_weight_is_integrated_to_gauss_degree(void **state)
{
    (void)state;
    pdmc_ring_rule rule;
    CHECK_OK(pdmc_ring_rule_create(4, 10, 2, 2.0, &rule));
    for (int k = 0; k <= 8; k++) {
        double sum = 0.0;
        for (int q = 0; q < 4; q++) sum += rule.mean[q] * pow(rule.radius[q], 2 + 2 * k);
        const double exact = power_integral(2 + 2 * k, 0.0, 2.0);
        if (k < 8) CHECK_NEAR(sum / exact, 1.0, 1e-13);
        else assert_true(fabs(sum / exact - 1.0) > 1e-7);
    }
    pdmc_ring_rule_clear(&rule);
}

// A ring function whose nearest singularity is at 1.5 radii, the closest that a tip comes to a collocation point: the
// error falls by the square of rho = 6.85 for each ring added (Gauss) and by rho in each bin (interpolation).
static void the_error_falls_geometrically(void **state)
{
    (void)state;
    double previous = 1.0;
    for (int rings = 2; rings <= 8; rings++) {
        pdmc_ring_rule rule, fine;
        CHECK_OK(pdmc_ring_rule_create(rings, 10, 2, 1.0, &rule));
        CHECK_OK(pdmc_ring_rule_create(24, 10, 2, 1.0, &fine));
        double worst = 0.0;
        for (int b = 0; b < 10; b++) {
            double sum = 0.0, exact = 0.0;
            for (int q = 0; q < rings; q++)
                sum += rule.weight[b * rings + q] * pow(rule.radius[q], 2) / (2.25 - pow(rule.radius[q], 2));
            for (int q = 0; q < 24; q++)
                exact += fine.weight[b * 24 + q] * pow(fine.radius[q], 2) / (2.25 - pow(fine.radius[q], 2));
            worst = fmax(worst, fabs(sum - exact));
        }
        assert_true(worst < previous / 4.0); // 6.85 asymptotically
        previous = worst;
        pdmc_ring_rule_clear(&rule);
        pdmc_ring_rule_clear(&fine);
    }
    assert_true(previous < 1e-6);
}

static void bad_arguments_are_refused(void **state)
{
    (void)state;
    pdmc_ring_rule rule;
    CHECK_STATUS(pdmc_ring_rule_create(0, 1, 2, 1.0, &rule), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_ring_rule_create(PDMC_MAX_RINGS + 1, 1, 2, 1.0, &rule), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_ring_rule_create(3, 0, 2, 1.0, &rule), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_ring_rule_create(3, 1, 1, 1.0, &rule), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_ring_rule_create(3, 1, 2, 0.0, &rule), PDMC_ERR_ARG);
    CHECK_FAILS_CLEANLY(pdmc_ring_rule_create(3, 2, 2, 1.0, &rule), pdmc_ring_rule_clear(&rule));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_bin_is_exact_for_polynomials),
        cmocka_unit_test(a_constant_weight_is_integrated_to_gauss_degree),
        cmocka_unit_test(the_error_falls_geometrically),
        cmocka_unit_test(bad_arguments_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
