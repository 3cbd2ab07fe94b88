// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bond/horizon.h"

/// A regular grid of square cells with a node at the middle of each. It fills the plate and, beyond every side with
/// prescribed displacements, a layer of the horizon's thickness in which they are prescribed (Macek & Silling 2007);
/// beyond two such sides that meet, their corner as well, where all is held that either side holds, at the mean of what
/// both hold. Unknown 2 k is u, 2 k + 1 is v of node k.
typedef struct {
    int columns, rows, nodes; // node = row * columns + column
    double spacing;           // h, length
    double origin[2];         // position of node 0, length
    uint8_t *held;            // [nodes] bits: 1 where u is prescribed, 2 where v is
    double *prescribed;       // [2 nodes] length; 0 where free
} pdmc_bond_grid;

/// @param[out] out  free with pdmc_bond_grid_clear(); zero on failure
/// @return PDMC_OK or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_bond_grid_create(const pdmc_problem *problem, pdmc_bond_grid *out);
void pdmc_bond_grid_clear(pdmc_bond_grid *grid);

void pdmc_bond_grid_node(const pdmc_bond_grid *grid, int node, double x[2]);

/// Those of all nodes.
/// @param[out] x  [nodes, 2] free with pdmc_free(); NULL on failure
PDMC_NODISCARD pdmc_status pdmc_bond_grid_nodes(const pdmc_bond_grid *grid, double **x);

/// Whether a crack cuts the bond between two points.
///
/// A crack is a closed segment, and a bond that meets it is cut; but the line of the crack belongs to its left face, so
/// that a bond to a point on it is cut only if it comes from the right, and a bond along it is not. Every bond is thus
/// decided, and both directions alike. A point counts as on the line within 1e-9 of `scale`.
/// @param[in] scale  the spacing, length
bool pdmc_bond_is_cut(const pdmc_crack *crack, double scale, const double a[2], const double b[2]);

/// The bonds of every node that no crack cuts. Node k has partners start[k] .. start[k + 1] - 1, in the order of the
/// horizon's neighbours.
typedef struct {
    size_t *start;       // [nodes + 1]
    int *partner;        // [start[nodes]] nodes
    uint16_t *neighbour; // [start[nodes]] index in the horizon
    double *scale;       // [nodes] surface correction; a bond's stiffness is multiplied by the mean of its two nodes'
    size_t cut;          // number of bonds that cracks cut, each counted once
} pdmc_bond_families;

/// Surface correction, where the problem asks for it: scale = the energy of an isotropic stretch of a whole horizon
/// over that of the node's bonds inside the grid, cut or not (Yu 2011, eq. 3.59-3.61, as sums over the bonds; there the
/// scale of one node only multiplies the bond, and K would not be symmetric).
/// @param[out] out  free with pdmc_bond_families_clear(); zero on failure
/// @return PDMC_OK or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_bond_families_create(const pdmc_problem *problem, const pdmc_bond_grid *grid,
                                                     const pdmc_bond_horizon *horizon, pdmc_bond_families *out);
void pdmc_bond_families_clear(pdmc_bond_families *families);
