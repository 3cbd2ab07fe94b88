// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/distribution.h"

#include "check.h"

#include <float.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_randist.h>

static double measured[] = {-1.0, 0.0, 0.5, 2.0, 2.0, 7.0};

static const pdmc_distribution cut[] = {
    {.kind = PDMC_NORMAL, .location = 1.0, .scale = 0.3, .least = 0.0, .most = INFINITY},
    {.kind = PDMC_NORMAL, .location = 1.0, .scale = 0.3, .least = 2.8, .most = 3.7},
    {.kind = PDMC_LOGNORMAL, .location = 0.0, .scale = 0.5, .least = -INFINITY, .most = 2.0},
    {.kind = PDMC_WEIBULL, .scale = 3.0, .shape = 2.0, .least = 1.0, .most = 4.0},
    {.kind = PDMC_GUMBEL, .location = 5.0, .scale = 0.5, .least = 4.0, .most = 9.0},
    {.kind = PDMC_GAMMA, .scale = 2.0, .shape = 3.0, .least = 1.0, .most = 30.0},
    {.kind = PDMC_BETA, .upper = 2.0, .alpha = 2.0, .beta = 3.0, .least = 0.5, .most = 5.0},
    {.kind = PDMC_UNIFORM, .upper = 4.0, .least = 1.0, .most = 3.0},
    {.kind = PDMC_TRIANGULAR, .mode = 1.0, .upper = 4.0, .least = 0.5, .most = 3.0},
    {.kind = PDMC_EMPIRICAL, .count = 6, .values = measured, .least = -0.5, .most = 5.0},
};
enum { CUT = sizeof cut / sizeof cut[0] };

static pdmc_distribution whole(const pdmc_distribution *distribution)
{
    pdmc_distribution all = *distribution;
    all.least = -INFINITY;
    all.most = INFINITY;
    return all;
}

/// The uncut tails, renormalised: the mass beyond the nearer cut is measured from there, to rounding of the uncut ones.
static void tails_are_those_of_the_whole_renormalised(void **state)
{
    (void)state;
    for (int i = 0; i < CUT; i++) {
        const pdmc_distribution all = whole(&cut[i]);
        const double below = pdmc_distribution_lower_tail(&all, cut[i].least);
        const double above = pdmc_distribution_upper_tail(&all, cut[i].most);
        CHECK_OK(pdmc_distribution_check(&cut[i]));
        for (int k = -16; k <= 16; k++) {
            const double z = k / 4.0, x = pdmc_distribution_value(&cut[i], z);
            const double upper = pdmc_distribution_upper_tail(&all, x), left = 1.0 - below;
            const bool far_right = left < 1e-3; // the left tail of what is cut off is 1 but for its last digits
            const double mass = far_right ? pdmc_distribution_upper_tail(&all, cut[i].least) - above : left - above;
            const double want = (upper - above) / mass;
            const bool atom = cut[i].kind == PDMC_EMPIRICAL && x == 2.0;
            if (!atom) CHECK_NEAR(want, gsl_cdf_ugaussian_Q(z), 1e-13);
            CHECK_NEAR(pdmc_distribution_upper_tail(&cut[i], x), want, 1e-13);
            CHECK_NEAR(pdmc_distribution_lower_tail(&cut[i], x), 1.0 - want, 1e-13);
        }
    }
}

static void values_stay_within_the_cuts_and_rise(void **state)
{
    (void)state;
    for (int i = 0; i < CUT; i++) {
        double previous = -INFINITY;
        for (int k = -300; k <= 300; k++) {
            const double x = pdmc_distribution_value(&cut[i], k / 10.0);
            assert_true(x >= cut[i].least && x <= cut[i].most && x >= previous);
            previous = x;
        }
        CHECK_NEAR(pdmc_distribution_lower_tail(&cut[i], cut[i].least), 0.0, 0.0);
        CHECK_NEAR(pdmc_distribution_upper_tail(&cut[i], cut[i].most), 0.0, 0.0);
    }
}

/// A cut that the variable does not reach changes nothing but rounding, of up to DBL_EPSILON (1 + z^2) in a tail.
static void a_distant_cut_changes_nothing(void **state)
{
    (void)state;
    const pdmc_distribution all = {
        .kind = PDMC_WEIBULL, .scale = 3.0, .shape = 2.0, .least = -INFINITY, .most = INFINITY};
    pdmc_distribution distant = all;
    distant.least = -1.0;
    for (int k = -64; k <= 64; k++) {
        const double want = pdmc_distribution_value(&all, k / 8.0);
        CHECK_NEAR(pdmc_distribution_value(&distant, k / 8.0) / want, 1.0, 1e-13);
    }
}

/// Of a standard normal variable between a and b: (phi(a) - phi(b)) / P and 1 + (a phi(a) - b phi(b)) / P - mean^2.
static void check_normal_moments(double a, double b, double tolerance)
{
    const double mass =
        a > 0.0 ? gsl_cdf_ugaussian_Q(a) - gsl_cdf_ugaussian_Q(b) : gsl_cdf_ugaussian_P(b) - gsl_cdf_ugaussian_P(a);
    const double pa = gsl_ran_ugaussian_pdf(a), pb = gsl_ran_ugaussian_pdf(b);
    const double want = (pa - pb) / mass;
    const double variance = 1.0 + ((isinf(a) ? 0.0 : a * pa) - (isinf(b) ? 0.0 : b * pb)) / mass - want * want;
    const pdmc_distribution d = {
        .kind = PDMC_NORMAL, .location = 7.0, .scale = 2.0, .least = 7.0 + 2.0 * a, .most = 7.0 + 2.0 * b};
    double mean, deviation;
    pdmc_distribution_moments(&d, &mean, &deviation);
    CHECK_NEAR((mean - 7.0) / 2.0, want, tolerance);
    CHECK_NEAR(deviation / 2.0, sqrt(variance), tolerance);
}

/// The closed form of the variance loses digits with the width and the distance of the cut; the tolerance is for that.
static void moments_of_a_cut_normal_variable(void **state)
{
    (void)state;
    check_normal_moments(-INFINITY, 0.0, 1e-13);
    check_normal_moments(-3.0, INFINITY, 1e-13);
    check_normal_moments(-1.0, 2.0, 1e-13);
    check_normal_moments(0.5, 3.0, 1e-13);
    check_normal_moments(5.0, INFINITY, 1e-11);
    check_normal_moments(6.0, 9.0, 1e-11);
}

/// E X^k of exp(s Z), Z < b, is exp(k^2 s^2 / 2) Phi(b - k s) / Phi(b).
static void moments_of_a_cut_lognormal_variable(void **state)
{
    (void)state;
    const double s = 0.5, b = log(2.0) / s;
    const double first = exp(0.5 * s * s) * gsl_cdf_ugaussian_P(b - s) / gsl_cdf_ugaussian_P(b);
    const double second = exp(2.0 * s * s) * gsl_cdf_ugaussian_P(b - 2.0 * s) / gsl_cdf_ugaussian_P(b);
    const pdmc_distribution d = {.kind = PDMC_LOGNORMAL, .scale = s, .least = -INFINITY, .most = 2.0};
    double mean, deviation;
    pdmc_distribution_moments(&d, &mean, &deviation);
    CHECK_NEAR(mean, first, 1e-13);
    CHECK_NEAR(deviation, sqrt(second - first * first), 1e-13);
}

/// Pieces of uniform density, by hand: mean and E X^2 = middle^2 + width^2 / 12 of each.
static void moments_of_cut_pieces(void **state)
{
    (void)state;
    const double from[] = {-0.5, 0.0, 0.5, 2.0, 2.0}, to[] = {0.0, 0.5, 2.0, 2.0, 5.0},
                 part[] = {0.5, 1.0, 1.0, 1.0, 0.6};
    double mass = 0.0, first = 0.0, second = 0.0, mean, deviation;
    for (int i = 0; i < 5; i++) {
        const double middle = 0.5 * (from[i] + to[i]);
        mass += part[i];
        first += part[i] * middle;
        second += part[i] * (middle * middle + gsl_pow_2(to[i] - from[i]) / 12.0);
    }
    pdmc_distribution_moments(&cut[CUT - 1], &mean, &deviation);
    CHECK_NEAR(mean, first / mass, 1e-13);
    CHECK_NEAR(deviation, sqrt(second / mass - gsl_pow_2(first / mass)), 1e-13);
}

/// The right half of a triangle with its mode on the left end: mean a third and deviation a root of 18 of its length.
static void moments_of_a_cut_triangle(void **state)
{
    (void)state;
    const pdmc_distribution d = {.kind = PDMC_TRIANGULAR, .mode = 1.0, .upper = 4.0, .least = 1.0, .most = INFINITY};
    double mean, deviation;
    pdmc_distribution_moments(&d, &mean, &deviation);
    CHECK_NEAR(mean, 2.0, 1e-13);
    CHECK_NEAR(deviation, 3.0 / sqrt(18.0), 1e-13);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tails_are_those_of_the_whole_renormalised),
        cmocka_unit_test(values_stay_within_the_cuts_and_rise),
        cmocka_unit_test(a_distant_cut_changes_nothing),
        cmocka_unit_test(moments_of_a_cut_normal_variable),
        cmocka_unit_test(moments_of_a_cut_lognormal_variable),
        cmocka_unit_test(moments_of_cut_pieces),
        cmocka_unit_test(moments_of_a_cut_triangle),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
