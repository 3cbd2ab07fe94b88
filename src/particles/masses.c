// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/masses.h"

#include "particles/particles_impl.h"

#include <math.h>

// Underwood: masses of a step of 1.1 are used with one of 1.
static const double mass_margin = 1.21;

// Of the spacing: more makes masses larger where nodes are near each other, less has them found more often.
static const double reach_share = 0.02;

double pdmc_masses_reach(const pdmc_particles *p)
{
    const bool can_touch = p->sphere_count > 0 || isfinite(p->nodes.touching);
    return can_touch ? reach_share * p->nodes.spacing : INFINITY;
}

/// Adds |k| |e_a| sum_b |e_b| of what acts with the stiffness k along e, of any length.
static void add_row(double stiffness, const double e[PDMC_AXES], double row[PDMC_AXES])
{
    double square = 0.0, sum = 0.0;
    for (int a = 0; a < PDMC_AXES; a++) {
        square += e[a] * e[a];
        sum += fabs(e[a]);
    }
    for (int a = 0; a < PDMC_AXES && square > 0.0; a++) row[a] += stiffness * fabs(e[a]) * sum / square;
}

/// From one cell's node to another's. @return their distance
static double find_apart(double *const x[PDMC_AXES], size_t from, size_t to, double apart[PDMC_AXES])
{
    for (int a = 0; a < PDMC_AXES; a++) apart[a] = x[a][to] - x[a][from];
    return sqrt(apart[0] * apart[0] + apart[1] * apart[1] + apart[2] * apart[2]);
}

/// A bond is in the row twice: in the node's own place and in its neighbour's. So is a contact of two nodes.
static void add_bond(const pdmc_particles *p, const pdmc_block *block, size_t c, size_t other, double row[PDMC_AXES])
{
    const pdmc_nodes *g = &p->nodes;
    const double micromodulus = pdmc_variation_micromodulus(&p->variation, g, &p->laws[block->material], c, other);
    double apart[PDMC_AXES];
    find_apart(p->linear ? g->reference : p->position, c, other, apart);
    add_row(2.0 * micromodulus * pdmc_nodes_weight(g, c, other) * g->volume[c] / pdmc_nodes_length(g, c, other), apart,
            row);
}

static void add_contact(const pdmc_particles *p, size_t c, size_t other, double distance, double row[PDMC_AXES])
{
    double apart[PDMC_AXES];
    if (find_apart(p->position, c, other, apart) < distance + pdmc_masses_reach(p))
        add_row(2.0 * p->repulsion * p->nodes.volume[c] * p->nodes.volume[other], apart, row);
}

/// Neighbours in the reference configuration: bonds, and whoever is near, bond or not.
static void add_neighbours(const pdmc_particles *p, const pdmc_block *block, int lane, double row[PDMC_AXES])
{
    const pdmc_nodes *g = &p->nodes;
    const size_t c = block->cell + (size_t)lane;
    for (int k = 0; k < block->listed; k++) {
        const size_t at = block->bonds + (size_t)k, other = pdmc_nodes_neighbour(g, block, k, lane);
        if (g->bonds[at] >> lane & 1) add_bond(p, block, c, other, row);
        const bool is_near = !g->near || g->near[at] >> lane & 1;
        if (isfinite(g->touching) && is_near && g->volume[other] > 0.0)
            add_contact(p, c, other, fmin(g->contact_distance, PDMC_TOUCHING_SHARE * pdmc_nodes_length(g, c, other)),
                        row);
    }
}

static void add_strangers(const pdmc_particles *p, size_t c, double row[PDMC_AXES])
{
    const pdmc_contact *contact = &p->contact;
    const int node = p->nodes.node[c];
    for (int k = 0; contact->listed > 0 && k < contact->partners[node]; k++)
        add_contact(p, c, p->nodes.cell[contact->partner[contact->start[node] + (size_t)k]], contact->distance, row);
}

/// 2 stiffness depth V; the sphere itself does not move.
static void add_sphere(const pdmc_particles *p, const pdmc_rigid_sphere *sphere, size_t c, double row[PDMC_AXES])
{
    double out[PDMC_AXES];
    for (int a = 0; a < PDMC_AXES; a++) out[a] = p->position[a][c] - sphere->centre[a];
    const double distance = sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2]);
    const double depth = sphere->radius - distance + pdmc_masses_reach(p);
    if (depth > 0.0) add_row(2.0 * sphere->stiffness * depth * p->nodes.volume[c], out, row);
}

static double mass_of(const pdmc_particles *p, const pdmc_block *block, int lane)
{
    const size_t c = block->cell + (size_t)lane;
    double row[PDMC_AXES] = {0.0};
    add_neighbours(p, block, lane, row);
    add_strangers(p, c, row);
    for (int s = 0; s < p->sphere_count; s++) add_sphere(p, &p->spheres[s], c, row);
    const double mass = 0.25 * mass_margin * fmax(row[0], fmax(row[1], row[2]));
    return mass > 0.0 ? mass : INFINITY;
}

static void hold(const pdmc_particles *p, const pdmc_layer *layer, double mass[])
{
    const int dimension = p->nodes.dimension;
    if (!pdmc_layer_holds(layer)) return;
    for (int a = 0; a < dimension; a++)
        for (int i = 0; layer->condition.along[a] && i < layer->count; i++)
            mass[p->nodes.node[layer->cell[i]] * dimension + a] = INFINITY;
}

void pdmc_masses_find(const pdmc_particles *p, double mass[])
{
    const pdmc_nodes *g = &p->nodes;
#pragma omp parallel for num_threads(p->threads) schedule(static)
    for (int b = 0; b < g->block_count; b++)
        for (unsigned left = g->blocks[b].nodes; left; left &= left - 1) {
            const int lane = __builtin_ctz(left), node = g->node[g->blocks[b].cell + (size_t)lane];
            const double of_node = mass_of(p, &g->blocks[b], lane);
            for (int a = 0; a < g->dimension; a++) mass[node * g->dimension + a] = of_node;
        }
    for (int k = 0; k < p->layer_count; k++) hold(p, &p->layers[k], mass);
}
