// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Elastic bodies of bonds at rest: a box of nodes on a cubic grid in three dimensions, with a choice of the rule for the
/// horizon's integral, compensation of what surfaces lack, prescribed displacements in layers, and tractions (Yu 2011,
/// chapters 3 and 4). Bonds are linear, f = c (xi o xi / |xi|^3) eta (eq. 4.66), and Poisson's ratio is 1/4.

#include "pdmc/base.h"
#include "pdmc/relaxation.h"

#include <stddef.h>

/// How a node's horizon is integrated.
typedef enum {
    PDMC_SOLID_CUBIC_CELL, // one point a cell, the node, with the volume factor of eq. 2.16
    PDMC_SOLID_GAUSS,      // Gauss points fixed in every cell, displaced by moving least squares (eq. 3.15)
} pdmc_solid_rule;

/// By what the micromodulus of a node whose horizon is cut by surfaces is multiplied, beta_s = W_inf / W_bdry of an
/// isotropic strain (eq. 3.61). A bond has the mean of its two nodes' factors, so that both feel one force.
typedef enum {
    PDMC_COMPENSATION_NONE,
    PDMC_COMPENSATION_SUM, // W_inf in closed form, W_bdry by the rule's own points: mends the rule within the body too
    PDMC_COMPENSATION_EXACT, // both in closed form, for faces, edges and corners
} pdmc_solid_compensation;

/// The faces of the box: below and above along the first, second and third direction.
enum { PDMC_SOLID_FACES = 6 };

/// Force per area on a face, t(x) = (1 + gradient . x) traction.
typedef struct {
    double traction[3];
    double gradient[3]; // 1 / length, along the face
} pdmc_solid_load;

/// The body is centred at the origin: node i of n stands at (i - (n - 1) / 2) spacing along each direction.
typedef struct {
    int nodes[3];
    double spacing, horizon;
    double youngs_modulus;
    pdmc_solid_rule rule;
    int gauss_points; // along each direction of a cell, 2 to 4; PDMC_SOLID_GAUSS only
    double support;   // radius of moving least squares; PDMC_SOLID_GAUSS only
    pdmc_solid_compensation compensation;
    int layers[PDMC_SOLID_FACES]; // layers of nodes at each face with the displacement of `strain`, u = strain x
    double strain[3][3];          // symmetric
    pdmc_solid_load load[PDMC_SOLID_FACES];
    int threads; // >= 1; no result depends on it
} pdmc_solid_options;

typedef struct pdmc_solid pdmc_solid;

/// Nodes are numbered with the first direction fastest; vectors are [3, nodes], one component after the other.
/// @param[out] solid  free with pdmc_solid_destroy(); NULL on failure
/// @return PDMC_OK, PDMC_ERR_ARG with the reason (a moment matrix of moving least squares with a condition past 1e8 names
///         its node), or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_solid_create(const pdmc_solid_options *options, pdmc_solid **solid);

/// NULL is allowed.
PDMC_API void pdmc_solid_destroy(pdmc_solid *solid);

PDMC_API size_t pdmc_solid_nodes(const pdmc_solid *solid);

/// Position of a node.
PDMC_API void pdmc_solid_position(const pdmc_solid *solid, size_t node, double x[3]);

/// beta_s of every node, [nodes]; owned by the body.
PDMC_API const double *pdmc_solid_compensation_factors(const pdmc_solid *solid);

/// The displacement of the strain at prescribed nodes and zero elsewhere.
/// @param[out] u  [3, nodes]
PDMC_API void pdmc_solid_start(const pdmc_solid *solid, double u[]);

/// Force density at every node, of its bonds and of the tractions.
/// @param[in]  u       [3, nodes]
/// @param[out] force   [3, nodes] force / length^3
/// @param[out] energy  [nodes] elastic energy density (eq. 3.52); NULL is allowed
PDMC_API void pdmc_solid_force(const pdmc_solid *solid, const double u[], double force[], double energy[]);

/// Force density of the tractions alone, int_S f_L dS (eq. 4.48), [3, nodes]; owned by the body.
PDMC_API const double *pdmc_solid_traction_force(const pdmc_solid *solid);

/// What a solution of equilibrium reached.
typedef struct {
    int iterations;
    double residual; // norm of the free nodes' forces over that at the start
} pdmc_solid_solution;

/// Equilibrium by conjugate gradients with the rows' diagonal; for PDMC_SOLID_GAUSS, whose matrix is not symmetric, by
/// corrections from the body of cubic cells.
/// @param[in]     tolerance  of the residual, > 0
/// @param[in,out] u          [3, nodes] start, for example of pdmc_solid_start(); result
/// @return PDMC_OK, PDMC_ERR_ARG (nothing holds the body, a bad tolerance), PDMC_ERR_SINGULAR (not reached; u is what was), or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_solid_rest(const pdmc_solid *solid, double tolerance, double u[],
                                                    pdmc_solid_solution *solution);

/// Motion towards rest with a damping force -c_v v (eq. 3.65, by central differences with the velocities in the middle of
/// steps, appendix A.2).
typedef struct {
    double density;
    double damping; // c_v, force time / length^4
    double safety;  // of the step, in (0, 1]: step = safety spacing / sqrt(K / density) (eq. 3.17, 3.18)
    int steps;
} pdmc_solid_motion;

/// The step of a motion, in time.
PDMC_API double pdmc_solid_step(const pdmc_solid *solid, const pdmc_solid_motion *motion);

/// @param[in,out] u        [3, nodes] start at rest, for example of pdmc_solid_start(); result
/// @param[out]    kinetic  [steps + 1] energy in the middle of the step before, 0 at the start
/// @param[out]    elastic  [steps + 1] energy
/// @return PDMC_OK, PDMC_ERR_ARG (a bad setting, or a damping at which the step is unstable), PDMC_ERR_SINGULAR (the
///         motion grows past all bounds: the step), or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_solid_move(const pdmc_solid *solid, const pdmc_solid_motion *motion,
                                                    double u[], double kinetic[], double elastic[]);

/// Equilibrium by dynamic relaxation, with fictitious masses by the rows' sums (eq. 4.59, 4.67, for a step of 1.1).
/// @param[in]     damping  constant, of a step of 1; negative for the adaptive one
/// @param[in,out] u        as of pdmc_solid_rest()
/// @return as pdmc_relax()
PDMC_API PDMC_NODISCARD pdmc_status pdmc_solid_relax(const pdmc_solid *solid, double tolerance, int max_steps,
                                                     double damping, double u[], pdmc_relaxation_state *state);

/// f_L of a unit micromodulus: the force that a line of points beyond a plane exerts on a point at depth h_0 below it,
/// under a uniform strain (eq. 4.6, with both points at their own depths),
///     int (xi o xi / |xi|^3) strain xi dxi_3 over xi_3 from h_0 to sqrt(horizon^2 - D^2), xi = (D_1, D_2, xi_3),
/// in closed form.
/// @param[in]  strain  [3, 3] symmetric, its third direction the plane's normal
/// @param[in]  across  [2] D, from the point to the line, along the plane
/// @param[out] force   [3] zero where the line is beyond the horizon
PDMC_API void pdmc_line_to_point_force(const double strain[3][3], double horizon, double depth, const double across[2],
                                       double force[3]);
