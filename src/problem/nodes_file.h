// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/mesh.h"
#include "pdmc/particles.h"

/// Reads nodes, one a line: `x y volume` in two dimensions, `x y z volume` in three, in the study's units. What follows a # is
/// a comment; empty lines do not count.
/// @param[out] count  of the nodes
/// @param[out] nodes  [count] in the order of the lines, to be freed with pdmc_free(); NULL on failure
/// @return PDMC_OK; PDMC_ERR_NO_INPUT; PDMC_ERR_DATA with file, line and reason where a line is no node, a number is not finite,
///         a volume is not positive, or two nodes are in one place; PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_nodes_read(const char *path, int dimension, int *count, pdmc_node **nodes);

/// The nodes of a mesh of Gmsh, triangles in two dimensions and tetrahedra in three, with their shares of it.
/// @param[in]  depth      by which an area is a volume
/// @param[out] generator  what read it
/// @return as pdmc_nodes_read(), or PDMC_ERR_EXTERN without Gmsh
PDMC_NODISCARD pdmc_status pdmc_nodes_of_mesh(const char *path, int dimension, pdmc_share share, double depth,
                                              char generator[PDMC_GENERATOR_SIZE], int *count, pdmc_node **nodes);
