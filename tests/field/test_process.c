// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/field.h"

#include "check.h"

#include <gsl/gsl_math.h>
#include <gsl/gsl_roots.h>

static const double LENGTH = 4.0, VARIATION = 0.3;

static pdmc_process *make(pdmc_covariance_kind kind, double correlation_length, int modes)
{
    const pdmc_covariance covariance = {.kind = kind, .length = correlation_length, .smoothness = 1.5};
    pdmc_process *process = NULL;
    CHECK_OK(pdmc_process_create(&covariance, LENGTH, VARIATION, modes, &process));
    return process;
}

// cos w a = l w sin w a of even and l w cos w a = -sin w a of odd functions, a half the length (Ghanem & Spanos 1991).
static double root_of(double w, void *parameter)
{
    const double *p = parameter; // l, parity
    const double a = 0.5 * LENGTH;
    return p[1] == 0.0 ? cos(w * a) - p[0] * w * sin(w * a) : p[0] * w * cos(w * a) + sin(w * a);
}

// The roots lie one in each interval of half a period.
static double wave_number(double correlation_length, int mode)
{
    double parameter[2] = {correlation_length, mode % 2};
    const double step = M_PI_2 / (0.5 * LENGTH);
    gsl_function f = {root_of, parameter};
    gsl_root_fsolver *solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    gsl_root_fsolver_set(solver, &f, mode * step + 1e-9, (mode + 1) * step - 1e-9);
    for (int i = 0; i < 100; i++) gsl_root_fsolver_iterate(solver);
    const double w = gsl_root_fsolver_root(solver);
    gsl_root_fsolver_free(solver);
    return w;
}

// lambda = 2 l / (1 + l^2 w^2), phi a cosine or a sine. The tail of the modes' variance, < 1e-8, is an error of 1e-4.
static void an_exponential_has_its_closed_form(void **state)
{
    (void)state;
    static const double lengths[] = {0.3, 2.0, 30.0};
    for (int c = 0; c < 3; c++) {
        pdmc_process *process = make(PDMC_COVARIANCE_EXPONENTIAL, lengths[c], 12);
        for (int k = 0; k < 12; k++) {
            const double w = wave_number(lengths[c], k), a = 0.5 * LENGTH, sign = k % 2 ? -1.0 : 1.0;
            const double lambda = 2.0 * lengths[c] / (1.0 + gsl_pow_2(lengths[c] * w));
            const double norm = sqrt(a + sign * sin(2.0 * w * a) / (2.0 * w)), x = 0.37 * a;
            const double phi = (k % 2 ? sin(w * x) : cos(w * x)) / norm;
            CHECK_NEAR(fabs(pdmc_process_mode(process, k, x)), fabs(VARIATION * sqrt(lambda) * phi), 1e-4 * VARIATION);
        }
        pdmc_process_destroy(&process);
    }
}

// With all modes that matter the sum of their products is the covariance, and nothing is left out.
static void the_modes_sum_to_the_covariance(void **state)
{
    (void)state;
    static const struct {
        pdmc_covariance_kind kind;
        double length, error;
    } cases[] = {{PDMC_COVARIANCE_GAUSSIAN, 0.7, 1e-7}, {PDMC_COVARIANCE_MATERN, 2.0, 1e-3}};
    enum { MODES = 40 };
    for (int c = 0; c < 2; c++) {
        const pdmc_covariance covariance = {.kind = cases[c].kind, .length = cases[c].length, .smoothness = 1.5};
        pdmc_process *process = make(cases[c].kind, cases[c].length, MODES);
        for (int i = 0; i < 7; i++) {
            const double x = -0.5 * LENGTH + LENGTH * i / 6.0, y = 0.3;
            double sum = 0.0;
            for (int k = 0; k < MODES; k++) sum += pdmc_process_mode(process, k, x) * pdmc_process_mode(process, k, y);
            const double want = gsl_pow_2(VARIATION) * pdmc_covariance_at(&covariance, fabs(x - y));
            CHECK_NEAR(sum, want, cases[c].error * gsl_pow_2(VARIATION));
        }
        assert_true(pdmc_process_retained(process) > 1.0 - cases[c].error);
        assert_true(pdmc_process_retained(process) < 1.0 + 1e-10);
        pdmc_process_destroy(&process);
    }
}

// Correlation over far more than the line: one factor for all of it.
static void a_long_process_is_a_constant(void **state)
{
    (void)state;
    pdmc_process *process = make(PDMC_COVARIANCE_GAUSSIAN, 1e3 * LENGTH, 3);
    for (int i = 0; i < 5; i++) {
        const double x = LENGTH * (0.25 * i - 0.5);
        CHECK_NEAR(pdmc_process_mode(process, 0, x), VARIATION, 1e-6 * VARIATION);
        CHECK_NEAR(pdmc_process_mode(process, 1, x), 0.0, 1e-3 * VARIATION);
        CHECK_NEAR(pdmc_process_mode(process, 2, x), 0.0, 1e-5 * VARIATION);
    }
    pdmc_process_destroy(&process);
}

static void what_cannot_be_is_refused(void **state)
{
    (void)state;
    const pdmc_covariance good = {.kind = PDMC_COVARIANCE_GAUSSIAN, .length = 1.0};
    const pdmc_covariance bad = {.kind = PDMC_COVARIANCE_GAUSSIAN, .length = -1.0};
    pdmc_process *process = NULL;
    CHECK_STATUS(pdmc_process_create(&bad, LENGTH, VARIATION, 3, &process), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_process_create(&good, 0.0, VARIATION, 3, &process), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_process_create(&good, LENGTH, VARIATION, 0, &process), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_process_create(&good, LENGTH, -0.1, 3, &process), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_process_create(&good, LENGTH, VARIATION, 2000, &process), PDMC_ERR_ARG);
    assert_null(process);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_exponential_has_its_closed_form),
        cmocka_unit_test(the_modes_sum_to_the_covariance),
        cmocka_unit_test(a_long_process_is_a_constant),
        cmocka_unit_test(what_cannot_be_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
