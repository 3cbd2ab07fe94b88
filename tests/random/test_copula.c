// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/distribution.h"
#include "pdmc/random.h"

#include "check.h"

#include <float.h>
#include <gsl/gsl_statistics_double.h>
#include <string.h>

enum { N = 4, SAMPLES = 100000 };

static const double correlation[N * N] = {1.0,  0.5, -0.3, 0.3, 0.5, 1.0, 0.2, 0.8,
                                          -0.3, 0.2, 1.0,  0.1, 0.3, 0.8, 0.1, 1.0};

static void the_factor_times_its_transpose_is_the_matrix(void **state)
{
    (void)state;
    double factor[N * N];
    CHECK_OK(pdmc_copula_factor(N, correlation, factor));
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            double sum = 0.0;
            for (int k = 0; k < N; k++) sum += factor[i * N + k] * factor[j * N + k];
            CHECK_NEAR(sum, correlation[i * N + j], 4 * DBL_EPSILON);
            if (j > i) CHECK_NEAR(factor[i * N + j], 0.0, 0.0);
        }
        assert_true(factor[i * N + i] > 0.0);
    }
}

static void two_variables_by_hand(void **state)
{
    (void)state;
    double factor[4];
    CHECK_OK(pdmc_copula_factor(2, (double[]){1.0, 0.6, 0.6, 1.0}, factor));
    const double want[] = {1.0, 0.0, 0.6, 0.8};
    for (int i = 0; i < 4; i++) CHECK_NEAR(factor[i], want[i], 2 * DBL_EPSILON);
}

static double z[N][SAMPLES];

static void draw_correlated(void)
{
    double factor[N * N];
    CHECK_OK(pdmc_copula_factor(N, correlation, factor));
    for (int s = 0; s < SAMPLES; s++) {
        double u[N];
        pdmc_random_uniform(5, PDMC_STREAM_LOAD, (uint64_t)s, 0, N, u);
        for (int i = 0; i < N; i++) {
            z[i][s] = 0.0;
            for (int j = 0; j <= i; j++) z[i][s] += factor[i * N + j] * pdmc_normal_quantile(u[j]);
        }
    }
}

/// Fisher's atanh r has the deviation 1 / sqrt(n - 3): 5 of them are passed by chance once in 2 million.
static void samples_have_the_correlation(void **state)
{
    (void)state;
    draw_correlated();
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < i; j++) {
            const double r = gsl_stats_correlation(z[i], 1, z[j], 1, SAMPLES);
            CHECK_NEAR(atanh(r), atanh(correlation[i * N + j]), 5.0 / sqrt(SAMPLES - 3.0));
        }
    }
}

/// Of lognormal variables: (exp(r s t) - 1) / sqrt((exp(s^2) - 1) (exp(t^2) - 1)). The mean of the products is
/// compared, with 5 of its own deviations: Fisher's is of normal variables alone.
static void lognormal_variables_have_the_correlation_of_their_closed_form(void **state)
{
    (void)state;
    const double s = 0.4, t = 0.8, r = correlation[3 * N + 1];
    const pdmc_distribution one = {
        .kind = PDMC_LOGNORMAL, .location = 1.0, .scale = s, .least = -INFINITY, .most = INFINITY};
    const pdmc_distribution other = {
        .kind = PDMC_LOGNORMAL, .location = -3.0, .scale = t, .least = -INFINITY, .most = INFINITY};
    const double mean[] = {exp(1.0 + 0.5 * s * s), exp(-3.0 + 0.5 * t * t)};
    const double scale = mean[0] * mean[1] * sqrt(expm1(s * s) * expm1(t * t));
    static double product[SAMPLES];
    draw_correlated();
    for (int k = 0; k < SAMPLES; k++)
        product[k] = (pdmc_distribution_value(&one, z[1][k]) - mean[0]) *
                     (pdmc_distribution_value(&other, z[3][k]) - mean[1]) / scale;
    const double deviation = gsl_stats_sd(product, 1, SAMPLES) / sqrt(SAMPLES);
    CHECK_NEAR(gsl_stats_mean(product, 1, SAMPLES), expm1(r * s * t) / sqrt(expm1(s * s) * expm1(t * t)),
               5.0 * deviation);
    assert_true(5.0 * deviation < 0.8 - 0.74); // told from the correlation of the normal ones
}

static void what_is_no_correlation_is_refused(void **state)
{
    (void)state;
    double factor[9];
    const double contradicting[] = {1.0, 0.9, -0.9, 0.9, 1.0, 0.9, -0.9, 0.9, 1.0};
    CHECK_STATUS(pdmc_copula_factor(3, contradicting, factor), PDMC_ERR_ARG);
    assert_non_null(strstr(pdmc_last_error(), "first 3 of 3"));
    CHECK_STATUS(pdmc_copula_factor(2, (double[]){1.0, 1.0, 1.0, 1.0}, factor), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_copula_factor(2, (double[]){1.0, 0.1, 0.2, 1.0}, factor), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_copula_factor(2, (double[]){1.0, 0.1, 0.1, 2.0}, factor), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_copula_factor(2, (double[]){1.0, NAN, NAN, 1.0}, factor), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_copula_factor(0, contradicting, factor), PDMC_ERR_ARG);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_factor_times_its_transpose_is_the_matrix),
        cmocka_unit_test(two_variables_by_hand),
        cmocka_unit_test(samples_have_the_correlation),
        cmocka_unit_test(lognormal_variables_have_the_correlation_of_their_closed_form),
        cmocka_unit_test(what_is_no_correlation_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
