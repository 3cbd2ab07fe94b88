// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Samples for the tests of statistics, and the tolerance of a coverage found by repetition.

#include "pdmc/random.h"

#include "check.h"

#include <gsl/gsl_sort.h>

typedef enum { SAMPLE_NORMAL, SAMPLE_EXPONENTIAL, SAMPLE_LOGNORMAL } sample_kind;

static const double lognormal_sigma = 0.25;

/// Sample number `repetition`: n values of the standard normal, of the exponential with mean 1, or of exp(0.25 Z).
static inline void draw_sample(sample_kind kind, uint64_t repetition, size_t n, double x[])
{
    pdmc_random_uniform(1968, PDMC_STREAM_LOAD, repetition, 0, n, x);
    for (size_t i = 0; i < n; i++) {
        if (kind == SAMPLE_NORMAL) x[i] = pdmc_normal_quantile(x[i]);
        if (kind == SAMPLE_EXPONENTIAL) x[i] = -log1p(-x[i]);
        if (kind == SAMPLE_LOGNORMAL) x[i] = exp(lognormal_sigma * pdmc_normal_quantile(x[i]));
    }
}

static inline void sort_sample(size_t n, double x[])
{
    gsl_sort(x, 1, n);
}

/// Four standard deviations of the share of hits in a number of repetitions: passed by chance once in 16 000.
static inline double repetition_error(double coverage, int repetitions)
{
    return 4.0 * sqrt(coverage * (1.0 - coverage) / repetitions);
}
