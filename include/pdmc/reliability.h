// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Probabilities of rare events g(z) > 0 of independent standard normal variables z, and what the variance of g comes from.
/// Results depend on the limit state and the seed, to the bit. A point at which g is NaN counts as no event in the value and
/// in the lower bound, and as an event in the upper bound.

#include "pdmc/limit_state.h"
#include "pdmc/statistics.h"

/// What a sampling method has found.
typedef struct {
    pdmc_estimate probability; // P; NaN where no event was seen
    pdmc_estimate index;       // reliability index -Phi^-1(P), with the bounds of P
    double variation;          // coefficient of variation of the estimate of P; NaN where no event was seen
    double effective_samples;  // (sum x)^2 / sum x^2 of what is averaged: weights of events, or runs
    double largest_share;      // max x^2 / sum x^2: near 1, value and interval hang on a single weight or run
    long evaluations;          // of g
    long failed;               // of these, NaN
    int levels;                // intermediate ones, of subset simulation
    bool reached;              // subset simulation came to the event; importance sampling saw it
    bool converged;            // the variation asked for was met, and no weight has too large a share
} pdmc_reliability;

typedef struct {
    double difference;   // step of the central differences
    double tolerance;    // of the point, in units of z
    int most_iterations; // steps of the search
    const double *start; // [dimension] where the search begins; NULL: the origin
} pdmc_first_order_options;

/// difference 0.05, tolerance 1e-4, 50 iterations, from the origin.
PDMC_API pdmc_first_order_options pdmc_first_order_options_default(void);

/// The point of g(z) = 0 nearest the origin, and what a plane through it gives (first-order reliability method).
typedef struct {
    int dimension;
    double *z;          // [dimension] owned; the last iterate, converged or not
    double *importance; // [dimension] owned; alpha_i^2 of the normal alpha = grad g / |grad g|, with sum 1; else NaN
    double index;       // beta = |z|, negative where g(0) > 0; NaN unless converged
    double probability; // Phi(-beta); NaN unless converged
    double slope;       // |grad g| at z; NaN unless converged
    double residual;    // |g| / |grad g| at z, the surface's distance to first order; NaN without a gradient
    long evaluations;
    bool converged; // residual and the part of z beside alpha are within the tolerance
} pdmc_first_order;

/// The improved HL-RF iteration: z moves along d = ((grad g . z - g) / |grad g|^2) grad g - z by the largest lambda = 1, 1/2,
/// 1/4, ... that reduces |z|^2 / 2 + c |g| enough (Zhang & Der Kiureghian 1995). All points of a gradient are evaluated at
/// once, as are all lambda. Points with NaN are stepped over; where the gradient vanishes at the start, the search begins at
/// the best point of the axes. It finds one point: see pdmc_first_order_find_other().
/// @param[out] point  free with pdmc_first_order_clear(), whatever is returned
/// @return PDMC_OK also where there is no such point (not converged), PDMC_ERR_ARG, PDMC_ERR_NOMEM, or what g gives
PDMC_API PDMC_NODISCARD pdmc_status pdmc_first_order_find(const pdmc_limit_state *limit,
                                                          const pdmc_first_order_options *options,
                                                          pdmc_first_order *point);

/// Another point of g(z) = 0 that is nearest the origin among those around it. The search begins again at a point of the axes,
/// as far from the origin as the nearest known point: that with the largest g of those which are nearer to the origin than to
/// any known point, and where g is above the planes through these by what a tenth of a unit of z does. Along the axes the
/// quantities act alone: what only several of them do together may still be missed.
/// @param[in]  known  [count] >= 1, converged points with positive indices
/// @param[out] point  free with pdmc_first_order_clear(), whatever is returned; converged where it is another one; its residual
///                    is NaN where no search began, or the search ended within half a unit of a known point; its
///                    evaluations are all that were made
/// @return PDMC_OK also where there is none, PDMC_ERR_ARG, PDMC_ERR_NOMEM, or what g gives
PDMC_API PDMC_NODISCARD pdmc_status pdmc_first_order_find_other(const pdmc_limit_state *limit,
                                                                const pdmc_first_order_options *options, int count,
                                                                const pdmc_first_order known[],
                                                                pdmc_first_order *point);

/// NULL inside is allowed.
PDMC_API void pdmc_first_order_clear(pdmc_first_order *point);

typedef struct {
    uint64_t seed;
    double confidence;     // of the intervals
    double variation;      // sampling goes on until the coefficient of variation is no more than this
    long most_evaluations; // and stops before it would take more than this
    int batch;             // samples evaluated at once, and between two looks at the variation
} pdmc_importance_options;

/// confidence 0.95, variation 0.05, 200 000 evaluations, batches of 2000.
PDMC_API pdmc_importance_options pdmc_importance_options_default(void);

/// Importance sampling from an equal mixture of standard normals moved to the centres c_j,
///     P = mean of [g(z) > 0] w(z),  1 / w(z) = mean_j exp(z . c_j - |c_j|^2 / 2).
/// The centres are the design points known; the origin may be one, and alone it is plain Monte Carlo. An event away from all
/// of them is missed, and the interval does not know: compare with subset simulation.
///
/// The interval is Student's with Hall's (1992) correction of the skewness. Sampling goes on too while one weight has more than 5 %
/// of the sum of squares, since the variance is not known then: a result that is not converged is to be believed less. Where less than 10 effective samples were seen it
/// is [0, b], with b the most that a set can have by the Neyman-Pearson lemma whose share of the samples is no more than
/// Clopper and Pearson's bound: it holds whatever the weights.
/// @param[in] centres  >= 1
/// @param[in] centre   [centres, dimension]
/// @return PDMC_OK, PDMC_ERR_ARG, PDMC_ERR_NOMEM, or what g gives
PDMC_API PDMC_NODISCARD pdmc_status pdmc_importance_sampling(const pdmc_limit_state *limit, int centres,
                                                             const double centre[],
                                                             const pdmc_importance_options *options,
                                                             pdmc_reliability *result);

typedef struct {
    uint64_t seed;
    double confidence;        // of the intervals
    double variation;         // runs are added until the coefficient of variation is no more than this
    long most_evaluations;    // and no more once another batch would take more than this
    int samples;              // a level, >= 10
    double level_probability; // of a level given the one before
    int most_levels;          // at most 64
    int runs;                 // a batch, side by side; >= 3
} pdmc_subset_options;

/// confidence 0.95, variation 0.1, 500 000 evaluations, 1000 samples, probability 0.1, 12 levels, batches of 20 runs.
PDMC_API pdmc_subset_options pdmc_subset_options_default(void);

/// Subset simulation (Au & Beck 2001): P = product of P(g >= b_j given g >= b_(j-1)), with chains that move from z to
/// rho z + sqrt(1 - rho^2) xi where g allows it (Papaioannou, Betz, Zwirglmaier & Straub 2015).
///
/// A pilot run finds the levels b_j and the steps. The runs that are averaged then have fixed levels, and as many chains of
/// the same length in each whatever its share (systematic resampling), so that each is an unbiased estimate, and the interval is that of the mean of independent runs, by Student and Hall (1992). Where the event
/// is not reached, the value is that of what was seen of it, or NaN, the lower bound is 0, and the upper bound that of the
/// last level's probability.
/// @return PDMC_OK, PDMC_ERR_ARG, PDMC_ERR_NOMEM, or what g gives
PDMC_API PDMC_NODISCARD pdmc_status pdmc_subset_simulation(const pdmc_limit_state *limit,
                                                           const pdmc_subset_options *options,
                                                           pdmc_reliability *result);

typedef struct {
    uint64_t seed;
    double confidence;
    int samples; // rows of the two designs, >= 2
} pdmc_sensitivity_options;

/// confidence 0.95, 10 000 samples.
PDMC_API pdmc_sensitivity_options pdmc_sensitivity_options_default(void);

/// Sobol' indices of groups of variables for the output g, whatever its sign:
///     first  S = V(E(g | group)) / V(g),  total  T = E(V(g | all others)) / V(g).
typedef struct {
    int groups;
    pdmc_estimate *first, *total; // [groups] owned; NaN where g has no variance
    long evaluations, failed;     // a row with a NaN is left out
} pdmc_sensitivity;

/// Pick and freeze: two designs A and B, and for each group A with the group's variables taken from B,
///     S V = mean f_B (f_AB - f_A)  (Saltelli et al. 2010),  T V = mean (f_A - f_AB)^2 / 2  (Jansen 1999),
/// with f = g less its mean, and V the mean of (f_A^2 + f_B^2) / 2. Each is a ratio of means, with Fieller's interval.
/// Takes samples (groups + 2) evaluations.
/// @param[in]  group        [dimension] in [0, groups), of each variable
/// @param[out] sensitivity  free with pdmc_sensitivity_clear(), whatever is returned
/// @return PDMC_OK, PDMC_ERR_ARG, PDMC_ERR_NOMEM, or what g gives
PDMC_API PDMC_NODISCARD pdmc_status pdmc_sensitivity_find(const pdmc_limit_state *output, int groups, const int group[],
                                                          const pdmc_sensitivity_options *options,
                                                          pdmc_sensitivity *sensitivity);

/// NULL inside is allowed.
PDMC_API void pdmc_sensitivity_clear(pdmc_sensitivity *sensitivity);
