// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/field.h"

#include "check.h"
#include "pdmc/random.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

static const double WIDTH = 4.0, HEIGHT = 3.0;
enum { POINTS = 40 };

/// Evenly spread points of the rectangle.
static void spread(int points, double x[])
{
    for (int i = 0; i < points; i++) {
        pdmc_random_uniform(7, PDMC_STREAM_PROBES, (uint64_t)i, 0, 2, &x[2 * i]);
        x[2 * i] = WIDTH * (x[2 * i] - 0.5);
        x[2 * i + 1] = HEIGHT * (x[2 * i + 1] - 0.5);
    }
}

static void draw_normals(int count, int modes, double z[])
{
    for (int s = 0; s < count; s++) {
        pdmc_random_uniform(11, PDMC_STREAM_FIELD, (uint64_t)s, 0, (size_t)modes, &z[s * modes]);
        for (int k = 0; k < modes; k++) z[s * modes + k] = pdmc_normal_quantile(z[s * modes + k]);
    }
}

static pdmc_field_request request_of(pdmc_covariance_kind kind, double length, pdmc_distribution_kind distribution,
                                     double variation, int modes)
{
    return (pdmc_field_request){{kind, length, 1.3}, distribution, variation, modes};
}

static pdmc_field *create(pdmc_field_request request, int functionals, const pdmc_field_functional functional[])
{
    pdmc_field *field = NULL;
    CHECK_OK(pdmc_field_create(&request, WIDTH, HEIGHT, functionals, functional, 1, &field));
    return field;
}

static double correlation(const pdmc_field_request *request, const double x[], int i, int j)
{
    return pdmc_covariance_at(&request->covariance, hypot(x[2 * i] - x[2 * j], x[2 * i + 1] - x[2 * j + 1]));
}

static double product(int terms, const double psi[], int i, int j)
{
    double sum = 0.0;
    for (int k = 0; k < terms; k++) sum += psi[i * terms + k] * psi[j * terms + k];
    return sum;
}

/// A covariance that is smooth over the rectangle is given by few modes, in full.
static void smooth_covariance_is_complete(void **state)
{
    (void)state;
    const pdmc_field_request request = request_of(PDMC_COVARIANCE_GAUSSIAN, 3.0, PDMC_NORMAL, 0.2, 60);
    double x[2 * POINTS], psi[POINTS * 60];
    pdmc_field *field = create(request, 0, NULL);
    spread(POINTS, x);
    CHECK_OK(pdmc_field_terms_at(field, POINTS, x, psi));
    CHECK_NEAR(pdmc_field_retained(field), 1.0, 1e-9);
    for (int i = 0; i < POINTS; i++)
        for (int j = 0; j < POINTS; j++)
            CHECK_NEAR(product(60, psi, i, j), 0.04 * correlation(&request, x, i, j), 1e-7 * 0.04);
    pdmc_field_destroy(&field);
}

/// What the modes leave out is a covariance too: |C - sum psi psi'| <= sqrt((1 - var) (1 - var')), by Cauchy and Schwarz;
/// and the variances average to what is said to be retained.
static void truncated_covariance_is_bounded(void **state)
{
    (void)state;
    enum { MODES = 120, MANY = 4000 };
    double x[2 * POINTS], psi[POINTS * MODES], *many = malloc(sizeof *many * 2 * MANY);
    double *value = malloc(sizeof *value * MANY * MODES);
    spread(POINTS, x);
    spread(MANY, many);
    for (int kind = 0; kind <= PDMC_COVARIANCE_MATERN; kind++) {
        const pdmc_field_request request = request_of((pdmc_covariance_kind)kind, 0.5, PDMC_NORMAL, 1.0, MODES);
        pdmc_field *field = create(request, 0, NULL);
        CHECK_OK(pdmc_field_terms_at(field, POINTS, x, psi));
        for (int i = 0; i < POINTS; i++)
            for (int j = 0; j < POINTS; j++) {
                const double left_i = 1.0 - product(MODES, psi, i, i), left_j = 1.0 - product(MODES, psi, j, j);
                assert_true(left_i > 0.0 && left_i < 0.5);
                CHECK_NEAR(product(MODES, psi, i, j), correlation(&request, x, i, j), sqrt(left_i * left_j));
            }
        CHECK_OK(pdmc_field_terms_at(field, MANY, many, value));
        double mean = 0.0, square = 0.0;
        for (int i = 0; i < MANY; i++) {
            const double variance = product(MODES, value, i, i);
            mean += variance / MANY;
            square += variance * variance / MANY;
        }
        CHECK_NEAR(mean, pdmc_field_retained(field), 4.0 * sqrt((square - mean * mean) / MANY));
        pdmc_field_destroy(&field);
    }
    free(value);
    free(many);
}

/// s_a' C s_b from the definition.
static double covariance_of(const pdmc_field_request *request, int points, const double x[], const double a[],
                            const double b[])
{
    double sum = 0.0;
    for (int i = 0; i < points; i++)
        for (int j = 0; j < points; j++) sum += a[i] * correlation(request, x, i, j) * b[j];
    return sum;
}

static double effect(int points, int terms, const double weight[], const double psi[], int k)
{
    double sum = 0.0;
    for (int i = 0; i < points; i++) sum += weight[i] * psi[i * terms + k];
    return sum;
}

/// The first mode carries the first functional alone, the first two the second; a third that depends on them takes none.
static void functionals_keep_their_variance(void **state)
{
    (void)state;
    enum { MODES = 12 };
    double x[2 * POINTS], first[POINTS], second[POINTS], third[POINTS], psi[POINTS * MODES];
    spread(POINTS, x);
    for (int i = 0; i < POINTS; i++) {
        first[i] = 1.0 / (0.2 + fabs(x[2 * i]));
        second[i] = x[2 * i + 1] - 0.3 * first[i];
        third[i] = first[i] - 2.0 * second[i];
    }
    const pdmc_field_functional functional[] = {{POINTS, x, first}, {POINTS, x, second}, {POINTS, x, third}};
    for (int kind = 0; kind <= PDMC_COVARIANCE_MATERN; kind++) {
        const pdmc_field_request request = request_of((pdmc_covariance_kind)kind, 0.4, PDMC_NORMAL, 0.2, MODES);
        const double scale = sqrt(covariance_of(&request, POINTS, x, first, first));
        pdmc_field *field = create(request, 3, functional);
        CHECK_OK(pdmc_field_terms_at(field, POINTS, x, psi));
        CHECK_NEAR(effect(POINTS, MODES, first, psi, 0), 0.2 * scale, 1e-12 * scale);
        for (int k = 1; k < MODES; k++) CHECK_NEAR(effect(POINTS, MODES, first, psi, k), 0.0, 1e-11 * scale);
        for (int k = 2; k < MODES; k++) CHECK_NEAR(effect(POINTS, MODES, second, psi, k), 0.0, 1e-11 * scale);
        double variance = 0.0, third_mode = 0.0;
        for (int k = 0; k < MODES; k++) variance += pow(effect(POINTS, MODES, second, psi, k), 2.0);
        for (int i = 0; i < POINTS; i++) third_mode = fmax(third_mode, fabs(psi[i * MODES + 2]));
        CHECK_NEAR(variance, 0.04 * covariance_of(&request, POINTS, x, second, second), 1e-11 * scale * scale);
        assert_true(third_mode > 0.01);
        pdmc_field_destroy(&field);
    }
}

/// With functionals too a smooth covariance is given in full, so that the modes after them are those of what remains.
static void functionals_leave_the_covariance_as_it_is(void **state)
{
    (void)state;
    enum { MODES = 60 };
    const pdmc_field_request request = request_of(PDMC_COVARIANCE_GAUSSIAN, 3.0, PDMC_NORMAL, 1.0, MODES);
    double x[2 * POINTS], weight[POINTS], psi[POINTS * MODES];
    spread(POINTS, x);
    for (int i = 0; i < POINTS; i++) weight[i] = cos(2.0 * x[2 * i]);
    const pdmc_field_functional functional[] = {{POINTS, x, weight}, {1, (double[]){0.3, -0.2}, (double[]){2.0}}};
    pdmc_field *field = create(request, 2, functional);
    CHECK_OK(pdmc_field_terms_at(field, POINTS, x, psi));
    for (int i = 0; i < POINTS; i++)
        for (int j = 0; j < POINTS; j++) CHECK_NEAR(product(MODES, psi, i, j), correlation(&request, x, i, j), 1e-7);
    pdmc_field_destroy(&field);
}

/// The modes after a functional's direction are the best ones of what remains: between the variances that as many and one
/// fewer of the field's own modes hold.
static void modes_after_a_functional_are_the_leading_ones(void **state)
{
    (void)state;
    enum { MODES = 20 };
    const pdmc_field_functional functional = {1, (double[]){0.3, -0.2}, (double[]){1.0}};
    for (int kind = 0; kind <= PDMC_COVARIANCE_MATERN; kind++) {
        pdmc_field *with = create(request_of((pdmc_covariance_kind)kind, 0.7, PDMC_NORMAL, 0.2, MODES), 1, &functional);
        pdmc_field *without = create(request_of((pdmc_covariance_kind)kind, 0.7, PDMC_NORMAL, 0.2, MODES), 0, NULL);
        pdmc_field *fewer = create(request_of((pdmc_covariance_kind)kind, 0.7, PDMC_NORMAL, 0.2, MODES - 1), 0, NULL);
        assert_true(pdmc_field_retained(with) < pdmc_field_retained(without));
        assert_true(pdmc_field_retained(with) > pdmc_field_retained(fewer));
        pdmc_field_destroy(&with);
        pdmc_field_destroy(&without);
        pdmc_field_destroy(&fewer);
    }
}

/// The expansion of a lognormal field against the exponential of the normal field of the same modes, sample by sample: the
/// root mean square of the difference is the error that the field states.
static void lognormal_is_the_exponential(void **state)
{
    (void)state;
    enum { MODES = 30, SAMPLES = 300 };
    static const double variation[] = {0.05, 0.2, 0.5};
    double x[2 * POINTS], normal_psi[POINTS * MODES], z[SAMPLES * MODES];
    spread(POINTS, x);
    draw_normals(SAMPLES, MODES, z);
    for (int kind = 0; kind <= PDMC_COVARIANCE_MATERN; kind++)
        for (int v = 0; v < 3; v++) {
            const double s2 = log1p(variation[v] * variation[v]);
            pdmc_field *normal =
                create(request_of((pdmc_covariance_kind)kind, 0.8, PDMC_NORMAL, sqrt(s2), MODES), 0, NULL);
            pdmc_field *field =
                create(request_of((pdmc_covariance_kind)kind, 0.8, PDMC_LOGNORMAL, variation[v], MODES), 0, NULL);
            const int terms = pdmc_field_terms(field);
            double *psi = malloc(sizeof *psi * (size_t)(POINTS * terms)), square = 0.0;
            double *xi = malloc(sizeof *xi * (size_t)(SAMPLES * terms));
            CHECK_OK(pdmc_field_terms_at(normal, POINTS, x, normal_psi));
            CHECK_OK(pdmc_field_terms_at(field, POINTS, x, psi));
            CHECK_OK(pdmc_field_coefficients(field, SAMPLES, z, xi));
            for (int s = 0; s < SAMPLES; s++)
                for (int i = 0; i < POINTS; i++) {
                    double exponent = -0.5 * product(MODES, normal_psi, i, i), m = 1.0;
                    for (int k = 0; k < MODES; k++) exponent += z[s * MODES + k] * normal_psi[i * MODES + k];
                    for (int k = 0; k < terms; k++) m += xi[s * terms + k] * psi[i * terms + k];
                    assert_true(m > 0.0);
                    square += pow(m - exp(exponent), 2.0) / (SAMPLES * POINTS);
                }
            const double error = pdmc_field_expansion_error(field);
            assert_true(error > 0.0 && error < 2e-3 * variation[v]);
            CHECK_NEAR(sqrt(square), error, 0.3 * error); // two samples of the same error
            free(xi);
            free(psi);
            pdmc_field_destroy(&field);
            pdmc_field_destroy(&normal);
        }
}

/// Mean, covariance and sign of many samples at a few points: mean 1, and with all the variance retained the coefficient
/// of variation that was asked for; the coefficients have mean 0, variance 1, and no correlation.
static void lognormal_moments(void **state)
{
    (void)state;
    enum { MODES = 40, SAMPLES = 40000, AT = 5 };
    const double variation = 0.3, s2 = log1p(0.09);
    const pdmc_field_request request = request_of(PDMC_COVARIANCE_GAUSSIAN, 3.0, PDMC_LOGNORMAL, variation, MODES);
    pdmc_field *field = create(request, 0, NULL);
    const int terms = pdmc_field_terms(field);
    double x[2 * AT], *z = malloc(sizeof *z * SAMPLES * MODES), mean[AT] = {0}, second[AT][AT] = {{0}};
    double *xi = malloc(sizeof *xi * (size_t)(SAMPLES * terms)), *psi = malloc(sizeof *psi * (size_t)(AT * terms));
    double first = 0.0, square = 0.0, mixed = 0.0, fourth = 0.0;
    spread(AT, x);
    draw_normals(SAMPLES, MODES, z);
    CHECK_OK(pdmc_field_terms_at(field, AT, x, psi));
    CHECK_OK(pdmc_field_coefficients(field, SAMPLES, z, xi));
    for (int s = 0; s < SAMPLES; s++) {
        double m[AT];
        const double *own = &xi[s * terms];
        for (int i = 0; i < AT; i++) {
            m[i] = 1.0;
            for (int k = 0; k < terms; k++) m[i] += own[k] * psi[i * terms + k];
            assert_true(m[i] > 0.0);
            mean[i] += m[i] / SAMPLES;
        }
        for (int i = 0; i < AT; i++)
            for (int j = 0; j < AT; j++) second[i][j] += (m[i] - 1.0) * (m[j] - 1.0) / SAMPLES;
        first += own[0] / SAMPLES;
        square += own[0] * own[0] / SAMPLES;
        fourth += pow(own[0], 4.0) / SAMPLES;
        mixed += own[0] * own[1] / SAMPLES;
    }
    const double error = pdmc_field_expansion_error(field);
    for (int i = 0; i < AT; i++) {
        CHECK_NEAR(mean[i], 1.0, 4.0 * variation / sqrt(SAMPLES) + error);
        for (int j = 0; j < AT; j++) {
            const double want = expm1(s2 * correlation(&request, x, i, j));
            // the fourth moment of this lognormal variable is less than 6 v^4
            CHECK_NEAR(second[i][j], want, 4.0 * sqrt(6.0 / SAMPLES) * variation * variation + error * error);
        }
    }
    CHECK_NEAR(first, 0.0, 4.0 / sqrt(SAMPLES));
    CHECK_NEAR(square, 1.0, 4.0 * sqrt(fourth / SAMPLES));
    CHECK_NEAR(mixed, 0.0, 4.0 * sqrt(fourth / SAMPLES));
    free(psi);
    free(xi);
    free(z);
    pdmc_field_destroy(&field);
}

/// The same bits for any number of threads and in any call.
static void fixed_bits(void **state)
{
    (void)state;
    enum { MODES = 20, SAMPLES = 150 };
    double x[2 * POINTS], weight[POINTS], z[SAMPLES * MODES];
    spread(POINTS, x);
    draw_normals(SAMPLES, MODES, z);
    for (int i = 0; i < POINTS; i++) weight[i] = 1.0 + i % 3;
    const pdmc_field_functional functional = {POINTS, x, weight};
    for (int lognormal = 0; lognormal <= 1; lognormal++) {
        const pdmc_field_request request =
            request_of(PDMC_COVARIANCE_MATERN, 0.8, lognormal ? PDMC_LOGNORMAL : PDMC_NORMAL, 0.2, MODES);
        pdmc_field *field = create(request, 1, &functional);
        const int terms = pdmc_field_terms(field);
        const size_t at_points = sizeof(double) * (size_t)(POINTS * terms);
        const size_t of_samples = sizeof(double) * (size_t)(SAMPLES * terms);
        double *psi = malloc(at_points), *xi = malloc(of_samples), *again = malloc(at_points + of_samples);
        CHECK_OK(pdmc_field_terms_at(field, POINTS, x, psi));
        CHECK_OK(pdmc_field_coefficients(field, SAMPLES, z, xi));
        for (int i = 0; i < POINTS; i++) CHECK_OK(pdmc_field_terms_at(field, 1, &x[2 * i], &again[i * terms]));
        assert_memory_equal(psi, again, at_points);
        for (int s = 0, count = 1; s < SAMPLES; s += count, count = 1 + s % 7) {
            if (count > SAMPLES - s) count = SAMPLES - s;
            CHECK_OK(pdmc_field_coefficients(field, count, &z[s * MODES], &again[s * terms]));
        }
        assert_memory_equal(xi, again, of_samples);
        for (int threads = 2; threads <= 3; threads++) {
            pdmc_field *other = NULL;
            CHECK_OK(pdmc_field_create(&request, WIDTH, HEIGHT, 1, &functional, threads, &other));
            assert_int_equal(pdmc_field_terms(other), terms);
            CHECK_OK(pdmc_field_terms_at(other, POINTS, x, again));
            assert_memory_equal(psi, again, at_points);
            CHECK_OK(pdmc_field_coefficients(other, SAMPLES, z, again));
            assert_memory_equal(xi, again, of_samples);
            pdmc_field_destroy(&other);
        }
        free(again);
        free(xi);
        free(psi);
        pdmc_field_destroy(&field);
    }
}

static void check_refused(pdmc_field_request request, double width, int functionals,
                          const pdmc_field_functional functional[], int threads)
{
    pdmc_field *field = NULL;
    CHECK_STATUS(pdmc_field_create(&request, width, HEIGHT, functionals, functional, threads, &field), PDMC_ERR_ARG);
    assert_null(field);
}

static void refusals(void **state)
{
    (void)state;
    const pdmc_field_request good = request_of(PDMC_COVARIANCE_EXPONENTIAL, 0.8, PDMC_NORMAL, 0.2, 3);
    const pdmc_field_functional outside = {1, (double[]){0.0, 2.0}, (double[]){1.0}};
    const pdmc_field_functional empty = {0, NULL, NULL};
    const pdmc_field_functional infinite = {1, (double[]){0.0, 0.0}, (double[]){INFINITY}};
    check_refused(request_of(PDMC_COVARIANCE_EXPONENTIAL, -1.0, PDMC_NORMAL, 0.2, 3), WIDTH, 0, NULL, 1);
    check_refused(request_of((pdmc_covariance_kind)3, 1.0, PDMC_NORMAL, 0.2, 3), WIDTH, 0, NULL, 1);
    check_refused(request_of(PDMC_COVARIANCE_EXPONENTIAL, 1.0, PDMC_WEIBULL, 0.2, 3), WIDTH, 0, NULL, 1);
    check_refused(request_of(PDMC_COVARIANCE_EXPONENTIAL, 1.0, PDMC_NORMAL, -0.2, 3), WIDTH, 0, NULL, 1);
    check_refused(request_of(PDMC_COVARIANCE_EXPONENTIAL, 1.0, PDMC_LOGNORMAL, 0.0, 3), WIDTH, 0, NULL, 1);
    check_refused(request_of(PDMC_COVARIANCE_EXPONENTIAL, 1.0, PDMC_NORMAL, 0.2, 0), WIDTH, 0, NULL, 1);
    check_refused(request_of(PDMC_COVARIANCE_EXPONENTIAL, 1.0, PDMC_NORMAL, 0.2, 1000000), WIDTH, 0, NULL, 1);
    check_refused(good, 0.0, 0, NULL, 1);
    check_refused(good, NAN, 0, NULL, 1);
    check_refused(good, WIDTH, 0, NULL, 0);
    check_refused(good, WIDTH, -1, NULL, 1);
    check_refused(good, WIDTH, 1, &outside, 1);
    check_refused(good, WIDTH, 1, &empty, 1);
    check_refused(good, WIDTH, 1, &infinite, 1);
    check_refused(good, WIDTH, 4, (pdmc_field_functional[]){infinite, infinite, infinite, infinite}, 1);

    pdmc_field *field = create(good, 0, NULL);
    double value[3];
    CHECK_STATUS(pdmc_field_terms_at(field, 1, (double[]){2.1, 0.0}, value), PDMC_ERR_ARG);
    CHECK_OK(pdmc_field_terms_at(field, 1, (double[]){2.0, -1.5}, value));
    CHECK_FAILS_CLEANLY(pdmc_field_terms_at(field, 1, (double[]){0.0, 0.0}, value), (void)0);
    pdmc_field_destroy(&field);
    pdmc_field_destroy(&field);
}

static void no_memory(void **state)
{
    (void)state;
    const pdmc_field_functional functional = {1, (double[]){0.0, 0.4}, (double[]){1.0}};
    pdmc_field_request request = request_of(PDMC_COVARIANCE_GAUSSIAN, 2.0, PDMC_NORMAL, 0.2, 3);
    pdmc_field *field = NULL;
    CHECK_FAILS_CLEANLY(pdmc_field_create(&request, WIDTH, HEIGHT, 1, &functional, 1, &field),
                        pdmc_field_destroy(&field));
    request.distribution = PDMC_LOGNORMAL;
    CHECK_FAILS_CLEANLY(pdmc_field_create(&request, WIDTH, HEIGHT, 0, NULL, 1, &field), (void)0);
    double z[3] = {0.1, 0.2, 0.3}, xi[100];
    assert_true(pdmc_field_terms(field) <= 100);
    CHECK_FAILS_CLEANLY(pdmc_field_coefficients(field, 1, z, xi), pdmc_field_destroy(&field));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(smooth_covariance_is_complete),
        cmocka_unit_test(truncated_covariance_is_bounded),
        cmocka_unit_test(functionals_keep_their_variance),
        cmocka_unit_test(functionals_leave_the_covariance_as_it_is),
        cmocka_unit_test(modes_after_a_functional_are_the_leading_ones),
        cmocka_unit_test(lognormal_is_the_exponential),
        cmocka_unit_test(lognormal_moments),
        cmocka_unit_test(fixed_bits),
        cmocka_unit_test(refusals),
        cmocka_unit_test(no_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
