// SPDX-License-Identifier: GPL-3.0-or-later

/// The pieces that bodies are in: disjoint sets of nodes that bonds connect (Tarjan, Journal of the ACM 22 (1975) 215-225).

#include "base/base_impl.h"
#include "particles/particles_impl.h"

#include <stdlib.h>
#include <string.h>

/// A piece while it has no number yet.
typedef struct {
    size_t root;
    double mass;
} piece;

static size_t root_of(size_t parent[], size_t cell)
{
    while (parent[cell] != cell) cell = parent[cell] = parent[parent[cell]];
    return cell;
}

/// The root of a set is its first cell, so that it does not depend on the order of the bonds.
static void unite(size_t parent[], size_t a, size_t b)
{
    if (parent[a] == parent[b]) return;
    const size_t first = root_of(parent, a), second = root_of(parent, b);
    if (first < second) parent[second] = first;
    else parent[first] = second;
}

/// Every bond from that of its nodes which comes first.
static void unite_bonds(const pdmc_nodes *g, const pdmc_block *block, size_t parent[])
{
    for (int k = 0; k < block->listed; k++) {
        for (unsigned left = g->bonds[block->bonds + (size_t)k]; left; left &= left - 1) {
            const int lane = __builtin_ctz(left);
            const size_t cell = block->cell + (size_t)lane, neighbour = pdmc_nodes_neighbour(g, block, k, lane);
            if (cell < neighbour) unite(parent, cell, neighbour);
        }
    }
}

static void find_roots(const pdmc_nodes *g, size_t parent[])
{
    for (int k = 0; k < g->node_count; k++) parent[g->cell[k]] = g->cell[k];
    for (int b = 0; b < g->block_count; b++) unite_bonds(g, &g->blocks[b], parent);
    for (int k = 0; k < g->node_count; k++) parent[g->cell[k]] = root_of(parent, g->cell[k]);
}

/// @param[in,out] mass  [cells] 0 on entry; of the piece, at its root
static void find_masses(const pdmc_particles *p, const size_t parent[], double mass[])
{
    for (int b = 0; b < p->nodes.block_count; b++) {
        const pdmc_block *block = &p->nodes.blocks[b];
        for (unsigned left = block->nodes; left; left &= left - 1) {
            const size_t cell = block->cell + (size_t)__builtin_ctz(left);
            mass[parent[cell]] += p->density[block->material] * p->nodes.volume[cell];
        }
    }
}

static int by_falling_mass(const void *a, const void *b)
{
    const piece *x = a, *y = b;
    if (x->mass != y->mass) return x->mass < y->mass ? 1 : -1;
    return x->root < y->root ? -1 : x->root > y->root;
}

static int list_pieces(const pdmc_nodes *g, const size_t parent[], const double mass[], piece pieces[])
{
    int count = 0;
    for (int k = 0; k < g->node_count; k++)
        if (parent[g->cell[k]] == g->cell[k]) pieces[count++] = (piece){g->cell[k], mass[g->cell[k]]};
    qsort(pieces, (size_t)count, sizeof *pieces, by_falling_mass);
    return count;
}

pdmc_status pdmc_particles_find_fragments(const pdmc_particles *p, int of_node[], int *count)
{
    pdmc_status status = PDMC_OK;
    const pdmc_nodes *g = &p->nodes;
    size_t *parent = NULL;
    double *mass = NULL;
    int *number = NULL;
    piece *pieces = NULL;
    PDMC_NEW(parent, g->cells);
    PDMC_NEW(mass, g->cells);
    PDMC_NEW(number, g->cells);
    PDMC_NEW(pieces, g->node_count);
    find_roots(g, parent);
    find_masses(p, parent, mass);
    *count = list_pieces(g, parent, mass, pieces);
    for (int i = 0; i < *count; i++) number[pieces[i].root] = i;
    for (int k = 0; k < g->node_count; k++) of_node[k] = number[parent[g->cell[k]]];
done:
    pdmc_free(parent);
    pdmc_free(mass);
    pdmc_free(number);
    pdmc_free(pieces);
    return status;
}

/// Adds a node's mass and first moments to its piece.
static void add_node(const pdmc_particles *p, const pdmc_block *block, int k, pdmc_fragment *fragment)
{
    const size_t cell = block->cell + (size_t)k;
    const double mass = p->density[block->material] * p->nodes.volume[cell];
    fragment->nodes++;
    fragment->mass += mass;
    for (int a = 0; a < PDMC_AXES; a++) {
        fragment->centre[a] += mass * p->position[a][cell];
        fragment->velocity[a] += mass * pdmc_particles_velocity_at(p, block, a, cell);
    }
}

void pdmc_particles_fragments(const pdmc_particles *p, const int of_node[], int count, pdmc_fragment fragments[])
{
    memset(fragments, 0, (size_t)count * sizeof *fragments);
    for (int b = 0; b < p->nodes.block_count; b++) {
        const pdmc_block *block = &p->nodes.blocks[b];
        for (unsigned left = block->nodes; left; left &= left - 1) {
            const int k = __builtin_ctz(left);
            add_node(p, block, k, &fragments[of_node[p->nodes.node[block->cell + (size_t)k]]]);
        }
    }
    for (int i = 0; i < count; i++)
        for (int a = 0; a < PDMC_AXES; a++) {
            fragments[i].centre[a] /= fragments[i].mass;
            fragments[i].velocity[a] /= fragments[i].mass;
        }
}
