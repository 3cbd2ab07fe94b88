// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/karhunen_loeve.h"

#include "check.h"

#include <float.h>
#include <gsl/gsl_math.h>
#include <lapacke.h>
#include <stdlib.h>

static const double WIDTH = 5.0, HEIGHT = 3.0;

static int descending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return x < y ? 1 : x > y ? -1 : 0;
}

/// Eigenvalues of exp(-(x - x')^2 / l^2) on an interval, by Nystrom's method with a Gauss rule, which for this kernel is
/// exact to rounding.
enum { NODES = 64 };
static void gaussian_eigenvalues(double length, double interval, double value[NODES])
{
    double x[NODES], w[NODES], *matrix = malloc(sizeof *matrix * NODES * NODES);
    CHECK_OK(pdmc_gauss_legendre(NODES, 0.0, interval, x, w));
    for (int i = 0; i < NODES; i++)
        for (int j = 0; j < NODES; j++)
            matrix[i * NODES + j] = sqrt(w[i] * w[j]) * exp(-gsl_pow_2((x[i] - x[j]) / length));
    assert_int_equal(LAPACKE_dsyevd(LAPACK_COL_MAJOR, 'N', 'L', NODES, matrix, NODES, value), 0);
    free(matrix);
}

/// In two dimensions the Gaussian covariance is a product, and so are its eigenvalues.
static void gaussian_eigenvalues_are_products(void **state)
{
    (void)state;
    enum { MODES = 60 };
    static const double lengths[] = {0.3, 0.5, 2.0};
    static double product[NODES * NODES];
    for (int c = 0; c < 3; c++) {
        const pdmc_covariance covariance = {.kind = PDMC_COVARIANCE_GAUSSIAN, .length = lengths[c]};
        pdmc_karhunen_loeve pairs;
        double in_x[NODES], in_y[NODES];
        CHECK_OK(pdmc_karhunen_loeve_create(&covariance, WIDTH, HEIGHT, MODES, MODES, 1, &pairs));
        gaussian_eigenvalues(lengths[c], WIDTH, in_x);
        gaussian_eigenvalues(lengths[c], HEIGHT, in_y);
        for (int i = 0; i < NODES * NODES; i++) product[i] = in_x[i / NODES] * in_y[i % NODES];
        qsort(product, NODES * NODES, sizeof *product, descending);
        // an eigenvalue's error is that of its function squared, of which the tail, < 1e-8, is a part
        for (int k = 0; k < MODES; k++) CHECK_NEAR(pairs.lambda[k], product[k], 1e-9 * product[0]);
        CHECK_NEAR(pairs.lambda[0], product[0], 1e-12 * product[0]);
        pdmc_karhunen_loeve_clear(&pairs);
    }
}

static double value_at(const pdmc_karhunen_loeve *pairs, int mode, const double x[2])
{
    static double p[10201];
    const int n = pdmc_polynomials_count(&pairs->space);
    double sum = 0.0;
    pdmc_polynomials_at(&pairs->space, 1, x, p);
    for (int i = 0; i < n; i++) sum += p[i] * pairs->coefficient[(size_t)mode * (size_t)n + (size_t)i];
    return sum;
}

/// The integral of the covariance times a mode over the rectangle, which is split into eight right triangles between x, its
/// foot on a side and a corner; in u along the side and v along the ray, y = x + v (e(u) - x), the integrand is smooth but
/// for C(r) near r = 0 and for the foot of a near side: Gauss rules in the cubic roots of u and v.
static double integral_around(const pdmc_karhunen_loeve *pairs, const pdmc_covariance *covariance, int mode,
                              const double x[2])
{
    enum { N = 32 };
    const double half[2] = {0.5 * WIDTH, 0.5 * HEIGHT};
    double t[N], w[N], sum = 0.0;
    CHECK_OK(pdmc_gauss_legendre(N, 0.0, 1.0, t, w));
    for (int triangle = 0; triangle < 8; triangle++) {
        const int across = triangle & 1, along = 1 - across;
        const double height = (triangle & 2 ? half[across] : -half[across]) - x[across];
        const double length = (triangle & 4 ? half[along] : -half[along]) - x[along];
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                const double u = gsl_pow_3(t[i]), v = gsl_pow_3(t[j]);
                double y[2], weight = 9.0 * w[i] * w[j] * gsl_pow_2(t[i] * t[j]) * v * fabs(height * length);
                y[across] = x[across] + v * height;
                y[along] = x[along] + v * u * length;
                sum +=
                    weight * pdmc_covariance_at(covariance, hypot(y[0] - x[0], y[1] - x[1])) * value_at(pairs, mode, y);
            }
    }
    return sum;
}

/// Integral equation and eigenvalue together, at points inside, by a side and by a corner.
static void modes_solve_the_integral_equation(void **state)
{
    (void)state;
    enum { MODES = 40 };
    static const pdmc_covariance covariances[] = {{PDMC_COVARIANCE_EXPONENTIAL, 0.5, 0.0},
                                                  {PDMC_COVARIANCE_EXPONENTIAL, 5.0, 0.0},
                                                  {PDMC_COVARIANCE_GAUSSIAN, 0.8, 0.0},
                                                  {PDMC_COVARIANCE_MATERN, 0.5, 0.7}};
    static const double points[][2] = {{0.31, -0.42}, {2.45, 0.2}, {-2.49, 1.48}};
    static const int modes[] = {0, 7, MODES - 1};
    for (int c = 0; c < 4; c++) {
        pdmc_karhunen_loeve pairs;
        CHECK_OK(pdmc_karhunen_loeve_create(&covariances[c], WIDTH, HEIGHT, MODES, MODES, 1, &pairs));
        for (int m = 0; m < 3; m++)
            for (int i = 0; i < 3; i++) {
                const double integral = integral_around(&pairs, &covariances[c], modes[m], points[i]);
                const double value = value_at(&pairs, modes[m], points[i]);
                // Galerkin's residual, of modes of size 0.3; the root of the tail allowed is 1e-4, and 3e-6 was seen
                CHECK_NEAR(integral / pairs.lambda[modes[m]], value, 1e-5);
            }
        pdmc_karhunen_loeve_clear(&pairs);
    }
}

/// The sum of the squares of all eigenvalues is the integral of the squared covariance over all pairs of points,
/// 4 integral (width - x) (height - y) C(x, y)^2 dx dy, here by a Gauss rule in polar coordinates.
static void squares_sum_to_the_integral_of_the_squared_covariance(void **state)
{
    (void)state;
    enum { POINTS = 96, MODES = 400 };
    const pdmc_covariance covariance = {.kind = PDMC_COVARIANCE_EXPONENTIAL, .length = 0.5};
    double angle[POINTS], angle_weight[POINTS], t[POINTS], t_weight[POINTS], want = 0.0, got = 0.0;
    const double edge[] = {0.0, atan2(HEIGHT, WIDTH), M_PI_2};
    for (int part = 0; part < 2; part++) {
        CHECK_OK(pdmc_gauss_legendre(POINTS, edge[part], edge[part + 1], angle, angle_weight));
        for (int a = 0; a < POINTS; a++) {
            const double c = cos(angle[a]), s = sin(angle[a]), reach = part == 0 ? WIDTH / c : HEIGHT / s;
            CHECK_OK(pdmc_gauss_legendre(POINTS, 0.0, reach, t, t_weight));
            for (int i = 0; i < POINTS; i++)
                want += 4.0 * angle_weight[a] * t_weight[i] * t[i] * (WIDTH - t[i] * c) * (HEIGHT - t[i] * s) *
                        exp(-2.0 * t[i] / covariance.length);
        }
    }
    pdmc_karhunen_loeve pairs;
    CHECK_OK(pdmc_karhunen_loeve_create(&covariance, WIDTH, HEIGHT, MODES, MODES, 1, &pairs));
    for (int k = 0; k < pairs.modes; k++) got += pairs.lambda[k] * pairs.lambda[k];
    // lambda_k goes with k^-1.5 (the covariance's spectrum with the wave number to the -3), so that what is beyond the last
    // of `modes` sums to lambda^2 modes / 2
    const double last = pairs.lambda[pairs.modes - 1], rest = 0.5 * last * last * pairs.modes;
    assert_true(rest < 1e-3 * want);
    CHECK_NEAR(got + rest, want, 0.5 * rest);
    pdmc_karhunen_loeve_clear(&pairs);
}

static void refusals(void **state)
{
    (void)state;
    const pdmc_covariance covariance = {.kind = PDMC_COVARIANCE_EXPONENTIAL, .length = 0.5};
    pdmc_karhunen_loeve pairs;
    CHECK_STATUS(pdmc_karhunen_loeve_create(&covariance, WIDTH, HEIGHT, 100000, 100000, 1, &pairs), PDMC_ERR_ARG);
    CHECK_FAILS_CLEANLY(pdmc_karhunen_loeve_create(&covariance, WIDTH, HEIGHT, 3, 3, 1, &pairs),
                        pdmc_karhunen_loeve_clear(&pairs));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gaussian_eigenvalues_are_products),
        cmocka_unit_test(modes_solve_the_integral_equation),
        cmocka_unit_test(squares_sum_to_the_integral_of_the_squared_covariance),
        cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
