// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/statistics.h"

#include "statistics/samples.h"

#include <float.h>
#include <gsl/gsl_randist.h>
#include <stdlib.h>

enum { POINTS = 401 };

static double *sorted_sample(sample_kind kind, uint64_t repetition, size_t n)
{
    double *x = pdmc_calloc(n, sizeof *x);
    assert_non_null(x);
    draw_sample(kind, repetition, n, x);
    sort_sample(n, x);
    return x;
}

static void equal_points(double low, double high, double at[POINTS])
{
    for (int k = 0; k < POINTS; k++) at[k] = low + (high - low) * k / (POINTS - 1);
}

static double step_of(const double at[POINTS])
{
    return (at[POINTS - 1] - at[0]) / (POINTS - 1);
}

/// The sum as it is defined, with and without its image at -x. Groups lessen the kernel's variance by no more than
/// 1 / 3072: by |f''| h^2 / 6144, and |K''| <= K(0) / h^2.
static void density_by_its_definition(void **state)
{
    (void)state;
    enum { N = 3000 };
    double *x = sorted_sample(SAMPLE_EXPONENTIAL, 0, N), at[POINTS];
    const double h = pdmc_statistics_bandwidth(N, x), closeness = gsl_ran_ugaussian_pdf(0.0) / h / 6144.0;
    pdmc_estimate density[POINTS];
    equal_points(-1.0, 9.0, at);
    for (int positive = 0; positive <= 1; positive++) {
        CHECK_OK(pdmc_statistics_kernel_density(N, x, h, positive, 0.95, POINTS, at, density));
        for (int k = 0; k < POINTS; k++) {
            double want = 0.0;
            for (size_t i = 0; i < N; i++) {
                want += gsl_ran_gaussian_pdf(at[k] - x[i], h) / N;
                if (positive) want += gsl_ran_gaussian_pdf(at[k] + x[i], h) / N;
            }
            CHECK_NEAR(density[k].value, positive && at[k] < 0.0 ? 0.0 : want, closeness);
            assert_true(density[k].lower <= density[k].value && density[k].value <= density[k].upper);
        }
    }
    pdmc_free(x);
}

/// By the trapezoidal rule, exact to rounding for Gaussians that are wider than its step; reflected, the integrand is
/// even, so that the rule is as good from 0 on.
static void densities_integrate_to_one(void **state)
{
    (void)state;
    static const sample_kind kinds[] = {SAMPLE_NORMAL, SAMPLE_EXPONENTIAL, SAMPLE_LOGNORMAL};
    enum { N = 500 };
    for (int kind = 0; kind < 3; kind++) {
        double *x = sorted_sample(kinds[kind], 1, N), at[POINTS];
        const bool positive = kind > 0;
        const double h = pdmc_statistics_bandwidth(N, x);
        pdmc_estimate density[POINTS];
        equal_points(positive ? 0.0 : x[0] - 9.0 * h, x[N - 1] + 9.0 * h, at);
        assert_true(step_of(at) < h);
        CHECK_OK(pdmc_statistics_kernel_density(N, x, h, positive, 0.95, POINTS, at, density));
        double area = -0.5 * step_of(at) * density[0].value;
        for (int k = 0; k < POINTS; k++) area += step_of(at) * density[k].value;
        CHECK_NEAR(area, 1.0, 1e-8); // exp(-2 (pi h / step)^2) at h = step
        pdmc_free(x);
    }
}

static void silvermans_bandwidth(void **state)
{
    (void)state;
    static const double even[] = {1, 2, 3, 4, 5, 6, 7, 8, 9}; // s = sqrt(7.5) = 2.74, IQR / 1.34 = 4 / 1.34 = 2.99
    CHECK_NEAR(pdmc_statistics_bandwidth(9, even), 0.9 * sqrt(7.5) * pow(9.0, -0.2), 1e-14);
    static const double tailed[] = {1, 2, 3, 4, 5, 6, 7, 8, 900};
    CHECK_NEAR(pdmc_statistics_bandwidth(9, tailed), 0.9 * 4.0 / 1.34 * pow(9.0, -0.2), 1e-14);
    static const double tied[] = {1, 1, 1, 1, 1, 1, 1, 1, 10}; // s = 3, and no IQR
    CHECK_NEAR(pdmc_statistics_bandwidth(9, tied), 0.9 * 3.0 * pow(9.0, -0.2), 1e-14);
    CHECK_NEAR(pdmc_statistics_bandwidth(8, tied), 1e-3, 0.0);
    CHECK_NEAR(pdmc_statistics_bandwidth(1, &even[4]), 5e-3, 1e-18);
}

static double density_of(sample_kind kind, double x)
{
    return kind == SAMPLE_NORMAL ? gsl_ran_ugaussian_pdf(x) : gsl_ran_lognormal_pdf(x, 0.0, lognormal_sigma);
}

/// The integral of (f^ - f)^2 from `low` to `high`, averaged over some samples.
static double squared_error(sample_kind kind, size_t n, double bandwidth, double low, double high, int repetitions)
{
    double at[POINTS], error = 0.0;
    pdmc_estimate density[POINTS];
    equal_points(low, high, at);
    for (int r = 0; r < repetitions; r++) {
        double *x = sorted_sample(kind, (uint64_t)r, n);
        const double h = bandwidth > 0.0 ? bandwidth : pdmc_statistics_bandwidth(n, x);
        CHECK_OK(pdmc_statistics_kernel_density(n, x, h, kind == SAMPLE_LOGNORMAL, 0.95, POINTS, at, density));
        for (int k = 0; k < POINTS; k++)
            error += step_of(at) * pow(density[k].value - density_of(kind, at[k]), 2) / repetitions;
        pdmc_free(x);
    }
    return error;
}

/// Of a normal sample and a given bandwidth the mean error is known (Marron & Wand 1992):
/// 2 sqrt(pi) MISE = 1 / (n h) + (1 - 1/n) / sqrt(1 + h^2) - 2 sqrt(2) / sqrt(2 + h^2) + 1.
static void the_error_of_a_normal_density_is_marrons(void **state)
{
    (void)state;
    enum { N = 1000, REPETITIONS = 300 };
    static const double bandwidths[] = {0.1, 0.25, 0.6};
    for (int k = 0; k < 3; k++) {
        const double h = bandwidths[k], pi = acos(-1.0);
        const double variance = 1.0 / (N * h) + (1.0 - 1.0 / N) / sqrt(1.0 + h * h);
        const double want = (variance - 2.0 * sqrt(2.0) / sqrt(2.0 + h * h) + 1.0) / (2.0 * sqrt(pi));
        // one sample's error scatters by no more than its mean: 4 / sqrt(300)
        CHECK_NEAR(squared_error(SAMPLE_NORMAL, N, h, -8.0, 8.0, REPETITIONS) / want, 1.0, 0.23);
    }
}

/// The error falls as n^(-4/5) with Silverman's bandwidth. From 500 to 50 000 samples the exponent of means of 40
/// errors, each of which scatters by half of itself or less, has an error of 0.5 sqrt(2 / 40) / log(100) = 0.024.
static void errors_fall_as_they_should(void **state)
{
    (void)state;
    const struct {
        sample_kind kind;
        double low, high;
    } cases[] = {{SAMPLE_NORMAL, -6.0, 6.0}, {SAMPLE_LOGNORMAL, 0.0, 4.0}};
    for (int k = 0; k < 2; k++) {
        const double few = squared_error(cases[k].kind, 500, 0.0, cases[k].low, cases[k].high, 40);
        const double many = squared_error(cases[k].kind, 50000, 0.0, cases[k].low, cases[k].high, 40);
        CHECK_NEAR(log(few / many) / log(100.0), 0.8, 4 * 0.024);
    }
}

/// The smoothed density of a normal sample is that of a normal with deviation sqrt(1 + h^2).
static void intervals_cover_the_smoothed_density(void **state)
{
    (void)state;
    enum { N = 2000, REPETITIONS = 1000 };
    static const double at[] = {0.0, 1.0, 2.5};
    const double h = 0.9 * pow(N, -0.2);
    int hits[3] = {0};
    pdmc_estimate density[3];
    for (uint64_t r = 0; r < REPETITIONS; r++) {
        double *x = sorted_sample(SAMPLE_NORMAL, r, N);
        CHECK_OK(pdmc_statistics_kernel_density(N, x, h, false, 0.95, 3, at, density));
        for (int k = 0; k < 3; k++) {
            const double mean = gsl_ran_gaussian_pdf(at[k], sqrt(1.0 + h * h));
            hits[k] += density[k].lower <= mean && mean <= density[k].upper;
        }
        pdmc_free(x);
    }
    for (int k = 0; k < 3; k++) {
        // the density varies within the kernel: by the second order in h, 5 % of the variance
        CHECK_NEAR((double)hits[k] / REPETITIONS, 0.95, repetition_error(0.95, REPETITIONS) + 0.006);
    }
}

/// At the boundary the image doubles the variance. The smoothed density of |Z| is known: reflected, it is that of Z.
static void intervals_cover_at_the_boundary(void **state)
{
    (void)state;
    enum { N = 2000, REPETITIONS = 1000 };
    const double h = 0.05, at = 0.0, mean = 2.0 * gsl_ran_gaussian_pdf(0.0, sqrt(1.0 + h * h));
    int hits = 0;
    for (uint64_t r = 0; r < REPETITIONS; r++) {
        double *x = sorted_sample(SAMPLE_NORMAL, r, N);
        for (int i = 0; i < N; i++) x[i] = fabs(x[i]);
        sort_sample(N, x);
        pdmc_estimate density;
        CHECK_OK(pdmc_statistics_kernel_density(N, x, h, true, 0.95, 1, &at, &density));
        hits += density.lower <= mean && mean <= density.upper;
        pdmc_free(x);
    }
    CHECK_NEAR((double)hits / REPETITIONS, 0.95, repetition_error(0.95, REPETITIONS));
}

static void many_samples_take_milliseconds(void **state)
{
    (void)state;
    enum { N = 1000000 };
    double *x = sorted_sample(SAMPLE_LOGNORMAL, 0, N), at[POINTS];
    pdmc_estimate density[POINTS];
    equal_points(0.0, 4.0, at);
    const double h = pdmc_statistics_bandwidth(N, x), start = pdmc_seconds();
    CHECK_OK(pdmc_statistics_kernel_density(N, x, h, true, 0.95, POINTS, at, density));
    assert_true(pdmc_seconds() - start < 1.0); // 14 ms alone; each sample at each point would take seconds
    pdmc_free(x);
}

static void failures_are_reported(void **state)
{
    (void)state;
    static const double x[] = {-1.0, 2.0}, at[] = {0.5};
    pdmc_estimate density[1];
    CHECK_STATUS(pdmc_statistics_kernel_density(0, x, 1.0, false, 0.95, 1, at, density), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_statistics_kernel_density(2, x, 0.0, false, 0.95, 1, at, density), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_statistics_kernel_density(2, x, INFINITY, false, 0.95, 1, at, density), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_statistics_kernel_density(2, x, 1.0, true, 0.95, 1, at, density), PDMC_ERR_ARG);
    CHECK_FAILS_CLEANLY(pdmc_statistics_kernel_density(2, x, 1.0, false, 0.95, 1, at, density), (void)0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(density_by_its_definition),
        cmocka_unit_test(densities_integrate_to_one),
        cmocka_unit_test(silvermans_bandwidth),
        cmocka_unit_test(the_error_of_a_normal_density_is_marrons),
        cmocka_unit_test(errors_fall_as_they_should),
        cmocka_unit_test(intervals_cover_the_smoothed_density),
        cmocka_unit_test(intervals_cover_at_the_boundary),
        cmocka_unit_test(many_samples_take_milliseconds),
        cmocka_unit_test(failures_are_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
