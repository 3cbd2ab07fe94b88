// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Nodes anywhere.
///
/// The cells are the nodes of one body after the other, each in an order in which eight that follow one another are near one
/// another: they are a block. The last block of a body may have empty cells. A block's list has every node that is a neighbour
/// of any of its own: about twice as many as each of these has, so that a bond takes fewer bytes than a list of its own would.

#include "particles/nodes.h"

/// The nodes of the grid in bodies with a shape come first, then those of the others, in their order.
/// @param[out] nodes  whose bonds are all whole; clear with pdmc_nodes_clear(), whatever is returned
/// @return PDMC_OK; PDMC_ERR_ARG where a node has no sound place or volume, has no neighbour in its body, or is where another
///         is; or where pdmc_lattice_create() refuses a body with a shape; PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_scattered_create(const pdmc_particles_options *options, const pdmc_joints *joints,
                                                 pdmc_nodes *nodes);
