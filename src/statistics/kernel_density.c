// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "pdmc/statistics.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>

static const double group_width = 1.0 / 16.0; // in bandwidths: lessens the kernel's variance by less than 1 / 3000
static const double reach = 8.5;              // in bandwidths, where the kernel is below the rounding of its middle

/// Samples that lie together, of which the kernel sees the mean only.
typedef struct {
    double centre, weight;
} sample_group;

double pdmc_statistics_bandwidth(size_t n, const double sorted[])
{
    pdmc_estimate mean, deviation;
    pdmc_statistics_moments(n, sorted, 0.5, &mean, &deviation);
    const double quartiles = gsl_stats_quantile_from_sorted_data(sorted, 1, n, 0.75) -
                             gsl_stats_quantile_from_sorted_data(sorted, 1, n, 0.25);
    double spread = deviation.value;
    if (quartiles > 0.0) spread = fmin(spread, quartiles / 1.34);
    if (spread > 0.0) return 0.9 * spread * pow((double)n, -0.2);
    return mean.value != 0.0 ? 1e-3 * fabs(mean.value) : 1.0; // the bins of pdmc_statistics_histogram()
}

/// @param[out] group  [n], ascending
/// @return the number of groups
static size_t gather(size_t n, const double sorted[], double width, sample_group group[])
{
    size_t groups = 0;
    for (size_t first = 0, next; first < n; first = next) {
        double sum = 0.0;
        for (next = first; next < n && sorted[next] - sorted[first] <= width; next++)
            sum += sorted[next] - sorted[first];
        const double count = (double)(next - first);
        group[groups++] = (sample_group){.centre = sorted[first] + sum / count, .weight = count / (double)n};
    }
    return groups;
}

/// The first group at x or above.
static size_t first_from(size_t groups, const sample_group group[], double x)
{
    size_t low = 0, high = groups;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (group[middle].centre < x) low = middle + 1;
        else high = middle;
    }
    return low;
}

static double smoothed(size_t groups, const sample_group group[], double bandwidth, double x)
{
    double sum = 0.0;
    for (size_t g = first_from(groups, group, x - reach * bandwidth); g < groups; g++) {
        const double u = (group[g].centre - x) / bandwidth;
        if (u > reach) break;
        sum += group[g].weight * exp(-0.5 * u * u);
    }
    return sum / (sqrt(2.0 * M_PI) * bandwidth);
}

pdmc_status pdmc_statistics_kernel_density(size_t n, const double sorted[], double bandwidth, bool positive,
                                           double confidence, size_t points, const double at[], pdmc_estimate density[])
{
    PDMC_REQUIRE(n > 0, "a density of no samples");
    PDMC_REQUIRE(bandwidth > 0.0 && isfinite(bandwidth), "bandwidth = %g is not above 0", bandwidth);
    PDMC_REQUIRE(!positive || sorted[0] >= 0.0, "a sample is %g, below 0", sorted[0]);
    pdmc_status status = PDMC_OK;
    sample_group *group = NULL; // [groups]
    PDMC_NEW(group, n);
    const size_t groups = gather(n, sorted, group_width * bandwidth, group);
    const double z = gsl_cdf_ugaussian_Qinv(0.5 * (1.0 - confidence));
    const double roughness = 0.5 / sqrt(M_PI) / bandwidth; // the integral of the kernel's square
    for (size_t k = 0; k < points; k++) {
        density[k] = (pdmc_estimate){0.0, 0.0, 0.0};
        if (positive && at[k] < 0.0) continue;
        const double image = positive ? smoothed(groups, group, bandwidth, -at[k]) : 0.0;
        const double both = positive ? 1.0 + exp(-gsl_pow_2(at[k] / bandwidth)) : 1.0;
        const double value = smoothed(groups, group, bandwidth, at[k]) + image;
        const double variance = fmax(both * roughness - value, 0.0) / (double)n; // of the estimate, per density
        const double half_width = 0.5 * z * sqrt(variance);                      // of the root
        density[k] = (pdmc_estimate){.value = value,
                                     .lower = gsl_pow_2(fmax(sqrt(value) - half_width, 0.0)),
                                     .upper = gsl_pow_2(sqrt(value) + half_width)};
    }

done:
    pdmc_free(group);
    return status;
}
