// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/problem.h"

/// The grid of nodes, the plate's edges included. A node on a crack would see neither side: it is made two, a millionth
/// of the spacing away on either side, each with the bonds of its own side.
typedef struct {
    int count;
    double *x; // [count, 2] length
} pdmc_paper_nodes;

/// @param[out] nodes  free with pdmc_paper_nodes_clear(); zero on failure
PDMC_NODISCARD pdmc_status pdmc_paper_nodes_create(const pdmc_problem *problem, pdmc_paper_nodes *nodes);
void pdmc_paper_nodes_clear(pdmc_paper_nodes *nodes);

/// True if x lies on a side of the plate.
bool pdmc_paper_on_side(const pdmc_plate *plate, pdmc_side side, const double x[2]);
