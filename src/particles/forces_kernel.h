// SPDX-License-Identifier: GPL-3.0-or-later

/// The kernel, written once over eight doubles: included after one of the lanes_*.h, with KERNEL the name of the function.
/// 1 / p is all that is needed of the distance p: s / p = 1 / |xi| - 1 / p, and s < s_0 is |xi| / p > 1 / (1 + s_0).

#include "particles/forces.h"

// In line whatever the compiler thinks of it: each of the three uses below has conditions that are constants.
#define INLINE static inline __attribute__((always_inline))

typedef struct {
    const pdmc_block *block;
    const pdmc_bond_law *law;
    lanes position[PDMC_AXES], force[PDMC_AXES]; // at micromodulus 1
    lanes elastic, contact;
    lanes shortest; // max |xi| / p over the bonds
    double fracture;
} node_sums;

/// A pair of nodes: what both directions have in common.
typedef struct {
    lanes apart[PDMC_AXES], inverse_distance;
} pairs;

INLINE pairs pairs_of(const pdmc_forces *f, const node_sums *s, size_t neighbour)
{
    pairs p;
    for (int a = 0; a < PDMC_AXES; a++) p.apart[a] = subtract(load(&f->position[a][neighbour]), s->position[a]);
    const lanes square =
        multiply_add(p.apart[0], p.apart[0], multiply_add(p.apart[1], p.apart[1], multiply(p.apart[2], p.apart[2])));
    p.inverse_distance = inverse_root(square);
    return p;
}

/// Not in line: bonds break rarely. Half of c s^2 |xi| / 2 of every bond.
static __attribute__((noinline)) double energy_of(const pdmc_lattice *g, const pdmc_neighbour *n, double micromodulus,
                                                  lanes inverse_distance, uint8_t bonds)
{
    const lanes stretch = subtract(divide(lanes_of(1.0 / n->length), inverse_distance), lanes_of(1.0));
    return 0.25 * micromodulus * n->length * n->weight * g->volume * sum_where(bonds, multiply(stretch, stretch));
}

/// Few nodes touch. The force is repulsion (p - d), d the distance below which they do.
INLINE void repel(const pdmc_forces *f, double touching, uint8_t nodes, const pairs *p, node_sums *s)
{
    const double distance = 1.0 / touching;
    const lanes one = lanes_of(1.0), minus = lanes_of(-distance);
    const lanes share = multiply_add(minus, p->inverse_distance, one); // (p - d) / p
    const lanes stiffness = multiply(lanes_of(f->repulsion / s->law->micromodulus), share);
    const lanes depth = add(divide(one, p->inverse_distance), minus);
    for (int a = 0; a < PDMC_AXES; a++) s->force[a] = multiply_add_where(nodes, stiffness, p->apart[a], s->force[a]);
    s->contact = multiply_add_where(nodes, multiply(depth, depth), lanes_of(0.25 * f->repulsion), s->contact);
}

INLINE void add_neighbour(const pdmc_forces *f, const pdmc_neighbour *n, uint8_t *bonds, lanes limit, bool strengthens,
                          bool energies, node_sums *s)
{
    const size_t neighbour = (size_t)((ptrdiff_t)s->block->cell + n->shift);
    const pairs p = pairs_of(f, s, neighbour);
    const lanes stiffness = multiply_add(lanes_of(-n->weight), p.inverse_distance, lanes_of(n->stiffness));
    for (int a = 0; a < PDMC_AXES; a++) s->force[a] = multiply_add_where(*bonds, stiffness, p.apart[a], s->force[a]);
    const lanes ratio = multiply(lanes_of(n->length), p.inverse_distance); // 1 / (1 + s)
    if (strengthens) {
        limit = greatest(limit, load(&f->limit[neighbour]));
        s->shortest = greatest_where(*bonds, s->shortest, ratio);
    }
    if (energies) {
        const lanes stretch = subtract(divide(lanes_of(1.0), ratio), lanes_of(1.0));
        s->elastic =
            multiply_add_where(*bonds, multiply(stretch, stretch), lanes_of(0.25 * n->length * n->weight), s->elastic);
    }
    const uint8_t broken = *bonds & less(ratio, limit);
    if (__builtin_expect(broken != 0, 0)) {
        s->fracture += energy_of(f->lattice, n, s->law->micromodulus, p.inverse_distance, broken);
        *bonds &= (uint8_t)~broken;
    }
    const uint8_t touching = s->block->nodes & less(lanes_of(n->touching), p.inverse_distance);
    if (__builtin_expect(touching != 0, 0)) repel(f, n->touching, touching, &p, s);
}

INLINE void store_forces(const pdmc_forces *f, bool strengthens, const node_sums *s)
{
    const pdmc_block *block = s->block;
    const lanes one = lanes_of(1.0), micromodulus = lanes_of(s->law->micromodulus);
    for (int a = 0; a < PDMC_AXES; a++)
        store_where(block->nodes, &f->force[a][block->cell], multiply(micromodulus, s->force[a]));
    if (!strengthens) return;
    const lanes least_stretch = subtract(divide(one, s->shortest), one);
    const lanes strength = multiply(lanes_of(-s->law->strengthening), least_stretch);
    const lanes limit = divide(one, add(lanes_of(1.0 + s->law->critical_stretch), strength));
    store_where(block->nodes, &f->next_limit[block->cell], limit);
}

INLINE void store_energies(const pdmc_forces *f, int b, const node_sums *s)
{
    f->elastic[b] = s->law->micromodulus * f->lattice->volume * sum_where(s->block->nodes, s->elastic);
    f->contact[b] = f->lattice->volume * sum_where(s->block->nodes, s->contact);
}

INLINE void sum_block(const pdmc_forces *f, int b, bool strengthens, bool energies)
{
    const pdmc_lattice *g = f->lattice;
    const pdmc_block *block = &g->blocks[b];
    const pdmc_bond_law *law = &f->laws[block->material];
    const lanes zero = lanes_of(0.0);
    node_sums s = {
        .block = block, .law = law, .force = {zero, zero, zero}, .elastic = zero, .contact = zero, .shortest = zero};
    for (int a = 0; a < PDMC_AXES; a++) s.position[a] = load(&f->position[a][block->cell]);
    const lanes limit = strengthens ? load(&f->limit[block->cell]) : lanes_of(1.0 / (1.0 + law->critical_stretch));
    const uint16_t *list = &g->lists[block->list];
    uint8_t *bonds = &g->bonds[block->bonds];
    for (int k = 0; k < block->listed; k++)
        add_neighbour(f, &g->neighbours[list[k]], &bonds[k], limit, strengthens, energies, &s);
    if (energies) {
        store_energies(f, b, &s);
        return;
    }
    store_forces(f, strengthens, &s);
    f->fracture[b] += s.fracture;
}

void KERNEL(const pdmc_forces *f, int first, int last)
{
    for (int b = first; b < last; b++) {
        if (f->energies) sum_block(f, b, false, true);
        else if (f->laws[f->lattice->blocks[b].material].strengthening != 0.0) sum_block(f, b, true, false);
        else sum_block(f, b, false, false);
    }
}
