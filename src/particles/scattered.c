// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/scattered.h"

#include "base/base_impl.h"
#include "particles/bins.h"
#include "particles/bisection.h"
#include "particles/lattice.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double same_place = 1e-6; // of the spacing
static const double far_away = 1e30;   // in spacings: where empty cells are, so that nothing touches them

/// Nodes in their order, before they have cells.
typedef struct {
    int count;
    double *x[PDMC_AXES], *volume;
    int16_t *body;
} cloud;

static int own_nodes(const pdmc_particles_options *options, int body)
{
    const pdmc_body *b = &options->bodies[body];
    return pdmc_shape_has_nodes(b->shape.kind) ? b->node_count : 0;
}

static void clear_cloud(cloud *c)
{
    for (int a = 0; a < PDMC_AXES; a++) pdmc_free(c->x[a]);
    pdmc_free(c->volume);
    pdmc_free(c->body);
}

static pdmc_status make_cloud(size_t count, cloud *c)
{
    pdmc_status status = PDMC_OK;
    if (count > INT_MAX / 2) PDMC_FAIL(PDMC_ERR_ARG, "the bodies have %zu nodes, more than %d", count, INT_MAX / 2);
    for (int a = 0; a < PDMC_AXES; a++) PDMC_NEW(c->x[a], count);
    PDMC_NEW(c->volume, count);
    PDMC_NEW(c->body, count);
done:
    return status;
}

/// The grid in the bodies that have no nodes of their own. @param[out] body  [body_count] numbers of these bodies
static pdmc_status make_grid(const pdmc_particles_options *options, int body[], pdmc_nodes *grid)
{
    pdmc_status status = PDMC_OK;
    pdmc_particles_options shaped = *options;
    pdmc_body *bodies = NULL;
    shaped.body_count = 0;
    PDMC_NEW(bodies, options->body_count);
    for (int b = 0; b < options->body_count; b++) {
        if (pdmc_shape_has_nodes(options->bodies[b].shape.kind) || options->bodies[b].is_part) continue;
        body[shaped.body_count] = b;
        bodies[shaped.body_count++] = options->bodies[b];
    }
    shaped.bodies = bodies;
    if (shaped.body_count > 0) PDMC_TRY(pdmc_lattice_create(&shaped, &(pdmc_joints){0}, grid));
done:
    pdmc_free(bodies);
    return status;
}

static pdmc_status check_node(const pdmc_particles_options *options, int body, int k)
{
    const pdmc_node *node = &options->bodies[body].nodes[k];
    const double *x = node->x;
    PDMC_REQUIRE(isfinite(x[0]) && isfinite(x[1]) && isfinite(x[2]), "bodies[%d]: node %d is at (%g, %g, %g)", body, k,
                 x[0], x[1], x[2]);
    PDMC_REQUIRE(options->dimension == 3 || x[2] == 0.0, "bodies[%d]: node %d is at z = %g in two dimensions", body, k,
                 x[2]);
    PDMC_REQUIRE(node->volume > 0.0 && isfinite(node->volume), "bodies[%d]: node %d has the volume %g, needs to be > 0",
                 body, k, node->volume);
    return PDMC_OK;
}

static void add_grid(const pdmc_particles_options *options, const pdmc_nodes *grid, const int body[], cloud *c)
{
    for (int k = 0; k < grid->node_count; k++, c->count++) {
        const size_t cell = grid->cell[k];
        const double x[PDMC_AXES] = {grid->reference[0][cell], grid->reference[1][cell], grid->reference[2][cell]};
        for (int a = 0; a < PDMC_AXES; a++) c->x[a][c->count] = x[a];
        c->volume[c->count] = grid->volume[cell];
        c->body[c->count] = pdmc_part_at(options, body[grid->body[cell]], x);
    }
}

static pdmc_status add_bodies(const pdmc_particles_options *options, cloud *c)
{
    for (int b = 0; b < options->body_count; b++) {
        for (int k = 0; k < own_nodes(options, b); k++, c->count++) {
            const pdmc_node *node = &options->bodies[b].nodes[k];
            const pdmc_status status = check_node(options, b, k);
            if (status != PDMC_OK) return status;
            for (int a = 0; a < PDMC_AXES; a++) c->x[a][c->count] = node->x[a];
            c->volume[c->count] = node->volume;
            c->body[c->count] = pdmc_part_at(options, b, node->x);
        }
    }
    return PDMC_OK;
}

static pdmc_status collect(const pdmc_particles_options *options, cloud *c)
{
    pdmc_status status = PDMC_OK;
    pdmc_nodes grid = {0};
    int *body = NULL;
    PDMC_NEW(body, options->body_count);
    PDMC_TRY(make_grid(options, body, &grid));
    size_t count = (size_t)grid.node_count;
    for (int b = 0; b < options->body_count; b++) count += (size_t)own_nodes(options, b);
    if (count == 0) PDMC_FAIL(PDMC_ERR_ARG, "no node: the bodies have none");
    PDMC_TRY(make_cloud(count, c));
    add_grid(options, &grid, body, c);
    PDMC_TRY(add_bodies(options, c));
done:
    pdmc_nodes_clear(&grid);
    pdmc_free(body);
    return status;
}

static int list_body(const cloud *c, int body, int order[])
{
    int count = 0;
    for (int k = 0; k < c->count; k++)
        if (c->body[k] == body) order[count++] = k;
    return count;
}

static int blocks_of(int nodes)
{
    return (nodes + PDMC_LANES - 1) / PDMC_LANES;
}

/// Room for the cells; empty ones are as they should be.
static pdmc_status make_cells(const pdmc_particles_options *options, const cloud *c, int order[], pdmc_nodes *g)
{
    pdmc_status status = PDMC_OK;
    for (int b = 0; b < options->body_count; b++) g->block_count += blocks_of(list_body(c, b, order));
    g->node_count = c->count;
    g->cells = (size_t)g->block_count * PDMC_LANES;
    PDMC_NEW(g->blocks, g->block_count);
    PDMC_NEW(g->cell, c->count);
    PDMC_NEW(g->node, g->cells);
    PDMC_NEW(g->volume, g->cells + PDMC_LANES);
    PDMC_NEW(g->body, g->cells + PDMC_LANES);
    PDMC_NEW(g->family, g->cells);
    for (int a = 0; a < PDMC_AXES; a++) PDMC_NEW(g->reference[a], g->cells + PDMC_LANES);
    for (size_t i = 0; i < g->cells + PDMC_LANES; i++) {
        g->body[i] = -1;
        for (int a = 0; a < PDMC_AXES; a++) g->reference[a][i] = far_away * g->spacing;
    }
done:
    return status;
}

/// Puts the nodes of a body into cells, from those of the block on. @return the block after the last
static int fill_blocks(const cloud *c, int body, int material, int count, const int order[], int block, pdmc_nodes *g)
{
    for (int k = 0; k < count; k++) {
        const size_t cell = (size_t)block * PDMC_LANES + (size_t)k;
        const int node = order[k];
        g->cell[node] = cell;
        g->node[cell] = node;
        g->volume[cell] = c->volume[node];
        g->body[cell] = (int16_t)body;
        for (int a = 0; a < PDMC_AXES; a++) g->reference[a][cell] = c->x[a][node];
    }
    for (int b = 0; b < blocks_of(count); b++) {
        const int left = count - b * PDMC_LANES;
        const uint8_t nodes = (uint8_t)(left < PDMC_LANES ? (1u << left) - 1u : 0xffu);
        g->blocks[block + b] = (pdmc_block){.cell = (size_t)(block + b) * PDMC_LANES,
                                            .body = body,
                                            .material = material,
                                            .nodes = nodes,
                                            .occupied = nodes};
    }
    return block + blocks_of(count);
}

/// @param[out] order  [nodes] in which they have cells
static pdmc_status lay_out(const pdmc_particles_options *options, const cloud *c, int order[], pdmc_nodes *g)
{
    pdmc_status status = PDMC_OK;
    int block = 0, before = 0;
    PDMC_TRY(make_cells(options, c, order, g));
    for (int b = 0; b < options->body_count; b++) {
        const int count = list_body(c, b, &order[before]);
        PDMC_TRY(pdmc_bisect((const double *const *)c->x, count, PDMC_LANES, &order[before]));
        block = fill_blocks(c, b, options->bodies[b].material, count, &order[before], block, g);
        before += count;
    }
done:
    return status;
}

/// The nodes sorted into bins by their places, as points in the order of their cells.
static pdmc_status sort_into_bins(const cloud *c, const int order[], double reach, pdmc_bins *bins)
{
    pdmc_status status = PDMC_OK;
    double *x[PDMC_AXES] = {NULL};
    PDMC_TRY(pdmc_bins_create(c->count, bins));
    for (int a = 0; a < PDMC_AXES; a++) {
        PDMC_NEW(x[a], c->count);
        for (int k = 0; k < c->count; k++) x[a][k] = c->x[a][order[k]];
    }
    pdmc_bins_fill(bins, x, reach);
done:
    for (int a = 0; a < PDMC_AXES; a++) pdmc_free(x[a]);
    return status;
}

/// What finds the neighbours of blocks.
typedef struct {
    pdmc_nodes *nodes;
    const pdmc_bins *bins;
    const int *order; // [nodes] of the bins' points
} search;

/// The box of a block's nodes, and what is within reach of it.
static void find_box(const pdmc_nodes *g, const pdmc_block *block, double low[], double high[])
{
    for (int a = 0; a < PDMC_AXES; a++) {
        low[a] = INFINITY, high[a] = -INFINITY;
        for (unsigned left = block->nodes; left; left &= left - 1) {
            const double x = g->reference[a][block->cell + (size_t)__builtin_ctz(left)];
            low[a] = fmin(low[a], x - g->reach), high[a] = fmax(high[a], x + g->reach);
        }
    }
}

/// Which of a block's nodes have the node as a neighbour.
static uint8_t find_near(const pdmc_nodes *g, const pdmc_block *block, size_t cell)
{
    unsigned near = 0;
    for (unsigned left = block->nodes; left; left &= left - 1) {
        const int lane = __builtin_ctz(left);
        const size_t here = block->cell + (size_t)lane;
        if (here != cell && pdmc_nodes_are_near(g, here, cell)) near |= 1u << lane;
    }
    return (uint8_t)near;
}

/// The neighbours of a block in one of the bins. @param[in] write  whether to write them from `at` on  @return how many
static int search_bin(const search *s, const pdmc_block *block, int bin, const double low[], const double high[],
                      bool write, size_t at)
{
    pdmc_nodes *g = s->nodes;
    int found = 0;
    for (int k = s->bins->start[bin]; k < s->bins->start[bin + 1]; k++) {
        bool outside = false;
        for (int a = 0; a < PDMC_AXES; a++) outside |= s->bins->x[a][k] < low[a] || s->bins->x[a][k] > high[a];
        if (outside) continue;
        const size_t cell = g->cell[s->order[s->bins->sorted[k]]];
        const uint8_t near = find_near(g, block, cell);
        if (near == 0) continue;
        if (write) g->partner[at + (size_t)found] = (int32_t)cell, g->near[at + (size_t)found] = near;
        found++;
    }
    return found;
}

static void search_block(const search *s, pdmc_block *block, bool write)
{
    const pdmc_bins *bins = s->bins;
    double low[PDMC_AXES], high[PDMC_AXES];
    int from[PDMC_AXES], to[PDMC_AXES], found = 0;
    find_box(s->nodes, block, low, high);
    pdmc_bins_place(bins, low, from);
    pdmc_bins_place(bins, high, to);
    for (int z = from[2]; z <= to[2]; z++)
        for (int y = from[1]; y <= to[1]; y++)
            for (int x = from[0]; x <= to[0]; x++)
                found += search_bin(s, block, (z * bins->count[1] + y) * bins->count[0] + x, low, high, write,
                                    block->bonds + (size_t)found);
    block->listed = found;
}

static pdmc_status find_lists(const search *s, int threads)
{
    pdmc_status status = PDMC_OK;
    pdmc_nodes *g = s->nodes;
#pragma omp parallel for num_threads(threads) schedule(dynamic, 64)
    for (int b = 0; b < g->block_count; b++) search_block(s, &g->blocks[b], false);
    for (int b = 0; b < g->block_count; b++) {
        g->blocks[b].bonds = g->bond_bytes;
        g->bond_bytes += (size_t)g->blocks[b].listed;
    }
    PDMC_NEW(g->bonds, g->bond_bytes);
    PDMC_NEW(g->partner, g->bond_bytes);
    PDMC_NEW(g->near, g->bond_bytes);
#pragma omp parallel for num_threads(threads) schedule(dynamic, 64)
    for (int b = 0; b < g->block_count; b++) search_block(s, &g->blocks[b], true);
done:
    return status;
}

static pdmc_status find_neighbours(const pdmc_particles_options *options, const cloud *c, const int order[],
                                   pdmc_nodes *g)
{
    pdmc_status status = PDMC_OK;
    pdmc_bins bins = {0};
    PDMC_TRY(sort_into_bins(c, order, g->reach, &bins));
    PDMC_TRY(find_lists(&(search){.nodes = g, .bins = &bins, .order = order}, options->threads));
done:
    pdmc_bins_clear(&bins);
    return status;
}

/// The body of a cell's node and where that is, for messages.
static const char *node_text(const pdmc_nodes *g, size_t cell, char text[128])
{
    snprintf(text, 128, "bodies[%d]: the node at (%g, %g, %g)", g->body[cell], g->reference[0][cell],
             g->reference[1][cell], g->reference[2][cell]);
    return text;
}

/// Makes the bonds of a block, and adds up what its nodes have.
static pdmc_status join_block(const pdmc_joints *joints, pdmc_nodes *g, pdmc_block *block, double stiffness[],
                              double weight[])
{
    char here[128];
    for (int n = 0; n < block->listed; n++) {
        const size_t entry = block->bonds + (size_t)n, other = (size_t)g->partner[entry];
        const bool bonded = pdmc_joints_bond(joints, block->body, g->body[other]);
        if (bonded) g->bonds[entry] = g->near[entry];
        block->joined |= bonded && g->body[other] != block->body;
        for (unsigned left = g->near[entry]; left; left &= left - 1) {
            const int k = __builtin_ctz(left);
            const size_t cell = block->cell + (size_t)k;
            const double length = pdmc_nodes_length(g, cell, other);
            PDMC_REQUIRE(length > same_place * g->spacing, "%s is in the same place as one of bodies[%d]",
                         node_text(g, cell, here), g->body[other]);
            if (!bonded) continue;
            stiffness[k] += pdmc_nodes_weight(g, cell, other) / length;
            weight[k] += pdmc_nodes_weight(g, cell, other);
        }
    }
    return PDMC_OK;
}

static pdmc_status count_family(pdmc_nodes *g, const pdmc_block *block)
{
    int whole[PDMC_LANES];
    char here[128];
    pdmc_nodes_whole(g, block, whole);
    for (unsigned left = block->nodes; left; left &= left - 1) {
        const int k = __builtin_ctz(left);
        const size_t cell = block->cell + (size_t)k;
        PDMC_REQUIRE(whole[k] > 0, "%s has no other to be bonded with within %g", node_text(g, cell, here), g->reach);
        PDMC_REQUIRE(whole[k] <= UINT16_MAX, "%s has %d others within %g, more than %d", node_text(g, cell, here),
                     whole[k], g->reach, UINT16_MAX);
        g->family[cell] = (uint16_t)whole[k];
    }
    return PDMC_OK;
}

static pdmc_status join(const pdmc_joints *joints, pdmc_nodes *g)
{
    pdmc_status status = PDMC_OK;
    for (int b = 0; b < g->block_count; b++) {
        double stiffness[PDMC_LANES] = {0.0}, weight[PDMC_LANES] = {0.0};
        PDMC_TRY(join_block(joints, g, &g->blocks[b], stiffness, weight));
        PDMC_TRY(count_family(g, &g->blocks[b]));
        for (int k = 0; k < PDMC_LANES; k++) {
            g->stiffest = fmax(g->stiffest, stiffness[k]);
            g->heaviest = fmax(g->heaviest, weight[k]);
        }
    }
done:
    return status;
}

pdmc_status pdmc_scattered_create(const pdmc_particles_options *options, const pdmc_joints *joints, pdmc_nodes *g)
{
    pdmc_status status = PDMC_OK;
    cloud c = {0};
    int *order = NULL;
    *g = pdmc_nodes_none(options);
    g->apart = g->reach;
    g->touching = g->contact_distance > 0.0 ? 1.0 / PDMC_TOUCHING_SHARE : INFINITY;
    PDMC_TRY(collect(options, &c));
    PDMC_NEW(order, c.count);
    PDMC_TRY(lay_out(options, &c, order, g));
    PDMC_TRY(find_neighbours(options, &c, order, g));
    PDMC_TRY(join(joints, g));
done:
    clear_cloud(&c);
    pdmc_free(order);
    return status;
}
