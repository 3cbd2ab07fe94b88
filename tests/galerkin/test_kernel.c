// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/kernel.h"

#include "check.h"
#include "pdmc/quadrature.h"
#include "pdmc/random.h"

#include <float.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_sf_bessel.h>
#include <gsl/gsl_sf_expint.h>

static pdmc_scalar_kernel kernel_of(int dimension, double horizon, double power, int bins, const double weight[])
{
    pdmc_scalar_kernel kernel;
    CHECK_OK(pdmc_scalar_kernel_create(dimension, horizon, power, bins, weight, &kernel));
    return kernel;
}

static double dispersion(const pdmc_scalar_kernel *kernel, double wave_number)
{
    double lambda;
    CHECK_OK(pdmc_scalar_dispersion(kernel, wave_number, &lambda));
    return lambda;
}

// The notes have 2 / (delta^2 r) and 3 / (pi delta^3 r); the second gives half of the Laplacian.
static void kernels_of_power_one_are_those_of_the_notes_corrected(void **state)
{
    (void)state;
    const pdmc_scalar_kernel one = kernel_of(1, 0.3, 1.0, 1, NULL), two = kernel_of(2, 0.3, 1.0, 1, NULL);
    CHECK_NEAR(pdmc_scalar_kernel_at(&one, 0.2), 2.0 / (0.09 * 0.2), 1e-12);
    CHECK_NEAR(pdmc_scalar_kernel_at(&two, 0.2), 6.0 / (M_PI * 0.027 * 0.2), 1e-12);
    assert_true(pdmc_scalar_kernel_at(&two, 0.31) == 0.0);
}

static const double profile[3] = {1.0, 0.25, 2.0};

// lambda = k^2 - O(k^4 delta^2) whatever the kernel: the factor of the Laplacian, by the dispersion, which is another
// integral than that of the scale.
static void long_waves_see_the_laplacian(void **state)
{
    (void)state;
    for (int dimension = 1; dimension <= 2; dimension++)
        for (int bins = 1; bins <= 3; bins += 2)
            for (double power = 0.0; power < 2.0; power += 0.45) {
                const pdmc_scalar_kernel kernel = kernel_of(dimension, 0.7, power, bins, bins > 1 ? profile : NULL);
                const double k = 0.01;
                CHECK_NEAR(dispersion(&kernel, k) / (k * k), 1.0, 0.49 * k * k / 12.0 + 1e-11);
                const double coarse = 1.0 - dispersion(&kernel, 0.2) / 0.04,
                             fine = 1.0 - dispersion(&kernel, 0.1) / 0.01;
                CHECK_NEAR(coarse / fine, 4.0, 0.01); // of the order of k^2
            }
}

// 4 / delta^2 int_0^(k delta) (1 - cos t) / t dt, in one dimension with power 1.
static void short_waves_have_the_frequency_of_the_cosine_integral(void **state)
{
    (void)state;
    for (double k = 1.0; k < 2000.0; k *= 7.0) {
        const double delta = 0.4, z = k * delta;
        const pdmc_scalar_kernel kernel = kernel_of(1, delta, 1.0, 1, NULL);
        const double want = 4.0 / (delta * delta) * (M_EULER + log(z) - gsl_sf_Ci(z));
        CHECK_NEAR(dispersion(&kernel, k) / want, 1.0, 1e-12);
    }
}

// In two dimensions with power 0: int_0^d r J0(kr) dr = d J1(kd) / k.
static void waves_in_the_plane_have_the_frequency_of_bessels_function(void **state)
{
    (void)state;
    for (double k = 1.0; k < 2000.0; k *= 7.0) {
        const double delta = 0.4, c = 8.0 / (M_PI * gsl_pow_4(delta));
        const pdmc_scalar_kernel kernel = kernel_of(2, delta, 0.0, 1, NULL);
        const double want = 2.0 * M_PI * c * (0.5 * delta * delta - delta * gsl_sf_bessel_J1(k * delta) / k);
        CHECK_NEAR(dispersion(&kernel, k) / want, 1.0, 1e-11);
    }
}

static void add_up(const pdmc_moments *part, pdmc_moments *sum)
{
    sum->zero += part->zero;
    for (int k = 0; k < 2; k++) sum->first[k] += part->first[k];
    for (int k = 0; k < 3; k++) sum->second[k] += part->second[k];
}

static void check_equal(const pdmc_moments *got, const pdmc_moments *want, double tolerance)
{
    CHECK_NEAR(got->zero, want->zero, tolerance);
    for (int k = 0; k < 2; k++) CHECK_NEAR(got->first[k], want->first[k], tolerance);
    for (int k = 0; k < 3; k++) CHECK_NEAR(got->second[k], want->second[k], tolerance);
}

// Triangles about the centre that fill the disc have its moments: int c xi xi^T = I, and no first ones.
static void triangles_round_the_centre_add_up_to_the_disc(void **state)
{
    (void)state;
    for (double power = 0.0; power < 2.0; power += 0.25)
        for (int bins = 1; bins <= 3; bins += 2) {
            const pdmc_scalar_kernel kernel = kernel_of(2, 0.3, power, bins, bins > 1 ? profile : NULL);
            double corner[4][2] = {{-0.5, -0.4}, {0.6, -0.37}, {0.45, 0.52}, {-0.41, 0.4}};
            double middle[2] = {0.11, 0.04};
            pdmc_moments sum = {0}, part;
            for (int e = 0; e < 4; e++) {
                double triangle[3][2] = {{middle[0], middle[1]},
                                         {corner[e][0], corner[e][1]},
                                         {corner[(e + 1) % 4][0], corner[(e + 1) % 4][1]}};
                pdmc_triangle_moments(&kernel, triangle, &part);
                add_up(&part, &sum);
            }
            const pdmc_moments whole = {.zero = 2.0 * M_PI * pdmc_kernel_constant(&kernel, bins, 0),
                                        .second = {2.0, 0.0, 2.0}};
            check_equal(&sum, &whole, 1e-12 * whole.zero);
        }
}

static void make_counter_clockwise(double corner[3][2])
{
    const double turn = (corner[1][0] - corner[0][0]) * (corner[2][1] - corner[0][1]) -
                        (corner[1][1] - corner[0][1]) * (corner[2][0] - corner[0][0]);
    for (int d = 0; d < 2 && turn < 0.0; d++) {
        const double swap = corner[1][d];
        corner[1][d] = corner[2][d];
        corner[2][d] = swap;
    }
}

// From a point on an edge, to rounding on either side of it, an element is half a disc, and its neighbour the other half: pi,
// 2 n and pi / 2 of the integrals of c r^m over the radius.
static void points_on_edges_see_half_discs(void **state)
{
    (void)state;
    for (double power = 0.0; power < 2.0; power += 0.5)
        for (int turn = 0; turn < 24; turn++)
            for (int side = -1; side <= 1; side++) {
                const pdmc_scalar_kernel kernel = kernel_of(2, 0.2, power, 3, profile);
                const double angle = 0.27 * turn, t[2] = {cos(angle), sin(angle)}, n[2] = {t[1], -t[0]};
                const double off = side * 1e-17;
                double corner[3][2];
                for (int d = 0; d < 2; d++) {
                    corner[0][d] = off * n[d] - 0.5 * t[d];
                    corner[1][d] = off * n[d] + 0.7 * t[d];
                    corner[2][d] = 0.1 * t[d] - 0.8 * n[d]; // counter-clockwise, the element is where n does not point
                }
                pdmc_moments got;
                pdmc_triangle_moments(&kernel, corner, &got);
                double radial[3];
                for (int m = 0; m < 3; m++) radial[m] = pdmc_kernel_constant(&kernel, 3, m);
                const double half = 0.5 * M_PI * radial[2];
                const pdmc_moments want = {M_PI * radial[0],
                                           {-2.0 * radial[1] * n[0], -2.0 * radial[1] * n[1]},
                                           {half, 0.0, half}};
                // the strip of rounding between the point and the edge has int h r^-p ds, of the order of h^(2 - p)
                check_equal(&got, &want, want.zero * (1e-12 + 3.0 * pow(DBL_EPSILON / 0.2, 2.0 - power)));
            }
}

// The other rule of this project, for polynomials, where the kernel has no power: at random.
static void without_a_power_the_moments_are_integrals_of_polynomials(void **state)
{
    (void)state;
    enum { CASES = 300 };
    const pdmc_scalar_kernel kernel = kernel_of(2, 0.8, 0.0, 1, NULL);
    const double c = pdmc_scalar_kernel_at(&kernel, 0.1);
    pdmc_triangle_disc_rule rule;
    CHECK_OK(pdmc_triangle_disc_rule_create(2, &rule));
    pdmc_area_rule points = {.x = pdmc_calloc(2 * (size_t)rule.capacity, sizeof(double)),
                             .weight = pdmc_calloc((size_t)rule.capacity, sizeof(double))};
    for (uint64_t sample = 0; sample < CASES; sample++) {
        double u[6], corner[3][2];
        pdmc_random_uniform(3, PDMC_STREAM_PROBES, sample, 0, 6, u);
        for (int k = 0; k < 6; k++) corner[k / 2][k % 2] = 2.4 * u[k] - 1.2;
        make_counter_clockwise(corner);
        pdmc_triangle_disc_points(&rule, (const double *)corner, (double[2]){0.0, 0.0}, 0.8, &points);
        pdmc_moments got, want = {0};
        pdmc_triangle_moments(&kernel, corner, &got);
        for (int p = 0; p < points.count; p++) {
            const double *x = &points.x[2 * p], w = c * points.weight[p];
            add_up(&(pdmc_moments){w, {w * x[0], w * x[1]}, {w * x[0] * x[0], w * x[0] * x[1], w * x[1] * x[1]}},
                   &want);
        }
        check_equal(&got, &want, 1e-13 * c);
    }
    pdmc_free(points.x);
    pdmc_free(points.weight);
    pdmc_triangle_disc_rule_clear(&rule);
}

// A triangle beside the centre, cut into ever smaller ones that have the kernel of their middle, extrapolated.
static void moments_beside_the_centre_are_sums_over_small_triangles(void **state)
{
    (void)state;
    for (double power = 0.5; power < 2.0; power += 0.5) {
        const pdmc_scalar_kernel kernel = kernel_of(2, 2.0, power, 1, NULL); // the triangle lies in the horizon
        double corner[3][2] = {{0.3, -0.2}, {1.0, 0.1}, {0.5, 0.7}}, sum[2] = {0.0, 0.0};
        for (int fine = 0; fine < 2; fine++) {
            const int n = fine ? 128 : 64;
            for (int i = 0; i < n; i++)
                for (int j = 0; j < 2 * (n - i) - 1; j++) { // both orientations of a row
                    const double b = (i + (j % 2 ? 2.0 : 1.0) / 3.0) / n, c = (j / 2 + (j % 2 ? 2.0 : 1.0) / 3.0) / n;
                    const double x = corner[0][0] + b * 0.7 + c * 0.2, y = corner[0][1] + b * 0.3 + c * 0.9;
                    sum[fine] +=
                        pdmc_scalar_kernel_at(&kernel, hypot(x, y)) * x * y * 0.5 * (0.7 * 0.9 - 0.3 * 0.2) / (n * n);
                }
        }
        pdmc_moments got;
        pdmc_triangle_moments(&kernel, corner, &got);
        const double want = (4.0 * sum[1] - sum[0]) / 3.0;
        CHECK_NEAR(got.second[1], want, 1e-7 * fabs(want));
    }
}

// By parts of an interval on both sides of the centre, and in closed form for one bin.
static void intervals_have_their_moments(void **state)
{
    (void)state;
    const pdmc_scalar_kernel kernel = kernel_of(1, 0.5, 1.0, 1, NULL), weighted = kernel_of(1, 0.5, 0.5, 3, profile);
    pdmc_moments got, whole, part, sum = {0};
    pdmc_interval_moments(&kernel, 0.1, 9.0, &got); // 8 / r up to the horizon
    CHECK_NEAR(got.zero, 8.0 * log(5.0), 1e-13);
    CHECK_NEAR(got.first[0], 8.0 * 0.4, 1e-13);
    CHECK_NEAR(got.second[0], 4.0 * (0.25 - 0.01), 1e-13);
    pdmc_interval_moments(&weighted, -0.45, 0.35, &whole);
    for (int i = 0; i < 8; i++) {
        pdmc_interval_moments(&weighted, -0.45 + 0.1 * i, -0.35 + 0.1 * i, &part);
        add_up(&part, &sum);
    }
    check_equal(&sum, &whole, 1e-13);
    pdmc_interval_moments(&weighted, -1.0, 1.0, &whole);
    CHECK_NEAR(whole.second[0], 2.0, 1e-14); // the Laplacian
}

static void kernels_that_cannot_be_are_refused(void **state)
{
    (void)state;
    pdmc_scalar_kernel kernel;
    const double none[2] = {0.0, 0.0}, negative[2] = {1.0, -0.1};
    CHECK_STATUS(pdmc_scalar_kernel_create(3, 1.0, 1.0, 1, NULL, &kernel), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_scalar_kernel_create(2, 0.0, 1.0, 1, NULL, &kernel), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_scalar_kernel_create(2, 1.0, 2.0, 1, NULL, &kernel), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_scalar_kernel_create(2, 1.0, -0.1, 1, NULL, &kernel), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_scalar_kernel_create(2, 1.0, 1.0, PDMC_KERNEL_BINS + 1, NULL, &kernel), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_scalar_kernel_create(2, 1.0, 1.0, 2, none, &kernel), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_scalar_kernel_create(2, 1.0, 1.0, 2, negative, &kernel), PDMC_ERR_ARG);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(kernels_of_power_one_are_those_of_the_notes_corrected),
        cmocka_unit_test(long_waves_see_the_laplacian),
        cmocka_unit_test(short_waves_have_the_frequency_of_the_cosine_integral),
        cmocka_unit_test(waves_in_the_plane_have_the_frequency_of_bessels_function),
        cmocka_unit_test(triangles_round_the_centre_add_up_to_the_disc),
        cmocka_unit_test(points_on_edges_see_half_discs),
        cmocka_unit_test(without_a_power_the_moments_are_integrals_of_polynomials),
        cmocka_unit_test(moments_beside_the_centre_are_sums_over_small_triangles),
        cmocka_unit_test(intervals_have_their_moments),
        cmocka_unit_test(kernels_that_cannot_be_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
