// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/particles.h"

/// Reads nodes, one a line: `x y volume` in two dimensions, `x y z volume` in three, in the study's units. What follows a # is
/// a comment; empty lines do not count.
/// @param[out] count  of the nodes
/// @param[out] nodes  [count] in the order of the lines, to be freed with pdmc_free(); NULL on failure
/// @return PDMC_OK; PDMC_ERR_NO_INPUT; PDMC_ERR_DATA with file, line and reason where a line is no node, a number is not finite,
///         a volume is not positive, or two nodes are in one place; PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_nodes_read(const char *path, int dimension, int *count, pdmc_node **nodes);
