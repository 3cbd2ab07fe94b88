// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/grid.h"

#include <math.h>

// The walk over the bonds of a grid. `near` lists the cracks that the bonds of a node may meet.
typedef struct {
    const pdmc_problem *problem;
    const pdmc_bond_grid *grid;
    const pdmc_bond_horizon *horizon;
    double reach; // of the bonds, length
    int *near, near_count;
} walk;

static double farthest(const pdmc_bond_grid *grid, const pdmc_bond_horizon *horizon)
{
    double most = 0.0;
    for (int k = 0; k < horizon->count; k++)
        most = fmax(most, hypot(horizon->neighbour[k].column, horizon->neighbour[k].row));
    return most * grid->spacing;
}

static void find_cracks(walk *w, const double x[2])
{
    const double reach = w->reach * (1.0 + 1e-9); // for rounding of the box
    w->near_count = 0;
    for (int c = 0; c < w->problem->crack_count; c++) {
        const pdmc_crack *crack = &w->problem->cracks[c];
        bool is_near = true;
        for (int i = 0; i < 2; i++)
            is_near = is_near && fmin(crack->from[i], crack->to[i]) <= x[i] + reach &&
                      fmax(crack->from[i], crack->to[i]) >= x[i] - reach;
        if (is_near) w->near[w->near_count++] = c;
    }
}

// The partner of a node in the grid, or -1.
static int partner_of(const pdmc_bond_grid *grid, int node, const pdmc_bond_neighbour *neighbour)
{
    const int column = node % grid->columns + neighbour->column, row = node / grid->columns + neighbour->row;
    const bool is_inside = column >= 0 && column < grid->columns && row >= 0 && row < grid->rows;
    return is_inside ? row * grid->columns + column : -1;
}

static bool is_cut(const walk *w, const double a[2], int partner)
{
    double b[2];
    if (w->near_count == 0) return false;
    pdmc_bond_grid_node(w->grid, partner, b);
    for (int c = 0; c < w->near_count; c++)
        if (pdmc_bond_is_cut(&w->problem->cracks[w->near[c]], w->grid->spacing, a, b)) return true;
    return false;
}

// Counts the bonds of a node, and stores them from `at` on where there are arrays.
static size_t visit(walk *w, int node, size_t at, pdmc_bond_families *out, size_t *cut)
{
    double a[2];
    size_t count = 0;
    pdmc_bond_grid_node(w->grid, node, a);
    find_cracks(w, a);
    for (int k = 0; k < w->horizon->count; k++) {
        const int partner = partner_of(w->grid, node, &w->horizon->neighbour[k]);
        if (partner < 0) continue;
        if (is_cut(w, a, partner)) {
            ++*cut;
            continue;
        }
        if (out->partner) {
            out->partner[at + count] = partner;
            out->neighbour[at + count] = (uint16_t)k;
        }
        count++;
    }
    return count;
}

// Twice over the bonds, so that no more memory is taken than they need.
static pdmc_status find_partners(walk *w, pdmc_bond_families *out)
{
    pdmc_status status = PDMC_OK;
    size_t directed_cuts = 0, again = 0;
    PDMC_NEW(out->start, w->grid->nodes + 1);
    for (int node = 0; node < w->grid->nodes; node++)
        out->start[node + 1] = out->start[node] + visit(w, node, 0, out, &directed_cuts);
    out->cut = directed_cuts / 2;
    PDMC_NEW(out->neighbour, out->start[w->grid->nodes]);
    PDMC_NEW(out->partner, out->start[w->grid->nodes]);
    for (int node = 0; node < w->grid->nodes; node++) visit(w, node, out->start[node], out, &again);
done:
    return status;
}

// Four times the energy density of the stretch u = x that a bond to a neighbour holds.
static double stretch_energy(const pdmc_bond_grid *grid, const pdmc_bond_neighbour *n)
{
    const double elongation = grid->spacing * (n->direction[0] * n->column + n->direction[1] * n->row);
    return n->stiffness * elongation * elongation;
}

static double correction(const walk *w, int node)
{
    double whole = 0.0, inside = 0.0;
    for (int k = 0; k < w->horizon->count; k++) {
        const pdmc_bond_neighbour *n = &w->horizon->neighbour[k];
        const double energy = stretch_energy(w->grid, n);
        whole += energy;
        if (partner_of(w->grid, node, n) >= 0) inside += energy;
    }
    return inside > 0.0 ? whole / inside : 1.0;
}

static bool is_horizon_inside(const walk *w, int node)
{
    const int reach = (int)ceil(w->reach / w->grid->spacing), column = node % w->grid->columns;
    const int row = node / w->grid->columns;
    return column >= reach && column + reach < w->grid->columns && row >= reach && row + reach < w->grid->rows;
}

pdmc_status pdmc_bond_families_create(const pdmc_problem *problem, const pdmc_bond_grid *grid,
                                      const pdmc_bond_horizon *horizon, pdmc_bond_families *out)
{
    pdmc_status status = PDMC_OK;
    walk w = {.problem = problem, .grid = grid, .horizon = horizon, .reach = farthest(grid, horizon)};
    const bool is_corrected = problem->solver.surface_correction == PDMC_ON;
    *out = (pdmc_bond_families){0};
    PDMC_NEW(w.near, problem->crack_count);
    PDMC_TRY(find_partners(&w, out));
    PDMC_NEW(out->scale, grid->nodes);
    for (int node = 0; node < grid->nodes; node++)
        out->scale[node] = is_corrected && !is_horizon_inside(&w, node) ? correction(&w, node) : 1.0;
done:
    if (status != PDMC_OK) pdmc_bond_families_clear(out);
    pdmc_free(w.near);
    return status;
}

void pdmc_bond_families_clear(pdmc_bond_families *families)
{
    pdmc_free(families->start);
    pdmc_free(families->partner);
    pdmc_free(families->neighbour);
    pdmc_free(families->scale);
    *families = (pdmc_bond_families){0};
}
