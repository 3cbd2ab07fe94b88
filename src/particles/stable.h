// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The largest stable step of time.

#include "particles/variation.h"

/// The least of all nodes: sqrt(2 rho / sum_p V_p c / |xi|) (Silling & Askari 2005, eq. 46), with the damping of bonds less. Where
/// all bonds of a material are alike it is that of a whole family, whether there is one or not.
/// @param[in] density  [materials]
double pdmc_bonds_stable_step(const pdmc_nodes *nodes, const pdmc_variation *variation, int materials,
                              const pdmc_brittle_law laws[], const double density[], double bond_damping);
