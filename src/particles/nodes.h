// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Nodes with their bonds, and the arrays that hold a value for every one of them.
///
/// The arrays are of cells, most of which have a node. Nodes are worked on in blocks: eight cells in a row.

#include "particles/joints.h"

enum { PDMC_LANES = 8 };

/// Nodes repel each other nearer than this share of their first distance.
#define PDMC_TOUCHING_SHARE 0.9

/// The neighbours of a node of a grid inside the horizon, in the order z, y, x.
typedef struct {
    ptrdiff_t shift; // of the cell's index
    int step[PDMC_AXES];
    double weight;           // volume of the neighbour that counts
    double length;           // |xi|
    double stiffness;        // weight / |xi|
    double slope[PDMC_AXES]; // xi / |xi|^2
    double touching;         // 1 / distance below which the two nodes repel each other; infinite: never
} pdmc_neighbour;

/// Eight cells in a row, and the nodes of one body among them. Cells with nodes of two bodies are in two blocks.
typedef struct {
    size_t cell;  // the first; a multiple of PDMC_LANES
    size_t bonds; // place of its bonds in pdmc_nodes.bonds: one byte a neighbour of its list, bit k for cell + k
    int list,
        listed; // neighbours that any of its nodes has: of a grid, neighbours[lists[list]] .. ; others, partner[bonds] ..
    int body, material;
    uint8_t nodes;    // bit k: cell + k holds a node of the body
    uint8_t occupied; // ... of any body
    bool joined;      // whether any of its bonds is to another body
} pdmc_block;

typedef struct {
    int dimension, count[PDMC_AXES]; // of the box, in cells
    int first[PDMC_AXES];            // of the box, in spacings from the grid's offset
    double spacing, offset[PDMC_AXES];
    size_t pitch[PDMC_AXES]; // of the index: 1, of a row, of a layer
    size_t origin, cells;    // index of the box's first cell; number of cells
    double touching;         // the least of the neighbours' |xi| touching: nothing touches where no |xi| / p is larger
    double reach;            // within which nodes are neighbours; and a little, so that rounding does not matter
    double apart;            // the least distance of nodes that are not, in the reference configuration
    double stiffest;         // the largest sum of weight / |xi| over the bonds that a node can have
    double heaviest;         // ... and of weight
    double contact_distance; // d_c, length: neighbours repel each other below it and the share of their |xi|; 0: never
    double share_start, share_slope; // of a neighbour's volume that counts: min(1, start - slope |xi|)
    int neighbour_count;
    pdmc_neighbour *neighbours; // of a grid
    size_t *cell;               // [node_count] of the nodes, in their order
    int *node;                  // [cells] the inverse
    int list_size;
    uint16_t *lists; // [list_size]
    int block_count, node_count;
    pdmc_block *blocks; // in the order of their cells
    size_t bond_bytes;
    uint8_t *bonds;               // [bond_bytes] whole bonds
    int32_t *partner;             // [bond_bytes] cells of the neighbours; NULL on a grid
    uint8_t *near;                // [bond_bytes] which of a block's nodes the partner is a neighbour of; NULL on a grid
    int16_t *body;                // [cells] -1 in empty cells
    uint16_t *family;             // [cells] bonds of a node before cracks; 0 in empty cells
    double *volume;               // [cells] 0 in empty cells
    double *reference[PDMC_AXES]; // [cells] positions; far away in empty cells
} pdmc_nodes;

void pdmc_nodes_clear(pdmc_nodes *nodes);

/// What bodies share before they have nodes.
pdmc_nodes pdmc_nodes_none(const pdmc_particles_options *options);

/// Whether two cells' nodes are within reach of each other in the reference configuration.
bool pdmc_nodes_are_near(const pdmc_nodes *nodes, size_t i, size_t j);

/// Whether a point of the reference configuration is in a region. @param[in] slack  a length that does not count
bool pdmc_shape_holds(const pdmc_shape *shape, const double x[PDMC_AXES], double slack);

/// Breaks the bonds that cross cracks.
/// @return PDMC_OK, or PDMC_ERR_ARG where a crack crosses no bond that those before it have left, or takes a node's last one
PDMC_NODISCARD pdmc_status pdmc_nodes_cut(pdmc_nodes *nodes, int count, const pdmc_planar_crack cracks[]);

/// Whole bonds of each interface. @param[out] whole  [interfaces]
void pdmc_joints_count(const pdmc_joints *joints, const pdmc_nodes *nodes, int interfaces, uint64_t whole[]);

/// The cell to which the node in a block's cell + lane has the k-th bond of the block's list.
static inline size_t pdmc_nodes_neighbour(const pdmc_nodes *g, const pdmc_block *block, int k, int lane)
{
    if (g->partner) return (size_t)g->partner[block->bonds + (size_t)k];
    return (size_t)((ptrdiff_t)block->cell + lane + g->neighbours[g->lists[block->list + k]].shift);
}

/// The distance of two cells' nodes in the reference configuration, |xi|.
double pdmc_nodes_length(const pdmc_nodes *nodes, size_t i, size_t j);

/// The volume of cell j's node that counts at cell i's node.
double pdmc_nodes_weight(const pdmc_nodes *nodes, size_t i, size_t j);

/// Whole bonds of each of a block's nodes. @param[out] whole  [PDMC_LANES]
void pdmc_nodes_whole(const pdmc_nodes *nodes, const pdmc_block *block, int whole[]);
