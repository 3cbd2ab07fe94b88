// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/contact.h"

#include "base/base_impl.h"

#include <math.h>
#include <string.h>

static const double skin = 0.65; // of the spacing: about half of the usual distance, where the search costs least

pdmc_status pdmc_contact_create(const pdmc_particles_options *options, const pdmc_nodes *g, double repulsion,
                                pdmc_contact *contact)
{
    pdmc_status status = PDMC_OK;
    *contact = (pdmc_contact){.repulsion = repulsion, .skin = skin * g->spacing};
    if (options->contact_distance == 0.0) return PDMC_OK;
    contact->distance = fmin(options->contact_distance * g->spacing, PDMC_TOUCHING_SHARE * g->apart);
    PDMC_NEW(contact->node, g->node_count);
    PDMC_NEW(contact->partners, g->node_count);
    PDMC_NEW(contact->start, g->node_count + 1);
    for (int a = 0; a < PDMC_AXES; a++) {
        PDMC_NEW(contact->built[a], g->cells);
        PDMC_NEW(contact->found[a], g->node_count);
        PDMC_NEW(contact->moved[a], g->node_count);
    }
    for (size_t c = 0; c < g->cells; c++) contact->built[0][c] = INFINITY;
    contact->way = INFINITY; // nothing was found yet
    PDMC_TRY(pdmc_bins_create(g->node_count, &contact->bins));
    PDMC_NEW(contact->range, 2 * PDMC_AXES * (size_t)contact->bins.most);
done:
    return status;
}

void pdmc_contact_clear(pdmc_contact *contact)
{
    pdmc_free(contact->node);
    pdmc_free(contact->partners);
    pdmc_free(contact->start);
    pdmc_free(contact->partner);
    for (int a = 0; a < PDMC_AXES; a++) {
        pdmc_free(contact->built[a]);
        pdmc_free(contact->found[a]);
        pdmc_free(contact->moved[a]);
    }
    pdmc_free(contact->range);
    pdmc_bins_clear(&contact->bins);
    *contact = (pdmc_contact){0};
}

/// The largest squared distance that nodes of a block have moved since the pairs were found; infinite where it is no number.
static double farthest(const pdmc_contact *contact, const pdmc_block *block, double *const position[])
{
    double square[PDMC_LANES] = {0.0}, most = 0.0;
    for (int a = 0; a < PDMC_AXES; a++) {
        const double *now = &position[a][block->cell], *then = &contact->built[a][block->cell];
        for (int k = 0; k < PDMC_LANES; k++) square[k] += (now[k] - then[k]) * (now[k] - then[k]);
    }
    for (int k = 0; k < PDMC_LANES; k++)
        if (block->nodes >> k & 1) most = square[k] <= most ? most : square[k];
    return isnan(most) ? INFINITY : most;
}

static double find_way(const pdmc_contact *contact, const pdmc_nodes *g, double *const position[], int threads)
{
    double most = 0.0; // of whichever node, so that the order is all the same
#pragma omp parallel for num_threads(threads) schedule(static) reduction(max : most)
    for (int b = 0; b < g->block_count; b++) {
        const double square = farthest(contact, &g->blocks[b], position);
        most = square > most ? square : most;
    }
    return sqrt(most);
}

/// Whether a node has moved by more than half of the skin since the pairs were found. It is looked at only where what was told
/// of the way since then does not say it.
static bool has_moved(pdmc_contact *contact, const pdmc_nodes *g, double *const position[], int threads)
{
    const double allowed = 0.5 * contact->skin;
    if (contact->way <= allowed) return false;
    contact->way = find_way(contact, g, position, threads);
    return contact->way > allowed;
}

void pdmc_contact_pass(pdmc_contact *contact, double distance)
{
    const double margin = 1.0 + 1e-9; // of rounding
    contact->way += margin * distance;
}

static void remember(pdmc_contact *contact, const pdmc_nodes *g, double *const position[], int threads)
{
#pragma omp parallel for num_threads(threads) schedule(static)
    for (int k = 0; k < g->node_count; k++) {
        const size_t c = g->cell[k];
        for (int a = 0; a < PDMC_AXES; a++) {
            contact->built[a][c] = contact->found[a][k] = position[a][c];
            contact->moved[a][k] = position[a][c] - g->reference[a][c];
        }
    }
}

static void find_range(pdmc_contact *contact, int bin)
{
    const pdmc_bins *bins = &contact->bins;
    double *least = &contact->range[2 * PDMC_AXES * (size_t)bin], *most = least + PDMC_AXES;
    for (int a = 0; a < PDMC_AXES; a++) {
        least[a] = INFINITY, most[a] = -INFINITY;
        for (int k = bins->start[bin]; k < bins->start[bin + 1]; k++) {
            const double u = contact->moved[a][bins->sorted[k]];
            if (u < least[a]) least[a] = u;
            if (u > most[a]) most[a] = u;
        }
    }
}

/// Whether no two nodes of these bins that are not neighbours can be near: they were `apart` at least, and have not moved
/// towards each other by as much as that takes.
static bool is_calm(const pdmc_contact *contact, double apart, int count, const int near[])
{
    double square = 0.0;
    for (int a = 0; a < PDMC_AXES; a++) {
        double least = INFINITY, most = -INFINITY;
        for (int k = 0; k < count; k++) {
            const double *range = &contact->range[2 * PDMC_AXES * (size_t)near[k]];
            if (range[a] < least) least = range[a];
            if (range[PDMC_AXES + a] > most) most = range[PDMC_AXES + a];
        }
        square += (most - least) * (most - least);
    }
    return sqrt(square) < apart - contact->distance - contact->skin;
}

/// The partners of a node, in the order of the bins. @param[out] partner  NULL: they are counted only
static int find_partners(const pdmc_contact *contact, const pdmc_nodes *g, int k, int count, const int near[],
                         int partner[])
{
    const pdmc_bins *bins = &contact->bins;
    const double reach = contact->distance + contact->skin;
    const double x = bins->x[0][k], y = bins->x[1][k], z = bins->x[2][k];
    const int node = bins->sorted[k];
    int found = 0;
    for (int b = 0; b < count; b++) {
        for (int j = bins->start[near[b]]; j < bins->start[near[b] + 1]; j++) {
            const double dx = bins->x[0][j] - x, dy = bins->x[1][j] - y, dz = bins->x[2][j] - z;
            if (dx * dx + dy * dy + dz * dz > reach * reach || j == k) continue;
            if (pdmc_nodes_are_near(g, g->cell[node], g->cell[bins->sorted[j]])) continue;
            if (partner) partner[found] = bins->sorted[j];
            found++;
        }
    }
    return found;
}

/// Counts the partners of a bin's nodes, or writes them where there is room.
static void search_bin(pdmc_contact *contact, const pdmc_nodes *g, int bin, bool write)
{
    int near[27];
    const pdmc_bins *bins = &contact->bins;
    const int count = pdmc_bins_near(bins, bin, near);
    if (is_calm(contact, g->apart, count, near)) return;
    for (int k = bins->start[bin]; k < bins->start[bin + 1]; k++) {
        const int node = bins->sorted[k];
        if (!write) contact->partners[node] = find_partners(contact, g, k, count, near, NULL);
        else if (contact->partners[node] > 0)
            find_partners(contact, g, k, count, near, &contact->partner[contact->start[node]]);
    }
}

static void search(pdmc_contact *contact, const pdmc_nodes *g, int threads, bool write)
{
    const pdmc_bins *bins = &contact->bins;
    const int total = bins->count[0] * bins->count[1] * bins->count[2];
#pragma omp parallel for num_threads(threads) schedule(dynamic, 64)
    for (int b = 0; b < total; b++)
        if (bins->start[b] < bins->start[b + 1]) search_bin(contact, g, b, write);
}

static pdmc_status make_room(pdmc_contact *contact, int nodes)
{
    contact->listed = 0;
    for (int k = 0; k < nodes; k++) {
        contact->start[k + 1] = contact->start[k] + (size_t)contact->partners[k];
        if (contact->partners[k] > 0) contact->node[contact->listed++] = k;
    }
    if (contact->start[nodes] <= contact->room) return PDMC_OK;
    pdmc_free(contact->partner);
    contact->room = 2 * contact->start[nodes];
    contact->partner = pdmc_calloc(contact->room, sizeof *contact->partner);
    if (contact->partner) return PDMC_OK;
    contact->room = 0;
    contact->listed = 0;
    return PDMC_ERR_NOMEM;
}

pdmc_status pdmc_contact_update(pdmc_contact *contact, const pdmc_nodes *g, double *const position[PDMC_AXES],
                                int threads)
{
    if (contact->distance == 0.0 || !has_moved(contact, g, position, threads)) return PDMC_OK;
    pdmc_bins *bins = &contact->bins;
    remember(contact, g, position, threads);
    contact->way = 0.0;
    pdmc_bins_fill(bins, contact->found, contact->distance + contact->skin);
    const int total = bins->count[0] * bins->count[1] * bins->count[2];
    for (int b = 0; b < total; b++) find_range(contact, b);
    memset(contact->partners, 0, (size_t)g->node_count * sizeof *contact->partners);
    search(contact, g, threads, false);
    const pdmc_status status = make_room(contact, g->node_count);
    if (status == PDMC_OK && contact->listed > 0) search(contact, g, threads, true);
    return status;
}

/// How far two nodes are inside the distance of contact. @param[out] apart  from the first to the second
static double depth_of(const pdmc_contact *contact, double *const position[], size_t i, size_t j, double apart[])
{
    double square = 0.0;
    for (int a = 0; a < PDMC_AXES; a++) {
        apart[a] = position[a][j] - position[a][i];
        square += apart[a] * apart[a];
    }
    return contact->distance - sqrt(square);
}

void pdmc_contact_add(const pdmc_contact *contact, const pdmc_nodes *g, double *const position[PDMC_AXES], int threads,
                      double *const force[PDMC_AXES])
{
#pragma omp parallel for num_threads(threads) schedule(dynamic, 256)
    for (int k = 0; k < contact->listed; k++) {
        const int node = contact->node[k];
        const size_t i = g->cell[node];
        for (size_t p = contact->start[node]; p < contact->start[node + 1]; p++) {
            double apart[PDMC_AXES];
            const size_t j = g->cell[contact->partner[p]];
            const double depth = depth_of(contact, position, i, j, apart);
            if (depth <= 0.0) continue;
            const double push = contact->repulsion * g->volume[j] * depth / (contact->distance - depth);
            for (int a = 0; a < PDMC_AXES; a++) force[a][i] -= push * apart[a];
        }
    }
}

double pdmc_contact_energy(const pdmc_contact *contact, const pdmc_nodes *g, double *const position[PDMC_AXES])
{
    double sum = 0.0;
    for (int k = 0; k < contact->listed; k++) {
        const int node = contact->node[k];
        for (size_t p = contact->start[node]; p < contact->start[node + 1]; p++) {
            double apart[PDMC_AXES];
            const size_t i = g->cell[node], j = g->cell[contact->partner[p]];
            const double depth = depth_of(contact, position, i, j, apart);
            if (depth > 0.0) sum += 0.25 * contact->repulsion * g->volume[i] * g->volume[j] * depth * depth;
        }
    }
    return sum;
}
