// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What the error of a reduced solution can do to the energies of its sample.
///
/// sqrt(G) is a seminorm of the displacement, so that it changes by at most a multiple of the error's norm: for bond energies
/// crossing_bound; for Griffith's, which are norms of the stress intensities F(kink) K of a kink, by the largest norm of F
/// times the error of K, over the root of E' at the tip. The largest energy G of a sample is then within
/// (sqrt(G) +- delta)^2.

#include "pdmc/results.h"
#include "stochastic/block.h"

/// delta of a measure for the first `count` samples of a block, the largest of all tips.
/// @param[in]  block  solved by the reduced model
/// @param[out] delta  [count] infinite where there is no bound, 0 of a sample that has failed, as it would in full
void pdmc_certify_root_energies(const pdmc_block *block, int count, const pdmc_results *results, pdmc_measure measure,
                                double delta[]);

/// What gives the largest energies at the mean, by the problem's measure, the relative error that is asked for.
/// @param[in]  results    the nominal energies
/// @param[out] intensity  [tips] what the goal may point to
void pdmc_certify_goal(const pdmc_variables *variables, const pdmc_results *results, double intensity[],
                       pdmc_reduced_goal *goal);

/// The bound of the relative error of the largest energy of a sample, the largest of all tips.
double pdmc_certify_relative(const pdmc_results *results, pdmc_measure measure, int sample, double delta);

/// Whether the largest energy of a sample at some tip may lie on the other side of G_c than it does, by the measure that
/// decides.
bool pdmc_certify_is_in_doubt(const pdmc_results *results, int sample, double delta);
