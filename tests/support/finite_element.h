// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A second method for a plate whose modulus varies in space: finite elements of nine nodes on a mesh that is graded to the
/// tips of a straight crack along the x axis. Basis, points and integrals have nothing in common with the library; of its
/// code only the sparse Cholesky factor is used.

#include "pdmc/problem.h"

/// The material is the bond-based one, lambda = mu in the plane, times M(x). The plate is centred at the origin.
typedef struct {
    double width, height;
    double tip[2]; // x of the left and the right end of the crack, which lies on y = 0
    double youngs_modulus;
    pdmc_assumption assumption;
    double traction[4][2];                                     // on each pdmc_side; together without force and moment
    double (*modulus)(const void *context, const double x[2]); // M > 0, a factor on E; NULL for 1
    const void *context;
    int refinement; // elements from a tip to the end of its graded box, >= 2; FINITE_ELEMENT_FINE for 1e-4 in G
} finite_element_plate;

enum { FINITE_ELEMENT_FINE = 16 };

typedef struct {
    double energy_release_rate[2]; // [tip] G of growth straight ahead
    double stress_intensity[2][2]; // [tip, mode] in the tip's own frame: x ahead, y to the left of it
    double potential_energy;       // of a unit thickness
} finite_element_result;

typedef struct finite_element_solution finite_element_solution;

/// Displacements by the principle of virtual work; M is interpolated between nodes. The plate is held at its lower left
/// corner, and its lower right one in y.
/// @param[out] solution  destroy with finite_element_destroy()
/// @return PDMC_OK, PDMC_ERR_ARG, PDMC_ERR_SINGULAR, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status finite_element_solve(const finite_element_plate *plate, finite_element_solution **solution);

/// NULL is allowed; sets the pointer to NULL.
void finite_element_destroy(finite_element_solution **solution);

/// What the tips ask for, in one call; integrals over the largest domain.
PDMC_NODISCARD pdmc_status finite_element_evaluate(const finite_element_plate *plate, finite_element_result *result);

/// -1/2 of the work of the tractions; G is minus its derivative by the length of the crack.
double finite_element_potential_energy(const finite_element_solution *solution);

/// Half the side of the largest square round a tip that is graded and holds neither the other tip nor a side.
double finite_element_radius(const finite_element_solution *solution);

/// G by the domain integral over the square |x_i - tip_i| < radius,
///     J = int (sigma_ij u_j,1 - W delta_1i) q,i - W,1 q dA,   W,1 = 1/2 M,1 / M sigma : epsilon,
/// where W,1 is the derivative by x in M alone and q falls from 1 at the tip to 0 at the square's sides.
/// F. Z. Li, C. F. Shih, A. Needleman: Engineering Fracture Mechanics 21 (1985) 405-421; J. W. Eischen: International
/// Journal of Fracture 34 (1987) 3-22.
/// @param[in]  tip  0 left, 1 right
double finite_element_energy_release_rate(const finite_element_solution *solution, int tip, double radius);

/// K_I and K_II by the interaction integral over the same square with the tip's homogeneous field as second field: its
/// stresses, and the strains that these cause in M(x). Those have no displacements; what is missing is
/// int (1 - M_tip / M) sigma : epsilon_2,1 q dA with the homogeneous strains, so that M is not differentiated.
/// J. E. Dolbow, M. Gosz: International Journal of Solids and Structures 39 (2002) 2557-2574.
/// @param[out] K  [mode] of the tip's frame
void finite_element_stress_intensity(const finite_element_solution *solution, int tip, double radius, double K[2]);

/// u(x) inside the plate; on the crack, of its upper face.
void finite_element_displacement(const finite_element_solution *solution, const double x[2], double u[2]);
