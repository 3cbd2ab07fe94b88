// SPDX-License-Identifier: GPL-3.0-or-later
#include "reliability/limit_states.h"

#include <math.h>

static pdmc_sensitivity find(known_state *state, int groups, const int group[], uint64_t seed, int samples)
{
    const pdmc_limit_state output = as_limit_state(state);
    pdmc_sensitivity_options options = pdmc_sensitivity_options_default();
    pdmc_sensitivity sensitivity;
    options.seed = seed;
    options.samples = samples;
    state->evaluations = 0;
    CHECK_OK(pdmc_sensitivity_find(&output, groups, group, &options, &sensitivity));
    assert_int_equal(sensitivity.evaluations, state->evaluations);
    assert_int_equal(sensitivity.evaluations, samples * (groups + 2));
    return sensitivity;
}

/// sin x_1 + a sin^2 x_2 + b x_3^4 sin x_1, x uniform in [-pi, pi], a = 7 and b = 0.1 (Ishigami & Homma 1990).
static double ishigami(const double parameter[], int n, const double z[])
{
    double x[3];
    (void)n;
    for (int i = 0; i < 3; i++) x[i] = M_PI * (2.0 * gsl_cdf_ugaussian_P(z[i]) - 1.0);
    return sin(x[0]) * (1.0 + parameter[1] * pow(x[2], 4.0)) + parameter[0] * pow(sin(x[1]), 2.0);
}

static const known_state ishigami_state = {.dimension = 3, .g = ishigami, .parameter = {7.0, 0.1}};

/// Its indices: V = a^2 / 8 + b pi^4 / 5 + b^2 pi^8 / 18 + 1 / 2.
static void ishigami_indices(double first[3], double total[3])
{
    const double a = 7.0, b = 0.1, pi4 = pow(M_PI, 4.0);
    const double one = 0.5 * pow(1.0 + 0.2 * b * pi4, 2.0), two = a * a / 8.0, both = b * b * pi4 * pi4 * 8.0 / 225.0;
    const double variance = one + two + both;
    CHECK_NEAR(variance, a * a / 8.0 + b * pi4 / 5.0 + b * b * pi4 * pi4 / 18.0 + 0.5, 1e-12);
    first[0] = one / variance, first[1] = two / variance, first[2] = 0.0;
    total[0] = (one + both) / variance, total[1] = first[1], total[2] = both / variance;
}

/// exp of a sum: a product of lognormal variables, in groups {0, 2}, {1}, {3}. With v_k = exp(s_k^2) - 1 of a group,
/// S_k = v_k / V and T_k = v_k prod_(j != k) (1 + v_j) / V, V = prod (1 + v_j) - 1.
static double product(const double parameter[], int n, const double z[])
{
    double sum = 0.0;
    for (int i = 0; i < n; i++) sum += parameter[i] * z[i];
    return exp(sum);
}

static const known_state product_state = {.dimension = 4, .g = product, .parameter = {0.3, 0.2, 0.2, 0.1}};
static const int product_group[] = {0, 1, 0, 2};

static void product_indices(double first[3], double total[3])
{
    double v[3], all = 1.0, exponent[3] = {0};
    for (int i = 0; i < 4; i++) exponent[product_group[i]] += pow(product_state.parameter[i], 2.0);
    for (int k = 0; k < 3; k++) all *= 1.0 + (v[k] = expm1(exponent[k]));
    for (int k = 0; k < 3; k++) {
        first[k] = v[k] / (all - 1.0);
        total[k] = v[k] * all / (1.0 + v[k]) / (all - 1.0);
    }
}

/// Within 1.8 half-widths at 95 %, 3.5 deviations, of the closed form; and an absolute bound, which no wide interval passes.
static void check_indices(const pdmc_estimate got[3], const double want[3], double absolute)
{
    for (int k = 0; k < 3; k++) {
        CHECK_NEAR(got[k].value, want[k], 0.9 * (got[k].upper - got[k].lower) + 1e-15);
        CHECK_NEAR(got[k].value, want[k], absolute);
        assert_true(got[k].lower <= got[k].value && got[k].value <= got[k].upper);
    }
}

static void closed_forms_are_found(void **state)
{
    (void)state;
    static const int each[] = {0, 1, 2};
    double first[3], total[3];
    known_state one = ishigami_state, other = product_state;
    pdmc_sensitivity s = find(&one, 3, each, 1, 40000);
    ishigami_indices(first, total);
    check_indices(s.first, first, 0.03);
    check_indices(s.total, total, 0.03);
    pdmc_sensitivity_clear(&s);
    s = find(&other, 3, product_group, 1, 40000);
    product_indices(first, total);
    check_indices(s.first, first, 0.03);
    check_indices(s.total, total, 0.03);
    pdmc_sensitivity_clear(&s);
}

static void coverage_of(const known_state *prototype, const int group[], const double first[3], const double total[3])
{
    enum { REPETITIONS = 1000, SAMPLES = 500 };
    int held[2][3] = {0};
    for (uint64_t r = 0; r < REPETITIONS; r++) {
        known_state repeated = *prototype;
        pdmc_sensitivity s = find(&repeated, 3, group, r, SAMPLES);
        for (int k = 0; k < 3; k++) {
            held[0][k] += holds(s.first[k], first[k]);
            held[1][k] += holds(s.total[k], total[k]);
        }
        pdmc_sensitivity_clear(&s);
    }
    for (int k = 0; k < 3; k++) {
        CHECK_NEAR((double)held[0][k] / REPETITIONS, 0.95, repetition_error(0.95, REPETITIONS));
        CHECK_NEAR((double)held[1][k] / REPETITIONS, 0.95, repetition_error(0.95, REPETITIONS));
    }
}

static void intervals_cover_as_often_as_they_say(void **state)
{
    (void)state;
    static const int each[] = {0, 1, 2};
    double first[3], total[3];
    ishigami_indices(first, total);
    coverage_of(&ishigami_state, each, first, total);
    product_indices(first, total);
    coverage_of(&product_state, product_group, first, total);
}

/// One group of all variables holds all the variance: f_AB is f_B.
static void all_variables_together_are_everything(void **state)
{
    (void)state;
    static const int together[] = {0, 0, 0, 0};
    known_state whole = product_state;
    pdmc_sensitivity s = find(&whole, 1, together, 5, 20000);
    CHECK_NEAR(s.first[0].value, 1.0, 0.9 * (s.first[0].upper - s.first[0].lower));
    CHECK_NEAR(s.total[0].value, 1.0, 0.9 * (s.total[0].upper - s.total[0].lower));
    pdmc_sensitivity_clear(&s);
}

/// A variable that g does not have: f_AB is f_A, exactly.
static void what_has_no_influence_is_exactly_nothing(void **state)
{
    (void)state;
    static const int each[] = {0, 1, 2};
    known_state idle = {.dimension = 3, .g = griffith, .parameter = {0.5, 0.1, 0.15}};
    pdmc_sensitivity s = find(&idle, 3, each, 5, 1000);
    assert_true(s.first[2].value == 0.0 && s.total[2].value == 0.0);
    assert_true(s.first[2].lower == 0.0 && s.first[2].upper == 0.0);
    pdmc_sensitivity_clear(&s);
}

static double constant(const double parameter[], int n, const double z[])
{
    (void)n;
    return z[0] > parameter[1] ? NAN : parameter[0];
}

static double product_with_a_hole(const double parameter[], int n, const double z[])
{
    return z[3] > 3.0 ? NAN : product(parameter, n, z);
}

static void failed_rows_are_left_out(void **state)
{
    (void)state;
    known_state hole = product_state;
    hole.g = product_with_a_hole;
    pdmc_sensitivity s = find(&hole, 3, product_group, 3, 20000);
    double first[3], total[3];
    product_indices(first, total);
    const double p = gsl_cdf_ugaussian_Q(3.0), rows = 20000.0;
    // z_3 of A stands in three of the five points of a row (A, and A with two other groups of B), that of B in two: a variance
    // of 9 p + 4 p a row
    CHECK_NEAR((double)s.failed, 5.0 * p * rows, 3.5 * sqrt(13.0 * p * rows));
    CHECK_NEAR(s.first[0].value, first[0], 0.9 * (s.first[0].upper - s.first[0].lower));
    pdmc_sensitivity_clear(&s);
}

static void without_variance_there_is_no_share_of_it(void **state)
{
    (void)state;
    static const int each[] = {0, 1};
    known_state still = {.dimension = 2, .g = constant, .parameter = {3.0, INFINITY}};
    known_state unsolved = {.dimension = 2, .g = constant, .parameter = {3.0, -INFINITY}};
    pdmc_sensitivity s = find(&still, 2, each, 1, 100);
    assert_true(isnan(s.first[0].value) && isnan(s.total[1].value));
    pdmc_sensitivity_clear(&s);
    s = find(&unsolved, 2, each, 1, 100);
    assert_true(s.failed == s.evaluations && isnan(s.first[0].value) && isnan(s.total[1].value));
    pdmc_sensitivity_clear(&s);
}

static void results_do_not_depend_on_how_g_is_evaluated(void **state)
{
    (void)state;
    known_state lognormal = product_state;
    pdmc_sensitivity want = find(&lognormal, 3, product_group, 7, 3000);
    for (int k = ONE_BY_ONE; k <= IN_THREADS; k++) {
        lognormal.manner = (manner)k;
        pdmc_sensitivity got = find(&lognormal, 3, product_group, 7, 3000);
        assert_memory_equal(got.first, want.first, 3 * sizeof *want.first);
        assert_memory_equal(got.total, want.total, 3 * sizeof *want.total);
        pdmc_sensitivity_clear(&got);
    }
    pdmc_sensitivity_clear(&want);
}

static pdmc_status find_and_clear_on_failure(int groups, const int group[], int samples, pdmc_sensitivity *s)
{
    known_state lognormal = product_state;
    const pdmc_limit_state output = as_limit_state(&lognormal);
    pdmc_sensitivity_options options = pdmc_sensitivity_options_default();
    options.samples = samples;
    const pdmc_status status = pdmc_sensitivity_find(&output, groups, group, &options, s);
    if (status != PDMC_OK) pdmc_sensitivity_clear(s);
    return status;
}

static void errors_are_reported(void **state)
{
    (void)state;
    pdmc_sensitivity s;
    CHECK_FAILS_CLEANLY(find_and_clear_on_failure(3, product_group, 10, &s), pdmc_sensitivity_clear(&s));
    CHECK_STATUS(find_and_clear_on_failure(2, product_group, 10, &s), PDMC_ERR_ARG);
    CHECK_STATUS(find_and_clear_on_failure(0, product_group, 10, &s), PDMC_ERR_ARG);
    CHECK_STATUS(find_and_clear_on_failure(3, product_group, 1, &s), PDMC_ERR_ARG);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closed_forms_are_found),
        cmocka_unit_test(intervals_cover_as_often_as_they_say),
        cmocka_unit_test(all_variables_together_are_everything),
        cmocka_unit_test(what_has_no_influence_is_exactly_nothing),
        cmocka_unit_test(failed_rows_are_left_out),
        cmocka_unit_test(without_variance_there_is_no_share_of_it),
        cmocka_unit_test(results_do_not_depend_on_how_g_is_evaluated),
        cmocka_unit_test(errors_are_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
