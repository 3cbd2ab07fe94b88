// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Nodes on a regular grid.
///
/// The cells are the grid's box, row after row with x fastest, with empty cells round it, so that a neighbour is at a constant
/// shift of the index wherever a node is. A block is eight cells in a row of x.

#include "particles/nodes.h"

/// @param[out] nodes  whose bonds are all whole; clear with pdmc_nodes_clear(), whatever is returned
/// @return PDMC_OK; PDMC_ERR_ARG where there is no node, bodies overlap, or the grid is too large; PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_lattice_create(const pdmc_particles_options *options, const pdmc_joints *joints,
                                               pdmc_nodes *nodes);
