// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/stiffness.h"
#include "pdmc/affine.h"

// The columns are worked on TILE at a time, node by node, so that one instruction does the same for all of them.
enum { TILE = 8, TILES = PDMC_BLOCK / TILE };

typedef double tile __attribute__((vector_size(TILE * sizeof(double))));

typedef struct {
    tile u[2];
} tile_vector;

static void gather_columns(int nodes, const double x[], tile_vector in[])
{
    const size_t unknowns = 2 * (size_t)nodes;
    for (size_t node = 0; node < (size_t)nodes; node++)
        for (size_t c = 0; c < TILE; c++)
            for (size_t i = 0; i < 2; i++) in[node].u[i][c] = x[c * unknowns + 2 * node + i];
}

// [shells] h^2 times the stiffness of a bond of the shell in each column, and whether it is 0 in all of them
static void gather_stiffness(const pdmc_bond_plate *plate, const double factor[], tile stiffness[], bool is_idle[])
{
    const pdmc_bond_horizon *horizon = &plate->horizon;
    const double area = plate->grid.spacing * plate->grid.spacing;
    for (int k = 0; k < horizon->count; k++) {
        const pdmc_bond_neighbour *n = &horizon->neighbour[k];
        for (int c = 0; c < TILE; c++)
            stiffness[n->shell][c] = area * n->stiffness * factor[c * horizon->shells + n->shell];
    }
    for (int m = 0; m < horizon->shells; m++) {
        is_idle[m] = true;
        for (int c = 0; c < TILE; c++) is_idle[m] = is_idle[m] && stiffness[m][c] == 0.0;
    }
}

// sum_j k e e . (u_i - u_j) of each node, in the order of its bonds. Vectors as long as a tile are twice as fast; none for
// AVX2: gcc 12 splits tiles into its vectors through memory, which is slower than SSE2.
PDMC_VECTORS("avx512f")
static void sum_bonds(const pdmc_bond_plate *plate, const tile stiffness[], const bool is_idle[],
                      const tile_vector in[], double y[])
{
    const pdmc_bond_families *families = &plate->families;
    const size_t nodes = (size_t)plate->grid.nodes, unknowns = 2 * nodes;
    for (size_t node = 0; node < nodes; node++) {
        const tile u = in[node].u[0], v = in[node].u[1];
        tile sum[2] = {{0.0}, {0.0}};
        for (size_t b = families->start[node]; b < families->start[node + 1]; b++) {
            const pdmc_bond_neighbour *n = &plate->horizon.neighbour[families->neighbour[b]];
            if (is_idle[n->shell]) continue;
            const int partner = families->partner[b];
            const double scale = 0.5 * (families->scale[node] + families->scale[partner]);
            const double e[2] = {n->direction[0], n->direction[1]}, pull[2] = {scale * e[0], scale * e[1]};
            const tile elongation = (u - in[partner].u[0]) * e[0] + (v - in[partner].u[1]) * e[1];
            const tile force = stiffness[n->shell] * elongation;
            sum[0] += pull[0] * force;
            sum[1] += pull[1] * force;
        }
        for (size_t i = 0; i < 2; i++) {
            const bool is_held = plate->grid.held[node] & (1U << i);
            for (size_t c = 0; c < TILE; c++) y[c * unknowns + 2 * node + i] = is_held ? 0.0 : sum[i][c];
        }
    }
}

static pdmc_status multiply_tile(const pdmc_bond_plate *plate, const double factor[], const double x[], double y[])
{
    pdmc_status status = PDMC_OK;
    tile_vector *in = NULL;
    tile *stiffness = NULL;
    bool *is_idle = NULL;
    PDMC_NEW(in, plate->grid.nodes);
    PDMC_NEW(stiffness, plate->horizon.shells);
    PDMC_NEW(is_idle, plate->horizon.shells);
    gather_columns(plate->grid.nodes, x, in);
    gather_stiffness(plate, factor, stiffness, is_idle);
    sum_bonds(plate, stiffness, is_idle, in, y);
done:
    pdmc_free(is_idle);
    pdmc_free(stiffness);
    pdmc_free(in);
    return status;
}

pdmc_status pdmc_bond_multiply(const pdmc_bond_plate *plate, int threads, const double factor[], const double x[],
                               double y[])
{
    pdmc_status status = PDMC_OK;
    const size_t shells = (size_t)plate->horizon.shells, columns = 2 * (size_t)plate->grid.nodes * TILE;
#pragma omp parallel for schedule(dynamic) num_threads(threads)
    for (size_t t = 0; t < TILES; t++) {
        const pdmc_status mine = multiply_tile(plate, &factor[t * TILE * shells], &x[t * columns], &y[t * columns]);
        if (mine != PDMC_OK) {
#pragma omp critical(pdmc_bond_multiply)
            status = mine;
        }
    }
    return status;
}
