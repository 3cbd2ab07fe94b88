// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The meshfree bond method, static and linearised: Silling & Askari 2005 on a regular grid, bonds that cross a crack
/// removed. It solves the same problem as the collocation over visible nodes at the same horizon.

#include "bond/stiffness.h"
#include "pdmc/affine.h"
#include "pdmc/load_cases.h"
#include "pdmc/results.h"
#include "sparse/factor.h"

typedef struct {
    const pdmc_problem *problem;
    int threads, unknowns; // 2 nodes
    pdmc_bond_plate plate;
    pdmc_sparse_factor *factor; // of the mean operator
    pdmc_load_cases loads;
    double *load;     // [cases of the loads, unknowns] force / thickness of the tractions; 0 where held
    double *solution; // [1 + cases, unknowns] answers to the prescribed displacements, and to these
    double *mean;     // [unknowns] the sum of the first two, without rigid motions that nothing holds
    double residual;  // largest of the mean, force / length^2
    double assembly_seconds, factorisation_seconds;
} pdmc_bond;

/// Makes the grid, factors its mean operator, and solves for the problem's mean loads.
/// @param[in]  problem  kept by reference: it must outlive the model
/// @param[in]  threads  >= 1; the result does not depend on it
/// @param[out] bond     destroy with pdmc_bond_destroy()
/// @return PDMC_OK, PDMC_ERR_CONFIG (loads out of equilibrium), PDMC_ERR_SINGULAR, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status pdmc_bond_create(const pdmc_problem *problem, int threads, pdmc_bond **bond);

/// NULL is allowed; sets the pointer to NULL.
void pdmc_bond_destroy(pdmc_bond **bond);

/// y = K x of one vector, and of the prescribed displacements in it.
PDMC_NODISCARD pdmc_status pdmc_bond_product(const pdmc_bond *bond, const pdmc_bond_moduli *moduli, const double x[],
                                             double y[]);

/// Solves for scale[0] times the prescribed displacements and scale[1 + l] times case l of the loads.
/// @param[in]  factor  of the operator with these moduli
/// @param[out] x       [unknowns]
PDMC_NODISCARD pdmc_status pdmc_bond_solve(const pdmc_bond *bond, const pdmc_sparse_factor *factor,
                                           const pdmc_bond_moduli *moduli, const double scale[], double x[]);

/// The mean displacement at x: that of a node, or the polynomial of degree 2 that fits the nodes nearby that are seen
/// from `anchor`, a point close by on the side of a crack that is meant; elsewhere anchor = x.
/// @return PDMC_OK, PDMC_ERR_NOMEM, PDMC_ERR_SINGULAR where too few nodes are seen, or PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status pdmc_bond_displacement(const pdmc_bond *bond, const double x[2], const double anchor[2],
                                                  double u[2]);

/// Name, position and direction of a tip, with K_I and K_II by the interaction integral; T is NaN.
PDMC_NODISCARD pdmc_status pdmc_bond_tip(const pdmc_bond *bond, int tip, pdmc_tip *out);

/// K_I and K_II of a tip as functionals of the unknowns, by the interaction integral beyond the horizon, with the modulus
/// that the grid has: its stresses are those of the loads whatever its areas sum to.
/// @param[in,out] row_1, row_2  [unknowns] zero on entry
PDMC_NODISCARD pdmc_status pdmc_bond_stress_intensity_rows(const pdmc_bond *bond, int tip, double row_1[],
                                                           double row_2[]);

/// The radius of that circle round a tip, and the same functionals by another one.
double pdmc_bond_interaction_radius(const pdmc_problem *problem, int tip);
PDMC_NODISCARD pdmc_status pdmc_bond_interaction_rows(const pdmc_bond *bond, int tip, double radius, double row_1[],
                                                      double row_2[]);

/// A stiffness that varies in space, M = 1 + sum_k xi_k psi_k, at the nodes.
typedef struct {
    int terms;
    double *value;   // [nodes, terms] psi
    double *release; // [tips, nodes] of pdmc_bond_release(), of the tips of the problem's request
} pdmc_bond_stiffness;

/// The affine model of the problem's uncertain quantities: a term for each shell of bonds, xi_m the relative deviation
/// of its micromodulus, and those of a stiffness that varies in space. A bond has the sum of both deviations, its shell's
/// and the mean of its two nodes': the product of the two is of second order and left out, so that the model is affine.
/// The model's coordinates are the unknowns; its field is not set.
/// @param[in]  stiffness  NULL where it is the same everywhere; kept by reference
/// @param[out] model      clear it before the bond model
PDMC_NODISCARD pdmc_status pdmc_bond_affine(const pdmc_bond *bond, const pdmc_bond_stiffness *stiffness,
                                            pdmc_affine *model);
