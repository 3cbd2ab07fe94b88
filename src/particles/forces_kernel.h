// SPDX-License-Identifier: GPL-3.0-or-later

/// The kernel, written once over eight doubles: included after one of the lanes_*.h, with KERNEL the name of the function.
/// 1 / p is all that is needed of the distance p: s / p = 1 / |xi| - 1 / p, and s < s_0 is |xi| / p > 1 / (1 + s_0).

#include "particles/forces.h"

// In line whatever the compiler thinks of it, with `strengthens` a constant.
#define INLINE static inline __attribute__((always_inline))

typedef struct {
    const pdmc_forces *forces;
    const pdmc_block *block;
    const pdmc_bond_law *law;
    lanes position[PDMC_AXES], limit;
} place;

/// Of a block's nodes, at micromodulus 1 and a unit of volume.
typedef struct {
    lanes force[PDMC_AXES];
    lanes shortest; // max |xi| / p over the bonds
    lanes closest;  // ... over all neighbours
    lanes weakest;  // min |xi| / p - 1 / (1 + s_0) over the bonds: negative where one of them breaks
} sums;

/// The pairs of a block's nodes with their neighbours in one direction: what both directions of a bond have in common.
typedef struct {
    lanes apart[PDMC_AXES], inverse_distance;
} pairs;

INLINE place place_of(const pdmc_forces *f, int b, bool strengthens)
{
    place at = {.forces = f, .block = &f->lattice->blocks[b], .law = &f->laws[f->lattice->blocks[b].material]};
    for (int a = 0; a < PDMC_AXES; a++) at.position[a] = load(&f->position[a][at.block->cell]);
    at.limit = strengthens ? load(&f->limit[at.block->cell]) : lanes_of(1.0 / (1.0 + at.law->critical_stretch));
    return at;
}

INLINE const pdmc_neighbour *neighbour_of(const place *at, int k)
{
    const pdmc_lattice *g = at->forces->lattice;
    return &g->neighbours[g->lists[at->block->list + k]];
}

INLINE size_t cell_of(const place *at, const pdmc_neighbour *n)
{
    return (size_t)((ptrdiff_t)at->block->cell + n->shift);
}

INLINE pairs pairs_of(const place *at, const pdmc_neighbour *n)
{
    pairs p;
    const size_t cell = cell_of(at, n);
    for (int a = 0; a < PDMC_AXES; a++) p.apart[a] = subtract(load(&at->forces->position[a][cell]), at->position[a]);
    const lanes square =
        multiply_add(p.apart[0], p.apart[0], multiply_add(p.apart[1], p.apart[1], multiply(p.apart[2], p.apart[2])));
    p.inverse_distance = inverse_root(square);
    return p;
}

INLINE lanes limit_of(const place *at, const pdmc_neighbour *n, bool strengthens)
{
    return strengthens ? greatest(at->limit, load(&at->forces->limit[cell_of(at, n)])) : at->limit;
}

/// There is no branch in here: whether a bond breaks or nodes touch is asked once a block.
INLINE void add_neighbour(const place *at, const pdmc_neighbour *n, uint8_t bonds, bool strengthens, sums *s)
{
    const pairs p = pairs_of(at, n);
    const lanes stiffness = multiply_add(lanes_of(-n->weight), p.inverse_distance, lanes_of(n->stiffness));
    const lanes ratio = multiply(lanes_of(n->length), p.inverse_distance); // 1 / (1 + s)
    for (int a = 0; a < PDMC_AXES; a++) s->force[a] = multiply_add_where(bonds, stiffness, p.apart[a], s->force[a]);
    s->weakest = least_where(bonds, s->weakest, subtract(ratio, limit_of(at, n, strengthens)));
    s->closest = greatest(s->closest, ratio);
    if (strengthens) s->shortest = greatest_where(bonds, s->shortest, ratio);
}

/// Breaks the bonds that are stretched too far. @return a half of c s^2 |xi| / 2 of every one of them
static __attribute__((noinline)) double break_bonds(const pdmc_forces *f, int b, bool strengthens)
{
    const place at = place_of(f, b, strengthens);
    double energy = 0.0;
    for (int k = 0; k < at.block->listed; k++) {
        const pdmc_neighbour *n = neighbour_of(&at, k);
        uint8_t *bonds = &f->lattice->bonds[at.block->bonds + (size_t)k];
        const pairs p = pairs_of(&at, n);
        const lanes ratio = multiply(lanes_of(n->length), p.inverse_distance);
        const uint8_t broken = *bonds & less(ratio, limit_of(&at, n, strengthens));
        if (broken == 0) continue;
        const lanes stretch = subtract(divide(lanes_of(1.0), ratio), lanes_of(1.0));
        energy += 0.25 * n->length * n->weight * sum_where(broken, multiply(stretch, stretch));
        *bonds &= (uint8_t)~broken;
    }
    return energy * at.law->micromodulus * f->lattice->volume;
}

/// The repulsion between nodes at p < d: repulsion (d - p). Written to `force`, on a unit of volume.
/// @return a half of its energy, of all pairs
static __attribute__((noinline)) double repel(const pdmc_forces *f, int b, bool energies)
{
    const place at = place_of(f, b, false);
    const lanes one = lanes_of(1.0);
    double energy = 0.0;
    lanes force[PDMC_AXES];
    for (int a = 0; a < PDMC_AXES; a++) force[a] = load(&f->force[a][at.block->cell]);
    for (int k = 0; k < at.block->listed; k++) {
        const pdmc_neighbour *n = neighbour_of(&at, k);
        const pairs p = pairs_of(&at, n);
        const uint8_t touching = at.block->nodes & less(lanes_of(n->touching), p.inverse_distance);
        if (touching == 0) continue;
        const lanes minus = lanes_of(-1.0 / n->touching), depth = add(divide(one, p.inverse_distance), minus);
        const lanes stiffness = multiply(lanes_of(f->repulsion), multiply_add(minus, p.inverse_distance, one));
        for (int a = 0; a < PDMC_AXES; a++) force[a] = multiply_add_where(touching, stiffness, p.apart[a], force[a]);
        energy += 0.25 * f->repulsion * f->lattice->volume * sum_where(touching, multiply(depth, depth));
    }
    for (int a = 0; a < PDMC_AXES && !energies; a++)
        store_where(at.block->nodes, &f->force[a][at.block->cell], force[a]);
    return energy;
}

INLINE void store(const place *at, bool strengthens, const sums *s)
{
    const pdmc_forces *f = at->forces;
    const lanes one = lanes_of(1.0), micromodulus = lanes_of(at->law->micromodulus);
    for (int a = 0; a < PDMC_AXES; a++)
        store_where(at->block->nodes, &f->force[a][at->block->cell], multiply(micromodulus, s->force[a]));
    if (!strengthens) return;
    const lanes least_stretch = subtract(divide(one, s->shortest), one);
    const lanes strength = multiply(lanes_of(-at->law->strengthening), least_stretch);
    const lanes limit = divide(one, add(lanes_of(1.0 + at->law->critical_stretch), strength));
    store_where(at->block->nodes, &f->next_limit[at->block->cell], limit);
}

INLINE void find_forces(const pdmc_forces *f, int b, bool strengthens)
{
    const place at = place_of(f, b, strengthens);
    const uint8_t *bonds = &f->lattice->bonds[at.block->bonds];
    const lanes zero = lanes_of(0.0);
    sums s = {.force = {zero, zero, zero}, .shortest = zero, .closest = zero, .weakest = lanes_of(1.0)};
    for (int k = 0; k < at.block->listed; k++) add_neighbour(&at, neighbour_of(&at, k), bonds[k], strengthens, &s);
    store(&at, strengthens, &s);
    if (less(s.weakest, zero) & at.block->nodes) f->fracture[b] += break_bonds(f, b, strengthens);
    if (less(lanes_of(f->lattice->touching), s.closest) & at.block->nodes) repel(f, b, false);
}

static void find_energies(const pdmc_forces *f, int b)
{
    const place at = place_of(f, b, false);
    double elastic = 0.0;
    for (int k = 0; k < at.block->listed; k++) {
        const pdmc_neighbour *n = neighbour_of(&at, k);
        const pairs p = pairs_of(&at, n);
        const lanes stretch = subtract(divide(lanes_of(1.0 / n->length), p.inverse_distance), lanes_of(1.0));
        const uint8_t bonds = f->lattice->bonds[at.block->bonds + (size_t)k];
        elastic += 0.25 * n->length * n->weight * sum_where(bonds, multiply(stretch, stretch));
    }
    f->elastic[b] = at.law->micromodulus * f->lattice->volume * elastic;
    f->contact[b] = repel(f, b, true);
}

void KERNEL(const pdmc_forces *f, int first, int last)
{
    for (int b = first; b < last; b++) {
        if (f->energies) find_energies(f, b);
        else if (f->laws[f->lattice->blocks[b].material].strengthening != 0.0) find_forces(f, b, true);
        else find_forces(f, b, false);
    }
}
