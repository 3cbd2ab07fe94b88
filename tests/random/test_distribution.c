// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/random.h"

#include "check.h"

#include <float.h>
#include <gsl/gsl_cdf.h>

/// The cdf magnifies a relative error of z by z phi(z) / Phi(z) <= 1 + z^2; the 16 leaves room for the rounding of both
/// of GSL's functions.
static double rounding(double z)
{
    return 16.0 * DBL_EPSILON * (1.0 + z * z);
}

static void the_normal_quantile_inverts_the_cdf_in_both_tails(void **state)
{
    (void)state;
    for (int k = 1; k <= 53; k++) {
        const double u = ldexp(1.0, -k);
        const double low = pdmc_normal_quantile(u), high = pdmc_normal_quantile(1.0 - u);
        CHECK_NEAR(gsl_cdf_ugaussian_P(low) / u, 1.0, rounding(low));
        CHECK_NEAR(gsl_cdf_ugaussian_Q(high) / u, 1.0, rounding(high));
    }
    for (int k = 1; k < 1000; k++) {
        const double z = pdmc_normal_quantile(k / 1000.0);
        CHECK_NEAR(gsl_cdf_ugaussian_P(z), k / 1000.0, rounding(z));
    }
}

static void the_normal_quantile_is_odd_and_increasing(void **state)
{
    (void)state;
    assert_true(pdmc_normal_quantile(0.5) == 0.0);
    double previous = -INFINITY;
    for (int k = 1; k < 4096; k++) {
        const double u = k / 4096.0; // 1 - u is exact
        const double z = pdmc_normal_quantile(u);
        CHECK_NEAR(pdmc_normal_quantile(1.0 - u), -z, 0.0);
        assert_true(z > previous);
        previous = z;
    }
}

/// 30-digit arithmetic at the doubles nearest to 0.975, 0.9999 and 1e-10.
static void known_normal_quantiles(void **state)
{
    (void)state;
    CHECK_NEAR(pdmc_normal_quantile(0.975), 1.959963984540054, 4 * DBL_EPSILON);
    CHECK_NEAR(pdmc_normal_quantile(0.9999), 3.7190164854557084, 8 * DBL_EPSILON);
    CHECK_NEAR(pdmc_normal_quantile(1e-10), -6.361340902404056, 16 * DBL_EPSILON);
}

/// The mean of n values of a variable with mean 1 has standard deviation v / sqrt(n). Theirs is v (1 + e) with
/// var e = (kurtosis - 1) / (4 n). Both within 5 standard deviations.
static void check_moments(pdmc_distribution_kind kind, double variation, double kurtosis)
{
    enum { N = 200000 };
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < N; i++) {
        double u;
        pdmc_random_uniform(7, PDMC_STREAM_LOAD, (uint64_t)i, 0, 1, &u);
        const double deviation = pdmc_unit_mean_quantile(kind, variation, u) - 1.0;
        sum += deviation;
        squares += deviation * deviation;
    }
    CHECK_NEAR(sum / N, 0.0, 5.0 * variation / sqrt(N));
    CHECK_NEAR(sqrt(squares / N) / variation, 1.0, 5.0 * sqrt((kurtosis - 1.0) / (4.0 * N)));
}

static void mean_is_one_and_variation_as_asked(void **state)
{
    (void)state;
    static const double variations[] = {0.01, 0.1, 0.3, 0.5};
    for (int k = 0; k < 4; k++) {
        const double v = variations[k], w = 1.0 + v * v;
        check_moments(PDMC_NORMAL, v, 3.0);
        check_moments(PDMC_LOGNORMAL, v, pow(w, 4) + 2.0 * pow(w, 3) + 3.0 * w * w - 3.0);
    }
}

/// With w = 1 + v^2: the median is w^-1/2, and the quantiles at u and 1 - u are in proportion to it as q and 1/q.
static void lognormal_quantiles_have_their_closed_form(void **state)
{
    (void)state;
    for (int k = 1; k < 512; k++) {
        const double u = k / 1024.0, v = 0.3, median = 1.0 / sqrt(1.0 + v * v);
        const double low = pdmc_unit_mean_quantile(PDMC_LOGNORMAL, v, u);
        const double high = pdmc_unit_mean_quantile(PDMC_LOGNORMAL, v, 1.0 - u);
        CHECK_NEAR(low * high / (median * median), 1.0, 16 * DBL_EPSILON);
        CHECK_NEAR(gsl_cdf_lognormal_P(low, log(median), sqrt(log(1.0 + v * v))), u, 64 * DBL_EPSILON);
    }
    CHECK_NEAR(pdmc_unit_mean_quantile(PDMC_LOGNORMAL, 1.0, 0.5), sqrt(0.5), 4 * DBL_EPSILON);
}

/// For small v the lognormal is 1 + v z + O(v^2): a log(1 + v^2) that loses v^2 would give 1.
static void a_small_variation_is_not_lost(void **state)
{
    (void)state;
    const double v = 1e-9, z = pdmc_normal_quantile(0.9);
    CHECK_NEAR((pdmc_unit_mean_quantile(PDMC_LOGNORMAL, v, 0.9) - 1.0) / v, z, 2.0 * DBL_EPSILON / v);
    CHECK_NEAR((pdmc_unit_mean_quantile(PDMC_NORMAL, v, 0.9) - 1.0) / v, z, 2.0 * DBL_EPSILON / v);
}

static void without_variation_there_is_exactly_one(void **state)
{
    (void)state;
    for (int k = 1; k < 16; k++) {
        CHECK_NEAR(pdmc_unit_mean_quantile(PDMC_NORMAL, 0.0, k / 16.0), 1.0, 0.0);
        CHECK_NEAR(pdmc_unit_mean_quantile(PDMC_LOGNORMAL, 0.0, k / 16.0), 1.0, 0.0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_normal_quantile_inverts_the_cdf_in_both_tails),
        cmocka_unit_test(the_normal_quantile_is_odd_and_increasing),
        cmocka_unit_test(known_normal_quantiles),
        cmocka_unit_test(mean_is_one_and_variation_as_asked),
        cmocka_unit_test(lognormal_quantiles_have_their_closed_form),
        cmocka_unit_test(a_small_variation_is_not_lost),
        cmocka_unit_test(without_variation_there_is_exactly_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
