// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/statistics.h"

#include <gsl/gsl_cdf.h>
#include <math.h>

typedef double cdf_fn(double x, double a, double b);

/// The x nearest to `near` with cdf(x; a, b) <= tail, between `near`, where it is more, and `far`, where it is 0.
/// By bisection to the last bit, since gsl_cdf_beta_Pinv and _Qinv do not return for 10^7 trials: from there on the
/// function itself is NaN where it is about 1/2, which the negated comparison takes for more than tail.
static double outermost(cdf_fn *cdf, double a, double b, double tail, double near, double far)
{
    for (;;) {
        const double middle = 0.5 * (near + far);
        if (middle == near || middle == far) return far;
        if (!(cdf(middle, a, b) <= tail)) {
            near = middle;
        } else {
            far = middle;
        }
    }
}

pdmc_estimate pdmc_statistics_proportion(size_t hits, size_t n, double confidence)
{
    const double k = (double)hits, misses = (double)(n - hits), tail = 0.5 * (1.0 - confidence);
    pdmc_estimate estimate = {.value = n > 0 ? k / (double)n : NAN, .lower = 0.0, .upper = 1.0};
    if (hits > 0) estimate.lower = outermost(gsl_cdf_beta_P, k, misses + 1.0, tail, estimate.value, 0.0);
    if (hits < n) estimate.upper = outermost(gsl_cdf_beta_Q, k + 1.0, misses, tail, estimate.value, 1.0);
    return estimate;
}
