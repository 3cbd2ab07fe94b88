// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/stiffness.h"
#include "bond/tile.h"

#include <cblas.h>
#include <string.h>

// A tile of vectors at once, and the nodes by chunks, whose forces stay in the cache until a matrix product has used them.
enum { TILE = PDMC_BOND_TILE, CHUNK = 512 };

typedef pdmc_bond_tile tile;

typedef struct {
    tile u[2];
} tile_vector;

typedef struct {
    const pdmc_bond_plate *plate;
    int u_count, v_count;
    const double *u, *v;
    double *out;
} projection;

// What a task works with.
typedef struct {
    tile_vector *in; // [nodes]
    tile *force;     // [CHUNK, 2, shells]
    double *sum;     // [shells, TILE, v_count]
} workspace;

static pdmc_status workspace_create(const projection *p, workspace *work)
{
    pdmc_status status = PDMC_OK;
    const int shells = p->plate->horizon.shells;
    *work = (workspace){0};
    PDMC_NEW(work->in, p->plate->grid.nodes);
    PDMC_NEW(work->force, CHUNK * 2 * shells);
    PDMC_NEW(work->sum, (size_t)(shells * TILE) * (size_t)p->v_count);
done:
    return status;
}

static void workspace_clear(workspace *work)
{
    pdmc_free(work->in);
    pdmc_free(work->force);
    pdmc_free(work->sum);
}

// Columns beyond the last are zero.
static void gather(const projection *p, int first_u, tile_vector in[])
{
    const size_t unknowns = 2 * (size_t)p->plate->grid.nodes;
    for (size_t node = 0; node < unknowns / 2; node++)
        for (int c = 0; c < TILE; c++)
            for (size_t i = 0; i < 2; i++)
                in[node].u[i][c] =
                    first_u + c < p->u_count ? p->u[(size_t)(first_u + c) * unknowns + 2 * node + i] : 0.0;
}

// h^2 sum k e e . (u_i - u_j) over the bonds of each shell, of nodes first .. end - 1; 0 where they are held.
PDMC_BOND_LONGEST_VECTORS
static void sum_bonds(const pdmc_bond_plate *plate, const tile_vector in[], int first, int end, tile force[])
{
    const pdmc_bond_families *families = &plate->families;
    const double area = plate->grid.spacing * plate->grid.spacing;
    const int shells = plate->horizon.shells;
    memset(force, 0, (size_t)(2 * shells * (end - first)) * sizeof *force);
    for (int node = first; node < end; node++) {
        const tile u = in[node].u[0], v = in[node].u[1];
        tile *along_x = &force[2 * shells * (node - first)], *along_y = along_x + shells;
        for (size_t b = families->start[node]; b < families->start[node + 1]; b++) {
            const pdmc_bond_neighbour *n = &plate->horizon.neighbour[families->neighbour[b]];
            const int partner = families->partner[b];
            const double k = area * n->stiffness * 0.5 * (families->scale[node] + families->scale[partner]);
            const double e[2] = {n->direction[0], n->direction[1]};
            const tile pull = k * ((u - in[partner].u[0]) * e[0] + (v - in[partner].u[1]) * e[1]);
            along_x[n->shell] += pull * e[0];
            along_y[n->shell] += pull * e[1];
        }
        if (plate->grid.held[node] & 1U) memset(along_x, 0, (size_t)shells * sizeof *along_x);
        if (plate->grid.held[node] & 2U) memset(along_y, 0, (size_t)shells * sizeof *along_y);
    }
}

static void scatter(const projection *p, int first_u, const double sum[])
{
    const size_t row = (size_t)p->v_count;
    for (int m = 0; m < p->plate->horizon.shells; m++)
        for (int c = 0; c < TILE && first_u + c < p->u_count; c++)
            memcpy(&p->out[(size_t)(m * p->u_count + first_u + c) * row], &sum[(size_t)(m * TILE + c) * row],
                   row * sizeof *sum);
}

static pdmc_status project_tile(const projection *p, int first_u)
{
    pdmc_status status = PDMC_OK;
    const int nodes = p->plate->grid.nodes, products = p->plate->horizon.shells * TILE;
    workspace work;
    PDMC_TRY(workspace_create(p, &work));
    gather(p, first_u, work.in);
    for (int first = 0; first < nodes; first += CHUNK) {
        const int count = nodes - first < CHUNK ? nodes - first : CHUNK;
        sum_bonds(p->plate, work.in, first, first + count, work.force);
        cblas_dgemm(CblasRowMajor, CblasTrans, CblasTrans, products, p->v_count, 2 * count, 1.0,
                    (const double *)work.force, products, &p->v[2 * (size_t)first], 2 * nodes, 1.0, work.sum,
                    p->v_count);
    }
    scatter(p, first_u, work.sum);
done:
    workspace_clear(&work);
    return status;
}

pdmc_status pdmc_bond_shell_project(const pdmc_bond_plate *plate, int threads, int u_count, const double u[],
                                    int v_count, const double v[], double out[])
{
    pdmc_status status = PDMC_OK;
    const projection p = {plate, u_count, v_count, u, v, out};
#pragma omp parallel for schedule(dynamic) num_threads(threads)
    for (int first = 0; first < u_count; first += TILE) {
        const pdmc_status mine = project_tile(&p, first);
        if (mine != PDMC_OK) {
#pragma omp critical(pdmc_bond_shell_project)
            status = mine;
        }
    }
    return status;
}
