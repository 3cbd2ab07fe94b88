// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The plates of kansa/plate.h with the settings of the paper's recipe: e = horizon / 5.

#include "kansa/plate.h"
#include "paper/paper_impl.h"

static inline void paper_settings(plate *p, bool tip_functions)
{
    p->problem.solver.crack_model = PDMC_CRACKS_PAPER;
    p->problem.solver.edge_layer = p->problem.solver.horizon / 5.0;
    p->problem.solver.tip_functions = tip_functions ? PDMC_ON : PDMC_OFF;
}
