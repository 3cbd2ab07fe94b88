// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The cracked plate of bonds by finite elements, static and linearised: linear triangles, bonds of the horizon that cracks
/// cut exactly where they do. It solves the same problem as the collocation over visible nodes and the grid of bonds.

#include "galerkin/plate_form.h"
#include "mesh/locate.h"
#include "pdmc/affine.h"
#include "pdmc/load_cases.h"
#include "pdmc/results.h"
#include "sparse/factor.h"

/// The elements round the nodes of a mesh.
typedef struct {
    int *start;   // [node_count + 1]
    int *element; // [start[node_count]] ascending
    int most;     // the largest number of one node
} pdmc_node_elements;

typedef struct {
    const pdmc_problem *problem;
    int threads, unknowns; // 2 values
    pdmc_mesh mesh;
    pdmc_space space;
    pdmc_mesh_locator locator;
    pdmc_node_elements around;
    pdmc_plate_form form;
    uint8_t *held;              // [values] bits: 1 where u is held, 2 where v is
    double *prescribed;         // [unknowns] length; 0 where free
    pdmc_sparse_factor *factor; // of the mean operator
    pdmc_load_cases loads;
    double *load;     // [cases of the loads, unknowns] force / thickness of the tractions; 0 where held
    double *solution; // [1 + cases, unknowns] answers to the prescribed displacements, and to these
    double *mean;     // [unknowns] the sum of the first two, without rigid motions that nothing holds
    double residual;  // largest of the mean, force / length^2
    double assembly_seconds, factorisation_seconds;
} pdmc_plate_elements;

/// Makes the mesh, factors the mean operator, and solves for the problem's mean loads.
/// @param[in]  problem  kept by reference: it must outlive the plate
/// @param[in]  threads  >= 1; the result does not depend on it
/// @param[out] plate    destroy with pdmc_plate_elements_destroy()
/// @return PDMC_OK, PDMC_ERR_CONFIG (loads out of equilibrium, a crack at an angle), PDMC_ERR_SINGULAR, PDMC_ERR_NOMEM, or
/// PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status pdmc_plate_elements_create(const pdmc_problem *problem, int threads,
                                                      pdmc_plate_elements **plate);

/// NULL is allowed; sets the pointer to NULL.
void pdmc_plate_elements_destroy(pdmc_plate_elements **plate);

/// Solves sum_p weight_p K_p x = scale[0] times the prescribed displacements and scale[1 + l] times case l of the loads.
/// @param[in]  factor  of the operator with these weights
/// @param[out] x       [unknowns]
PDMC_NODISCARD pdmc_status pdmc_plate_elements_solve(const pdmc_plate_elements *plate, const pdmc_sparse_factor *factor,
                                                     const double weight[], const double scale[], double x[]);

/// Fills plate->held and plate->prescribed from the supports (plate_support.c): the values of elements beyond a side that
/// holds them, at the mean of what two sides hold that meet.
PDMC_NODISCARD pdmc_status pdmc_plate_hold(pdmc_plate_elements *plate);

/// Fills plate->load (plate_load.c): tractions as forces in a layer inside the sides, integrated exactly.
PDMC_NODISCARD pdmc_status pdmc_plate_load(pdmc_plate_elements *plate);

/// The values and the weights by which they give the displacement at x; of the face of a crack, on the side of `anchor`.
typedef struct {
    int value[3];
    double weight[3];
} pdmc_plate_point;

pdmc_plate_point pdmc_plate_point_at(const pdmc_plate_elements *plate, const double x[2], const double anchor[2]);

/// The mean displacement at x.
void pdmc_plate_displacement(const pdmc_plate_elements *plate, const double x[2], const double anchor[2], double u[2]);

/// K_I and K_II of a tip as functionals of the unknowns, by the interaction integral; the gradient is that of the elements
/// averaged in the nodes and linear in between.
/// @param[in,out] row_1, row_2  [unknowns] added to
PDMC_NODISCARD pdmc_status pdmc_plate_intensity_rows(const pdmc_plate_elements *plate, int tip, double row_1[],
                                                     double row_2[]);

/// Name, position and direction of a tip, with K_I and K_II; T is NaN.
PDMC_NODISCARD pdmc_status pdmc_plate_tip(const pdmc_plate_elements *plate, int tip, pdmc_tip *out);

/// The affine model of the problem's uncertain quantities (plate_affine.c): a term for each bin of c(r), up to
/// PDMC_PLATE_PLANES, with its own exact stiffness; finer bins are averaged with the weight r^2 of the effective modulus. In
/// coordinates of the space in which the answers lie.
/// @param[out] model  clear it before the plate
PDMC_NODISCARD pdmc_status pdmc_plate_affine(const pdmc_plate_elements *plate, pdmc_affine *model);
