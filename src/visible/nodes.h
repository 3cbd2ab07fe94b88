// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The nodes of the plate, graded towards the cracks.
///
/// The spacing is h(x) = min(spacing, h_f + 0.12 max(d(x) - max(delta / 2, 3 h_f), 0)), h_f = delta / refinement, d the
/// distance to the nearest crack: the field has a layer as wide as the horizon round every crack.

#include "visible/grid.h"
#include "visible/view.h"

typedef struct {
    pdmc_view view;
    double spacing; // h there, length
    int edge;       // of a ghost: the side of the plate it belongs to; -1 for a node of the plate
    double foot[2]; // of a ghost: its place on that side
    int inward;     // of a ghost: the ghost before it on the way out, or the node at its foot
    int ring;       // of a ghost: 1 next to the side, 2, ..; 0 for a node of the plate
} pdmc_visible_node;

typedef struct {
    double finest; // h_f
    int count;
    pdmc_visible_node *node; // [count] faces of the cracks, sides of the plate, its inside, ghosts
    pdmc_grid grid;          // of all nodes, in their order
} pdmc_visible_nodes;

/// With `faces` doubled nodes on the faces of the cracks, the last one half a spacing before the tip and none at it;
/// two rings of nodes round every tip; nodes on the sides of the plate, none at its corners nor at the mouths of edge
/// cracks; the inside filled by greedy thinning of a low-discrepancy sequence and a little repulsion; and, with
/// `ghosts`, nodes outside for every one on a side, as far as the horizon reaches. No random numbers.
/// @param[out] nodes  free with pdmc_visible_nodes_clear(); zero on failure
PDMC_NODISCARD pdmc_status pdmc_visible_nodes_create(const pdmc_problem *problem, const pdmc_cuts *cuts, bool faces,
                                                     bool ghosts, pdmc_visible_nodes *nodes);
void pdmc_visible_nodes_clear(pdmc_visible_nodes *nodes);
