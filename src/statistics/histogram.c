// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/histogram.h"

#include <float.h>
#include <math.h>

/// The width of bins from `low` to `high` and a half-bin beyond on each side.
static double bin_width(double low, double high, int bins)
{
    const double width = (high - low) / (bins > 1 ? bins - 1 : 0.5);
    const double magnitude = fmax(fabs(low), fabs(high));
    if (width > 1e-12 * magnitude) return width; // else the edges could not be told apart
    return magnitude > 1e3 * DBL_MIN ? 1e-3 * magnitude : 1.0;
}

/// Sorted samples are counted from edge to edge, so that each is counted once whatever the edges are.
static void count_bins(size_t n, const double sorted[], int bins, const double edges[], int64_t counts[])
{
    size_t i = 0;
    for (int b = 0; b <= bins; b++) {
        const size_t first = i;
        while (i < n && sorted[i] < edges[b]) i++;
        counts[b] = (int64_t)(i - first);
    }
    counts[bins + 1] = (int64_t)(n - i);
}

pdmc_estimate pdmc_statistics_bin_density(int64_t count, size_t n, double width, double confidence)
{
    const pdmc_estimate p = pdmc_statistics_proportion((size_t)count, n, confidence);
    return (pdmc_estimate){p.value / width, p.lower / width, p.upper / width};
}

void pdmc_statistics_histogram_edges(double low, double high, int bins, double edges[])
{
    const double width = bin_width(low, high, bins), middle = low + 0.5 * (high - low);
    for (int b = 0; b <= bins; b++) edges[b] = middle + (b - 0.5 * bins) * width;
}

void pdmc_statistics_histogram(size_t n, const double sorted[], int bins, double confidence, double edges[],
                               int64_t counts[], pdmc_estimate density[])
{
    const double low = pdmc_statistics_quantile(n, sorted, 0.001, confidence).value;
    const double high = pdmc_statistics_quantile(n, sorted, 0.999, confidence).value;
    const double width = bin_width(low, high, bins);
    pdmc_statistics_histogram_edges(low, high, bins, edges);
    count_bins(n, sorted, bins, edges, counts);
    for (int b = 0; b < bins; b++) density[b] = pdmc_statistics_bin_density(counts[b + 1], n, width, confidence);
}
