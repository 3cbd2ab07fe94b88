// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/statistics.h"

#include "statistics/samples.h"

#include <float.h>
#include <gsl/gsl_multifit.h>

enum { N = 200, CONTROLS = 2 };

static const double load_variation = 0.1, stiffness_variation = 0.2;

/// G = L^2 / e with a load L, normal, and a stiffness e, lognormal, both of mean 1; the controls are L^2 and e.
static void draw_energy(uint64_t repetition, size_t n, double g[], double c[])
{
    pdmc_random_uniform(1981, PDMC_STREAM_LOAD, repetition, 0, 2 * n, c);
    for (size_t i = 0; i < n; i++) {
        const double load = pdmc_unit_mean_quantile(PDMC_NORMAL, load_variation, c[2 * i]);
        const double stiffness = pdmc_unit_mean_quantile(PDMC_LOGNORMAL, stiffness_variation, c[2 * i + 1]);
        c[2 * i] = load * load;
        c[2 * i + 1] = stiffness;
        g[i] = load * load / stiffness;
    }
}

/// Moments in closed form: E 1/e = w, E 1/e^2 = w^3 with w = 1 + variation^2.
typedef struct {
    double mean, r_square, control[CONTROLS];
} truth;

static truth energy_truth(void)
{
    const double v = load_variation * load_variation, w = 1.0 + stiffness_variation * stiffness_variation;
    const double square = 1.0 + v, fourth = 1.0 + 6.0 * v + 3.0 * v * v; // E L^2, E L^4
    const double variance = fourth * w * w * w - square * square * w * w;
    const double load_variance = fourth - square * square, covariance = w * load_variance;
    const double stiffness_variance = w - 1.0, stiffness_covariance = square * (1.0 - w);
    const double explained =
        covariance * covariance / load_variance + stiffness_covariance * stiffness_covariance / stiffness_variance;
    return (truth){.mean = square * w, .r_square = explained / variance, .control = {square, 1.0}};
}

/// The intercept of the regression on c - mu, by GSL.
static void regression_by_gsl(void **state)
{
    (void)state;
    double g[N], c[2 * N], covariance_data[9], squares;
    const truth t = energy_truth();
    draw_energy(0, N, g, c);
    gsl_matrix *design = gsl_matrix_alloc(N, 3);
    gsl_vector *coefficient = gsl_vector_alloc(3);
    gsl_multifit_linear_workspace *work = gsl_multifit_linear_alloc(N, 3);
    for (size_t i = 0; i < N; i++) {
        gsl_matrix_set(design, i, 0, 1.0);
        for (size_t j = 0; j < 2; j++) gsl_matrix_set(design, i, j + 1, c[2 * i + j] - t.control[j]);
    }
    const gsl_vector_const_view y = gsl_vector_const_view_array(g, N);
    gsl_matrix_view covariance = gsl_matrix_view_array(covariance_data, 3, 3);
    gsl_multifit_linear(design, &y.vector, coefficient, &covariance.matrix, &squares, work);
    const double want = gsl_vector_get(coefficient, 0), error = sqrt(covariance_data[0]);

    pdmc_controlled got;
    CHECK_OK(pdmc_statistics_control(N, g, CONTROLS, c, t.control, INFINITY, 0.95, &got));
    const double student = 1.9720790337760216; // 197 degrees of freedom, 0.975
    assert_int_equal(got.controls, 2);
    CHECK_NEAR(got.mean.value, want, 1e-13);
    CHECK_NEAR(got.mean.upper, want + student * error, 1e-13);
    CHECK_NEAR(got.mean.lower, want - student * error, 1e-13);
    gsl_multifit_linear_free(work);
    gsl_vector_free(coefficient);
    gsl_matrix_free(design);
}

static void without_controls_it_is_the_mean(void **state)
{
    (void)state;
    double g[N], c[2 * N];
    draw_energy(0, N, g, c);
    pdmc_estimate mean, deviation;
    pdmc_controlled got;
    pdmc_statistics_moments(N, g, 0.95, &mean, &deviation);
    CHECK_OK(pdmc_statistics_control(N, g, 0, NULL, NULL, INFINITY, 0.95, &got));
    CHECK_NEAR(got.mean.value, mean.value, 0.0);
    CHECK_NEAR(got.mean.upper, mean.upper, 16 * DBL_EPSILON);
    CHECK_NEAR(got.reduction, 1.0, N * DBL_EPSILON);
}

/// A constant, one that is not by rounding, a copy and a combination add nothing.
static void degenerate_controls_are_left_out(void **state)
{
    (void)state;
    enum { ALL = 6 };
    double g[N], c[2 * N], more[ALL * N];
    const truth t = energy_truth();
    draw_energy(0, N, g, c);
    for (size_t i = 0; i < N; i++) {
        const double extended[ALL] = {7.0,          c[2 * i],      0.1 + (double)(i % 2) * 0x1p-56,
                                      c[2 * i + 1], -c[2 * i + 1], 3.0 * c[2 * i] - 2.0 * c[2 * i + 1]};
        for (size_t j = 0; j < ALL; j++) more[ALL * i + j] = extended[j];
    }
    const double means[ALL] = {8.0,          t.control[0],  0.2,
                               t.control[1], -t.control[1], 3.0 * t.control[0] - 2.0 * t.control[1]};
    pdmc_controlled want, got;
    CHECK_OK(pdmc_statistics_control(N, g, CONTROLS, c, t.control, INFINITY, 0.95, &want));
    CHECK_OK(pdmc_statistics_control(N, g, ALL, more, means, INFINITY, 0.95, &got));
    assert_int_equal(got.controls, 2);
    CHECK_NEAR(got.mean.value, want.mean.value, 1e-13);
    CHECK_NEAR(got.mean.upper, want.mean.upper, 1e-13);
    CHECK_NEAR(got.reduction, want.reduction, 1e-11 * want.reduction);
}

/// What is linear in the controls has no error, in any unit.
static void a_linear_quantity_is_known(void **state)
{
    (void)state;
    double g[N], c[2 * N];
    const truth t = energy_truth();
    draw_energy(0, N, g, c);
    for (int e = -600; e <= 600; e += 600) {
        pdmc_controlled got;
        for (size_t i = 0; i < N; i++) g[i] = ldexp(1.0 + 2.0 * c[2 * i] - 3.0 * c[2 * i + 1], e);
        CHECK_OK(pdmc_statistics_control(N, g, CONTROLS, c, t.control, INFINITY, 0.95, &got));
        CHECK_NEAR(ldexp(got.mean.value, -e), 1.0 + 2.0 * t.control[0] - 3.0 * t.control[1], 1e-14);
        CHECK_NEAR(ldexp(got.mean.upper - got.mean.lower, -e), 0.0, 1e-14);
        assert_true(got.reduction > 1e20);
    }
    for (size_t i = 0; i < N; i++) g[i] = 0.1;
    pdmc_controlled got;
    CHECK_OK(pdmc_statistics_control(N, g, CONTROLS, c, t.control, INFINITY, 0.95, &got));
    CHECK_NEAR(got.mean.upper, 0.1, 0.0);
}

static void intervals_cover_and_shrink_as_they_should(void **state)
{
    (void)state;
    enum { REPETITIONS = 4000 };
    const truth t = energy_truth();
    double g[N], c[2 * N], squares = 0.0, plain_squares = 0.0, reduction = 0.0;
    int hits = 0;
    for (uint64_t r = 0; r < REPETITIONS; r++) {
        pdmc_controlled got;
        double plain = 0.0;
        draw_energy(r, N, g, c);
        CHECK_OK(pdmc_statistics_control(N, g, CONTROLS, c, t.control, INFINITY, 0.95, &got));
        for (size_t i = 0; i < N; i++) plain += g[i] / N;
        hits += got.mean.lower <= t.mean && t.mean <= got.mean.upper;
        squares += pow(got.mean.value - t.mean, 2);
        plain_squares += pow(plain - t.mean, 2);
        reduction += got.reduction / REPETITIONS;
    }
    assert_true(hits >= 0.93 * REPETITIONS && hits <= 0.97 * REPETITIONS);
    // of the variances of 4000 means each has an error of sqrt(2 / 4000), together 3.2 %; and two controls cost 2 / N
    CHECK_NEAR(plain_squares / squares * (1.0 - t.r_square), 1.0, 4 * 0.032);
    // the mean of a ratio of variances of N samples; 1 - R^2 is seen too small by the heaviest residuals that are
    // absent
    CHECK_NEAR(reduction * (1.0 - t.r_square), 1.0, 0.1);
}

/// Controls whose means are of five times the samples.
static void means_of_more_samples_add_their_error(void **state)
{
    (void)state;
    enum { REPETITIONS = 2000, MORE = 5 * N };
    const truth t = energy_truth();
    double g[MORE], c[CONTROLS * MORE], squares = 0.0, plain_squares = 0.0;
    int hits = 0;
    for (uint64_t r = 0; r < REPETITIONS; r++) {
        pdmc_controlled got, exact;
        double plain = 0.0, mean[CONTROLS] = {0.0};
        draw_energy(r, MORE, g, c);
        for (size_t i = 0; i < CONTROLS * MORE; i++) mean[i % CONTROLS] += c[i] / MORE;
        CHECK_OK(pdmc_statistics_control(N, g, CONTROLS, c, mean, MORE, 0.95, &got));
        CHECK_OK(pdmc_statistics_control(N, g, CONTROLS, c, t.control, INFINITY, 0.95, &exact));
        for (size_t i = 0; i < N; i++) plain += g[i] / N;
        hits += got.mean.lower <= t.mean && t.mean <= got.mean.upper;
        squares += pow(got.mean.value - t.mean, 2);
        plain_squares += pow(plain - t.mean, 2);
        CHECK_NEAR(got.correlation, exact.correlation, 0.0);
    }
    CHECK_NEAR((double)hits / REPETITIONS, 0.95, repetition_error(0.95, REPETITIONS));
    // each variance has an error of sqrt(2 / 2000), together 4.5 %
    CHECK_NEAR(squares / plain_squares / (1.0 - t.r_square + t.r_square / 5.0), 1.0, 4 * 0.045);
}

static void failures_are_reported(void **state)
{
    (void)state;
    double g[N], c[2 * N];
    const truth t = energy_truth();
    pdmc_controlled got;
    draw_energy(0, N, g, c);
    CHECK_STATUS(pdmc_statistics_control(3, g, CONTROLS, c, t.control, INFINITY, 0.95, &got), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_statistics_control(N, g, CONTROLS, c, t.control, N - 1.0, 0.95, &got), PDMC_ERR_ARG);
    CHECK_OK(pdmc_statistics_control(4, g, CONTROLS, c, t.control, INFINITY, 0.95, &got));
    CHECK_FAILS_CLEANLY(pdmc_statistics_control(N, g, CONTROLS, c, t.control, INFINITY, 0.95, &got), (void)0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(regression_by_gsl),
        cmocka_unit_test(without_controls_it_is_the_mean),
        cmocka_unit_test(degenerate_controls_are_left_out),
        cmocka_unit_test(a_linear_quantity_is_known),
        cmocka_unit_test(intervals_cover_and_shrink_as_they_should),
        cmocka_unit_test(means_of_more_samples_add_their_error),
        cmocka_unit_test(failures_are_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
