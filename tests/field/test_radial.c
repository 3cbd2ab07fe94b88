// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/field.h"

#include "check.h"

#include <float.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_roots.h>
#include <stdlib.h>

static const pdmc_covariance exponential = {.kind = PDMC_COVARIANCE_EXPONENTIAL, .length = 0.6};

/// The equations of the even and the odd eigenfunctions cos(w x), sin(w x) of exp(-|x - x'| / l) on [-a, a], without poles,
/// in t = w a (Ghanem & Spanos, Stochastic Finite Elements, section 2.3): a cos t - l t sin t = 0, a sin t + l t cos t = 0.
typedef struct {
    double half, length;
    bool even;
} wave;

static double equation(double t, void *data)
{
    const wave *w = data;
    return w->even ? w->half * cos(t) - w->length * t * sin(t) : w->half * sin(t) + w->length * t * cos(t);
}

/// The eigenvalue of number k on [0, radius], from the root in (k pi / 2, (k + 1) pi / 2).
static double analytic(int k, double radius, double length)
{
    wave w = {0.5 * radius, length, k % 2 == 0};
    gsl_function f = {equation, &w};
    gsl_root_fsolver *solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    gsl_root_fsolver_set(solver, &f, k * M_PI_2 + 1e-12, (k + 1) * M_PI_2);
    for (int i = 0; i < 100; i++) gsl_root_fsolver_iterate(solver);
    const double t = gsl_root_fsolver_root(solver) / w.half;
    gsl_root_fsolver_free(solver);
    return 2.0 * length / (1.0 + t * t * length * length);
}

/// The eigenvalue of the process that a column of the factor stands for.
static double eigenvalue(int bins, int modes, const double factor[], int k, double radius)
{
    double sum = 0.0;
    for (int i = 0; i < bins; i++) sum += factor[i * modes + k] * factor[i * modes + k];
    return sum * radius / bins;
}

/// The bins are a midpoint rule, whose error goes with the square of their width.
static void converges_to_the_transcendental_roots(void **state)
{
    (void)state;
    enum { MODES = 6, FINEST = 320 };
    const double radius = 1.5;
    double *factor = malloc(sizeof *factor * FINEST * MODES), retained, error[3][MODES];
    for (int level = 0; level < 3; level++) {
        const int bins = 80 << level;
        CHECK_OK(pdmc_radial_modes(&exponential, radius, bins, MODES, factor, &retained));
        for (int k = 0; k < MODES; k++)
            error[level][k] =
                eigenvalue(bins, MODES, factor, k, radius) / analytic(k, radius, exponential.length) - 1.0;
    }
    for (int k = 0; k < MODES; k++) {
        CHECK_NEAR(error[2][k], 0.0, 1e-3);
        CHECK_NEAR(log2(error[0][k] / error[1][k]), 2.0, 0.05);
        CHECK_NEAR(log2(error[1][k] / error[2][k]), 2.0, 0.02);
    }
    free(factor);
}

static void all_modes_give_the_correlation(void **state)
{
    (void)state;
    enum { BINS = 12 };
    for (int kind = 0; kind <= PDMC_COVARIANCE_MATERN; kind++) {
        const pdmc_covariance covariance = {(pdmc_covariance_kind)kind, 0.6, 1.2};
        double factor[BINS * BINS], few[BINS * 3], retained, variance = 0.0;
        CHECK_OK(pdmc_radial_modes(&covariance, 2.4, BINS, BINS, factor, &retained));
        CHECK_NEAR(retained, 1.0, 16 * DBL_EPSILON);
        for (int i = 0; i < BINS; i++)
            for (int j = 0; j < BINS; j++) {
                double sum = 0.0;
                for (int k = 0; k < BINS; k++) sum += factor[i * BINS + k] * factor[j * BINS + k];
                CHECK_NEAR(sum, pdmc_covariance_at(&covariance, 0.2 * abs(i - j)), 100 * DBL_EPSILON);
            }
        CHECK_OK(pdmc_radial_modes(&covariance, 2.4, BINS, 3, few, &retained));
        for (int i = 0; i < BINS; i++)
            for (int k = 0; k < 3; k++) {
                assert_true(few[i * 3 + k] == factor[i * BINS + k]);
                variance += few[i * 3 + k] * few[i * 3 + k];
            }
        CHECK_NEAR(retained, variance / BINS, 16 * DBL_EPSILON);
    }
}

static void refusals(void **state)
{
    (void)state;
    double factor[16], retained;
    CHECK_STATUS(pdmc_radial_modes(&exponential, 1.0, 4, 5, factor, &retained), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_radial_modes(&exponential, 1.0, 4, 0, factor, &retained), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_radial_modes(&exponential, 0.0, 4, 2, factor, &retained), PDMC_ERR_ARG);
    const pdmc_covariance pointlike = {.kind = PDMC_COVARIANCE_GAUSSIAN, .length = 0.0};
    CHECK_STATUS(pdmc_radial_modes(&pointlike, 1.0, 4, 2, factor, &retained), PDMC_ERR_ARG);
    const pdmc_covariance rough = {PDMC_COVARIANCE_MATERN, 1.0, 0.0};
    CHECK_STATUS(pdmc_radial_modes(&rough, 1.0, 4, 2, factor, &retained), PDMC_ERR_ARG);
    CHECK_FAILS_CLEANLY(pdmc_radial_modes(&exponential, 1.0, 4, 2, factor, &retained), (void)0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(converges_to_the_transcendental_roots),
        cmocka_unit_test(all_modes_give_the_correlation),
        cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
