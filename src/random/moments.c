// SPDX-License-Identifier: GPL-3.0-or-later
#include "random/distribution_impl.h"

#include <gsl/gsl_math.h>
#include <gsl/gsl_randist.h>
#include <math.h>

// Three-point Gauss rules on panels of this width: the error of the normal density's own integral is 1e-15. Beyond the
// range it is 1e-197.
static const double panel = 1.0 / 32.0, range = 30.0;

/// The first two moments about a centre.
typedef struct {
    const pdmc_distribution *distribution;
    double centre, first, second;
} moments;

static void add_point(moments *sum, double z, double weight)
{
    const double x = pdmc_distribution_value(sum->distribution, z) - sum->centre;
    const double probability = weight * gsl_ran_ugaussian_pdf(z);
    sum->first += probability * x;
    sum->second += probability * x * x;
}

static void add_panel(moments *sum, double from, double to)
{
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from), node = half * sqrt(0.6);
    add_point(sum, middle - node, half * (5.0 / 9.0));
    add_point(sum, middle, half * (8.0 / 9.0));
    add_point(sum, middle + node, half * (5.0 / 9.0));
}

static void add_smooth_part(moments *sum, double from, double to)
{
    const int panels = (int)ceil((to - from) / panel);
    for (int i = 0; i < panels; i++)
        add_panel(sum, from + (to - from) * i / panels, from + (to - from) * (i + 1) / panels);
}

static double kink_at(const pdmc_distribution *distribution, const pdmc_family *family, int index)
{
    const pdmc_tails uncut = family->kink(distribution, index);
    const double z =
        pdmc_normal_score(pdmc_distribution_is_cut(distribution) ? pdmc_cut_tails(distribution, uncut) : uncut);
    return GSL_MIN(range, GSL_MAX(-range, z));
}

void pdmc_distribution_moments_by_quadrature(const pdmc_distribution *distribution, double *mean, double *deviation)
{
    const pdmc_family *family = pdmc_family_of(distribution);
    const int kinks = family->kinks ? family->kinks(distribution) : 0;
    // About the median, which is within one deviation of the mean, so that little cancels.
    moments sum = {.distribution = distribution, .centre = pdmc_distribution_value(distribution, 0.0)};
    double from = -range;
    for (int i = 0; i < kinks; i++) {
        const double to = kink_at(distribution, family, i);
        add_smooth_part(&sum, from, to);
        from = to;
    }
    add_smooth_part(&sum, from, range);
    *mean = sum.centre + sum.first;
    *deviation = sqrt(sum.second - sum.first * sum.first);
}
