// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/discretisation.h"

/// pdmc_discretise() for finite elements; out is set on success only.
PDMC_NODISCARD pdmc_status pdmc_galerkin_discretise(const pdmc_problem *problem, int threads, pdmc_discretisation *out);
