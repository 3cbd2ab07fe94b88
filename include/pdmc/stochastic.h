// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Monte Carlo on an affine model. It sees only models and random numbers, and knows no discretisation.

#include "pdmc/affine.h"
#include "pdmc/results.h"

/// How well a study's target is known after a round of samples.
typedef struct {
    pdmc_target target;
    int samples;           // so far
    const char *tip;       // at which it is known worst; the results own it
    double error, wanted;  // half the width of its interval over its value, infinite where that is 0; and what is asked for
    double needed;         // the samples in all that would do, samples (error / wanted)^2
} pdmc_round;

/// How a run is steered from outside.
typedef struct {
    int threads; // >= 1; no result depends on it
    /// Called, never by two threads at once, when samples are done; NULL is allowed. False asks for an early stop: the
    /// blocks under way are finished, and the results hold the samples up to the first that is missing.
    bool (*progress)(void *context, int done, int total);
    /// Called after every round of a study with a target; NULL is allowed.
    void (*round)(void *context, const pdmc_round *round);
    void *context;
} pdmc_run_options;

/// What is counted of all samples of a study that keeps only the first of them.
typedef struct pdmc_sample_counts pdmc_sample_counts;

/// Frees counts and sets them to NULL; NULL is allowed.
PDMC_API void pdmc_sample_counts_destroy(pdmc_sample_counts **counts);

/// Draws and solves the samples of a study.
///
/// Sample i depends on (seed, i) alone; samples are solved in blocks of PDMC_BLOCK, by
///  - the Neumann expansion (Evangelatos & Spanos 2011, eq. 52, with the sign (-1)^j that is missing in print)
///        x = sum_{j <= order} (-K_0^-1 K'(xi))^j K_0^-1 F,
///    whose contraction factor is measured as the ratio of the norms of its last two terms; where that is 1 or more the
///    sample is solved by a surer way, which results->sample_solver names;
///  - conjugate gradients, or a reduced model with a bound of its error; or
///  - the sample's own factorisation.
/// A sample that cannot be solved is marked in results->failure and has NaN for results. Rare growth, where the problem
/// asks for it, comes after the samples, in results->reliability.
///
/// With a target, samples are drawn in rounds until it is known at every tip, or until the most that are allowed: the results
/// are those of a study of so many samples, and their status says which of the two it was.
/// @param[in]     model    of the problem
/// @param[in,out] results  the problem's tips, angles, measure, bonds and bins are set; the sample arrays are made and filled,
///                         as are the nominal energies, the status and the times of sampling and energy
/// @param[out]    counts   what pdmc_summarise() needs of samples that are not kept, to be freed; NULL where all are
/// @return PDMC_OK (also when stopped early), PDMC_ERR_ARG, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_API PDMC_NODISCARD pdmc_status pdmc_monte_carlo(const pdmc_problem *problem, const pdmc_affine *model,
                                                     const pdmc_run_options *options, pdmc_results *results,
                                                     pdmc_sample_counts **counts);

/// Fills the statistics of results from its samples, with intervals at results->confidence. Energies that are not kept are in
/// the counts: then quantiles are known to 2^-12 of themselves, and edges of histograms are rounded by as much.
/// @param[in] counts  of the same samples, or NULL where all are kept
/// @return PDMC_OK, PDMC_ERR_DATA (all samples failed) or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_summarise(const pdmc_run_options *options, const pdmc_sample_counts *counts,
                                                   pdmc_results *results);
