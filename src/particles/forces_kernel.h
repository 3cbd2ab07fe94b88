// SPDX-License-Identifier: GPL-3.0-or-later

/// The kernel, written once over eight doubles: included after one of the lanes_*.h, with KERNEL the name of the function.
/// 1 / p is all that is needed of the distance p: s / p = 1 / |xi| - 1 / p, and s < s_0 is |xi| / p > 1 / (1 + s_0).
///
/// A block's nodes meet either eight neighbours, which are side by side on a grid and at one |xi|, or one node that is a
/// neighbour of some of them, at |xi| that are computed as the distances are.

#include "particles/forces.h"

#include <math.h>

// In line whatever the compiler thinks of it, with the kind of bonds a constant.
#define INLINE static inline __attribute__((always_inline))

/// Versions of the kernel for what is simple, so that it costs nothing else.
typedef struct {
    bool scattered; // the nodes are off the grid
    bool linear;    // the stretch is that along the reference direction
    bool by_node;   // s_0 differs from node to node
    bool varied;    // c or s_0 differ from bond to bond
    bool joined;    // some bonds are to other bodies
} bond_kind;

typedef struct {
    const pdmc_forces *forces;
    const pdmc_block *block;
    const pdmc_bond_law *law;
    bond_kind kind;
    lanes position[PDMC_AXES], reference[PDMC_AXES];
    lanes strength;      // s_0
    lanes enough;        // a bond breaks whose reserve is below
    double micromodulus; // c over what stiffness_of() says
    size_t joints;       // row of the body
} place;

/// Of a block's nodes, at micromodulus 1 and a unit of volume.
typedef struct {
    lanes force[PDMC_AXES];
    lanes shortest; // max |xi| / p over the bonds, or -s where that is linear
    lanes closest;  // max |xi| / p over all neighbours
    lanes weakest;  // the least reserve of the bonds
} sums;

/// The pairs of a block's nodes with an entry of its list: what both directions of a bond have in common, and the volume of
/// the neighbour that counts.
typedef struct {
    size_t cell;                     // of the neighbour; of the first of eight on a grid
    const pdmc_neighbour *neighbour; // on a grid only
    uint8_t near;                    // which of them are neighbours
    lanes apart[PDMC_AXES], inverse_distance;
    lanes length, inverse_length; // |xi|; the inverse of nodes off the grid only
    lanes minus_weight;           // - volume of the neighbour that counts
    lanes stiffness;              // weight / |xi|, on a grid only
    lanes touching;               // 1 / distance below which they repel each other
    lanes slope[PDMC_AXES];       // xi / |xi|^2, of linear stretch only
} pairs;

INLINE bool is_uniform(bond_kind kind)
{
    return !kind.linear && !kind.by_node && !kind.varied;
}

/// Where it is not known to the compiler, as in everything that is done seldom: once a version would be too much code.
static bond_kind kind_of(const pdmc_forces *f, int b)
{
    const pdmc_bond_law *law = &f->laws[f->nodes->blocks[b].material];
    const bool joined = f->nodes->blocks[b].joined;
    const bool varied = joined || f->linear || f->stiffness || law->strengths || law->fibre_excess != 0.0;
    return (bond_kind){.scattered = f->nodes->partner,
                       .linear = f->linear,
                       .by_node = f->nodes->partner || varied || f->by_node || law->strengthening != 0.0,
                       .varied = varied,
                       .joined = joined};
}

INLINE place place_of(const pdmc_forces *f, int b, bond_kind kind)
{
    place at = {
        .forces = f, .block = &f->nodes->blocks[b], .law = &f->laws[f->nodes->blocks[b].material], .kind = kind};
    for (int a = 0; a < PDMC_AXES; a++) {
        at.position[a] = load(&f->position[a][at.block->cell]);
        if (kind.scattered) at.reference[a] = load(&f->nodes->reference[a][at.block->cell]);
    }
    at.strength = kind.by_node ? load(&f->strength[at.block->cell]) : lanes_of(at.law->critical_stretch);
    at.micromodulus = kind.joined ? 1.0 : at.law->micromodulus;
    if (kind.joined) at.joints = pdmc_joints_row(f->joints, at.block->body) + 1;
    at.enough = lanes_of(kind.linear ? 0.0 : is_uniform(kind) ? 1.0 / (1.0 + at.law->critical_stretch) : 1.0);
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
    p->neighbour = n;
    p->cell = (size_t)((ptrdiff_t)at->block->cell + n->shift);
    p->near = 0xff;
    p->length = lanes_of(n->length);
    p->minus_weight = lanes_of(-n->weight);
    p->stiffness = lanes_of(n->stiffness);
    p->touching = lanes_of(n->touching);
    for (int a = 0; a < PDMC_AXES && at->kind.linear; a++) p->slope[a] = lanes_of(n->slope[a]);
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
    for (int a = 0; a < PDMC_AXES && at->kind.linear; a++)
        p->slope[a] = multiply(multiply(p->inverse_length, p->inverse_length), xi[a]);
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

/// |xi| / p = 1 / (1 + s)
INLINE lanes ratio_of(const pairs *p)
{
    return multiply(p->length, p->inverse_distance);
}

/// eta . xi / |xi|^2 = (xi + eta) . xi / |xi|^2 - 1
INLINE lanes linear_stretch(const pairs *p)
{
    lanes s = lanes_of(-1.0);
    for (int a = 0; a < PDMC_AXES; a++) s = multiply_add(p->slope[a], p->apart[a], s);
    return s;
}

INLINE lanes stretch_of(const place *at, const pairs *p)
{
    if (at->kind.linear) return linear_stretch(p);
    return subtract(divide(lanes_of(1.0), ratio_of(p)), lanes_of(1.0));
}

/// The cosine between the bonds and the fibres.
INLINE lanes alignment_of(const place *at, const pairs *p)
{
    const pdmc_nodes *g = at->forces->nodes;
    const double *fibre = at->law->fibre;
    lanes beta = lanes_of(0.0);
    for (int a = 0; a < PDMC_AXES && at->kind.scattered; a++) {
        const lanes xi = subtract(lanes_of(g->reference[a][p->cell]), load(&g->reference[a][at->block->cell]));
        beta = multiply_add(multiply(lanes_of(fibre[a]), p->inverse_length), xi, beta);
    }
    if (at->kind.scattered) return beta;
    const double *slope = p->neighbour->slope;
    return multiply(p->length, lanes_of(slope[0] * fibre[0] + slope[1] * fibre[1] + slope[2] * fibre[2]));
}

/// From a table of pairs of bodies, what the block's has with those of its neighbours.
INLINE lanes of_joints(const place *at, const pairs *p, const double table[])
{
    const int16_t *body = &at->forces->nodes->body[p->cell];
    const double *row = &table[at->joints];
    double out[PDMC_LANES];
    if (at->kind.scattered) return lanes_of(row[*body]);
    for (int k = 0; k < PDMC_LANES; k++) out[k] = row[body[k]];
    return load(out);
}

/// c of the bonds over that of the place.
INLINE lanes stiffness_of(const place *at, const pairs *p)
{
    const double *factor = at->forces->stiffness;
    lanes stiffness = lanes_of(1.0), excess = lanes_of(at->law->fibre_excess);
    if (factor)
        stiffness = multiply(lanes_of(0.5), add(load(&factor[at->block->cell]), of_neighbours(at, factor, p->cell)));
    if (at->kind.joined) stiffness = multiply(stiffness, of_joints(at, p, at->forces->joints->micromodulus));
    if (at->law->fibre_excess == 0.0) return stiffness;
    if (at->kind.joined) excess = of_joints(at, p, at->forces->joints->fibre_excess);
    const lanes beta = alignment_of(at, p);
    return multiply_add(stiffness, multiply(excess, multiply(beta, beta)), stiffness);
}

/// The factors of single bonds.
INLINE lanes drawn_strength(const place *at, const pairs *p)
{
    return draw(at->law->strengths, &at->forces->key, (uint32_t)at->block->cell, (uint32_t)p->cell, at->kind.scattered);
}

/// s_0 of the bonds, by what it would be by the strengths of their nodes.
INLINE lanes joint_strength(const place *at, const pairs *p, lanes of_nodes)
{
    const double *relative = at->forces->relative_strength;
    lanes own = of_joints(at, p, at->forces->joints->strength);
    if (relative) own = multiply(own, least(load(&relative[at->block->cell]), of_neighbours(at, relative, p->cell)));
    return least(own, add(of_nodes, of_joints(at, p, at->forces->joints->by_nodes)));
}

/// s_0 of the bonds.
INLINE lanes strength_of(const place *at, const pairs *p)
{
    lanes s_0 = at->strength;
    if (at->kind.by_node) s_0 = least(s_0, of_neighbours(at, at->forces->strength, p->cell));
    if (at->kind.joined) s_0 = joint_strength(at, p, s_0);
    if (at->kind.varied && at->law->strengths) s_0 = multiply(s_0, drawn_strength(at, p));
    return s_0;
}

/// What falls below place.enough where a bond is stretched beyond s_0: 1 / (1 + s); s_0 - s; or (1 + s_0) / (1 + s).
INLINE lanes reserve_of(const place *at, const pairs *p)
{
    const lanes ratio = ratio_of(p);
    if (is_uniform(at->kind)) return ratio;
    const lanes s_0 = strength_of(at, p);
    return at->kind.linear ? subtract(s_0, linear_stretch(p)) : multiply_add(ratio, s_0, ratio);
}

/// Weight times s / p, or weight times s |xi| where that is linear, and the slope what it is multiplied with.
INLINE lanes pull_of(const place *at, const pairs *p)
{
    lanes pull;
    if (at->kind.linear)
        pull = multiply(multiply(p->minus_weight, p->length), subtract(lanes_of(0.0), linear_stretch(p)));
    else if (at->kind.scattered) pull = multiply(p->minus_weight, subtract(p->inverse_distance, p->inverse_length));
    else pull = multiply_add(p->minus_weight, p->inverse_distance, p->stiffness);
    return at->kind.varied ? multiply(pull, stiffness_of(at, p)) : pull;
}

/// There is no branch in here: whether a bond breaks or nodes touch is asked once a block.
INLINE void add_neighbour(const place *at, int k, uint8_t bonds, sums *s)
{
    const pairs p = pairs_of(at, k);
    const lanes pull = pull_of(at, &p), ratio = ratio_of(&p);
    const lanes *along = at->kind.linear ? p.slope : p.apart;
    for (int a = 0; a < PDMC_AXES; a++) s->force[a] = multiply_add_where(bonds, pull, along[a], s->force[a]);
    s->weakest = least_where(bonds, s->weakest, reserve_of(at, &p));
    s->closest = at->kind.scattered ? greatest_where(p.near, s->closest, ratio) : greatest(s->closest, ratio);
    if (!at->kind.by_node) return;
    s->shortest =
        greatest_where(bonds, s->shortest, at->kind.linear ? subtract(lanes_of(0.0), linear_stretch(&p)) : ratio);
}

/// |xi| V_p V_x s s' / 4, summed over some of the pairs: half of a bond's energy where s' = s.
INLINE double energy_of(const place *at, const pairs *p, uint8_t counted, lanes s, lanes other)
{
    const lanes volume = load(&at->forces->nodes->volume[at->block->cell]);
    const lanes volumes = multiply(volume, multiply(p->length, p->minus_weight));
    const lanes stiffness = multiply(volumes, stiffness_of(at, p));
    return -0.25 * sum_where(counted, multiply(stiffness, multiply(s, other)));
}

/// What the stretch grows by in a step, with the velocities half a step before.
INLINE lanes growth_of(const place *at, const pairs *p)
{
    const pdmc_forces *f = at->forces;
    lanes growth = lanes_of(0.0);
    for (int a = 0; a < PDMC_AXES; a++) {
        const lanes own = load(&f->velocity[a][at->block->cell]);
        const lanes parting = subtract(of_neighbours(at, f->velocity[a], p->cell), own);
        growth = multiply_add(parting, at->kind.linear ? p->slope[a] : p->apart[a], growth);
    }
    const lanes by_step = multiply(lanes_of(f->step), growth);
    return at->kind.linear ? by_step : divide(multiply(by_step, p->inverse_distance), p->length);
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
    return energy * at.micromodulus;
}

/// The repulsion between nodes at p < d: repulsion V_p (d - p). Written to `force`, on a unit of volume.
/// @return a half of its energy, of all pairs
static __attribute__((noinline)) double repel(const pdmc_forces *f, int b, bool energies)
{
    const place at = place_of(f, b, kind_of(f, b));
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

/// s_0 of the next step, by the least stretch of a node's bonds.
INLINE void strengthen(const place *at, const sums *s)
{
    const pdmc_forces *f = at->forces;
    const lanes one = lanes_of(1.0), law = lanes_of(at->law->critical_stretch);
    const lanes first = f->first_strength ? load(&f->first_strength[at->block->cell]) : law;
    const lanes least_stretch =
        at->kind.linear ? subtract(lanes_of(0.0), s->shortest) : subtract(divide(one, s->shortest), one);
    const lanes strength = multiply_add(lanes_of(-at->law->strengthening), least_stretch, first);
    store_where(at->block->nodes, &f->next_strength[at->block->cell], strength);
}

INLINE void find_forces(const pdmc_forces *f, int b, bond_kind kind)
{
    const place at = place_of(f, b, kind);
    const uint8_t *bonds = &f->nodes->bonds[at.block->bonds];
    const lanes zero = lanes_of(0.0), least = lanes_of(-INFINITY), micromodulus = lanes_of(at.micromodulus);
    sums s = {.force = {zero, zero, zero}, .shortest = least, .closest = zero, .weakest = lanes_of(INFINITY)};
    for (int k = 0; k < at.block->listed; k++) add_neighbour(&at, k, bonds[k], &s);
    for (int a = 0; a < PDMC_AXES; a++)
        store_where(at.block->nodes, &f->force[a][at.block->cell], multiply(micromodulus, s.force[a]));
    if (at.law->strengthening != 0.0) strengthen(&at, &s);
    if (!f->unbreakable && (less(s.weakest, at.enough) & at.block->nodes)) f->fracture[b] += break_bonds(f, b);
    if (less(lanes_of(f->nodes->touching), s.closest) & at.block->nodes) repel(f, b, false);
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
    f->elastic[b] = at.micromodulus * elastic;
    f->contact[b] = repel(f, b, true);
}

static __attribute__((noinline)) void find_seldom_forces(const pdmc_forces *f, int b)
{
    find_forces(f, b, kind_of(f, b));
}

/// A constant kind for each version of the kernel that has to be fast.
INLINE void find(const pdmc_forces *f, int b)
{
    const bond_kind kind = kind_of(f, b);
    if (f->energies) find_energies(f, b);
    else if (kind.linear || kind.joined || (kind.varied && kind.scattered)) find_seldom_forces(f, b);
    else if (kind.scattered) find_forces(f, b, (bond_kind){.scattered = true, .by_node = true});
    else if (kind.varied) find_forces(f, b, (bond_kind){.by_node = true, .varied = true});
    else if (kind.by_node) find_forces(f, b, (bond_kind){.by_node = true});
    else find_forces(f, b, (bond_kind){0});
}

void KERNEL(const pdmc_forces *f, int first, int last)
{
    for (int b = first; b < last; b++) find(f, b);
}
