// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/statistics.h"

#include "statistics/samples.h"

#include <float.h>

enum { MOST_BINS = 200 };

typedef struct {
    double edges[MOST_BINS + 1];
    int64_t counts[MOST_BINS + 2];
    pdmc_estimate density[MOST_BINS];
} histogram;

/// The histogram of a sample, with what must hold of every histogram: ascending edges, each sample in the one place
/// where its edges are, and densities that are its counts.
static histogram checked_histogram(size_t n, const double sorted[], int bins)
{
    histogram h;
    pdmc_statistics_histogram(n, sorted, bins, 0.95, h.edges, h.counts, h.density);
    int64_t total = h.counts[0] + h.counts[bins + 1];
    for (int b = 0; b < bins; b++) {
        assert_true(h.edges[b] < h.edges[b + 1]);
        int64_t count = 0;
        for (size_t i = 0; i < n; i++) count += h.edges[b] <= sorted[i] && sorted[i] < h.edges[b + 1];
        assert_int_equal(h.counts[b + 1], count);
        total += count;
        const double width = (h.edges[bins] - h.edges[0]) / bins;
        const pdmc_estimate p = pdmc_statistics_proportion((size_t)count, n, 0.95);
        CHECK_NEAR(h.density[b].value * width, p.value,
                   1e-3 * p.value); // edges may be close, 1e-12 of x
        CHECK_NEAR(h.density[b].lower * width, p.lower, 1e-3 * p.lower);
        CHECK_NEAR(h.density[b].upper * width, p.upper, 1e-3 * p.upper);
    }
    assert_int_equal(total, (int64_t)n);
    return h;
}

static void four_bins_by_hand(void **state)
{
    (void)state;
    static const double sorted[] = {0, 1, 1, 2, 3, 3};
    const histogram h = checked_histogram(6, sorted, 4); // of width (3 - 0) / (4 - 1) from -1/2
    static const int64_t want[] = {0, 1, 2, 1, 2, 0};
    for (int b = 0; b <= 4; b++) CHECK_NEAR(h.edges[b], b - 0.5, 4 * DBL_EPSILON);
    for (int b = 0; b < 6; b++) assert_int_equal(h.counts[b], want[b]);
    CHECK_NEAR(h.density[1].value, 2.0 / 6.0, 4 * DBL_EPSILON);
}

static void one_bin_holds_what_the_quantiles_hold(void **state)
{
    (void)state;
    static const double sorted[] = {2, 3, 6};
    const histogram h = checked_histogram(3, sorted, 1);
    CHECK_NEAR(h.edges[0], 0.0, 0.0);
    CHECK_NEAR(h.edges[1], 8.0, 0.0);
    assert_int_equal(h.counts[1], 3);
}

static void a_sample_without_spread_is_counted(void **state)
{
    (void)state;
    static const double values[] = {0.0, 5e-324, 0.1, -7e250, 1e-300, 1.7e308};
    for (int k = 0; k < 6; k++) {
        double sorted[20];
        for (int i = 0; i < 20; i++) sorted[i] = values[k];
        for (int bins = 1; bins <= 5; bins++) {
            const histogram h = checked_histogram(20, sorted, bins);
            assert_int_equal(h.counts[0] + h.counts[bins + 1], 0);
        }
        checked_histogram(1, sorted, 10);
    }
}

/// Spread of a few last bits cannot be resolved; ten thousand of them can.
static void a_spread_of_rounding_is_none(void **state)
{
    (void)state;
    double sorted[30];
    for (int i = 0; i < 30; i++) sorted[i] = 1.0 + i * DBL_EPSILON;
    const histogram noise = checked_histogram(30, sorted, 20);
    CHECK_NEAR(noise.edges[1] - noise.edges[0], 1e-3, 1e-12);
    for (int i = 0; i < 30; i++) sorted[i] = 1.0 + i * 1e4 * DBL_EPSILON;
    const histogram fine = checked_histogram(30, sorted, 20);
    assert_true(fine.edges[20] - fine.edges[0] < 1e-9);
}

static void ties_at_edges_are_counted_once(void **state)
{
    (void)state;
    double sorted[1000];
    for (int i = 0; i < 1000; i++) sorted[i] = i / 100; // 0, 0, ... 9
    for (int bins = 1; bins <= 40; bins++) checked_histogram(1000, sorted, bins);
}

static void outliers_are_kept_outside(void **state)
{
    (void)state;
    enum { N = 5000 };
    double sorted[N];
    draw_sample(SAMPLE_NORMAL, 0, N, sorted);
    sorted[0] = -1e6;
    sorted[1] = 1e6;
    sort_sample(N, sorted);
    const histogram h = checked_histogram(N, sorted, 50);
    assert_true(h.counts[0] >= 1 && h.counts[0] <= 5);
    assert_true(h.counts[51] >= 1 && h.counts[51] <= 5);
    assert_true(h.edges[0] > -4.5 && h.edges[50] < 4.5);
}

/// A bin's interval covers the mean density of the bin as often as it says, or more; that the edges are the sample's
/// own quantiles is no matter away from the ends. The tolerance is that of 1000 repetitions.
static void densities_cover_the_truth(void **state)
{
    (void)state;
    enum { N = 200, BINS = 12, REPETITIONS = 1000 };
    int hits = 0;
    for (uint64_t r = 0; r < REPETITIONS; r++) {
        double x[N];
        draw_sample(SAMPLE_EXPONENTIAL, r, N, x);
        sort_sample(N, x);
        histogram h;
        pdmc_statistics_histogram(N, x, BINS, 0.95, h.edges, h.counts, h.density);
        const double a = h.edges[3], b = h.edges[4], truth = (exp(-a) - exp(-b)) / (b - a);
        hits += h.density[3].lower <= truth && truth <= h.density[3].upper;
    }
    assert_true((double)hits / REPETITIONS >= 0.95 - repetition_error(0.95, REPETITIONS));
    assert_true(hits < REPETITIONS);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(four_bins_by_hand),
        cmocka_unit_test(one_bin_holds_what_the_quantiles_hold),
        cmocka_unit_test(a_sample_without_spread_is_counted),
        cmocka_unit_test(a_spread_of_rounding_is_none),
        cmocka_unit_test(ties_at_edges_are_counted_once),
        cmocka_unit_test(outliers_are_kept_outside),
        cmocka_unit_test(densities_cover_the_truth),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
