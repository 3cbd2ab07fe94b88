// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Rigid spheres that push nodes out of themselves.

#include "particles/nodes.h"

/// Adds a sphere's push to the nodes' forces.
/// @param      reaction  [blocks, 4] room for the blocks' shares of what the nodes do to the sphere
/// @param[out] total     [3] force of the nodes on the sphere
/// @return the energy of the contact
double pdmc_sphere_push(const pdmc_rigid_sphere *sphere, const pdmc_nodes *nodes, double *const position[PDMC_AXES],
                        int threads, double *const force[PDMC_AXES], double reaction[], double total[PDMC_AXES]);
