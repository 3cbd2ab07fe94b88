// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/bond.h"
#include "bond/dissection.h"
#include "bond/nodal.h"
#include "discretisation/rigid.h"

#include <cblas.h>
#include <math.h>
#include <string.h>

static pdmc_status hold_rigid_motions(const pdmc_problem *problem, pdmc_bond_plate *plate)
{
    const pdmc_bond_grid *grid = &plate->grid;
    const int corners[PDMC_RIGID_CANDIDATES] = {0, grid->columns - 1, grid->nodes - grid->columns, grid->nodes - 1};
    pdmc_status status = PDMC_OK;
    double *x = NULL;
    PDMC_TRY(pdmc_bond_grid_nodes(grid, &x));
    PDMC_TRY(pdmc_rigid_hold(problem, x, corners, grid->held));
done:
    pdmc_free(x);
    return status;
}

// The node in the plate's column or row `along` of a side, `depth` rows inside; -1 beyond the side's end.
static int node_at_side(const pdmc_problem *problem, const pdmc_bond_grid *grid, pdmc_side side, int along, int depth)
{
    const double h = grid->spacing;
    const int first[2] = {(int)lround((-0.5 * problem->plate.width + 0.5 * h - grid->origin[0]) / h),
                          (int)lround((-0.5 * problem->plate.height + 0.5 * h - grid->origin[1]) / h)};
    const int count[2] = {(int)lround(problem->plate.width / h), (int)lround(problem->plate.height / h)};
    const int across = side == PDMC_SIDE_LEFT || side == PDMC_SIDE_RIGHT ? 0 : 1;
    const bool is_far = side == PDMC_SIDE_RIGHT || side == PDMC_SIDE_TOP;
    int at[2];
    if (along >= count[1 - across]) return -1;
    at[across] = is_far ? count[across] - 1 - depth : depth;
    at[1 - across] = along;
    return (first[1] + at[1]) * grid->columns + first[0] + at[0];
}

// The traction of a case as a body force in the layer of nodes next to its side: sigma h / rows on every node.
static void add_load(pdmc_bond *bond, int index, pdmc_side side)
{
    const pdmc_bond_grid *grid = &bond->plate.grid;
    const int rows = (int)lround(bond->problem->solver.load_layer / grid->spacing);
    double *load = &bond->load[(size_t)index * (size_t)bond->unknowns];
    for (int depth = 0; depth < rows; depth++) {
        int node;
        for (int along = 0; (node = node_at_side(bond->problem, grid, side, along, depth)) >= 0; along++) {
            double x[2], traction[2];
            pdmc_bond_grid_node(grid, node, x);
            pdmc_load_traction(&bond->loads, index, side, x, traction);
            for (int k = 0; k < 2; k++)
                if (!(grid->held[node] & (1U << k))) load[2 * node + k] += traction[k] * grid->spacing / rows;
        }
    }
}

static bool is_at_edge(const pdmc_bond_grid *grid, int node)
{
    const int column = node % grid->columns, row = node / grid->columns;
    return column == 0 || column == grid->columns - 1 || row == 0 || row == grid->rows - 1;
}

// Their mean over the nodes at the edges becomes zero.
static pdmc_status take_out_rigid_motions(const pdmc_bond *bond, double x[])
{
    const pdmc_bond_grid *grid = &bond->plate.grid;
    pdmc_status status = PDMC_OK;
    double *node = NULL;
    uint8_t *at_edge = NULL;
    PDMC_TRY(pdmc_bond_grid_nodes(grid, &node));
    PDMC_NEW(at_edge, grid->nodes);
    for (int k = 0; k < grid->nodes; k++) at_edge[k] = is_at_edge(grid, k);
    PDMC_TRY(pdmc_rigid_take_out(bond->problem, grid->nodes, node, at_edge, x));
done:
    pdmc_free(node);
    pdmc_free(at_edge);
    return status;
}

static pdmc_status factor_mean(pdmc_bond *bond)
{
    pdmc_status status = PDMC_OK;
    const int shells = bond->plate.horizon.shells;
    const double start = pdmc_seconds();
    pdmc_sparse_matrix matrix = {0};
    double *factor = NULL;
    int64_t *order = NULL;
    PDMC_NEW(factor, shells);
    PDMC_NEW(order, bond->unknowns);
    for (int s = 0; s < shells; s++) factor[s] = 1.0;
    PDMC_TRY(pdmc_bond_matrix_create(&bond->plate, &(pdmc_bond_moduli){.shell = factor}, &matrix));
    const double assembled = pdmc_seconds();
    pdmc_bond_dissection(&bond->plate, order);
    PDMC_TRY(pdmc_sparse_factor_create(&matrix, NULL, order, &bond->factor));
    bond->assembly_seconds += assembled - start;
    bond->factorisation_seconds = pdmc_seconds() - assembled;
done:
    pdmc_sparse_matrix_clear(&matrix);
    pdmc_free(factor);
    pdmc_free(order);
    return status;
}

pdmc_status pdmc_bond_product(const pdmc_bond *bond, const pdmc_bond_moduli *moduli, const double x[], double y[])
{
    pdmc_status status = PDMC_OK;
    const int n = bond->unknowns, shells = bond->plate.horizon.shells;
    const double one[PDMC_BLOCK] = {1.0};
    double *block = NULL, *product = NULL, *factors = NULL;
    PDMC_NEW(block, (size_t)PDMC_BLOCK * (size_t)n);
    PDMC_NEW(product, (size_t)PDMC_BLOCK * (size_t)n);
    PDMC_NEW(factors, PDMC_BLOCK * shells);
    memcpy(block, x, (size_t)n * sizeof *x);
    memcpy(factors, moduli->shell, (size_t)shells * sizeof *factors);
    PDMC_TRY(pdmc_bond_multiply(&bond->plate, bond->threads, factors, block, product));
    memcpy(y, product, (size_t)n * sizeof *y);
    if (moduli->node)
        PDMC_TRY(pdmc_bond_nodal_multiply(&bond->plate, bond->threads, 1, moduli->node, 0.0, 1, one, block, product));
    if (moduli->node) cblas_daxpy(n, 1.0, product, 1, y, 1);
done:
    pdmc_free(block);
    pdmc_free(product);
    pdmc_free(factors);
    return status;
}

pdmc_status pdmc_bond_solve(const pdmc_bond *bond, const pdmc_sparse_factor *factor, const pdmc_bond_moduli *moduli,
                            const double scale[], double x[])
{
    pdmc_status status = PDMC_OK;
    const int n = bond->unknowns;
    double *force = NULL; // that the prescribed displacements put on the free unknowns
    PDMC_NEW(force, n);
    PDMC_TRY(pdmc_bond_product(bond, moduli, bond->plate.grid.prescribed, force));
    for (int k = 0; k < n; k++)
        x[k] = scale[0] * (bond->plate.grid.prescribed[k] - force[k]) + scale[1] * bond->load[k];
    for (int l = 1; l < bond->loads.count; l++)
        cblas_daxpy(n, scale[1 + l], &bond->load[(size_t)l * (size_t)n], 1, x, 1);
    PDMC_TRY(pdmc_sparse_factor_solve(factor, 1, x, x));
done:
    pdmc_free(force);
    return status;
}

static pdmc_status solve_mean(pdmc_bond *bond)
{
    pdmc_status status = PDMC_OK;
    const int n = bond->unknowns, shells = bond->plate.horizon.shells;
    const size_t cases = (size_t)bond->loads.count;
    double *factor = NULL, *force = NULL, *held = NULL;
    PDMC_NEW(factor, shells);
    PDMC_NEW(force, n);
    PDMC_NEW(held, 1 + cases);
    PDMC_NEW(bond->mean, n);
    PDMC_NEW(bond->solution, (1 + cases) * (size_t)n);
    const pdmc_bond_moduli moduli = {.shell = factor};
    for (int s = 0; s < shells; s++) factor[s] = 1.0;
    held[0] = 1.0;
    PDMC_TRY(pdmc_bond_solve(bond, bond->factor, &moduli, held, bond->solution));
    for (size_t l = 0; l < cases; l++)
        PDMC_TRY(pdmc_sparse_factor_solve(bond->factor, 1, &bond->load[l * (size_t)n], &bond->solution[(1 + l) * (size_t)n]));
    for (size_t l = 0; l < 2; l++) cblas_daxpy(n, 1.0, &bond->solution[l * (size_t)n], 1, bond->mean, 1);
    PDMC_TRY(take_out_rigid_motions(bond, bond->mean));
    PDMC_TRY(pdmc_bond_product(bond, &moduli, bond->mean, force));
    for (int k = 0; k < n; k++)
        bond->residual = fmax(bond->residual, fabs(force[k] - bond->load[k]) / bond->plate.grid.spacing);
done:
    pdmc_free(factor);
    pdmc_free(force);
    pdmc_free(held);
    return status;
}

static pdmc_status make_plate(pdmc_bond *bond)
{
    pdmc_status status = PDMC_OK;
    const pdmc_problem *problem = bond->problem;
    const double start = pdmc_seconds();
    const pdmc_uncertainty *noise = pdmc_problem_uncertainty(problem, PDMC_QUANTITY_MICROMODULUS);
    pdmc_bond_plate *plate = &bond->plate;
    PDMC_TRY(pdmc_bond_horizon_create(problem, noise ? noise->bins : 1, &plate->horizon));
    PDMC_TRY(pdmc_bond_grid_create(problem, &plate->grid));
    PDMC_TRY(hold_rigid_motions(problem, plate));
    PDMC_TRY(pdmc_bond_families_create(problem, &plate->grid, &plate->horizon, &plate->families));
    bond->unknowns = 2 * plate->grid.nodes;
    PDMC_TRY(pdmc_load_cases_create(problem, &bond->loads));
    PDMC_NEW(bond->load, (size_t)bond->loads.count * (size_t)bond->unknowns);
    for (int l = 0; l < bond->loads.count; l++)
        for (int side = 0; side < PDMC_SIDES; side++) add_load(bond, l, (pdmc_side)side);
    bond->assembly_seconds = pdmc_seconds() - start;
done:
    return status;
}

pdmc_status pdmc_bond_create(const pdmc_problem *problem, int threads, pdmc_bond **bond)
{
    PDMC_REQUIRE(threads >= 1, "%d threads: at least one is needed", threads);
    pdmc_status status = PDMC_OK;
    pdmc_bond *made = NULL;
    pdmc_blas_prepare();
    PDMC_TRY(pdmc_problem_check_equilibrium(problem));
    PDMC_NEW(made, 1);
    made->problem = problem;
    made->threads = threads;
    PDMC_TRY(make_plate(made));
    PDMC_TRY(factor_mean(made));
    PDMC_TRY(solve_mean(made));
    *bond = made;
    made = NULL;
done:
    pdmc_bond_destroy(&made);
    return status;
}

void pdmc_bond_destroy(pdmc_bond **bond)
{
    pdmc_bond *old = *bond;
    if (!old) return;
    pdmc_sparse_factor_destroy(&old->factor);
    pdmc_bond_families_clear(&old->plate.families);
    pdmc_bond_grid_clear(&old->plate.grid);
    pdmc_bond_horizon_clear(&old->plate.horizon);
    pdmc_load_cases_clear(&old->loads);
    pdmc_free(old->load);
    pdmc_free(old->solution);
    pdmc_free(old->mean);
    pdmc_free(old);
    *bond = NULL;
}
