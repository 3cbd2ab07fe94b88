// SPDX-License-Identifier: GPL-3.0-or-later

/// The kernel, written once over eight doubles: included after one of the lanes_*.h, with KERNEL the name of the function.
/// 1 / p is all that is needed of the distance p: s / p = 1 / |xi| - 1 / p, and s < s_0 is |xi| / p > 1 / (1 + s_0).
///
/// A block's nodes meet either eight neighbours, which are side by side on a grid and at one |xi|, or one node that is a
/// neighbour of some of them, at |xi| that are computed as the distances are.

#include "particles/forces.h"

// In line whatever the compiler thinks of it, with the kind of bonds a constant.
#define INLINE static inline __attribute__((always_inline))

typedef struct {
    bool strengthens; // whether s_0 changes
    bool scattered;   // whether the nodes are off the grid
} bond_kind;

typedef struct {
    const pdmc_forces *forces;
    const pdmc_block *block;
    const pdmc_bond_law *law;
    bond_kind kind;
    lanes position[PDMC_AXES], reference[PDMC_AXES], limit;
} place;

/// Of a block's nodes, at micromodulus 1 and a unit of volume.
typedef struct {
    lanes force[PDMC_AXES];
    lanes shortest; // max |xi| / p over the bonds
    lanes closest;  // ... over all neighbours
    lanes weakest;  // min |xi| / p - 1 / (1 + s_0) over the bonds: negative where one of them breaks
} sums;

/// The pairs of a block's nodes with an entry of its list: what both directions of a bond have in common, and the volume of
/// the neighbour that counts.
typedef struct {
    size_t cell;  // of the neighbour; of the first of eight on a grid
    uint8_t near; // which of them are neighbours
    lanes apart[PDMC_AXES], inverse_distance;
    lanes length, inverse_length; // |xi|; the inverse of nodes off the grid only
    lanes minus_weight;           // - volume of the neighbour that counts
    lanes stiffness;              // weight / |xi|, on a grid only
    lanes touching;               // 1 / distance below which they repel each other
} pairs;

INLINE place place_of(const pdmc_forces *f, int b, bond_kind kind)
{
    place at = {
        .forces = f, .block = &f->nodes->blocks[b], .law = &f->laws[f->nodes->blocks[b].material], .kind = kind};
    for (int a = 0; a < PDMC_AXES; a++) {
        at.position[a] = load(&f->position[a][at.block->cell]);
        if (kind.scattered) at.reference[a] = load(&f->nodes->reference[a][at.block->cell]);
    }
    at.limit = kind.strengthens ? load(&f->limit[at.block->cell]) : lanes_of(1.0 / (1.0 + at.law->critical_stretch));
    return at;
}

INLINE lanes of_neighbours(const place *at, const double x[], size_t cell)
{
    return at->kind.scattered ? lanes_of(x[cell]) : load(&x[cell]);
}

INLINE lanes square_of(const lanes x[PDMC_AXES])
{
    return multiply_add(x[0], x[0], multiply_add(x[1], x[1], multiply(x[2], x[2])));
}

/// What does not change of eight pairs side by side.
INLINE void add_grid(const place *at, int k, pairs *p)
{
    const pdmc_nodes *g = at->forces->nodes;
    const pdmc_neighbour *n = &g->neighbours[g->lists[at->block->list + k]];
    p->cell = (size_t)((ptrdiff_t)at->block->cell + n->shift);
    p->near = 0xff;
    p->length = lanes_of(n->length);
    p->minus_weight = lanes_of(-n->weight);
    p->stiffness = lanes_of(n->stiffness);
    p->touching = lanes_of(n->touching);
}

/// What does not change of the pairs with one node. A node has no |xi| to itself, nor is it near.
INLINE void add_scattered(const place *at, int k, pairs *p)
{
    const pdmc_nodes *g = at->forces->nodes;
    lanes xi[PDMC_AXES];
    p->cell = (size_t)g->partner[at->block->bonds + (size_t)k];
    p->near = g->near[at->block->bonds + (size_t)k];
    for (int a = 0; a < PDMC_AXES; a++) xi[a] = subtract(lanes_of(g->reference[a][p->cell]), at->reference[a]);
    const lanes square = square_of(xi);
    p->inverse_length = inverse_root(square);
    p->length = multiply(square, p->inverse_length);
    const lanes falling = multiply_add(lanes_of(g->share_slope), p->length, lanes_of(-g->share_start));
    p->minus_weight = multiply(lanes_of(g->volume[p->cell]), greatest(lanes_of(-1.0), falling));
    const lanes first = multiply(lanes_of(1.0 / PDMC_TOUCHING_SHARE), p->inverse_length);
    p->touching = greatest(first, lanes_of(1.0 / g->contact_distance));
}

INLINE pairs pairs_of(const place *at, int k)
{
    pairs p;
    if (at->kind.scattered) add_scattered(at, k, &p);
    else add_grid(at, k, &p);
    for (int a = 0; a < PDMC_AXES; a++)
        p.apart[a] = subtract(of_neighbours(at, at->forces->position[a], p.cell), at->position[a]);
    p.inverse_distance = inverse_root(square_of(p.apart));
    return p;
}

INLINE lanes limit_of(const place *at, const pairs *p)
{
    return at->kind.strengthens ? greatest(at->limit, of_neighbours(at, at->forces->limit, p->cell)) : at->limit;
}

/// Weight times s / p.
INLINE lanes pull_of(const place *at, const pairs *p)
{
    if (at->kind.scattered) return multiply(p->minus_weight, subtract(p->inverse_distance, p->inverse_length));
    return multiply_add(p->minus_weight, p->inverse_distance, p->stiffness);
}

/// There is no branch in here: whether a bond breaks or nodes touch is asked once a block.
INLINE void add_neighbour(const place *at, int k, uint8_t bonds, sums *s)
{
    const pairs p = pairs_of(at, k);
    const lanes pull = pull_of(at, &p);
    const lanes ratio = multiply(p.length, p.inverse_distance); // 1 / (1 + s)
    for (int a = 0; a < PDMC_AXES; a++) s->force[a] = multiply_add_where(bonds, pull, p.apart[a], s->force[a]);
    s->weakest = least_where(bonds, s->weakest, subtract(ratio, limit_of(at, &p)));
    s->closest = at->kind.scattered ? greatest_where(p.near, s->closest, ratio) : greatest(s->closest, ratio);
    if (at->kind.strengthens) s->shortest = greatest_where(bonds, s->shortest, ratio);
}

/// |xi| V_p V_x s^2 / 4, summed over some of the pairs.
INLINE double energy_of(const place *at, const pairs *p, uint8_t counted, lanes stretch)
{
    const lanes volume = load(&at->forces->nodes->volume[at->block->cell]);
    const lanes volumes = multiply(volume, multiply(p->length, p->minus_weight));
    return -0.25 * sum_where(counted, multiply(volumes, multiply(stretch, stretch)));
}

/// Breaks the bonds that are stretched too far. @return a half of c s^2 |xi| / 2 of every one of them
static __attribute__((noinline)) double break_bonds(const pdmc_forces *f, int b, bond_kind kind)
{
    const place at = place_of(f, b, kind);
    double energy = 0.0;
    for (int k = 0; k < at.block->listed; k++) {
        uint8_t *bonds = &f->nodes->bonds[at.block->bonds + (size_t)k];
        const pairs p = pairs_of(&at, k);
        const lanes ratio = multiply(p.length, p.inverse_distance);
        const uint8_t broken = *bonds & less(ratio, limit_of(&at, &p));
        if (broken == 0) continue;
        energy += energy_of(&at, &p, broken, subtract(divide(lanes_of(1.0), ratio), lanes_of(1.0)));
        *bonds &= (uint8_t)~broken;
    }
    return energy * at.law->micromodulus;
}

/// The repulsion between nodes at p < d: repulsion V_p (d - p). Written to `force`, on a unit of volume.
/// @return a half of its energy, of all pairs
static __attribute__((noinline)) double repel(const pdmc_forces *f, int b, bond_kind kind, bool energies)
{
    const place at = place_of(f, b, kind);
    const lanes one = lanes_of(1.0), volume = load(&f->nodes->volume[at.block->cell]);
    double energy = 0.0;
    lanes force[PDMC_AXES];
    for (int a = 0; a < PDMC_AXES; a++) force[a] = load(&f->force[a][at.block->cell]);
    for (int k = 0; k < at.block->listed; k++) {
        const pairs p = pairs_of(&at, k);
        const uint8_t touching = p.near & at.block->nodes & less(p.touching, p.inverse_distance);
        if (touching == 0) continue;
        const lanes minus = divide(lanes_of(-1.0), p.touching), depth = add(divide(one, p.inverse_distance), minus);
        const lanes stiffness = multiply(lanes_of(f->repulsion), of_neighbours(&at, f->nodes->volume, p.cell));
        const lanes push = multiply(stiffness, multiply_add(minus, p.inverse_distance, one));
        for (int a = 0; a < PDMC_AXES; a++) force[a] = multiply_add_where(touching, push, p.apart[a], force[a]);
        energy += 0.25 * sum_where(touching, multiply(multiply(volume, stiffness), multiply(depth, depth)));
    }
    for (int a = 0; a < PDMC_AXES && !energies; a++)
        store_where(at.block->nodes, &f->force[a][at.block->cell], force[a]);
    return energy;
}

INLINE void store(const place *at, const sums *s)
{
    const pdmc_forces *f = at->forces;
    const lanes one = lanes_of(1.0), micromodulus = lanes_of(at->law->micromodulus);
    for (int a = 0; a < PDMC_AXES; a++)
        store_where(at->block->nodes, &f->force[a][at->block->cell], multiply(micromodulus, s->force[a]));
    if (!at->kind.strengthens) return;
    const lanes least_stretch = subtract(divide(one, s->shortest), one);
    const lanes strength = multiply(lanes_of(-at->law->strengthening), least_stretch);
    const lanes limit = divide(one, add(lanes_of(1.0 + at->law->critical_stretch), strength));
    store_where(at->block->nodes, &f->next_limit[at->block->cell], limit);
}

INLINE void find_forces(const pdmc_forces *f, int b, bond_kind kind)
{
    const place at = place_of(f, b, kind);
    const uint8_t *bonds = &f->nodes->bonds[at.block->bonds];
    const lanes zero = lanes_of(0.0);
    sums s = {.force = {zero, zero, zero}, .shortest = zero, .closest = zero, .weakest = lanes_of(1.0)};
    for (int k = 0; k < at.block->listed; k++) add_neighbour(&at, k, bonds[k], &s);
    store(&at, &s);
    if (less(s.weakest, zero) & at.block->nodes) f->fracture[b] += break_bonds(f, b, kind);
    if (less(lanes_of(f->nodes->touching), s.closest) & at.block->nodes) repel(f, b, kind, false);
}

INLINE void find_energies(const pdmc_forces *f, int b, bond_kind kind)
{
    const place at = place_of(f, b, kind);
    const lanes one = lanes_of(1.0);
    double elastic = 0.0;
    for (int k = 0; k < at.block->listed; k++) {
        const pairs p = pairs_of(&at, k);
        const lanes stretch = subtract(divide(one, multiply(p.length, p.inverse_distance)), one);
        elastic += energy_of(&at, &p, f->nodes->bonds[at.block->bonds + (size_t)k], stretch);
    }
    f->elastic[b] = at.law->micromodulus * elastic;
    f->contact[b] = repel(f, b, kind, true);
}

INLINE void find(const pdmc_forces *f, int b, bond_kind kind)
{
    if (f->energies) find_energies(f, b, kind);
    else find_forces(f, b, kind);
}

void KERNEL(const pdmc_forces *f, int first, int last)
{
    const bool scattered = f->nodes->partner != NULL;
    for (int b = first; b < last; b++) {
        const bool strengthens = f->laws[f->nodes->blocks[b].material].strengthening != 0.0;
        if (scattered && strengthens) find(f, b, (bond_kind){true, true});
        else if (scattered) find(f, b, (bond_kind){false, true});
        else if (strengthens) find(f, b, (bond_kind){true, false});
        else find(f, b, (bond_kind){false, false});
    }
}
