// SPDX-License-Identifier: GPL-3.0-or-later
#include "random/distribution_impl.h"

#include <float.h>
#include <math.h>

// From a guess near enough it takes 3 to 6 steps, and some tens where the quantile is hardly a double.
enum { MAX_STEPS = 200 };

// Tails and densities below it are as good as 0: their quotients, times the logarithm of any tail, do not overflow.
static const double nothing = 1e-300;

static bool is_usable(double probability, double slope)
{
    return probability >= nothing && slope >= nothing;
}

double pdmc_log_concave_quantile(pdmc_log_concave_tail *tail, const pdmc_distribution *distribution, double target,
                                 int side, double guess)
{
    const double log_target = log(fmax(target, nothing));
    double slope, before = 0.0, y = guess, probability = tail(distribution, y, side, &slope);
    if (!is_usable(probability, slope)) probability = tail(distribution, y = 0.0, side, &slope);
    for (int i = 0; i < MAX_STEPS; i++) {
        const double rounding = DBL_EPSILON * fmax(1.0, fabs(y));
        double step = (log_target - log(probability)) * (probability / slope); // towards the middle where positive
        if (before > 0.0 && step < 0.0) break;
        while (fabs(step) > rounding &&
               !is_usable(probability = tail(distribution, y + side * step, side, &slope), slope))
            step *= 0.5;
        if (!(fabs(step) > rounding)) break;
        y += side * step;
        before = step;
    }
    return y;
}
