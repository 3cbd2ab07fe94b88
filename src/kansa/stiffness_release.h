// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kansa/stiffness_operator.h"

/// The derivative of ln G of a tip to the stiffness M at the mean, from energies of two plates whose tip is a little nearer
/// and a little farther:
///     G = -dPi/da,  dPi/dM(x) = 1/2 epsilon : C : epsilon  =>  d ln G = -1/(2 G) d/da int dM epsilon : C : epsilon,
/// with the fields of the uniform plate alone, which the crack fields hold to 1e-4. The derivative of the stress intensity
/// factors needs the answer of the tip to a stiffness that varies close to it, which no smooth basis has: without it the
/// scatter of G of an exponential covariance is 15 % too large.
/// @param[in]  tip         number of the tip in the problem's request
/// @param[in]  length      on which the stiffness varies: its correlation length
/// @param[out] functional  of M; its arrays are the caller's to free
PDMC_NODISCARD pdmc_status pdmc_kansa_release_sensitivity(const pdmc_kansa *kansa, int tip, double length,
                                                          pdmc_field_functional *functional);

/// Replaces the stiffness at each tip of a model by the weighted average that a tip feels: the one with which
/// G = E M_tip (row . x)^2 has these derivatives.
/// @param[in]     release  [tips] of pdmc_kansa_release_sensitivity()
/// @param[in,out] model    of pdmc_kansa_form_affine() with the same terms
PDMC_NODISCARD pdmc_status pdmc_kansa_correct_tips(const pdmc_kansa_form *form, const pdmc_stiffness_terms *terms,
                                                   const pdmc_field_functional release[], pdmc_affine *model);
