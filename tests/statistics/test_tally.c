// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/tally.h"

#include "statistics/exact_sum.h"
#include "statistics/samples.h"

#include <float.h>
#include <string.h>

enum { QUANTITIES = 3, BLOCK = 250, BLOCKS = 80, N = BLOCK * BLOCKS, BINS = 50 };

static const double threshold[QUANTITIES] = {1.5, 1.0, 3.0};

/// [QUANTITIES, BLOCK] of a normal, with negative values, a lognormal, and an exponential, which reaches down to 0.
static void draw_block(size_t block, double value[])
{
    static const sample_kind kinds[QUANTITIES] = {SAMPLE_NORMAL, SAMPLE_LOGNORMAL, SAMPLE_EXPONENTIAL};
    for (size_t q = 0; q < QUANTITIES; q++) draw_sample(kinds[q], QUANTITIES * block + q, BLOCK, &value[q * BLOCK]);
}

static pdmc_tally *empty_tally(void)
{
    double pilot[QUANTITIES * BLOCK];
    pdmc_tally *tally = NULL;
    draw_block(0, pilot);
    CHECK_OK(pdmc_tally_create(QUANTITIES, BLOCK, pilot, 1, threshold, &tally));
    return tally;
}

static void add_block(pdmc_tally *tally, size_t block)
{
    double value[QUANTITIES * BLOCK];
    draw_block(block, value);
    CHECK_OK(pdmc_tally_add(tally, BLOCK, BLOCK, value));
}

static pdmc_tally *full_tally(void)
{
    pdmc_tally *tally = empty_tally();
    for (size_t block = 0; block < BLOCKS; block++) add_block(tally, block);
    assert_int_equal(pdmc_tally_samples(tally), N);
    return tally;
}

/// The same samples, kept and sorted.
static double *kept_samples(size_t quantity)
{
    double value[QUANTITIES * BLOCK], *x = pdmc_calloc(N, sizeof *x);
    assert_non_null(x);
    for (size_t block = 0; block < BLOCKS; block++) {
        draw_block(block, value);
        memcpy(&x[block * BLOCK], &value[quantity * BLOCK], BLOCK * sizeof *x);
    }
    sort_sample(N, x);
    return x;
}

static void check_moments(const pdmc_tally *tally, size_t quantity, const double x[])
{
    pdmc_estimate mean, deviation, want_mean, want_deviation;
    pdmc_tally_moments(tally, quantity, 0.95, &mean, &deviation);
    pdmc_statistics_moments(N, x, 0.95, &want_mean, &want_deviation);
    const double rounding = 64 * DBL_EPSILON; // of sums in blocks, which have tens of additions a lane
    CHECK_NEAR(mean.value, want_mean.value, rounding);
    CHECK_NEAR(mean.lower, want_mean.lower, rounding);
    CHECK_NEAR(mean.upper, want_mean.upper, rounding);
    CHECK_NEAR(deviation.value, want_deviation.value, rounding);
    // the jackknife shifts log s by kurtosis / (4 n), and kurtosis <= 9 here; its width differs less
    CHECK_NEAR(log(deviation.lower / want_deviation.lower), 0.0, 4.0 / N);
    CHECK_NEAR(log(deviation.upper / want_deviation.upper), 0.0, 4.0 / N);
}

static void check_quantiles(const pdmc_tally *tally, size_t quantity, const double x[])
{
    static const double levels[] = {0.0, 1e-4, 0.01, 0.25, 0.5, 0.9, 0.999, 1.0};
    for (size_t k = 0; k < sizeof levels / sizeof levels[0]; k++) {
        const pdmc_estimate got = pdmc_tally_quantile(tally, quantity, levels[k], 0.95);
        const pdmc_estimate want = pdmc_statistics_quantile(N, x, levels[k], 0.95);
        CHECK_NEAR(got.value, want.value, 0x1p-12 * fabs(want.value));
        assert_true(got.lower <= want.lower && want.upper <= got.upper);
        assert_true(isinf(want.lower) == isinf(got.lower) && isinf(want.upper) == isinf(got.upper));
        if (isfinite(want.lower)) CHECK_NEAR(got.lower, want.lower, 0x1p-11 * fabs(want.lower));
        if (isfinite(want.upper)) CHECK_NEAR(got.upper, want.upper, 0x1p-11 * fabs(want.upper));
    }
}

static bool is_inside(double x, double low, double high)
{
    return x < 0.0 ? low < x && x <= high : low <= x && x < high;
}

static void check_histogram(const pdmc_tally *tally, size_t quantity, const double x[])
{
    double edges[BINS + 1], want_edges[BINS + 1];
    int64_t counts[BINS + 2], want_counts[BINS + 2], total = 0;
    pdmc_estimate density[BINS], want[BINS];
    pdmc_tally_histogram(tally, quantity, BINS, 0.95, edges, counts, density);
    pdmc_statistics_histogram(N, x, BINS, 0.95, want_edges, want_counts, want);
    const double size = fmax(fabs(want_edges[0]), fabs(want_edges[BINS])); // of it, quantiles are off by 2^-12
    for (int b = 0; b <= BINS; b++) CHECK_NEAR(edges[b], want_edges[b], 2 * 0x1p-12 * size);
    for (int b = 0; b < BINS + 2; b++) {
        const double low = b > 0 ? edges[b - 1] : -INFINITY, high = b <= BINS ? edges[b] : INFINITY;
        int64_t count = 0;
        for (size_t i = 0; i < N; i++) count += is_inside(x[i], low, high);
        assert_int_equal(counts[b], count);
        total += counts[b];
        if (b == 0 || b > BINS) continue;
        const pdmc_estimate p = pdmc_statistics_proportion((size_t)count, N, 0.95);
        CHECK_NEAR(density[b - 1].value * (high - low), p.value, 4 * DBL_EPSILON);
        CHECK_NEAR(density[b - 1].upper * (high - low), p.upper, 4 * DBL_EPSILON);
    }
    assert_int_equal(total, N);
}

static void check_exceedance(const pdmc_tally *tally, size_t quantity, const double x[])
{
    size_t above = 0;
    for (size_t i = 0; i < N; i++) above += x[i] > threshold[quantity];
    assert_true(above > 0 && above < N);
    const pdmc_estimate got = pdmc_tally_exceedance(tally, quantity, 0, 0.95);
    const pdmc_estimate want = pdmc_statistics_proportion(above, N, 0.95);
    assert_memory_equal(&got, &want, sizeof got);
}

static void a_tally_says_what_the_samples_say(void **state)
{
    (void)state;
    pdmc_tally *tally = full_tally();
    for (size_t q = 0; q < QUANTITIES; q++) {
        double *x = kept_samples(q);
        check_moments(tally, q, x);
        check_quantiles(tally, q, x);
        check_histogram(tally, q, x);
        check_exceedance(tally, q, x);
        pdmc_free(x);
    }
    pdmc_tally_destroy(&tally);
    assert_null(tally);
}

static void check_same_bits(const pdmc_tally *a, const pdmc_tally *b)
{
    assert_int_equal(pdmc_tally_samples(a), pdmc_tally_samples(b));
    for (size_t q = 0; q < QUANTITIES; q++) {
        pdmc_estimate x[5], y[5];
        pdmc_tally_moments(a, q, 0.95, &x[0], &x[1]);
        pdmc_tally_moments(b, q, 0.95, &y[0], &y[1]);
        x[2] = pdmc_tally_quantile(a, q, 0.5, 0.95), y[2] = pdmc_tally_quantile(b, q, 0.5, 0.95);
        x[3] = pdmc_tally_quantile(a, q, 1e-3, 0.95), y[3] = pdmc_tally_quantile(b, q, 1e-3, 0.95);
        x[4] = pdmc_tally_exceedance(a, q, 0, 0.95), y[4] = pdmc_tally_exceedance(b, q, 0, 0.95);
        assert_memory_equal(x, y, sizeof x);
    }
}

/// Blocks in any order, by as many threads as there are tallies, which are merged from either end.
static void neither_order_nor_threads_change_a_bit(void **state)
{
    (void)state;
    enum { MOST = 4 };
    pdmc_tally *whole = full_tally();
    for (int threads = 1; threads <= MOST; threads++) {
        pdmc_tally *part[MOST], *merged = empty_tally();
        for (int t = 0; t < threads; t++) part[t] = empty_tally();
#pragma omp parallel for num_threads(threads) schedule(static, 1)
        for (int t = 0; t < threads; t++)
            for (size_t k = (size_t)t; k < BLOCKS; k += (size_t)threads)
                add_block(part[t], threads % 2 ? BLOCKS - 1 - k : (7 * k) % BLOCKS); // 7 and 80 have no common factor
        for (int t = 0; t < threads; t++) CHECK_OK(pdmc_tally_merge(merged, part[threads % 3 ? t : threads - 1 - t]));
        check_same_bits(merged, whole);
        for (int t = 0; t < threads; t++) pdmc_tally_destroy(&part[t]);
        pdmc_tally_destroy(&merged);
    }
    pdmc_tally_destroy(&whole);
}

static void units_change_nothing(void **state)
{
    (void)state;
    double value[QUANTITIES * BLOCK];
    draw_block(0, value);
    pdmc_tally *tally = NULL;
    pdmc_estimate want_mean, want_deviation, mean, deviation;
    CHECK_OK(pdmc_tally_create(1, BLOCK, value, 0, NULL, &tally));
    CHECK_OK(pdmc_tally_add(tally, BLOCK, BLOCK, value));
    pdmc_tally_moments(tally, 0, 0.95, &want_mean, &want_deviation);
    pdmc_tally_destroy(&tally);
    for (int e = -600; e <= 600; e += 1200) { // of which the squares do not exist
        double scaled[BLOCK];
        for (int i = 0; i < BLOCK; i++) scaled[i] = ldexp(value[i], e);
        CHECK_OK(pdmc_tally_create(1, BLOCK, scaled, 0, NULL, &tally));
        CHECK_OK(pdmc_tally_add(tally, BLOCK, BLOCK, scaled));
        pdmc_tally_moments(tally, 0, 0.95, &mean, &deviation);
        CHECK_NEAR(ldexp(mean.value, -e), want_mean.value, 0.0);
        CHECK_NEAR(ldexp(deviation.value, -e), want_deviation.value, 0.0);
        CHECK_NEAR(ldexp(deviation.upper, -e), want_deviation.upper, 0.0);
        pdmc_tally_destroy(&tally);
    }
}

/// The bins hold every double; with the sums' unit that of the largest, so are the sums.
static void values_of_all_sizes_are_in_order(void **state)
{
    (void)state;
    static const double x[] = {-1e307, -2.0, -1e-300, -0.0, 0.0, 5e-324, 1e-310, 1e-300, 1.0, 1e300, 1e307};
    enum { COUNT = sizeof x / sizeof x[0] };
    double edges[4];
    int64_t counts[5];
    pdmc_estimate density[3];
    pdmc_tally *tally = NULL;
    CHECK_OK(pdmc_tally_create(1, 1, &x[COUNT - 1], 0, NULL, &tally));
    CHECK_OK(pdmc_tally_add(tally, COUNT, COUNT, x));
    for (int k = 0; k < COUNT; k++) {
        const pdmc_estimate quantile = pdmc_tally_quantile(tally, 0, (k + 1.0) / COUNT, 0.95);
        CHECK_NEAR(quantile.value, fabs(x[k]) < DBL_MIN ? 0.0 : x[k], 0x1p-12 * fabs(x[k]));
    }
    pdmc_tally_histogram(tally, 0, 3, 0.95, edges, counts, density);
    assert_int_equal(counts[0] + counts[1] + counts[2] + counts[3] + counts[4], COUNT);
    assert_true(edges[0] < edges[1] && edges[1] < edges[2] && edges[2] < edges[3]);
    pdmc_tally_destroy(&tally);
}

static void values_that_are_not_finite_are_refused(void **state)
{
    (void)state;
    static const double bad[] = {INFINITY, -INFINITY, NAN, 1e200}; // of the last, z^4 is infinite
    pdmc_tally *tally = NULL;
    for (int k = 0; k < 4; k++) {
        const double x[] = {1.0, 2.0, bad[k], 3.0};
        CHECK_OK(pdmc_tally_create(1, 2, x, 0, NULL, &tally));
        CHECK_STATUS(pdmc_tally_add(tally, 4, 4, x), PDMC_ERR_DATA);
        pdmc_tally_destroy(&tally);
    }
    const double x[] = {1.0, INFINITY};
    CHECK_STATUS(pdmc_tally_create(1, 2, x, 0, NULL, &tally), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_tally_create(0, 2, x, 0, NULL, &tally), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_tally_create(1, 0, x, 0, NULL, &tally), PDMC_ERR_ARG);
    assert_null(tally);
}

static void samples_without_spread_are_a_point(void **state)
{
    (void)state;
    static const double values[] = {0.1, 0.0, -7.0};
    for (int k = 0; k < 3; k++) {
        double x[100], edges[3];
        int64_t counts[4];
        pdmc_estimate mean, deviation, density[2];
        pdmc_tally *tally = NULL;
        for (int i = 0; i < 100; i++) x[i] = values[k];
        CHECK_OK(pdmc_tally_create(1, 10, x, 0, NULL, &tally));
        for (int i = 0; i < 3; i++) CHECK_OK(pdmc_tally_add(tally, 100, 100, x));
        pdmc_tally_moments(tally, 0, 0.95, &mean, &deviation);
        CHECK_NEAR(mean.value, values[k], 0.0);
        CHECK_NEAR(mean.upper - mean.lower, 0.0, 0.0);
        CHECK_NEAR(deviation.upper, 0.0, 0.0);
        CHECK_NEAR(pdmc_tally_quantile(tally, 0, 0.5, 0.95).value, values[k], 0x1p-12 * fabs(values[k]));
        pdmc_tally_histogram(tally, 0, 2, 0.95, edges, counts, density);
        assert_int_equal(counts[1] + counts[2], 300);
        pdmc_tally_destroy(&tally);
    }
}

/// Bins cannot be narrower than the tally's.
static void a_narrow_sample_has_wide_bins(void **state)
{
    (void)state;
    double x[1000], edges[BINS + 1];
    int64_t counts[BINS + 2], total = 0;
    pdmc_estimate density[BINS];
    for (int sign = -1; sign <= 1; sign += 2) {
        pdmc_tally *tally = NULL;
        for (int i = 0; i < 1000; i++) x[i] = sign * (1.0 + 2e-6 * i);
        CHECK_OK(pdmc_tally_create(1, 1000, x, 0, NULL, &tally));
        CHECK_OK(pdmc_tally_add(tally, 1000, 1000, x));
        pdmc_tally_histogram(tally, 0, BINS, 0.95, edges, counts, density);
        for (int b = 0; b < BINS; b++) assert_true(edges[b + 1] - edges[b] >= 0x1p-12);
        for (int b = 1; b <= BINS; b++) total += counts[b];
        pdmc_tally_destroy(&tally);
    }
    assert_int_equal(total, 2000);
}

static void what_too_few_samples_cannot_tell_is_nan(void **state)
{
    (void)state;
    static const double x[] = {3.0, 5.0};
    double edges[2];
    int64_t counts[3];
    pdmc_estimate mean, deviation, density[1];
    pdmc_tally *tally = NULL;
    CHECK_OK(pdmc_tally_create(1, 2, x, 0, NULL, &tally));
    pdmc_tally_moments(tally, 0, 0.95, &mean, &deviation);
    pdmc_tally_histogram(tally, 0, 1, 0.95, edges, counts, density);
    assert_true(isnan(mean.value) && isnan(deviation.value) && isnan(density[0].value));
    assert_true(isnan(pdmc_tally_quantile(tally, 0, 0.5, 0.95).value));
    CHECK_OK(pdmc_tally_add(tally, 1, 2, x));
    pdmc_tally_moments(tally, 0, 0.95, &mean, &deviation);
    assert_true(mean.value == 3.0 && isnan(mean.lower) && isnan(deviation.value));
    CHECK_OK(pdmc_tally_add(tally, 1, 1, &x[1]));
    pdmc_tally_moments(tally, 0, 0.95, &mean, &deviation);
    CHECK_NEAR(mean.value, 4.0, 0.0);
    CHECK_NEAR(deviation.value, sqrt(2.0), 4 * DBL_EPSILON);
    assert_true(mean.lower < 3.0 && isnan(deviation.lower));
    pdmc_tally_destroy(&tally);
}

static void tallies_that_differ_are_not_merged(void **state)
{
    (void)state;
    static const double x[] = {3.0, 5.0, 8.0}, limits[] = {1.0, 2.0};
    pdmc_tally *tally = NULL, *other = NULL;
    CHECK_OK(pdmc_tally_create(1, 2, x, 1, limits, &tally));
    CHECK_OK(pdmc_tally_create(1, 3, x, 1, limits, &other));
    CHECK_STATUS(pdmc_tally_merge(tally, other), PDMC_ERR_ARG);
    pdmc_tally_destroy(&other);
    CHECK_OK(pdmc_tally_create(1, 2, x, 1, &limits[1], &other));
    CHECK_STATUS(pdmc_tally_merge(tally, other), PDMC_ERR_ARG);
    pdmc_tally_destroy(&other);
    CHECK_STATUS(pdmc_tally_add(tally, 3, 2, x), PDMC_ERR_ARG);
    CHECK_STATUS(pdmc_tally_add(tally, (size_t)UINT32_MAX + 1, (size_t)UINT32_MAX + 1, x), PDMC_ERR_ARG);
    pdmc_tally_destroy(&tally);
    pdmc_tally_destroy(&tally);
}

static pdmc_status use_tallies(void)
{
    static const double x[] = {0.3, 5.0, -8.0}, limits[] = {1.0};
    pdmc_status status = PDMC_OK;
    pdmc_tally *tally = NULL, *other = NULL;
    PDMC_TRY(pdmc_tally_create(1, 3, x, 1, limits, &tally));
    PDMC_TRY(pdmc_tally_create(1, 3, x, 1, limits, &other));
    PDMC_TRY(pdmc_tally_add(other, 3, 3, x));
    PDMC_TRY(pdmc_tally_merge(tally, other));

done:
    pdmc_tally_destroy(&tally);
    pdmc_tally_destroy(&other);
    return status;
}

static void no_memory_is_reported(void **state)
{
    (void)state;
    CHECK_FAILS_CLEANLY(use_tallies(), (void)0);
}

static double exact_sum_of(size_t n, const double x[])
{
    pdmc_exact_sum *sum = pdmc_calloc(1, sizeof *sum), *rest = pdmc_calloc(1, sizeof *rest);
    assert_true(sum && rest);
    for (size_t i = 0; i < n; i++) pdmc_exact_sum_add(i % 2 ? sum : rest, x[i]);
    pdmc_exact_sum_join(sum, rest);
    const double value = pdmc_exact_sum_value(sum);
    pdmc_free(sum);
    pdmc_free(rest);
    return value;
}

static void exact_sums_lose_nothing(void **state)
{
    (void)state;
    static const double cancelling[] = {1e308, 1.0, -1e308, 1e-300, -1.0};
    CHECK_NEAR(exact_sum_of(5, cancelling), 1e-300, 0.0);
    static const double negative[] = {5e-324, -1e300, 1e300, -1e-323, 0.0};
    CHECK_NEAR(exact_sum_of(5, negative), -5e-324, 0.0);
    static const double beyond[] = {-DBL_MAX, -DBL_MAX, DBL_MAX, DBL_MIN};
    CHECK_NEAR(exact_sum_of(4, beyond), -DBL_MAX, 0.0);
    double powers[2098];
    for (int e = 0; e < 2098; e++) powers[e] = ldexp(e % 3 ? 1.0 : -1.0, e - 1074);
    const double want = ldexp(-2.0 / 7.0, 1023); // (-1 + 1/2 + 1/4) (1 + 1/8 + 1/64 + ...)
    CHECK_NEAR(exact_sum_of(2098, powers) / want, 1.0, DBL_EPSILON);
    for (int e = 0; e < 2098; e++) powers[e] = 0.1; // 2098 times the double, whose product is rounded once
    CHECK_NEAR(exact_sum_of(2098, powers), 2098 * 0.1, 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_tally_says_what_the_samples_say),
        cmocka_unit_test(neither_order_nor_threads_change_a_bit),
        cmocka_unit_test(units_change_nothing),
        cmocka_unit_test(values_of_all_sizes_are_in_order),
        cmocka_unit_test(values_that_are_not_finite_are_refused),
        cmocka_unit_test(samples_without_spread_are_a_point),
        cmocka_unit_test(a_narrow_sample_has_wide_bins),
        cmocka_unit_test(what_too_few_samples_cannot_tell_is_nan),
        cmocka_unit_test(tallies_that_differ_are_not_merged),
        cmocka_unit_test(no_memory_is_reported),
        cmocka_unit_test(exact_sums_lose_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
