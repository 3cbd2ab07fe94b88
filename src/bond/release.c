// SPDX-License-Identifier: GPL-3.0-or-later
#include "bond/release.h"

#include "bond/nodal.h"

#include <cblas.h>
#include <math.h>
#include <string.h>

// The problem with one tip moved straight on; its list of cracks is a copy.
static pdmc_status move_tip(const pdmc_problem *problem, int number, double distance, pdmc_problem *moved)
{
    pdmc_status status = PDMC_OK;
    pdmc_crack *cracks = NULL;
    PDMC_NEW(cracks, problem->crack_count);
    memcpy(cracks, problem->cracks, (size_t)problem->crack_count * sizeof *cracks);
    *moved = *problem;
    moved->cracks = cracks;
    moved->uncertainty_count = 0; // the means alone
    double *end = number % 2 ? cracks[number / 2].to : cracks[number / 2].from;
    const double *other = number % 2 ? cracks[number / 2].from : cracks[number / 2].to;
    const double along[2] = {end[0] - other[0], end[1] - other[1]}, length = hypot(along[0], along[1]);
    for (int k = 0; k < 2; k++) end[k] += distance * along[k] / length;
done:
    return status;
}

// Adds `sign` times the strain energy of every node, and tells the potential energy, which has that of the loads as well.
static pdmc_status add_energies(const pdmc_bond *bond, double sign, double energy[], double *potential)
{
    pdmc_status status = PDMC_OK;
    const int nodes = bond->plate.grid.nodes;
    double *twice = NULL;
    PDMC_NEW(twice, nodes);
    pdmc_bond_nodal_energy(&bond->plate, bond->mean, bond->mean, twice);
    *potential = 0.0; // of the solutions: a corner that stops rigid motions is unloaded, and the mean moves it
    for (int l = 0; l < 2; l++)
        *potential -= cblas_ddot(bond->unknowns, bond->load, 1, &bond->solution[l * bond->unknowns], 1);
    for (int node = 0; node < nodes; node++) *potential += 0.5 * twice[node];
    cblas_daxpy(nodes, 0.5 * sign, twice, 1, energy, 1);
done:
    pdmc_free(twice);
    return status;
}

static pdmc_status add_plate(const pdmc_bond *bond, int number, double side, double energy[], double *potential)
{
    pdmc_status status = PDMC_OK;
    pdmc_problem problem = {0};
    pdmc_bond *moved = NULL;
    PDMC_TRY(move_tip(bond->problem, number, side * bond->plate.grid.spacing, &problem));
    PDMC_TRY(pdmc_bond_create(&problem, bond->threads, &moved));
    PDMC_TRY(add_energies(moved, side, energy, potential));
done:
    pdmc_bond_destroy(&moved);
    pdmc_free(problem.cracks);
    return status;
}

pdmc_status pdmc_bond_release(const pdmc_bond *bond, int number, double sensitivity[])
{
    pdmc_status status = PDMC_OK;
    const int nodes = bond->plate.grid.nodes;
    double longer, shorter;
    memset(sensitivity, 0, (size_t)nodes * sizeof *sensitivity);
    PDMC_TRY(add_plate(bond, number, 1.0, sensitivity, &longer));
    PDMC_TRY(add_plate(bond, number, -1.0, sensitivity, &shorter));
    cblas_dscal(nodes, longer != shorter ? 1.0 / (longer - shorter) : 0.0, sensitivity, 1);
done:
    return status;
}

// The adjoint of ln (K_I^2 + K_II^2) by the rows of a tip, held unknowns 0.
static pdmc_status find_adjoint(const pdmc_bond *bond, const double row[], double adjoint[])
{
    const int n = bond->unknowns;
    const double K[2] = {cblas_ddot(n, row, 1, bond->mean, 1), cblas_ddot(n, row + n, 1, bond->mean, 1)};
    const double square = K[0] * K[0] + K[1] * K[1];
    for (int k = 0; k < 2 && square > 0.0; k++) cblas_daxpy(n, 2.0 * K[k] / square, row + k * n, 1, adjoint, 1);
    for (int k = 0; k < n; k++)
        if (bond->plate.grid.held[k / 2] & (1U << (k % 2))) adjoint[k] = 0.0;
    return pdmc_sparse_factor_solve(bond->factor, 1, adjoint, adjoint);
}

pdmc_status pdmc_bond_tip_weights(const pdmc_bond *bond, const double release[], const double row[], double weight[])
{
    pdmc_status status = PDMC_OK;
    const int nodes = bond->plate.grid.nodes;
    double *adjoint = NULL;
    PDMC_NEW(adjoint, bond->unknowns);
    PDMC_TRY(find_adjoint(bond, row, adjoint));
    pdmc_bond_nodal_energy(&bond->plate, adjoint, bond->mean, weight);
    cblas_daxpy(nodes, 1.0, release, 1, weight, 1);
done:
    pdmc_free(adjoint);
    return status;
}
