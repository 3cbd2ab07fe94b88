// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/random.h"

#include "random/design_impl.h"

#include <math.h>

/// The midpoint of the cell of 2^-52 that holds x; rounding may have brought x to 1.
static double cell_midpoint(double x)
{
    return (fmin(floor(ldexp(x, 52)), 0x1p52 - 1.0) + 0.5) * 0x1p-52;
}

void pdmc_latin_hypercube_point(const pdmc_design *design, uint64_t sample, double u[])
{
    const uint64_t replicate = sample % design->replicates, index = sample / design->replicates;
    const uint64_t n = design->samples / design->replicates;
    pdmc_random_uniform(design->seed, PDMC_STREAM_SCRAMBLE, sample, 0, design->dimension, u);
    for (size_t j = 0; j < design->dimension; j++) {
        const uint64_t interval = pdmc_random_permutation(design->seed, replicate, j, n, index);
        u[j] = cell_midpoint(((double)interval + u[j]) / (double)n);
    }
}
