// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/nodal.h"
#include "bond/tile.h"

#include <cblas.h>
#include <string.h>

// All pairs of two tiles of vectors at once, and the nodes by chunks, whose energies are summed up by one matrix product.
enum { TILE = PDMC_BOND_TILE, PAIRS = TILE * TILE, CHUNK = 256 };

typedef pdmc_bond_tile tile;

typedef struct {
    tile u[2], v[2];
} node_pair;

typedef struct {
    const pdmc_bond_plate *plate;
    int terms, u_count, v_count;
    const double *psi, *u, *v;
    double *out;
} projection;

// What a task works with.
typedef struct {
    node_pair *in;  // [nodes]
    double *energy; // [CHUNK, PAIRS]
    double *sum;    // [terms, PAIRS]
} workspace;

static pdmc_status workspace_create(const projection *p, workspace *work)
{
    pdmc_status status = PDMC_OK;
    *work = (workspace){0};
    PDMC_NEW(work->in, p->plate->grid.nodes);
    PDMC_NEW(work->energy, CHUNK * PAIRS);
    PDMC_NEW(work->sum, p->terms * PAIRS);
done:
    return status;
}

static void workspace_clear(workspace *work)
{
    pdmc_free(work->in);
    pdmc_free(work->energy);
    pdmc_free(work->sum);
}

// Columns beyond the last are zero.
static void gather(const projection *p, int first_u, int first_v, node_pair in[])
{
    const size_t unknowns = 2 * (size_t)p->plate->grid.nodes;
    for (size_t node = 0; node < (size_t)p->plate->grid.nodes; node++)
        for (int c = 0; c < TILE; c++)
            for (size_t i = 0; i < 2; i++) {
                const size_t row_u = (size_t)(first_u + c), row_v = (size_t)(first_v + c), at = 2 * node + i;
                in[node].u[i][c] = first_u + c < p->u_count ? p->u[row_u * unknowns + at] : 0.0;
                in[node].v[i][c] = first_v + c < p->v_count ? p->v[row_v * unknowns + at] : 0.0;
            }
}

// E of every pair at nodes first .. end - 1.
PDMC_BOND_LONGEST_VECTORS
static void sum_bonds(const pdmc_bond_plate *plate, const node_pair in[], int first, int end, double energy[])
{
    const pdmc_bond_families *families = &plate->families;
    const double half_area = 0.5 * plate->grid.spacing * plate->grid.spacing;
    for (int node = first; node < end; node++) {
        const node_pair at = in[node];
        tile sum[TILE];
        for (int a = 0; a < TILE; a++) sum[a] = (tile){0.0};
        for (size_t b = families->start[node]; b < families->start[node + 1]; b++) {
            const pdmc_bond_neighbour *n = &plate->horizon.neighbour[families->neighbour[b]];
            const node_pair *partner = &in[families->partner[b]];
            const double scale = 0.5 * (families->scale[node] + families->scale[families->partner[b]]);
            const double k = half_area * n->stiffness * scale, *e = n->direction;
            const tile stretch_u = k * ((at.u[0] - partner->u[0]) * e[0] + (at.u[1] - partner->u[1]) * e[1]);
            const tile stretch_v = (at.v[0] - partner->v[0]) * e[0] + (at.v[1] - partner->v[1]) * e[1];
            for (int a = 0; a < TILE; a++) sum[a] += stretch_u[a] * stretch_v;
        }
        memcpy(&energy[(node - first) * PAIRS], sum, sizeof sum);
    }
}

static void scatter(const projection *p, int first_u, int first_v, const double sum[])
{
    for (int m = 0; m < p->terms; m++)
        for (int a = 0; a < TILE && first_u + a < p->u_count; a++)
            for (int b = 0; b < TILE && first_v + b < p->v_count; b++)
                p->out[((size_t)m * (size_t)p->u_count + (size_t)(first_u + a)) * (size_t)p->v_count +
                       (size_t)(first_v + b)] = sum[m * PAIRS + a * TILE + b];
}

static pdmc_status project_tiles(const projection *p, int first_u, int first_v)
{
    pdmc_status status = PDMC_OK;
    const int nodes = p->plate->grid.nodes;
    workspace work;
    PDMC_TRY(workspace_create(p, &work));
    gather(p, first_u, first_v, work.in);
    for (int first = 0; first < nodes; first += CHUNK) {
        const int count = nodes - first < CHUNK ? nodes - first : CHUNK;
        sum_bonds(p->plate, work.in, first, first + count, work.energy);
        cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, p->terms, PAIRS, count, 1.0,
                    &p->psi[(size_t)first * (size_t)p->terms], p->terms, work.energy, PAIRS, 1.0, work.sum, PAIRS);
    }
    scatter(p, first_u, first_v, work.sum);
done:
    workspace_clear(&work);
    return status;
}

pdmc_status pdmc_bond_nodal_project(const pdmc_bond_plate *plate, int threads, int terms, const double psi[],
                                    int u_count, const double u[], int v_count, const double v[], double out[])
{
    pdmc_status status = PDMC_OK;
    const projection p = {plate, terms, u_count, v_count, psi, u, v, out};
    const int rows = (u_count + TILE - 1) / TILE, columns = (v_count + TILE - 1) / TILE;
#pragma omp parallel for schedule(dynamic) num_threads(threads)
    for (int task = 0; task < rows * columns; task++) {
        const pdmc_status mine = project_tiles(&p, task / columns * TILE, task % columns * TILE);
        if (mine != PDMC_OK) {
#pragma omp critical(pdmc_bond_nodal_project)
            status = mine;
        }
    }
    return status;
}

void pdmc_bond_nodal_energy(const pdmc_bond_plate *plate, const double u[], const double v[], double energy[])
{
    const pdmc_bond_families *families = &plate->families;
    const double half_area = 0.5 * plate->grid.spacing * plate->grid.spacing;
    for (int node = 0; node < plate->grid.nodes; node++) {
        energy[node] = 0.0;
        for (size_t b = families->start[node]; b < families->start[node + 1]; b++) {
            const pdmc_bond_neighbour *n = &plate->horizon.neighbour[families->neighbour[b]];
            const int other = families->partner[b];
            const double k = half_area * n->stiffness * 0.5 * (families->scale[node] + families->scale[other]);
            double stretch[2] = {0.0, 0.0};
            for (int i = 0; i < 2; i++) {
                stretch[0] += n->direction[i] * (u[2 * node + i] - u[2 * other + i]);
                stretch[1] += n->direction[i] * (v[2 * node + i] - v[2 * other + i]);
            }
            energy[node] += k * stretch[0] * stretch[1];
        }
    }
}
