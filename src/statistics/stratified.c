// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/statistics.h"

#include <math.h>

/// Adds the squares of the distances from a share to its bounds, times a slope, which turns them round where it is negative.
static void add_reach(pdmc_estimate share, double slope, double *below, double *above)
{
    const double down = slope * (share.value - (slope > 0.0 ? share.lower : share.upper));
    const double up = slope * ((slope > 0.0 ? share.upper : share.lower) - share.value);
    *below += down * down;
    *above += up * up;
}

pdmc_estimate pdmc_statistics_stratified_proportion(const size_t hits[2], const size_t trials[2], size_t known_hits,
                                                    size_t known_by, double confidence)
{
    if (trials[0] == 0 || trials[1] == 0)
        return pdmc_statistics_proportion(hits[0] + hits[1], trials[0] + trials[1], confidence);
    const pdmc_estimate without = pdmc_statistics_proportion(hits[0], trials[0], confidence);
    const pdmc_estimate with = pdmc_statistics_proportion(hits[1], trials[1], confidence);
    const pdmc_estimate weight = pdmc_statistics_proportion(known_hits, known_by, confidence);
    const double value = weight.value * with.value + (1.0 - weight.value) * without.value;
    double below = 0.0, above = 0.0;
    add_reach(with, weight.value, &below, &above);
    add_reach(without, 1.0 - weight.value, &below, &above);
    add_reach(weight, with.value - without.value, &below, &above);
    return (pdmc_estimate){value, fmax(0.0, value - sqrt(below)), fmin(1.0, value + sqrt(above))};
}
