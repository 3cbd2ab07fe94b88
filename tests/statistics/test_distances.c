// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/statistics.h"

#include "statistics/samples.h"

#include <float.h>

static double normal_below(double z)
{
    return 0.5 * erfc(-z / sqrt(2.0));
}

/// The 5 % and the 1 % point as all tables have them, the sum at 1 by hand, and 400 terms of it below, where few are
/// not enough.
static void kolmogorov_distribution_of_the_tables(void **state)
{
    (void)state;
    CHECK_NEAR(pdmc_statistics_kolmogorov(1.0), 2.0 * (exp(-2.0) - exp(-8.0) + exp(-18.0)), 3e-14); // the next is e^-32
    CHECK_NEAR(pdmc_statistics_kolmogorov(0.5), 0.9639452436648751, 1e-14);
    CHECK_NEAR(pdmc_statistics_kolmogorov(0.83), 0.49619099535050587, 1e-14);
    CHECK_NEAR(pdmc_statistics_kolmogorov(1.3581), 0.05, 1e-5); // half a digit of the argument
    CHECK_NEAR(pdmc_statistics_kolmogorov(1.6276), 0.01, 1e-5);
    CHECK_NEAR(pdmc_statistics_kolmogorov(0.0), 1.0, 0.0);
    CHECK_NEAR(pdmc_statistics_kolmogorov(100.0), 0.0, 0.0);
    assert_true(isnan(pdmc_statistics_kolmogorov(NAN)));
}

/// The two series are the same function.
static void the_series_meet(void **state)
{
    (void)state;
    const double below = nextafter(1.0, 0.0);
    CHECK_NEAR(pdmc_statistics_kolmogorov(below), pdmc_statistics_kolmogorov(1.0), 8 * DBL_EPSILON);
}

/// Gnedenko & Korolyuk: for n = m, P(D >= k / n) = 2 sum_j (-1)^(j-1) C(2n, n - jk) / C(2n, n).
static void p_is_near_the_exact_one_of_equal_numbers(void **state)
{
    (void)state;
    enum { N = 100, SHIFT = 18 };
    double x[N], y[N], exact = 0.0;
    for (int i = 0; i < N; i++) x[i] = i, y[i] = i + SHIFT - 0.5; // D = SHIFT / N
    pdmc_distances d;
    CHECK_OK(pdmc_statistics_distances(N, x, N, y, false, 0.95, &d));
    CHECK_NEAR(d.kolmogorov_smirnov.value, SHIFT / (double)N, DBL_EPSILON);
    for (int j = 1; j * SHIFT <= N; j++)
        exact += (j % 2 ? 2.0 : -2.0) *
                 exp(2.0 * lgamma(N + 1.0) - lgamma(N + j * SHIFT + 1.0) - lgamma(N - j * SHIFT + 1.0));
    // log C(2n, n - k) / C(2n, n) = -k^2 / n + k^2 / (2 n^2) - k^4 / (6 n^3) ..., here -3.24 + 0.016 - 0.017
    CHECK_NEAR(d.p_value / exact, 1.0, 0.03);
}

static void small_samples_by_hand(void **state)
{
    (void)state;
    static const double x[] = {4, 1, 3, 2}, y[] = {2.5, 3.5, 1.5, 4.5}, far[] = {10, 12}, ties[] = {1, 1, 1, 4};
    pdmc_distances d;
    CHECK_OK(pdmc_statistics_distances(4, x, 4, y, false, 0.95, &d));
    CHECK_NEAR(d.kolmogorov_smirnov.value, 0.25, 0.0);
    CHECK_NEAR(d.wasserstein.value, 0.5, DBL_EPSILON);
    CHECK_OK(pdmc_statistics_distances(4, x, 2, far, false, 0.95, &d));
    CHECK_NEAR(d.kolmogorov_smirnov.value, 1.0, 0.0);
    CHECK_NEAR(d.wasserstein.value, 11.0 - 2.5, 16 * DBL_EPSILON);
    CHECK_OK(pdmc_statistics_distances(4, x, 4, ties, false, 0.95, &d)); // 0.5 on [1, 2], 0.25 on [2, 3]
    CHECK_NEAR(d.kolmogorov_smirnov.value, 0.5, 0.0);
    CHECK_NEAR(d.wasserstein.value, 0.75, 0.0);
}

static double share_up_to(size_t n, const double x[], double limit)
{
    size_t count = 0;
    for (size_t i = 0; i < n; i++) count += x[i] <= limit;
    return (double)count / (double)n;
}

/// By the definition, value by value, with many ties.
static void distances_by_their_definition(void **state)
{
    (void)state;
    enum { N = 40, M = 29, STEPS = 60 };
    double x[N], y[M], most = 0.0, area = 0.0;
    draw_sample(SAMPLE_EXPONENTIAL, 1, N, x);
    draw_sample(SAMPLE_EXPONENTIAL, 2, M, y);
    for (int i = 0; i < N; i++) x[i] = floor(8.0 * x[i]);
    for (int i = 0; i < M; i++) y[i] = floor(6.0 * y[i]);
    for (int k = 0; k < STEPS; k++) {
        const double gap = fabs(share_up_to(N, x, k) - share_up_to(M, y, k));
        most = fmax(most, gap);
        area += gap;
    }
    CHECK_NEAR(share_up_to(N, x, STEPS), 1.0, 0.0);
    CHECK_NEAR(share_up_to(M, y, STEPS), 1.0, 0.0);
    pdmc_distances d, swapped;
    CHECK_OK(pdmc_statistics_distances(N, x, M, y, false, 0.95, &d));
    CHECK_OK(pdmc_statistics_distances(M, y, N, x, false, 0.95, &swapped));
    CHECK_NEAR(d.kolmogorov_smirnov.value, most, 4 * DBL_EPSILON);
    CHECK_NEAR(d.wasserstein.value, area, STEPS * DBL_EPSILON);
    CHECK_NEAR(swapped.kolmogorov_smirnov.value, most, 4 * DBL_EPSILON);
    CHECK_NEAR(swapped.wasserstein.value, area, STEPS * DBL_EPSILON);
}

static void units_do_not_matter(void **state)
{
    (void)state;
    enum { N = 50 };
    double x[N], y[N], u[N], v[N];
    pdmc_distances d, e;
    draw_sample(SAMPLE_LOGNORMAL, 1, N, x);
    draw_sample(SAMPLE_LOGNORMAL, 2, N, y);
    for (int i = 0; i < N; i++) u[i] = 0x1p600 * x[i], v[i] = 0x1p600 * y[i];
    CHECK_OK(pdmc_statistics_distances(N, x, N, y, true, 0.95, &d));
    CHECK_OK(pdmc_statistics_distances(N, u, N, v, true, 0.95, &e));
    assert_memory_equal(&d.kolmogorov_smirnov, &e.kolmogorov_smirnov, sizeof d.kolmogorov_smirnov);
    CHECK_NEAR(e.wasserstein.value / 0x1p600, d.wasserstein.value, 0.0);
    CHECK_NEAR(e.wasserstein.upper / 0x1p600, d.wasserstein.upper, 0.0);
}

static void a_sample_is_where_it_is(void **state)
{
    (void)state;
    enum { N = 100 };
    double x[N];
    pdmc_distances d;
    draw_sample(SAMPLE_NORMAL, 1, N, x);
    CHECK_OK(pdmc_statistics_distances(N, x, N, x, true, 0.95, &d)); // as pairs, the same resamples
    const pdmc_distances zero = {.p_value = 1.0};
    assert_memory_equal(&d, &zero, sizeof d);
    CHECK_OK(pdmc_statistics_distances(N, x, N, x, false, 0.95, &d)); // as if another study had given it
    assert_true(d.kolmogorov_smirnov.value == 0.0 && d.kolmogorov_smirnov.lower == 0.0);
    CHECK_NEAR(d.kolmogorov_smirnov.upper, 1.358 * sqrt(2.0 / N), 0.03); // the 95 % quantile of 999, in steps of 0.01
    CHECK_NEAR(d.p_value, 1.0, 0.0);
}

static void without_samples_nothing_is_known(void **state)
{
    (void)state;
    static const double x[] = {1.0, 2.0};
    pdmc_distances d;
    CHECK_OK(pdmc_statistics_distances(0, x, 2, x, false, 0.95, &d));
    assert_true(isnan(d.kolmogorov_smirnov.value) && isnan(d.p_value) && isnan(d.wasserstein.upper));
    CHECK_STATUS(pdmc_statistics_distances(1, x, 2, x, true, 0.95, &d), PDMC_ERR_ARG);
}

typedef struct {
    double largest, area, refused, half; // shares of intervals that hold the truth, of p <= 0.05, and of p <= 0.5
} coverage;

enum { REPETITIONS = 300, N = 100, M = 60 };

/// Of y = shift + noise: independent of x, or, as pairs, x + shift + 0.2 noise with the mean and deviation of the
/// former.
static coverage measure_coverage(double shift, bool paired)
{
    coverage share = {0};
    const double most = 2.0 * normal_below(0.5 * shift) - 1.0;
    const size_t m = paired ? N : M;
    double x[N], y[N];
    for (uint64_t r = 0; r < REPETITIONS; r++) {
        pdmc_distances d;
        draw_sample(SAMPLE_NORMAL, 2 * r, N, x);
        draw_sample(SAMPLE_NORMAL, 2 * r + 1, m, y);
        for (size_t i = 0; i < m; i++) y[i] = shift + (paired ? sqrt(1.0 - 0.04) * x[i] + 0.2 * y[i] : y[i]);
        CHECK_OK(pdmc_statistics_distances(N, x, m, y, paired, 0.95, &d));
        share.largest +=
            (d.kolmogorov_smirnov.lower <= most && most <= d.kolmogorov_smirnov.upper) / (double)REPETITIONS;
        share.area += (d.wasserstein.lower <= shift && shift <= d.wasserstein.upper) / (double)REPETITIONS;
        share.refused += (d.p_value <= 0.05) / (double)REPETITIONS;
        share.half += (d.p_value <= 0.5) / (double)REPETITIONS;
    }
    return share;
}

/// A share that was never missed in 4000 is taken as 0.99.
static void check_share(double got, double want)
{
    CHECK_NEAR(got, want, repetition_error(fmin(want, 0.99), REPETITIONS));
}

static void check_coverage(const coverage *got, const coverage *want)
{
    check_share(got->largest, want->largest);
    check_share(got->area, want->area);
    check_share(got->refused, want->refused);
    check_share(got->half, want->half);
}

/// What 4000 repetitions have given, as in src/statistics/README.md.
static void intervals_cover_at_no_distance_and_away_from_it(void **state)
{
    (void)state;
    const struct {
        coverage same, apart;
    } measured[] = {
        {{0.942, 0.946, 0.042, 0.442}, {0.977, 0.973, 0.717, 0.978}},
        {{0.973, 0.927, 0.027, 0.476}, {0.985, 1.0, 1.0, 1.0}},
    };
    for (int paired = 0; paired < 2; paired++) {
        const coverage same = measure_coverage(0.0, paired), apart = measure_coverage(0.5, paired);
        check_coverage(&same, &measured[paired].same);
        check_coverage(&apart, &measured[paired].apart);
    }
}

static void refused_memory_is_reported(void **state)
{
    (void)state;
    static const double x[] = {1.0, 2.0, 3.0};
    pdmc_distances d;
    CHECK_FAILS_CLEANLY(pdmc_statistics_distances(3, x, 2, x, false, 0.95, &d), (void)0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(kolmogorov_distribution_of_the_tables),
        cmocka_unit_test(the_series_meet),
        cmocka_unit_test(p_is_near_the_exact_one_of_equal_numbers),
        cmocka_unit_test(small_samples_by_hand),
        cmocka_unit_test(distances_by_their_definition),
        cmocka_unit_test(units_do_not_matter),
        cmocka_unit_test(a_sample_is_where_it_is),
        cmocka_unit_test(without_samples_nothing_is_known),
        cmocka_unit_test(intervals_cover_at_no_distance_and_away_from_it),
        cmocka_unit_test(refused_memory_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
