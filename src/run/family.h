// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/affine.h"
#include "pdmc/problem.h"

/// The plates of a problem whose cracks have a random place: each is discretised anew, by the problem's method.
/// @param[in] problem  kept by reference
pdmc_affine_family pdmc_plate_family(const pdmc_problem *problem, int threads);
