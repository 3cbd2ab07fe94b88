// SPDX-License-Identifier: GPL-3.0-or-later
#include "random/distribution_impl.h"

#include "base/base_impl.h"

#include <gsl/gsl_math.h>
#include <math.h>

/// Between neighbours the distribution is uniform, and each interval is as likely.
static int intervals(const pdmc_distribution *distribution)
{
    return distribution->count - 1;
}

static double empirical_value(const pdmc_distribution *distribution, double z)
{
    const double *values = distribution->values, last = intervals(distribution);
    const pdmc_tails tails = pdmc_normal_tails(z);
    const bool from_left = z < 0.0;
    const double distance = last * (from_left ? tails.lower : tails.upper); // from the nearer end
    const int step = (int)distance, at = from_left ? step : intervals(distribution) - step;
    const double from = values[at], to = values[from_left ? at + 1 : at - 1];
    return from + (distance - step) * (to - from);
}

/// The last interval that begins at or below x, which is in [values[0], values[last]).
static int interval_at(const pdmc_distribution *distribution, double x)
{
    int low = 0, high = intervals(distribution);
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        if (distribution->values[middle] <= x) low = middle;
        else high = middle;
    }
    return low;
}

static pdmc_tails empirical_tails(const pdmc_distribution *distribution, double x)
{
    const int last = intervals(distribution);
    if (x < distribution->values[0]) return (pdmc_tails){0.0, 1.0};
    if (x >= distribution->values[last]) return (pdmc_tails){1.0, 0.0};
    const int at = interval_at(distribution, x);
    const double from = distribution->values[at], to = distribution->values[at + 1];
    return (pdmc_tails){(at + (x - from) / (to - from)) / last, (last - 1 - at + (to - x) / (to - from)) / last};
}

static void empirical_moments(const pdmc_distribution *distribution, double *mean, double *deviation)
{
    const double *values = distribution->values;
    const int last = intervals(distribution);
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < last; i++) sum += 0.5 * (values[i] + values[i + 1]);
    *mean = sum / last;
    for (int i = 0; i < last; i++)
        squares += gsl_pow_2(0.5 * (values[i] + values[i + 1]) - *mean) + gsl_pow_2(values[i + 1] - values[i]) / 12.0;
    *deviation = sqrt(squares / last);
}

static pdmc_status empirical_check(const pdmc_distribution *distribution)
{
    const int count = distribution->count;
    const double *values = distribution->values;
    PDMC_REQUIRE(count >= 2 && values, "an empirical distribution needs two values, not %d", count);
    for (int i = 0; i < count; i++)
        PDMC_REQUIRE(isfinite(values[i]), "value %d of an empirical distribution is %g", i, values[i]);
    for (int i = 1; i < count; i++)
        PDMC_REQUIRE(values[i - 1] <= values[i], "the values of an empirical distribution must ascend: %g, %g",
                     values[i - 1], values[i]);
    PDMC_REQUIRE(values[0] < values[count - 1], "the values of an empirical distribution are all %g", values[0]);
    return PDMC_OK;
}

static int empirical_kinks(const pdmc_distribution *distribution)
{
    return intervals(distribution) - 1;
}

static pdmc_tails empirical_kink(const pdmc_distribution *distribution, int index)
{
    const double last = intervals(distribution);
    return (pdmc_tails){(index + 1) / last, (last - 1 - index) / last};
}

const pdmc_family pdmc_family_empirical = {
    .name = "empirical",
    .value = empirical_value,
    .tails = empirical_tails,
    .moments = empirical_moments,
    .check = empirical_check,
    .kinks = empirical_kinks,
    .kink = empirical_kink,
};
