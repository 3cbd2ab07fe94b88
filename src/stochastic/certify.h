// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What the error of a reduced solution can do to the energies of its sample.
///
/// sqrt(G) is a seminorm of the displacement, so that it changes by at most a multiple of |e|, |e|^2 = e' K(xi) e: for
/// bond energies crossing_bound; for Griffith's, which are norms of the stress intensities F(kink) K of a kink, the largest
/// norm of F times intensity_bound, over the root of E'. The largest energy G of a sample is then within
/// (sqrt(G) +- delta)^2.

#include "pdmc/results.h"
#include "stochastic/draw.h"

/// @param[in] error  bound of |e|
/// @return delta of a measure, the largest of all tips; infinite where there is no bound
double pdmc_certify_root_energy(const pdmc_problem *problem, const pdmc_affine *reduced, const pdmc_results *results,
                                const pdmc_draw *draw, pdmc_measure measure, double error);

/// The bound of the relative error of the largest energy of a sample, the largest of all tips.
double pdmc_certify_relative(const pdmc_results *results, pdmc_measure measure, int sample, double delta);

/// Whether the largest energy of a sample at some tip may lie on the other side of G_c than it does, by the measure that
/// decides.
bool pdmc_certify_is_in_doubt(const pdmc_results *results, int sample, double delta);
