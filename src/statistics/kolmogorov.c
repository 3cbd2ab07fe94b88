// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/statistics.h"

#include <gsl/gsl_math.h>
#include <math.h>

// Both series are Jacobi's theta function; on its side of 1 each has all digits after four terms.
enum { TERMS = 4 };

double pdmc_statistics_kolmogorov(double distance)
{
    double sum = 0.0;
    if (!(distance > 0.0)) return isnan(distance) ? NAN : 1.0;
    if (distance < 1.0) {
        for (int k = 0; k < TERMS; k++) sum += exp(-gsl_pow_2((2 * k + 1) * M_PI / distance) / 8.0);
        return 1.0 - sqrt(2.0 * M_PI) / distance * sum;
    }
    for (int k = TERMS; k > 0; k--) sum += (k % 2 ? 2.0 : -2.0) * exp(-2.0 * gsl_pow_2(k * distance));
    return sum;
}
