// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Fictitious masses with which bodies of bonds are relaxed with a step of 1.

#include "pdmc/particles.h"

/// A quarter of the largest row sum of a node's |k_ij| (Gerschgorin; Yu 2011, eq. 4.59 and 4.67, whose sum leaves the
/// node's own place out), and Underwood's margin: of its bonds as they lie, and of what touches it or would if nodes came nearer
/// by pdmc_masses_reach(). One for all axes of a node; infinite where its position is prescribed, and where nothing holds it.
/// @param[out] mass  [nodes, dimension] node by node
void pdmc_masses_find(const pdmc_particles *particles, double mass[]);

/// How far nodes may move before masses must be found anew; infinite where nothing can touch.
double pdmc_masses_reach(const pdmc_particles *particles);
