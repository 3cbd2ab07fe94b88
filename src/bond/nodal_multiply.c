// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/nodal.h"
#include "bond/tile.h"

#include <cblas.h>
#include <string.h>

enum { TILE = PDMC_BOND_TILE, TILES = PDMC_BLOCK / TILE };

typedef pdmc_bond_tile tile;

// A node's displacement and half its factor.
typedef struct {
    tile u[2], half;
} tile_node;

static void gather_columns(int nodes, const double x[], tile_node in[])
{
    const size_t unknowns = 2 * (size_t)nodes;
    for (size_t node = 0; node < (size_t)nodes; node++)
        for (size_t c = 0; c < TILE; c++)
            for (size_t i = 0; i < 2; i++) in[node].u[i][c] = x[c * unknowns + 2 * node + i];
}

static pdmc_status gather_factors(int nodes, int terms, const double psi[], double mean, int stride, const double xi[],
                                  tile_node in[])
{
    pdmc_status status = PDMC_OK;
    double *factor = NULL; // [nodes, TILE]
    PDMC_NEW(factor, nodes * TILE);
    if (terms > 0)
        cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, nodes, TILE, terms, 1.0, psi, terms, xi, stride, 0.0,
                    factor, TILE);
    for (int node = 0; node < nodes; node++)
        for (int c = 0; c < TILE; c++) in[node].half[c] = 0.5 * (mean + factor[node * TILE + c]);
done:
    pdmc_free(factor);
    return status;
}

// Of each node, in the order of its bonds.
PDMC_BOND_LONGEST_VECTORS
static void sum_bonds(const pdmc_bond_plate *plate, const tile_node in[], double y[])
{
    const pdmc_bond_families *families = &plate->families;
    const size_t nodes = (size_t)plate->grid.nodes, unknowns = 2 * nodes;
    const double area = plate->grid.spacing * plate->grid.spacing;
    for (size_t node = 0; node < nodes; node++) {
        const tile_node at = in[node];
        tile sum[2] = {{0.0}, {0.0}};
        for (size_t b = families->start[node]; b < families->start[node + 1]; b++) {
            const pdmc_bond_neighbour *n = &plate->horizon.neighbour[families->neighbour[b]];
            const tile_node *partner = &in[families->partner[b]];
            const double k =
                area * n->stiffness * 0.5 * (families->scale[node] + families->scale[families->partner[b]]);
            const tile elongation =
                (at.u[0] - partner->u[0]) * n->direction[0] + (at.u[1] - partner->u[1]) * n->direction[1];
            const tile force = (at.half + partner->half) * elongation;
            sum[0] += k * n->direction[0] * force;
            sum[1] += k * n->direction[1] * force;
        }
        for (size_t i = 0; i < 2; i++) {
            const bool is_held = plate->grid.held[node] & (1U << i);
            for (size_t c = 0; c < TILE; c++) y[c * unknowns + 2 * node + i] = is_held ? 0.0 : sum[i][c];
        }
    }
}

pdmc_status pdmc_bond_nodal_multiply(const pdmc_bond_plate *plate, int threads, int terms, const double psi[],
                                     double mean, int stride, const double xi[], const double x[], double y[])
{
    pdmc_status status = PDMC_OK;
    const int nodes = plate->grid.nodes;
    const size_t columns = 2 * (size_t)nodes * TILE;
#pragma omp parallel for schedule(dynamic) num_threads(threads)
    for (size_t t = 0; t < TILES; t++) {
        tile_node *in = pdmc_calloc((size_t)nodes, sizeof *in);
        pdmc_status mine = in ? PDMC_OK : PDMC_ERR_NOMEM;
        if (in) mine = gather_factors(nodes, terms, psi, mean, stride, &xi[t * TILE * (size_t)stride], in);
        if (mine == PDMC_OK) {
            gather_columns(nodes, &x[t * columns], in);
            sum_bonds(plate, in, &y[t * columns]);
        } else {
#pragma omp critical(pdmc_bond_nodal_multiply)
            status = mine;
        }
        pdmc_free(in);
    }
    return status;
}
