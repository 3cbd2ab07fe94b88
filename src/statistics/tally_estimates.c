// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/histogram.h"
#include "statistics/quantile.h"
#include "statistics/tally_impl.h"

#include <float.h>
#include <gsl/gsl_cdf.h>
#include <math.h>
#include <stdlib.h>

static const pdmc_estimate unknown = {NAN, NAN, NAN};

/// Mean, variance (with n) and kurtosis of z from the sums of its powers.
typedef struct {
    double mean, variance, kurtosis;
} central_moments;

static central_moments moments_of(const pdmc_tally_quantity *quantity, double n)
{
    double m[TALLY_POWERS]; // about the shift
    for (int k = 0; k < TALLY_POWERS; k++) m[k] = pdmc_exact_sum_value(&quantity->power[k]) / n;
    const double mean = m[0], square = mean * mean, variance = fmax(m[1] - square, 0.0);
    const double fourth = m[3] - 4.0 * mean * m[2] + 6.0 * square * m[1] - 3.0 * square * square;
    return (central_moments){mean, variance, fmax(fourth / (variance * variance), 1.0)};
}

void pdmc_tally_moments(const pdmc_tally *tally, size_t quantity, double confidence, pdmc_estimate *mean,
                        pdmc_estimate *deviation)
{
    const pdmc_tally_quantity *q = &tally->quantity[quantity];
    const double n = (double)tally->samples;
    *mean = *deviation = unknown;
    if (n < 1.0) return;
    const central_moments z = moments_of(q, n);
    mean->value = q->shift + z.mean / q->scale;
    if (n < 2.0) return;

    const double s = sqrt(z.variance * n / (n - 1.0)) / q->scale;
    const double t = gsl_cdf_tdist_Qinv(0.5 * (1.0 - confidence), n - 1.0);
    mean->lower = mean->value - t * s / sqrt(n);
    mean->upper = mean->value + t * s / sqrt(n);
    *deviation = s > 0.0 ? (pdmc_estimate){s, NAN, NAN} : (pdmc_estimate){0.0, 0.0, 0.0};
    if (n < 3.0 || s == 0.0) return;
    const double factor = exp(0.5 * t * sqrt((z.kurtosis - 1.0) / n));
    deviation->lower = s / factor;
    deviation->upper = s * factor;
}

/// The lower edge of a bin, which is the upper edge of the one below.
static double edge_below(int64_t bin)
{
    const uint64_t bits = (uint64_t)llabs(bin - TALLY_ZERO) << TALLY_DROPPED_BITS;
    double magnitude;
    memcpy(&magnitude, &bits, sizeof magnitude);
    return copysign(fmin(magnitude, DBL_MAX), (double)(bin - TALLY_ZERO));
}

/// The bin that begins at an edge, edge_below()'s inverse.
static int64_t bin_from(double edge)
{
    return edge < 0.0 ? (int64_t)pdmc_tally_bin(edge) + 1 : (int64_t)pdmc_tally_bin(edge);
}

/// The edge nearest to x.
static double nearest_edge(double x)
{
    const int64_t bin = pdmc_tally_bin(x);
    const double below = edge_below(bin), above = edge_below(bin + 1);
    return x - below <= above - x ? below : above;
}

/// The bin of an order statistic.
/// @param[in] rank  in [1, n]
static int64_t bin_of_rank(const pdmc_tally_quantity *quantity, size_t rank)
{
    size_t seen = 0;
    for (int64_t p = 0; p < TALLY_PAGES; p++) {
        for (int64_t b = 0; quantity->page[p] && b < TALLY_PAGE_BINS; b++) {
            seen += quantity->page[p][b];
            if (seen >= rank) return p * TALLY_PAGE_BINS + b;
        }
    }
    return (int64_t)TALLY_PAGES * TALLY_PAGE_BINS;
}

/// The bin of a zero has an edge that is not, but is no number of interest either.
static double flushed(double x)
{
    return fabs(x) < DBL_MIN ? 0.0 : x;
}

pdmc_estimate pdmc_tally_quantile(const pdmc_tally *tally, size_t quantity, double p, double confidence)
{
    const pdmc_tally_quantity *q = &tally->quantity[quantity];
    const size_t n = tally->samples;
    if (n == 0) return unknown;
    const pdmc_quantile_ranks rank = pdmc_statistics_quantile_ranks(n, p, confidence);
    const int64_t bin = bin_of_rank(q, rank.value);
    return (pdmc_estimate){
        .value = flushed(0.5 * edge_below(bin) + 0.5 * edge_below(bin + 1)),
        .lower = rank.lower > 0 ? flushed(edge_below(bin_of_rank(q, rank.lower))) : -INFINITY,
        .upper = rank.upper <= n ? flushed(edge_below(bin_of_rank(q, rank.upper) + 1)) : INFINITY,
    };
}

/// Moves edges to those of the tally's bins, each above the one before.
static void align_edges(int bins, double edges[])
{
    for (int b = 0; b <= bins; b++) {
        edges[b] = nearest_edge(edges[b]);
        if (b > 0 && edges[b] <= edges[b - 1]) edges[b] = edge_below(bin_from(edges[b - 1]) + 1);
    }
}

static void count_between(const pdmc_tally_quantity *quantity, int bins, const double edges[], int64_t counts[])
{
    int place = 0;
    for (int b = 0; b < bins + 2; b++) counts[b] = 0;
    for (int64_t p = 0; p < TALLY_PAGES; p++) {
        for (int64_t b = 0; quantity->page[p] && b < TALLY_PAGE_BINS; b++) {
            while (place <= bins && bin_from(edges[place]) <= p * TALLY_PAGE_BINS + b) place++;
            counts[place] += quantity->page[p][b];
        }
    }
}

void pdmc_tally_histogram(const pdmc_tally *tally, size_t quantity, int bins, double confidence, double edges[],
                          int64_t counts[], pdmc_estimate density[])
{
    const double low = pdmc_tally_quantile(tally, quantity, 0.001, confidence).value;
    const double high = pdmc_tally_quantile(tally, quantity, 0.999, confidence).value;
    const bool is_empty = tally->samples == 0;
    pdmc_statistics_histogram_edges(is_empty ? 0.0 : low, is_empty ? 0.0 : high, bins, edges);
    align_edges(bins, edges);
    count_between(&tally->quantity[quantity], bins, edges, counts);
    for (int b = 0; b < bins; b++) {
        const double width = edges[b + 1] - edges[b];
        density[b] = is_empty ? unknown : pdmc_statistics_bin_density(counts[b + 1], tally->samples, width, confidence);
    }
}

pdmc_estimate pdmc_tally_exceedance(const pdmc_tally *tally, size_t quantity, size_t threshold, double confidence)
{
    const size_t above = tally->above[quantity * tally->thresholds + threshold];
    return pdmc_statistics_proportion(above, tally->samples, confidence);
}
