// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/bond.h"
#include "bond/point.h"
#include "discretisation/interaction.h"
#include "discretisation/tip.h"

#include <cblas.h>
#include <gsl/gsl_math.h>
#include <math.h>
#include <string.h>

// The node at x, or -1.
static int node_at(const pdmc_bond_grid *grid, const double x[2])
{
    const double column = (x[0] - grid->origin[0]) / grid->spacing, row = (x[1] - grid->origin[1]) / grid->spacing;
    const double tolerance = 1e-9;
    if (fabs(column - round(column)) > tolerance || fabs(row - round(row)) > tolerance) return -1;
    if (round(column) < 0.0 || round(column) >= grid->columns || round(row) < 0.0 || round(row) >= grid->rows)
        return -1;
    return (int)lround(row) * grid->columns + (int)lround(column);
}

pdmc_status pdmc_bond_displacement(const pdmc_bond *bond, const double x[2], const double anchor[2], double u[2])
{
    const pdmc_bond_grid *grid = &bond->plate.grid;
    const int node = anchor[0] == x[0] && anchor[1] == x[1] ? node_at(grid, x) : -1;
    if (node >= 0) {
        memcpy(u, &bond->mean[2 * node], 2 * sizeof *u);
        return PDMC_OK;
    }
    pdmc_bond_point point;
    const pdmc_status status = pdmc_bond_point_at(bond->problem, grid, x, anchor, &point);
    u[0] = u[1] = 0.0;
    for (int k = 0; status == PDMC_OK && k < point.count; k++)
        for (int i = 0; i < 2; i++) u[i] += point.value[k] * bond->mean[2 * point.node[k] + i];
    return status;
}

static pdmc_status gradient_at(const void *method, const double x[2], int *count, int node[], double by_x[],
                               double by_y[])
{
    const pdmc_bond *bond = method;
    pdmc_bond_point point;
    const pdmc_status status = pdmc_bond_point_at(bond->problem, &bond->plate.grid, x, x, &point);
    if (status != PDMC_OK) return status;
    *count = point.count;
    memcpy(node, point.node, (size_t)point.count * sizeof *node);
    memcpy(by_x, point.by_x, (size_t)point.count * sizeof *by_x);
    memcpy(by_y, point.by_y, (size_t)point.count * sizeof *by_y);
    return PDMC_OK;
}

// The modulus of the grid over that of the material: energies of an isotropic stretch. Averaged over the directions of the
// grid it is the ratio of all stiffnesses.
static double modulus_of_grid(const pdmc_bond *bond)
{
    const pdmc_bond_horizon *horizon = &bond->plate.horizon;
    const double delta = bond->problem->solver.horizon, c = pdmc_micromodulus(&bond->problem->material, delta);
    double sum = 0.0;
    for (int k = 0; k < horizon->count; k++)
        sum += horizon->neighbour[k].stiffness * gsl_pow_2(horizon->neighbour[k].length);
    return sum / (2.0 * M_PI / 3.0 * c * gsl_pow_3(delta));
}

pdmc_status pdmc_bond_interaction_rows(const pdmc_bond *bond, int tip, double radius, double row_1[], double row_2[])
{
    const pdmc_gradient_functional functional = {PDMC_BOND_POINT_NODES, bond, gradient_at};
    const pdmc_status status = pdmc_interaction_rows(bond->problem, tip, radius, &functional, row_1, row_2);
    cblas_dscal(bond->unknowns, modulus_of_grid(bond), row_1, 1);
    cblas_dscal(bond->unknowns, modulus_of_grid(bond), row_2, 1);
    return status;
}

// Beyond two horizons the field is that of local elasticity, and the half length is where the contour has most room.
double pdmc_bond_interaction_radius(const pdmc_problem *problem, int tip)
{
    return pdmc_interaction_radius(problem, tip,
                                   fmax(pdmc_tip_half_length(problem, tip), 2.0 * problem->solver.horizon));
}

pdmc_status pdmc_bond_stress_intensity_rows(const pdmc_bond *bond, int tip, double row_1[], double row_2[])
{
    return pdmc_bond_interaction_rows(bond, tip, pdmc_bond_interaction_radius(bond->problem, tip), row_1, row_2);
}

static pdmc_status tip_rows(const void *method, int tip, double row_1[], double row_2[])
{
    return pdmc_bond_stress_intensity_rows(method, tip, row_1, row_2);
}

pdmc_status pdmc_bond_tip(const pdmc_bond *bond, int tip, pdmc_tip *out)
{
    return pdmc_tip_of(bond->problem, tip, bond->unknowns, bond->mean, tip_rows, bond, out);
}
