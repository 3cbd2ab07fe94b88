// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/dissection.h"

/// Nodes first[0] .. first[0] + count[0] - 1 of the columns, and of the rows likewise.
typedef struct {
    int first[2], count[2];
} part;

static int64_t *append(const pdmc_bond_grid *grid, const part *nodes, int64_t order[])
{
    for (int row = nodes->first[1]; row < nodes->first[1] + nodes->count[1]; row++)
        for (int column = nodes->first[0]; column < nodes->first[0] + nodes->count[0]; column++)
            for (int k = 0; k < 2; k++) *order++ = 2 * ((int64_t)row * grid->columns + column) + k;
    return order;
}

static part cut(const part *nodes, int axis, int from, int count)
{
    part piece = *nodes;
    piece.first[axis] += from;
    piece.count[axis] = count;
    return piece;
}

static int64_t *dissect(const pdmc_bond_grid *grid, int reach, const part *nodes, int64_t order[])
{
    const int axis = nodes->count[0] >= nodes->count[1] ? 0 : 1, length = nodes->count[axis];
    if (length < 3 * reach) return append(grid, nodes, order); // a smaller part would be all strip
    const int before = (length - reach) / 2;
    const part strip = cut(nodes, axis, before, reach), near = cut(nodes, axis, 0, before);
    const part far = cut(nodes, axis, before + reach, length - reach - before);
    order = dissect(grid, reach, &near, order);
    order = dissect(grid, reach, &far, order);
    return append(grid, &strip, order);
}

void pdmc_bond_dissection(const pdmc_bond_plate *plate, int64_t order[])
{
    int reach = 1;
    for (int k = 0; k < plate->horizon.count; k++)
        if (plate->horizon.neighbour[k].column > reach) reach = plate->horizon.neighbour[k].column;
    dissect(&plate->grid, reach, &(part){.count = {plate->grid.columns, plate->grid.rows}}, order);
}
