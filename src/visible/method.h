// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/discretisation.h"

/// The plate with bonds that the cracks cut behind the verbs of every method.
PDMC_NODISCARD pdmc_status pdmc_visible_discretise(const pdmc_problem *problem, int threads, pdmc_discretisation *out);
