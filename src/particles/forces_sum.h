// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What a block's nodes have of forces, over as many lanes as the lanes_*.h and by_*.h before it have: one block, or two in a row.
///
/// A block's nodes meet either as many neighbours, which are side by side on a grid and at one |xi|, or one node that is a
/// neighbour of some of them, at |xi| that are computed as the distances are.

#include <math.h>

/// Of a block's nodes, at micromodulus 1 and a unit of volume.
typedef struct {
    lanes force[PDMC_AXES];
    lanes shortest; // the largest shortening of the bonds, or -s where that is linear
    lanes closest;  // ... of all neighbours
    lanes weakest;  // the least reserve of the bonds
} sums;

INLINE place place_of(const pdmc_forces *f, int b, bond_kind kind)
{
    place at = {
        .forces = f, .block = &f->nodes->blocks[b], .law = &f->laws[f->nodes->blocks[b].material], .kind = kind};
    for (int a = 0; a < PDMC_AXES; a++) {
        at.place[a] = load(&places_of(f)[a][at.block->cell]);
        if (kind.scattered) at.reference[a] = load(&references_of(f)[a][at.block->cell]);
    }
    const double s_0 = at.law->critical_stretch;
    at.strength = kind.by_node ? load(&strengths_of(f)[at.block->cell]) : lanes_of(s_0);
    at.micromodulus = kind.joined ? unit_of_micromodulus(f) : at.law->micromodulus;
    if (kind.joined) at.joints = pdmc_joints_row(f->joints, at.block->body) + 1;
    at.enough = lanes_of(kind.linear ? 0.0 : is_uniform(kind) ? shortening_at(1.0 / (1.0 + s_0)) : reserve_enough);
    return at;
}

/// What does not change of pairs side by side.
INLINE void add_grid(const place *at, int k, pairs *p)
{
    const neighbour *n = &neighbours_of(at->forces)[at->forces->nodes->lists[at->block->list + k]];
    p->neighbour = n;
    p->cell = (size_t)((ptrdiff_t)at->block->cell + n->shift);
    p->near = (lane_mask)~0;
    p->length = lanes_of(n->length);
    p->weight = lanes_of(n->weight);
    p->touching = lanes_of(n->touching);
    for (int a = 0; a < PDMC_AXES; a++) p->slope[a] = lanes_of(n->slope[a]);
}

/// What does not change of the pairs with one node. A node has no |xi| to itself, nor is it near.
INLINE void add_scattered(const place *at, int k, pairs *p)
{
    const pdmc_forces *f = at->forces;
    const pdmc_nodes *g = f->nodes;
    const double unit = unit_of_length(f);
    p->neighbour = NULL;
    p->cell = (size_t)g->partner[at->block->bonds + (size_t)k];
    p->near = g->near[at->block->bonds + (size_t)k];
    for (int a = 0; a < PDMC_AXES; a++) p->xi[a] = subtract(lanes_of(references_of(f)[a][p->cell]), at->reference[a]);
    const lanes square = square_of(p->xi);
    p->inverse_length = inverse_root(square);
    p->length = multiply(square, p->inverse_length);
    const lanes share = subtract_product(lanes_of(g->share_start), lanes_of(unit * g->share_slope), p->length);
    p->weight = multiply(lanes_of(volumes_of(f)[p->cell]), least(lanes_of(1.0), share));
    const lanes first = multiply(lanes_of(1.0 / PDMC_TOUCHING_SHARE), p->inverse_length);
    p->touching = greatest(first, lanes_of(unit / g->contact_distance));
    for (int a = 0; a < PDMC_AXES; a++)
        p->slope[a] = multiply(multiply(p->inverse_length, p->inverse_length), p->xi[a]);
}

INLINE pairs pairs_of(const place *at, int k)
{
    pairs p;
    if (at->kind.scattered) add_scattered(at, k, &p);
    else add_grid(at, k, &p);
    measure(at, &p);
    return p;
}

INLINE lanes stretch_of(const place *at, const pairs *p)
{
    return at->kind.linear ? p->stretch : stretch_at(shortening(p));
}

/// The cosine between the bonds and the fibres.
INLINE lanes alignment_of(const place *at, const pairs *p)
{
    const double *fibre = at->law->fibre;
    lanes beta = lanes_of(0.0);
    for (int a = 0; a < PDMC_AXES; a++) beta = multiply_add(multiply(lanes_of(fibre[a]), p->length), p->slope[a], beta);
    return beta;
}

/// Of neighbours, what is in double precision in every kernel.
INLINE lanes doubles_of(const place *at, const double x[], size_t cell)
{
    return at->kind.scattered ? lanes_of(x[cell]) : load_double(&x[cell]);
}

/// Whether neighbours side by side are of one body, as they mostly are.
INLINE bool are_of_one(const int16_t body[])
{
    int16_t others = 0;
    for (int k = 1; k < BLOCKS * PDMC_LANES; k++) others |= body[k] ^ body[0];
    return others == 0;
}

/// From a table of pairs of bodies, what the block's has with those of its neighbours.
INLINE lanes of_joints(const place *at, const pairs *p, const double table[], double unit)
{
    const int16_t *body = &at->forces->nodes->body[p->cell];
    const double *row = &table[at->joints];
    double out[BLOCKS * PDMC_LANES];
    if (at->kind.scattered || are_of_one(body)) return lanes_of(row[*body] / unit);
    for (int k = 0; k < BLOCKS * PDMC_LANES; k++) out[k] = row[body[k]] / unit;
    return load_double(out);
}

/// c of the bonds over that of the place.
INLINE lanes stiffness_of(const place *at, const pairs *p)
{
    const real *factor = factors_of(at->forces);
    const pdmc_joints *joints = at->forces->joints;
    lanes stiffness = lanes_of(1.0), excess = lanes_of(at->law->fibre_excess);
    if (factor)
        stiffness = multiply(lanes_of(0.5), add(load(&factor[at->block->cell]), of_neighbours(at, factor, p->cell)));
    if (at->kind.joined)
        stiffness = multiply(stiffness, of_joints(at, p, joints->micromodulus, unit_of_micromodulus(at->forces)));
    if (at->law->fibre_excess == 0.0) return stiffness;
    if (at->kind.joined) excess = of_joints(at, p, joints->fibre_excess, 1.0);
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
    lanes own = of_joints(at, p, at->forces->joints->strength, 1.0);
    if (relative)
        own = multiply(own, least(load_double(&relative[at->block->cell]), doubles_of(at, relative, p->cell)));
    return least(own, add(of_nodes, of_joints(at, p, at->forces->joints->by_nodes, 1.0)));
}

/// s_0 of the bonds.
INLINE lanes strength_of(const place *at, const pairs *p)
{
    lanes s_0 = at->strength;
    if (at->kind.by_node) s_0 = least(s_0, of_neighbours(at, strengths_of(at->forces), p->cell));
    if (at->kind.joined) s_0 = joint_strength(at, p, s_0);
    if (at->kind.varied && at->law->strengths) s_0 = multiply(s_0, drawn_strength(at, p));
    return s_0;
}

/// What falls below place.enough where a bond is stretched beyond s_0.
INLINE lanes reserve_of(const place *at, const pairs *p)
{
    if (is_uniform(at->kind)) return shortening(p);
    const lanes s_0 = strength_of(at, p);
    return at->kind.linear ? subtract(s_0, p->stretch) : reserve_against(s_0, shortening(p));
}

/// Weight times s / p, or weight times s |xi| where that is linear, and the slope what it is multiplied with.
INLINE lanes pull_of(const place *at, const pairs *p)
{
    const lanes pull = at->kind.linear ? multiply(multiply(p->weight, p->length), p->stretch) : pull_by_length(at, p);
    return at->kind.varied ? multiply(pull, stiffness_of(at, p)) : pull;
}

/// There is no branch in here.
INLINE void add_neighbour(const place *at, int k, lane_mask bonds, sums *s)
{
    const pairs p = pairs_of(at, k);
    const lanes pull = pull_of(at, &p), nearness = shortening(&p);
    const lanes *along = at->kind.linear ? p.slope : p.apart;
    for (int a = 0; a < PDMC_AXES; a++) s->force[a] = multiply_add_where(bonds, pull, along[a], s->force[a]);
    s->weakest = least_where(bonds, s->weakest, reserve_of(at, &p));
    s->closest = at->kind.scattered ? greatest_where(p.near, s->closest, nearness) : greatest(s->closest, nearness);
    if (!at->kind.by_node) return;
    const lanes shortest = at->kind.linear ? subtract(lanes_of(0.0), p.stretch) : nearness;
    s->shortest = greatest_where(bonds, s->shortest, shortest);
}

INLINE lane_mask nodes_of(const place *at)
{
    unsigned nodes = at->block->nodes;
    if (BLOCKS > 1) nodes |= (unsigned)at->block[1].nodes << PDMC_LANES;
    return (lane_mask)nodes;
}

/// s_0 of the next step, by the least stretch of a node's bonds.
INLINE void strengthen(const place *at, const sums *s)
{
    const pdmc_forces *f = at->forces;
    const lanes law = lanes_of(at->law->critical_stretch);
    const lanes first = f->first_strength ? load_double(&f->first_strength[at->block->cell]) : law;
    const lanes least_stretch = at->kind.linear ? subtract(lanes_of(0.0), s->shortest) : stretch_at(s->shortest);
    const lanes strength = multiply_add(lanes_of(-at->law->strengthening), least_stretch, first);
    store_where(nodes_of(at), &next_strengths_of(f)[at->block->cell], strength);
}

/// The bonds to an entry of the list.
INLINE lane_mask bonds_of(const place *at, int k)
{
    const uint8_t *bonds = &at->forces->nodes->bonds[k];
    unsigned whole = bonds[at->block->bonds];
    if (BLOCKS > 1) whole |= (unsigned)bonds[at->block[1].bonds] << PDMC_LANES;
    return (lane_mask)whole;
}

/// Whether a bond breaks or nodes touch is only asked, node by node: what then happens is seldom.
INLINE pdmc_alarms find_forces(const pdmc_forces *f, int b, bond_kind kind)
{
    const place at = place_of(f, b, kind);
    const lane_mask nodes = nodes_of(&at);
    const lanes zero = lanes_of(0.0), least = lanes_of(-INFINITY);
    sums s = {.force = {zero, zero, zero}, .shortest = least, .closest = least, .weakest = lanes_of(INFINITY)};
    for (int k = 0; k < at.block->listed; k++) add_neighbour(&at, k, bonds_of(&at, k), &s);
    for (int a = 0; a < PDMC_AXES; a++)
        put_where(nodes, &f->force[a][at.block->cell], at.micromodulus * unit_of_volume(f), s.force[a]);
    if (at.law->strengthening != 0.0) strengthen(&at, &s);
    const lanes touching = lanes_of(shortening_at(f->nodes->touching) - shortening_slack);
    return (pdmc_alarms){.breaking = f->unbreakable ? 0 : less(s.weakest, at.enough) & nodes,
                         .touching = less(touching, s.closest) & nodes};
}
