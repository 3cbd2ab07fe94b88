// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Nodes on a regular grid, and the arrays that hold a value for every one of them.
///
/// The arrays are of cells: the grid's box, row after row with x fastest, with empty cells round it, so that a neighbour is
/// at a constant shift of the index wherever a node is. Nodes are worked on in blocks: eight cells in a row of x.

#include "pdmc/particles.h"

enum { PDMC_LANES = 8 };

/// The neighbours of a node inside the horizon, in the order z, y, x.
typedef struct {
    ptrdiff_t shift; // of the cell's index
    int step[PDMC_AXES];
    double weight;    // volume of the neighbour that counts
    double length;    // |xi|
    double stiffness; // weight / |xi|
    double touching;  // 1 / distance below which the two nodes repel each other; infinite: never
} pdmc_neighbour;

/// Eight cells in a row, and the nodes of one body among them. Cells with nodes of two bodies are in two blocks.
typedef struct {
    size_t cell;      // the first; a multiple of PDMC_LANES
    size_t bonds;     // place of its bonds in pdmc_lattice.bonds: one byte a neighbour of its list, bit k for cell + k
    int list, listed; // neighbours[lists[list]] .. : those that any of its nodes has
    int body, material;
    int first_node;   // index of the first node in these cells, of any body
    uint8_t nodes;    // bit k: cell + k holds a node of the body
    uint8_t occupied; // ... of any body
} pdmc_block;

typedef struct {
    int dimension, count[PDMC_AXES]; // of the box, in cells
    int first[PDMC_AXES];            // of the box, in spacings from the grid's offset
    double spacing, offset[PDMC_AXES];
    double volume;           // of a node
    size_t pitch[PDMC_AXES]; // of the index: 1, of a row, of a layer
    size_t origin, cells;    // index of the box's first cell; number of cells
    double touching;         // the least of the neighbours' |xi| touching: nothing touches where no |xi| / p is larger
    int neighbour_count;
    pdmc_neighbour *neighbours;
    size_t *nodes; // [node_count] cells of the nodes, in their order
    int list_size;
    uint16_t *lists; // [list_size]
    int block_count, node_count;
    pdmc_block *blocks; // in the order of their cells
    size_t bond_bytes;
    uint8_t *bonds;               // [bond_bytes]
    int16_t *body;                // [cells] -1 in empty cells
    uint16_t *family;             // [cells] bonds of a node before cracks; 0 in empty cells
    double *reference[PDMC_AXES]; // [cells] positions; far away in empty cells
} pdmc_lattice;

/// @param[out] lattice  whose bonds are all whole; clear with pdmc_lattice_clear(), whatever is returned
/// @return PDMC_OK; PDMC_ERR_ARG where there is no node, bodies overlap, or the grid is too large; PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_lattice_create(const pdmc_particles_options *options, pdmc_lattice *lattice);
void pdmc_lattice_clear(pdmc_lattice *lattice);

/// The largest distance of neighbours: the horizon, or what the volume rule adds to it; and a little, so that rounding does not
/// matter.
double pdmc_lattice_reach(const pdmc_particles_options *options);

/// Whether a point of the reference configuration is in a region. @param[in] slack  a length that does not count
bool pdmc_shape_holds(const pdmc_shape *shape, const double x[PDMC_AXES], double slack);

/// Breaks the bonds that cross cracks.
/// @return PDMC_OK, or PDMC_ERR_ARG where a crack crosses no bond that those before it have left
PDMC_NODISCARD pdmc_status pdmc_lattice_cut(pdmc_lattice *lattice, int count, const pdmc_planar_crack cracks[]);

/// The index of the node in a block's cell + k, in the order of the cells.
int pdmc_lattice_node(const pdmc_block *block, int k);

/// Whole bonds of each of a block's nodes. @param[out] whole  [PDMC_LANES]
void pdmc_lattice_whole(const pdmc_lattice *lattice, const pdmc_block *block, int whole[]);
