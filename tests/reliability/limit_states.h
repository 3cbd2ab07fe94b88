// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Limit states whose probabilities are known in closed form.

#include "pdmc/reliability.h"

#include "check.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_math.h>
#include <stdlib.h>
#include <string.h>

/// How a limit state goes through its points; the values must not depend on it.
typedef enum { AT_ONCE, ONE_BY_ONE, IN_THREADS } manner;

typedef struct {
    int dimension;
    double (*g)(const double parameter[], int dimension, const double z[]);
    double parameter[4];
    double noise; // amplitude of a reproducible error of g
    manner manner;
    long evaluations;
} known_state;

/// The noise is a hash of the point's bits: it depends on the point alone.
static inline double state_at(const known_state *state, const double z[])
{
    const double g = state->g(state->parameter, state->dimension, z);
    if (state->noise == 0.0) return g;
    uint64_t bits = 0, word;
    for (int i = 0; i < state->dimension; i++) {
        memcpy(&word, &z[i], sizeof word);
        bits = (bits ^ word) * 0x9e3779b97f4a7c15u;
    }
    return g + state->noise * ((double)(bits >> 11) * 0x1p-52 - 1.0);
}

static inline pdmc_status state_evaluate(void *context, int count, const double z[], double g[])
{
    known_state *state = context;
    const int n = state->dimension;
    state->evaluations += count;
    if (state->manner == IN_THREADS) {
#pragma omp parallel for schedule(dynamic, 7) num_threads(3)
        for (int k = 0; k < count; k++) g[k] = state_at(state, &z[k * n]);
        return PDMC_OK;
    }
    if (state->manner == ONE_BY_ONE) {
        for (int k = count - 1; k >= 0; k--) g[k] = state_at(state, &z[k * n]);
        return PDMC_OK;
    }
    for (int k = 0; k < count; k++) g[k] = state_at(state, &z[k * n]);
    return PDMC_OK;
}

static inline pdmc_limit_state as_limit_state(known_state *state)
{
    return (pdmc_limit_state){.dimension = state->dimension, .evaluate = state_evaluate, .context = state};
}

/// alpha . z - beta, with alpha along (1, 2, ..., n) and beta = parameter[0]: P = Phi(-beta).
static inline double plane(const double parameter[], int n, const double z[])
{
    double along = 0.0, square = 0.0;
    for (int i = 0; i < n; i++) along += (i + 1) * z[i];
    for (int i = 0; i < n; i++) square += (i + 1.0) * (i + 1.0);
    return along / sqrt(square) - parameter[0];
}

/// |z|^2 - r^2, r = parameter[0]: P is the upper tail of chi-square.
static inline double outside_sphere(const double parameter[], int n, const double z[])
{
    double square = 0.0;
    for (int i = 0; i < n; i++) square += z[i] * z[i];
    return square - parameter[0] * parameter[0];
}

/// z_1 - b + k sum_(i > 1) z_i^2 / 2, with b and k the parameters: for k > 0 the event bends towards the origin.
static inline double parabola(const double parameter[], int n, const double z[])
{
    double square = 0.0;
    for (int i = 1; i < n; i++) square += z[i] * z[i];
    return z[0] - parameter[0] + 0.5 * parameter[1] * square;
}

/// P of the parabola with n = 2 or 3: the integral over the chi-square variable, of Phi(k x / 2 - b).
static inline double parabola_probability(const double parameter[], int n)
{
    enum { PANELS = 200000 };
    const double top = 14.0, h = top / PANELS; // x = r^2; the midpoint rule of a smooth function of r
    double sum = 0.0;
    for (int k = 0; k < PANELS; k++) {
        const double r = (k + 0.5) * h;
        const double density = n == 2 ? sqrt(2.0 / M_PI) * exp(-0.5 * r * r) : r * exp(-0.5 * r * r);
        sum += h * density * gsl_cdf_ugaussian_P(0.5 * parameter[1] * r * r - parameter[0]);
    }
    return sum;
}

/// Griffith's G = K^2 / E above the toughness, both lognormal: K of the load with s_L, G_c with s_c.
/// parameter: log of the medians' ratio G_c / G, s_L, s_c.
static inline double griffith(const double parameter[], int n, const double z[])
{
    (void)n;
    const double root_g = exp(parameter[1] * z[0]);
    return root_g * root_g - exp(parameter[0] + parameter[2] * z[1]);
}

static inline double griffith_probability(const double parameter[])
{
    return gsl_cdf_ugaussian_Q(parameter[0] / sqrt(4.0 * parameter[1] * parameter[1] + parameter[2] * parameter[2]));
}

/// The lognormal case at a probability: load 10 %, toughness 15 %.
static inline known_state griffith_at(double probability)
{
    known_state state = {.dimension = 2, .g = griffith, .parameter = {0.0, 0.10, 0.15}};
    state.parameter[0] = gsl_cdf_ugaussian_Qinv(probability) * sqrt(4.0 * 0.10 * 0.10 + 0.15 * 0.15);
    return state;
}

/// |z_1| - b: two planes, of which one design point sees half.
static inline double two_planes(const double parameter[], int n, const double z[])
{
    (void)n;
    return fabs(z[0]) - parameter[0];
}

static inline bool holds(pdmc_estimate interval, double truth)
{
    return interval.lower <= truth && truth <= interval.upper;
}

/// Three and a half standard deviations of the share of hits in a number of repetitions: passed by chance once in 2000.
static inline double repetition_error(double coverage, int repetitions)
{
    return 3.5 * sqrt(coverage * (1.0 - coverage) / repetitions);
}
