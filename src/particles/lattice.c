// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/lattice.h"

#include "base/base_impl.h"

#include <limits.h>
#include <math.h>
#include <string.h>

static const double slack = 1e-9;    // of the spacing, where a region's edge runs through nodes
static const double far_away = 1e30; // in spacings: where empty cells are, so that nothing touches them
static const double most_cells = 2e9;

static size_t index_of(const pdmc_nodes *g, const int place[])
{
    return g->origin + (size_t)place[0] + (size_t)place[1] * g->pitch[1] + (size_t)place[2] * g->pitch[2];
}

/// The corners of a shape's bounding box.
static void bounds(const pdmc_shape *shape, double low[], double high[])
{
    for (int a = 0; a < PDMC_AXES; a++) {
        low[a] = fmin(shape->from[a], shape->to[a]), high[a] = fmax(shape->from[a], shape->to[a]);
        const bool round = shape->kind == PDMC_SHAPE_BALL || (shape->kind == PDMC_SHAPE_CYLINDER && low[a] == high[a]);
        if (shape->kind == PDMC_SHAPE_BALL) low[a] = high[a] = shape->centre[a];
        if (round) low[a] -= shape->radius, high[a] += shape->radius;
    }
}

/// The box of cells that holds all bodies.
static pdmc_status find_box(const pdmc_particles_options *options, pdmc_nodes *g)
{
    double cells = 1.0;
    for (int a = 0; a < PDMC_AXES; a++) {
        double first = INFINITY, last = -INFINITY;
        for (int b = 0; b < options->body_count; b++) {
            double low[PDMC_AXES], high[PDMC_AXES];
            if (options->bodies[b].is_part) continue;
            bounds(&options->bodies[b].shape, low, high);
            first = fmin(first, ceil((low[a] - g->offset[a]) / g->spacing - slack));
            last = fmax(last, floor((high[a] - g->offset[a]) / g->spacing + slack));
        }
        if (a >= g->dimension) first = last = 0.0;
        PDMC_REQUIRE(first <= last, "bodies: they hold no point of the grid");
        cells *= last - first + 1.0;
        PDMC_REQUIRE(cells < most_cells && fabs(first) < most_cells, "the grid would have more than %g cells",
                     most_cells);
        g->first[a] = (int)first;
        g->count[a] = (int)(last - first) + 1;
    }
    return PDMC_OK;
}

/// Rows begin at a multiple of PDMC_LANES. Empty cells stand between rows, layers, and at both ends, `reach` of them at least.
static void lay_out(pdmc_nodes *g, int reach)
{
    const size_t lanes = PDMC_LANES, empty = (size_t)reach;
    g->pitch[0] = 1;
    g->pitch[1] = ((size_t)g->count[0] + lanes - 1) / lanes * lanes + (empty + lanes - 1) / lanes * lanes;
    g->pitch[2] = g->dimension < 3 ? 0 : g->pitch[1] * ((size_t)g->count[1] + empty);
    g->origin = empty * (g->pitch[2] + g->pitch[1]) + (empty + lanes - 1) / lanes * lanes;
    g->cells = 2 * g->origin + g->pitch[1] * (size_t)g->count[1] + g->pitch[2] * (size_t)(g->count[2] - 1);
}

/// The shortest of the grid's steps that are longer than a length.
static double shortest_beyond(const pdmc_nodes *g, double length)
{
    const int reach = (int)floor(length / g->spacing) + 1;
    int least = reach * reach;
    for (int z = 0; z <= (g->dimension < 3 ? 0 : reach); z++)
        for (int y = 0; y <= reach; y++)
            for (int x = 0; x <= reach; x++) {
                const int square = x * x + y * y + z * z;
                if (g->spacing * sqrt(square) > length && square < least) least = square;
            }
    return g->spacing * sqrt(least);
}

static pdmc_status find_neighbours(double volume, pdmc_nodes *g)
{
    pdmc_status status = PDMC_OK;
    const double h = g->spacing;
    const int reach = (int)floor(g->reach / h), layers = g->dimension < 3 ? 0 : reach;
    const int width = 2 * reach + 1;
    g->touching = INFINITY;
    PDMC_NEW(g->neighbours, width * width * (2 * layers + 1));
    for (int z = -layers; z <= layers; z++) {
        for (int y = -reach; y <= reach; y++) {
            for (int x = -reach; x <= reach; x++) {
                const double length = h * sqrt((double)(x * x + y * y + z * z));
                if (length == 0.0 || length > g->reach) continue;
                const double weight = volume * fmin(1.0, g->share_start - g->share_slope * length);
                const double distance = fmin(PDMC_TOUCHING_SHARE * length, g->contact_distance);
                const double touching = distance > 0.0 ? 1.0 / distance : INFINITY;
                g->touching = fmin(g->touching, length * touching);
                g->stiffest += weight / length;
                g->heaviest += weight;
                g->neighbours[g->neighbour_count++] = (pdmc_neighbour){
                    .shift = x + y * (ptrdiff_t)g->pitch[1] + z * (ptrdiff_t)g->pitch[2],
                    .step = {x, y, z},
                    .weight = weight,
                    .length = length,
                    .stiffness = weight / length,
                    .slope = {h * x / (length * length), h * y / (length * length), h * z / (length * length)},
                    .touching = touching,
                };
            }
        }
    }
done:
    return status;
}

/// The body that has the node, -1 for none.
static pdmc_status body_at(const pdmc_particles_options *options, const double x[], int16_t *body)
{
    *body = -1;
    for (int b = 0; b < options->body_count; b++) {
        if (options->bodies[b].is_part) continue;
        if (!pdmc_shape_holds(&options->bodies[b].shape, x, slack * options->spacing)) continue;
        PDMC_REQUIRE(*body < 0, "bodies[%d]: overlaps bodies[%d], both have the node at (%g, %g, %g)", b, *body, x[0],
                     x[1], x[2]);
        *body = (int16_t)b;
    }
    if (*body >= 0) *body = pdmc_part_at(options, *body, x);
    return PDMC_OK;
}

static pdmc_status place_nodes(const pdmc_particles_options *options, double volume, pdmc_nodes *g)
{
    int16_t *body = g->body;
    for (size_t c = 0; c < g->cells; c++) {
        body[c] = -1;
        for (int a = 0; a < PDMC_AXES; a++) g->reference[a][c] = far_away * g->spacing;
    }
    int place[PDMC_AXES];
    for (place[2] = 0; place[2] < g->count[2]; place[2]++) {
        for (place[1] = 0; place[1] < g->count[1]; place[1]++) {
            for (place[0] = 0; place[0] < g->count[0]; place[0]++) {
                double x[PDMC_AXES] = {0.0};
                for (int a = 0; a < g->dimension; a++) x[a] = g->offset[a] + g->spacing * (g->first[a] + place[a]);
                const size_t c = index_of(g, place);
                const pdmc_status status = body_at(options, x, &body[c]);
                if (status != PDMC_OK) return status;
                if (body[c] < 0) continue;
                g->node_count++;
                g->volume[c] = volume;
                for (int a = 0; a < PDMC_AXES; a++) g->reference[a][c] = x[a];
            }
        }
    }
    return PDMC_OK;
}

static void list_nodes(pdmc_nodes *g)
{
    size_t node = 0;
    for (size_t c = 0; c < g->cells; c++) {
        if (g->body[c] < 0) continue;
        g->node[c] = (int)node;
        g->cell[node++] = c;
    }
}

static uint8_t lanes_of_body(const int16_t body[], int wanted)
{
    unsigned bits = 0;
    for (int k = 0; k < PDMC_LANES; k++) bits |= (unsigned)(body[k] == wanted) << k;
    return (uint8_t)bits;
}

/// The blocks of the cells from c on: one a body. Counts them where there is no room yet.
static void add_blocks(const pdmc_particles_options *options, pdmc_nodes *g, size_t c)
{
    const int16_t *body = g->body;
    const uint8_t all = (uint8_t)~lanes_of_body(&body[c], -1);
    uint8_t left = all;
    while (left) {
        const int b = body[c + (size_t)__builtin_ctz(left)];
        const uint8_t nodes = lanes_of_body(&body[c], b);
        if (g->blocks)
            g->blocks[g->block_count] = (pdmc_block){
                .cell = c, .body = b, .material = options->bodies[b].material, .nodes = nodes, .occupied = all};
        g->block_count++;
        left &= (uint8_t)~nodes;
    }
}

static void find_blocks(const pdmc_particles_options *options, pdmc_nodes *g)
{
    g->block_count = 0;
    for (int z = 0; z < g->count[2]; z++)
        for (int y = 0; y < g->count[1]; y++)
            for (int x = 0; x < g->count[0]; x += PDMC_LANES) add_blocks(options, g, index_of(g, (int[]){x, y, z}));
}

static uint8_t lanes_of_joined(const pdmc_joints *joints, const int16_t body[], int wanted)
{
    unsigned bits = 0;
    for (int k = 0; k < PDMC_LANES; k++) bits |= (unsigned)pdmc_joints_bond(joints, wanted, body[k]) << k;
    return (uint8_t)bits;
}

/// The whole bonds of a block to one of the neighbours.
static uint8_t bonded(const pdmc_joints *joints, const pdmc_block *block, const int16_t body[], ptrdiff_t shift)
{
    const int16_t *other = &body[(ptrdiff_t)block->cell + shift];
    return block->nodes &
           (joints->bonded ? lanes_of_joined(joints, other, block->body) : lanes_of_body(other, block->body));
}

/// Whether a block's nodes have anybody at a neighbour's place, their own body or another.
static bool meets(const pdmc_block *block, const int16_t body[], ptrdiff_t shift)
{
    return (block->nodes & (uint8_t)~lanes_of_body(&body[(ptrdiff_t)block->cell + shift], -1)) != 0;
}

/// The list of neighbours that a block meets. Most blocks meet the same as one not long before them.
static void find_list(pdmc_nodes *g, pdmc_block *block, int previous[], int kept, int *next)
{
    uint16_t *list = &g->lists[g->list_size];
    int listed = 0;
    for (int n = 0; n < g->neighbour_count; n++)
        if (meets(block, g->body, g->neighbours[n].shift)) list[listed++] = (uint16_t)n;
    block->list = g->list_size;
    block->listed = listed;
    for (int k = 0; k < kept && previous[2 * k + 1] > 0; k++) {
        if (previous[2 * k + 1] != listed || memcmp(&g->lists[previous[2 * k]], list, (size_t)listed * sizeof *list))
            continue;
        block->list = previous[2 * k];
        return;
    }
    g->list_size += listed;
    previous[2 * *next] = block->list;
    previous[2 * *next + 1] = listed;
    *next = (*next + 1) % kept;
}

/// The lists, and room for the bonds.
static pdmc_status find_lists(pdmc_nodes *g)
{
    enum { KEPT = 64 };
    int previous[2 * KEPT] = {0}, next = 0;
    pdmc_status status = PDMC_OK;
    const double most = (double)g->block_count * g->neighbour_count;
    if (most > INT_MAX) return pdmc_raise(PDMC_ERR_ARG, "the grid would have more than %d bonds", INT_MAX);
    PDMC_NEW(g->lists, (size_t)g->block_count * (size_t)g->neighbour_count);
    for (int b = 0; b < g->block_count; b++) {
        find_list(g, &g->blocks[b], previous, KEPT, &next);
        g->blocks[b].bonds = g->bond_bytes;
        g->bond_bytes += (size_t)g->blocks[b].listed;
    }
done:
    return status;
}

static void join(const pdmc_joints *joints, pdmc_nodes *g)
{
    for (int b = 0; b < g->block_count; b++) {
        pdmc_block *block = &g->blocks[b];
        int whole[PDMC_LANES];
        for (int n = 0; n < block->listed; n++) {
            const ptrdiff_t shift = g->neighbours[g->lists[block->list + n]].shift;
            const uint8_t bonds = bonded(joints, block, g->body, shift);
            g->bonds[block->bonds + (size_t)n] = bonds;
            block->joined |= (bonds & ~bonded(&(pdmc_joints){0}, block, g->body, shift)) != 0;
        }
        pdmc_nodes_whole(g, block, whole);
        for (int k = 0; k < PDMC_LANES; k++)
            if (block->nodes >> k & 1) g->family[block->cell + (size_t)k] = (uint16_t)whole[k];
    }
}

pdmc_status pdmc_lattice_create(const pdmc_particles_options *options, const pdmc_joints *joints, pdmc_nodes *g)
{
    pdmc_status status = PDMC_OK;
    *g = pdmc_nodes_none(options);
    const double h = options->spacing;
    const double volume = h * h * (g->dimension < 3 ? options->thickness : h);
    g->apart = shortest_beyond(g, g->reach);
    memcpy(g->offset, options->offset, sizeof g->offset);
    PDMC_TRY(find_box(options, g));
    lay_out(g, (int)floor(g->reach / h));
    PDMC_NEW(g->body, g->cells + PDMC_LANES);
    PDMC_NEW(g->volume, g->cells + PDMC_LANES);
    for (int a = 0; a < PDMC_AXES; a++) PDMC_NEW(g->reference[a], g->cells + PDMC_LANES);
    PDMC_TRY(find_neighbours(volume, g));
    PDMC_TRY(place_nodes(options, volume, g));
    if (g->node_count == 0) PDMC_FAIL(PDMC_ERR_ARG, "bodies: they hold no point of the grid");
    PDMC_NEW(g->cell, g->node_count);
    PDMC_NEW(g->node, g->cells);
    list_nodes(g);
    find_blocks(options, g);
    PDMC_NEW(g->blocks, g->block_count);
    find_blocks(options, g);
    PDMC_TRY(find_lists(g));
    PDMC_NEW(g->bonds, g->bond_bytes);
    PDMC_NEW(g->family, g->cells);
    join(joints, g);

done:
    return status;
}
