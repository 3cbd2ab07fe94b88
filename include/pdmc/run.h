// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A study from its problem to its results.

#include "pdmc/stochastic.h"
#include "pdmc/study.h"

/// What a study will cost.
typedef struct {
    int nodes, unknowns, rows;
    double bytes, seconds; // of memory and of wall time, within a factor of two or so
    double most_seconds;   // where a target goes on to the most samples; else the same
} pdmc_cost;

/// What an explicit or a quasi-static study will cost: upper bounds of its nodes, bonds and steps, with memory and wall time from them.
typedef struct {
    double nodes, bonds, steps;
    double bytes, seconds;
} pdmc_explicit_cost;

/// Discretises the problem and solves for the mean; then solves for every sample and summarises, or integrates the
/// motion of a dynamic study and records it step by step; or moves the bodies of an explicit one, or brings those of a
/// quasi-static one to rest; solves the levels of a scalar one; or compares rules.
/// @param[out] results  free with pdmc_results_clear(); zero on failure
/// `options->progress` counts samples, the time steps of a dynamic or explicit study, the loads of a quasi-static one, or the
/// levels of a scalar one; it is called with 0 done as well, before
/// and between what comes before them.
/// @return PDMC_OK (also when stopped early, see pdmc_monte_carlo()), PDMC_ERR_INTERRUPTED when stopped before there is
/// anything to save, or the failure of a step
PDMC_API PDMC_NODISCARD pdmc_status pdmc_run(const pdmc_study *study, const pdmc_run_options *options,
                                             pdmc_results *results);

/// Estimates what pdmc_run() would need, from counts of operations at a nominal rate a thread: the samples, and what they
/// usually take of points of rare growth and sensitivities, and a control.
PDMC_API pdmc_cost pdmc_run_cost(const pdmc_problem *problem, int threads);

/// Bytes that a study of quadrature will need: the points of its finest rule.
PDMC_API double pdmc_run_quadrature_bytes(const pdmc_horizon_study *study);

/// The same of an explicit study, without placing its nodes.
PDMC_API pdmc_explicit_cost pdmc_run_explicit_cost(const pdmc_explicit *study, int threads);

/// The same of an explicit study with its samples, where it has random quantities; the steps are those of one.
PDMC_API pdmc_explicit_cost pdmc_run_ensemble_cost(const pdmc_study *study, int threads);
