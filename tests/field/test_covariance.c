// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/field.h"

#include "check.h"

#include <float.h>

static double matern(double nu, double length, double r)
{
    return pdmc_covariance_at(&(pdmc_covariance){PDMC_COVARIANCE_MATERN, length, nu}, r);
}

static void closed_forms(void **state)
{
    (void)state;
    const pdmc_covariance exponential = {.kind = PDMC_COVARIANCE_EXPONENTIAL, .length = 0.7};
    const pdmc_covariance gaussian = {.kind = PDMC_COVARIANCE_GAUSSIAN, .length = 0.7};
    for (double r = 1e-3; r < 10.0; r *= 1.7) {
        const double s = r / 0.7, a = sqrt(3.0) * s, b = sqrt(5.0) * s;
        CHECK_NEAR(pdmc_covariance_at(&exponential, r), exp(-s), 4 * DBL_EPSILON);
        CHECK_NEAR(pdmc_covariance_at(&gaussian, r), exp(-s * s), 4 * DBL_EPSILON);
        // the logarithms in Matern's are of size 10, and their rounding is relative to that
        CHECK_NEAR(matern(0.5, 0.7, r), exp(-s), 100 * DBL_EPSILON);
        CHECK_NEAR(matern(1.5, 0.7, r), (1.0 + a) * exp(-a), 100 * DBL_EPSILON);
        CHECK_NEAR(matern(2.5, 0.7, r), (1.0 + b + b * b / 3.0) * exp(-b), 100 * DBL_EPSILON);
    }
}

/// As nu grows Matern's becomes exp(-r^2 / (2 l^2)), with a difference that goes with 1 / nu.
static void matern_tends_to_gaussian(void **state)
{
    (void)state;
    for (double r = 0.1; r < 3.0; r += 0.3) {
        const double limit = exp(-0.5 * r * r);
        const double coarse = matern(50.0, 1.0, r) - limit, fine = matern(200.0, 1.0, r) - limit;
        CHECK_NEAR(fine, coarse / 4.0, 0.1 * fabs(coarse) + 1e-4);
        CHECK_NEAR(fine, 0.0, 1.0 / 200.0);
    }
}

static void one_at_no_distance(void **state)
{
    (void)state;
    for (int kind = 0; kind <= PDMC_COVARIANCE_MATERN; kind++)
        for (double nu = 0.3; nu < 200.0; nu *= 5.0) {
            const pdmc_covariance covariance = {(pdmc_covariance_kind)kind, 2.0, nu};
            assert_true(pdmc_covariance_at(&covariance, 0.0) == 1.0);
            for (double r = 1e-300; r < 1e3; r *= 1e10) {
                const double c = pdmc_covariance_at(&covariance, r);
                assert_true(c >= 0.0 && c <= 1.0);
            }
            // 1 - C goes with s^(2 nu), times a factor of order one
            CHECK_NEAR(pdmc_covariance_at(&covariance, 1e-30), 1.0, 1e-12);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closed_forms),
        cmocka_unit_test(matern_tends_to_gaussian),
        cmocka_unit_test(one_at_no_distance),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
