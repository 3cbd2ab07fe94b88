// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Rules for integrals over the horizon of a node of a regular grid: a sphere in space, a disc in the plane. Positions
/// are relative to the node whose horizon it is; in two dimensions z is zero everywhere. Pure functions; the numbers of
/// equations are those of K. Yu, Enhanced integration methods for the peridynamic theory, Kansas State University
/// (2011).

#include "pdmc/base.h"

/// A box, lower[a] <= x[a] <= upper[a]; in two dimensions a rectangle, lower[2] = upper[2] = 0.
typedef struct {
    double lower[3], upper[3]; // length
} pdmc_cell;

/// The part of a cell that lies inside a sphere round the origin, or of a rectangle inside a circle, in closed form.
/// Volume by the divergence theorem from a corner, with the faces as polygons and circular segments, the part of the
/// sphere as spherical triangles and the slivers between great and small circles: the error is that of a radius which
/// is off by some units in the last place. First moments by int x_i dV = -1/2 int div((radius^2 - x^2) e_i) dV, which
/// has no part on the sphere.
/// @param[in]  dimension  2 or 3
/// @param[out] centroid   of that part, length; the middle of the cell where the volume is zero
/// @return the volume, length^dimension
PDMC_API double pdmc_cell_in_sphere(int dimension, const pdmc_cell *cell, double radius, double centroid[3]);

/// What is added for each cell in which the horizon ends, and for each cell inside it.
typedef enum {
    PDMC_RULE_CUBIC, // the node, with a share of its volume that falls from 1 to 0 over the spacing round the horizon,
                     // eq. 2.15-2.16; nodes outside the horizon do not count
    PDMC_RULE_GAUSS, // Gauss points of the whole cell, each with such a share of its own volume, eq. 3.11-3.14
    PDMC_RULE_EXACT, // the centroid of the cell's part inside the horizon, with the volume of that part
    PDMC_RULE_ADAPTIVE, // iterated trapezoidal rules over that part, refined until they agree, section 2.4
} pdmc_horizon_kind;

/// A function of the position, with as many values as it was announced.
typedef void pdmc_integrand(void *context, const double position[3], double value[]);
enum { PDMC_MAX_INTEGRANDS = 16 };

/// How the adaptive rule refines. A direction of a piece of a cell has 2^(index - 1) intervals, or one point in the
/// middle where its index is 0; the indices are those from which one more in any direction changes the integral over
/// the piece by no more than `accuracy` times that over the cell, or `accuracy` cells where the latter is below
/// `threshold` cells. Integrals are counted in cells, spacing^dimension, so that no unit matters.
typedef struct {
    double accuracy;   // EPS
    double threshold;  // TOL
    int start, most;   // the smallest and the largest index
    bool extrapolates; // two successive trapezoidal rules to Simpson's, on the points of the finer
} pdmc_adaptive;

typedef struct {
    pdmc_horizon_kind kind;
    int dimension;          // 2 or 3
    double radius, spacing; // of the horizon, and of the nodes; length
    int gauss_points;       // a side of a cell, 1 to 4
    pdmc_adaptive adaptive;
    int integrand_count; // what the adaptive rule is to integrate; 0 for volume alone
    pdmc_integrand *integrand;
    void *context;
    double origin[3]; // where the centre of the horizon is relative to the node of cell (0, 0, 0)
    pdmc_cell within; // what there is of the body, relative to the centre of the horizon; infinite for all of it
} pdmc_horizon_options;

/// The whole horizon of a node, with EPS = 5e-4, TOL = 1e-4, indices from 0 to 8, extrapolation, and 2 Gauss points a
/// side.
PDMC_API pdmc_horizon_options pdmc_horizon_options_default(pdmc_horizon_kind kind, int dimension, double radius,
                                                           double spacing);

/// Points and weights, int f dV ~ sum weight f(position), by cells of the grid.
typedef struct {
    int cell_count;
    int *cell;  // [cell_count, 3] steps from the node of cell (0, 0, 0); z fastest
    int *first; // [cell_count + 1] of the cell's points
    int point_count;
    double *position; // [point_count, 3] relative to the centre of the horizon, length
    double *weight;   // [point_count] length^dimension
} pdmc_horizon_rule;

/// Cells that get no point are not listed. A cell that the body's edge cuts counts with the part inside; of the rules
/// by whole cells, with the share of its extent that is inside, at points that are not moved.
/// @param[out] rule  free with pdmc_horizon_rule_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_ARG, or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_horizon_rule_create(const pdmc_horizon_options *options,
                                                             pdmc_horizon_rule *rule);

/// A zeroed rule is allowed.
PDMC_API void pdmc_horizon_rule_clear(pdmc_horizon_rule *rule);

/// The sum of the weights, compensated.
PDMC_API double pdmc_horizon_rule_volume(const pdmc_horizon_rule *rule);

/// Average distance between integration points, (volume / points)^(1 / dimension), eq. 2.52.
PDMC_API double pdmc_horizon_rule_distance(const pdmc_horizon_rule *rule, int dimension, double volume);

/// How the micromodulus falls with the length r of a bond, over its value at r = 0: not at all, as a cone 1 - r /
/// radius, or as a bell (1 - r^2 / radius^2)^2.
typedef enum { PDMC_PROFILE_CONSTANT, PDMC_PROFILE_CONE, PDMC_PROFILE_BELL } pdmc_profile;

/// c(r) over the micromodulus of the constant profile that has the same elastic moduli: the integral of c(r)
/// r^dimension over [0, radius] is the same, which is the strain energy of an isotropic stretch (eq. 3.51-3.58). Zero
/// beyond the horizon.
PDMC_API double pdmc_profile_at(pdmc_profile profile, int dimension, double radius, double r);

/// A field of displacements.
typedef void pdmc_displacement(void *context, const double position[3], double displacement[3]);

/// Bonds of a microelastic material. With xi the difference of the positions of a bond's ends, r its length, and eta
/// that of their displacements, the force on a unit of volume squared is f = c(r) s (xi + eta) / |xi + eta|, s = (|xi +
/// eta| - r) / r (eq. 2.5 and 2.7); or, linear, f = c(r) xi (xi . eta) / r^3 (eq. 4.66).
typedef struct {
    double
        micromodulus; // c of the constant profile: force / length^6; in two dimensions per unit thickness, force / length^5
    pdmc_profile profile;
    bool is_linear;
    pdmc_displacement *displacement;
    void *context;
} pdmc_bonded_body;

/// What a stress was computed from.
typedef struct {
    int half_points; // in the half of the horizon beyond the plane through the node, as in eq. 2.56
    double points;   // in all halves and for all planes
} pdmc_stress_effort;

/// The areal force density at a node (eq. 2.12): the force of what lies beyond the plane x[axis] = node[axis], on the
/// side of positive x[axis], on the line of points behind the node, over an area. The integral over the half of the
/// horizon beyond the plane is that of the rule; that over the line has the points that the rule has along an axis:
/// nodes with shares of the line, Gauss points, the middles of spacings, or trapezoidal points that are refined. Where
/// a body has edges, options->within says where, relative to the node.
/// @param[in]  options  its origin, integrands and context are not read
/// @param[in]  node     of the grid
/// @param[out] density  force / length^(dimension - 1)
/// @param[in,out] effort  added to; may be NULL
/// @return PDMC_OK, PDMC_ERR_ARG, or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_areal_force_density(const pdmc_horizon_options *options,
                                                             const pdmc_bonded_body *body, const double node[3],
                                                             int axis, double density[3], pdmc_stress_effort *effort);

/// The stress (Piola and Kirchhoff's first) at a node, whose columns are the areal force densities along the axes (eq.
/// 2.13).
/// @param[out] stress  [3, 3] row-major, force / length^2; zero out of the plane in two dimensions
/// @param[out] effort  may be NULL
/// @return as pdmc_areal_force_density()
PDMC_API PDMC_NODISCARD pdmc_status pdmc_horizon_stress(const pdmc_horizon_options *options,
                                                        const pdmc_bonded_body *body, const double node[3],
                                                        double stress[9], pdmc_stress_effort *effort);
