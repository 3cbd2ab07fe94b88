// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/random.h"

#include "base/base_impl.h"

#include <math.h>

enum { DEGREE = 7, BATCH = 64 };

// Algorithm AS 241, PPND16 (Wichura, Applied Statistics 37 (1988) 477-484), for |u - 1/2| <= 0.425: the middle of the
// distribution, in which 85 % of the numbers are. GSL has the same, and the tails.
static const double centre = 0.425;
static const double numerator[DEGREE + 1] = {3.3871328727963666080e0, 1.3314166789178437745e2, 1.9715909503065514427e3,
                                             1.3731693765509461125e4, 4.5921953931549871457e4, 6.7265770927008700853e4,
                                             3.3430575583588128105e4, 2.5090809287301226727e3};
static const double denominator[DEGREE + 1] = {1.0,
                                               4.2313330701600911252e1,
                                               6.8718700749205790830e2,
                                               5.3941960214247511077e3,
                                               2.1213794301586595867e4,
                                               3.9307895800092710610e4,
                                               2.8729085735721942674e4,
                                               5.2264952788528545610e3};

// Of all numbers, those in the tails too, whose values are then of no use.
PDMC_VECTORS("avx2", "avx512f")
static void central_quantiles(size_t count, const double u[], double z[])
{
    for (size_t i = 0; i < count; i++) {
        const double q = u[i] - 0.5, r = 0.180625 - q * q; // 0.425^2 - q^2
        double above = numerator[DEGREE], below = denominator[DEGREE];
        for (int k = DEGREE - 1; k >= 0; k--) {
            above = r * above + numerator[k];
            below = r * below + denominator[k];
        }
        z[i] = q * (above / below);
    }
}

void pdmc_normal_quantiles(size_t count, double u[])
{
    double z[BATCH];
    for (size_t first = 0; first < count; first += BATCH) {
        const size_t batch = count - first < BATCH ? count - first : BATCH;
        central_quantiles(batch, &u[first], z);
        for (size_t i = 0; i < batch; i++) {
            double *here = &u[first + i];
            *here = fabs(*here - 0.5) <= centre ? z[i] : pdmc_normal_quantile(*here);
        }
    }
}
