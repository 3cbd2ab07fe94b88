// SPDX-License-Identifier: GPL-3.0-or-later

/// The kernel, written once over eight numbers: included after one of the lanes_*.h and one of the ways to measure bonds,
/// by_*.h, with KERNEL the name of the function.

#include "particles/forces_sum.h"

/// Where it is not known to the compiler, as in everything that is done seldom: once a version would be too much code.
static bond_kind kind_of(const pdmc_forces *f, int b)
{
    const pdmc_brittle_law *law = &f->laws[f->nodes->blocks[b].material];
    const bool joined = f->nodes->blocks[b].joined;
    const bool varied = joined || f->linear || f->stiffness || law->strengths || law->fibre_excess != 0.0;
    return (bond_kind){.scattered = f->nodes->partner,
                       .linear = f->linear,
                       .by_node = f->nodes->partner || varied || f->by_node || law->strengthening != 0.0,
                       .varied = varied,
                       .joined = joined};
}

INLINE double unit_of_energy(const pdmc_forces *f)
{
    return unit_of_volume(f) * unit_of_volume(f) * unit_of_length(f);
}

/// |xi| V_p V_x s s' / 4, summed over some of the pairs, in units of length and volume: half of a bond's energy where s' = s.
INLINE double energy_of(const place *at, const pairs *p, uint8_t counted, lanes s, lanes other)
{
    const lanes volume = load(&volumes_of(at->forces)[at->block->cell]);
    const lanes volumes = multiply(volume, multiply(p->length, p->weight));
    const lanes stiffness = multiply(volumes, stiffness_of(at, p));
    return 0.25 * sum_where(counted, multiply(stiffness, multiply(s, other)));
}

/// What the stretch grows by in a step, with the velocities half a step before.
INLINE lanes growth_of(const place *at, const pairs *p)
{
    const pdmc_forces *f = at->forces;
    lanes growth = lanes_of(0.0);
    for (int a = 0; a < PDMC_AXES; a++) {
        const lanes own = load_double(&f->velocity[a][at->block->cell]);
        const lanes parting = subtract(doubles_of(at, f->velocity[a], p->cell), own);
        growth = multiply_add(parting, at->kind.linear ? p->slope[a] : p->apart[a], growth);
    }
    const lanes by_step = multiply(lanes_of(f->step / unit_of_length(f)), growth);
    return at->kind.linear ? by_step : divide(multiply(by_step, inverse_distance(p)), p->length);
}

/// Breaks the bonds that are stretched too far. They still act in this step, and in the half of it that is to come they
/// take c s ds |xi| / 2 more, with which the sum of energies is of second order.
/// @return a half of c (s^2 + s ds) |xi| / 2 of every one of them
static __attribute__((noinline)) double break_bonds(const pdmc_forces *f, int b)
{
    const place at = place_of(f, b, kind_of(f, b));
    double energy = 0.0;
    for (int k = 0; k < at.block->listed; k++) {
        uint8_t *bonds = &f->nodes->bonds[at.block->bonds + (size_t)k];
        const pairs p = pairs_of(&at, k);
        const uint8_t broken = *bonds & less(reserve_of(&at, &p), at.enough);
        if (broken == 0) continue;
        const lanes s = stretch_of(&at, &p);
        energy += energy_of(&at, &p, broken, s, add(s, growth_of(&at, &p)));
        *bonds &= (uint8_t)~broken;
    }
    return energy * at.micromodulus * unit_of_energy(f);
}

/// The repulsion between nodes at p < d: repulsion V_p (d - p). Added to the forces on a unit of volume.
/// @return a half of its energy, of all pairs
static __attribute__((noinline)) double repel(const pdmc_forces *f, int b, bool energies)
{
    const place at = place_of(f, b, kind_of(f, b));
    const lanes one = lanes_of(1.0), zero = lanes_of(0.0), volume = load(&volumes_of(f)[at.block->cell]);
    const double unit = f->repulsion * unit_of_volume(f) * unit_of_length(f);
    double energy = 0.0;
    lanes force[PDMC_AXES] = {zero, zero, zero};
    for (int k = 0; k < at.block->listed; k++) {
        const pairs p = pairs_of(&at, k);
        const lanes inverse = inverse_distance(&p);
        const uint8_t touching = p.near & at.block->nodes & less(p.touching, inverse);
        if (touching == 0) continue;
        const lanes minus = divide(lanes_of(-1.0), p.touching), depth = add(divide(one, inverse), minus);
        const lanes other = of_neighbours(&at, volumes_of(f), p.cell);
        const lanes push = multiply(other, multiply_add(minus, inverse, one));
        for (int a = 0; a < PDMC_AXES; a++) force[a] = multiply_add_where(touching, push, p.apart[a], force[a]);
        energy += 0.25 * sum_where(touching, multiply(multiply(volume, other), multiply(depth, depth)));
    }
    for (int a = 0; a < PDMC_AXES && !energies; a++)
        add_where(at.block->nodes, &f->force[a][at.block->cell], unit, force[a]);
    return energy * unit * unit_of_volume(f) * unit_of_length(f);
}

static void find_energies(const pdmc_forces *f, int b)
{
    const place at = place_of(f, b, kind_of(f, b));
    double elastic = 0.0;
    for (int k = 0; k < at.block->listed; k++) {
        const pairs p = pairs_of(&at, k);
        const lanes s = stretch_of(&at, &p);
        elastic += energy_of(&at, &p, f->nodes->bonds[at.block->bonds + (size_t)k], s, s);
    }
    f->elastic[b] = at.micromodulus * unit_of_energy(f) * elastic;
    f->contact[b] = repel(f, b, true);
}

/// Does what was found to be due.
INLINE void answer(const pdmc_forces *f, int b, pdmc_alarms due)
{
    if (due.breaking) f->fracture[b] += break_bonds(f, b);
    if (due.touching) repel(f, b, false);
}

static __attribute__((noinline)) void find_seldom_forces(const pdmc_forces *f, int b, bond_kind kind)
{
    answer(f, b, find_forces(f, b, kind));
}

/// A constant kind for each version of the kernel that has to be fast.
INLINE void find(const pdmc_forces *f, int b, bond_kind kind)
{
    if (f->energies) find_energies(f, b);
    else if (kind.joined && !kind.linear && !kind.scattered)
        answer(f, b, find_forces(f, b, (bond_kind){.by_node = true, .varied = true, .joined = true}));
    else if (kind.linear || kind.joined || (kind.varied && kind.scattered)) find_seldom_forces(f, b, kind);
    else if (kind.scattered) answer(f, b, find_forces(f, b, (bond_kind){.scattered = true, .by_node = true}));
    else if (kind.varied) answer(f, b, find_forces(f, b, (bond_kind){.by_node = true, .varied = true}));
    else if (kind.by_node) answer(f, b, find_forces(f, b, (bond_kind){.by_node = true}));
    else answer(f, b, find_forces(f, b, (bond_kind){0}));
}

#ifdef KERNEL_OF_TWO
/// Whether a block and the next one are side by side and have the same neighbours and law.
INLINE bool are_alike(const pdmc_forces *f, int b, bond_kind kind)
{
    const pdmc_block *block = &f->nodes->blocks[b], *next = block + 1;
    return !(f->energies || kind.scattered || kind.linear || kind.joined || next->joined) &&
           next->cell == block->cell + PDMC_LANES && next->list == block->list && next->listed == block->listed &&
           next->material == block->material;
}

INLINE void find_two(const pdmc_forces *f, int b, bond_kind kind)
{
    const pdmc_alarms due = KERNEL_OF_TWO(f, b, kind.by_node, kind.varied);
    answer(f, b, (pdmc_alarms){due.breaking & 0xff, due.touching & 0xff});
    answer(f, b + 1, (pdmc_alarms){due.breaking >> PDMC_LANES, due.touching >> PDMC_LANES});
}
#endif

void KERNEL(const pdmc_forces *f, int first, int last)
{
    for (int b = first; b < last; b++) {
        const bond_kind kind = kind_of(f, b);
#ifdef KERNEL_OF_TWO
        if (b + 1 < last && are_alike(f, b, kind)) {
            find_two(f, b++, kind);
            continue;
        }
#endif
        find(f, b, kind);
    }
}
