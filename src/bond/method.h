// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/discretisation.h"

/// As pdmc_discretise(), by bonds.
PDMC_NODISCARD pdmc_status pdmc_bond_discretise(const pdmc_problem *problem, int threads, pdmc_discretisation *out);
