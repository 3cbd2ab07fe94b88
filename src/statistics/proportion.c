// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/statistics.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>
#include <math.h>

typedef double cdf_fn(double x, double a, double b);

static const double closeness = 1e-14; // of the bound, to which it is found

/// The next trial between `near` and `far`: Newton's from x, where the function is `value`; past its own rounding a step
/// that closes the bracket from the other side; the middle where Newton's leads outside or to nothing.
static double next_trial(double x, double value, double tail, double slope, double near, double far)
{
    const double newton = x - (value - tail) / slope, low = fmin(near, far), high = fmax(near, far);
    if (!(low <= newton && newton <= high)) return 0.5 * (near + far);
    if (fabs(newton - x) > 0.25 * closeness * fabs(x)) return newton;
    return x == near ? x + 0.5 * closeness * copysign(x, far - near) : x - 0.5 * closeness * copysign(x, far - near);
}

/// The x nearest to `near`, to a share of some `closeness`, with cdf(x; a, b) <= tail, between `near`, where it is more, and
/// `far`, where it is 0. By Newton's method inside a bracket, from a guess if that is between them, since gsl_cdf_beta_Pinv
/// and _Qinv do not return for 10^7 trials: from there on the function itself is NaN where it is about 1/2, which the negated
/// comparison takes for more than tail.
static double outermost(cdf_fn *cdf, double sign, double a, double b, double tail, double guess, double near,
                        double far)
{
    double x = fmin(near, far) < guess && guess < fmax(near, far) ? guess : 0.5 * (near + far);
    while (fabs(far - near) > closeness * fabs(far)) {
        const double value = cdf(x, a, b);
        if (!(value <= tail)) near = x;
        else far = x;
        const double trial = next_trial(x, value, tail, sign * gsl_ran_beta_pdf(x, a, b), near, far);
        x = trial != near && trial != far ? trial : 0.5 * (near + far);
        if (x == near || x == far) break;
    }
    return far;
}

/// Wilson's bound, z standard deviations of the p that is looked for from the share p of n: half of the steps are saved that
/// Newton's method takes from the middle.
static double wilson(double p, double n, double z)
{
    return (p + 0.5 * z * z / n + z * sqrt((p * (1.0 - p) + 0.25 * z * z / n) / n)) / (1.0 + z * z / n);
}

pdmc_estimate pdmc_statistics_proportion(size_t hits, size_t n, double confidence)
{
    const double k = (double)hits, misses = (double)(n - hits), tail = 0.5 * (1.0 - confidence);
    pdmc_estimate estimate = {.value = n > 0 ? k / (double)n : NAN, .lower = 0.0, .upper = 1.0};
    const double p = estimate.value, z = gsl_cdf_ugaussian_Qinv(tail);
    if (hits > 0)
        estimate.lower = outermost(gsl_cdf_beta_P, 1.0, k, misses + 1.0, tail, wilson(p, (double)n, -z), p, 0.0);
    if (hits < n)
        estimate.upper = outermost(gsl_cdf_beta_Q, -1.0, k + 1.0, misses, tail, wilson(p, (double)n, z), p, 1.0);
    return estimate;
}
