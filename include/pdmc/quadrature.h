// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Quadrature over discs and balls. Pure functions, no state.

#include "pdmc/base.h"

/// Gauss-Legendre rule with n points on [lower, upper], exact for polynomials of degree <= 2 n - 1.
/// @param[in]  n  >= 1
/// @param[out] x  [n] ascending
/// @param[out] w  [n] summing to upper - lower
/// @return PDMC_OK, PDMC_ERR_ARG, or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_gauss_legendre(int n, double lower, double upper, double x[], double w[]);

enum { PDMC_MAX_RINGS = 32 };

/// A rule for integrals over the radius of a disc with a weight that is piecewise constant in it, such as a random
/// micromodulus.
///
/// An analytic field makes F(r), the integral of bond quantities over a ring, an even function of r with F(0) = 0. With
/// s = r^2, F(r) / s is interpolated by the polynomial of degree `rings` - 1 in s, and each bin of r integrates that
/// interpolant exactly:
///     int_bin r^(power - 2) F(r) dr  ~  sum_q weight[bin][q] F(radius[q]).
/// The radii are those of the Gauss-Jacobi rule of the weight r^power dr, so that a weight that is constant in r is
/// integrated exactly for F(r) / s of degree 2 rings - 1 in s. The sum over q of weight[bin][q] radius[q]^2 is
/// int_bin r^power dr whatever the number of rings.
typedef struct {
    int rings, bins;
    double radius[PDMC_MAX_RINGS]; // ascending, in (0, outer radius)
    double mean[PDMC_MAX_RINGS];   // sum over the bins of weight
    double *weight;                // [bins, rings]
} pdmc_ring_rule;

/// @param[in]  rings  1 <= rings <= PDMC_MAX_RINGS
/// @param[in]  bins   >= 1, equal bins of [0, radius]
/// @param[in]  power  >= 2: 2 for forces, 3 for the energy of bonds that cross a line
/// @param[out] rule   free with pdmc_ring_rule_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_ARG, or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_ring_rule_create(int rings, int bins, int power, double radius,
                                                          pdmc_ring_rule *rule);

/// A zeroed rule is allowed.
PDMC_API void pdmc_ring_rule_clear(pdmc_ring_rule *rule);

/// Points and weights of a rule over a region of the plane.
typedef struct {
    int count;
    double *x;      // [count, 2]
    double *weight; // [count] area
} pdmc_area_rule;

/// A rule over a rectangle, centred at the origin, that cracks cut: exact to rounding for smooth fields on either side
/// of them, and for those that go with the square root of the distance from a tip, or with its inverse, and their
/// squares.
///
/// The rectangle is split into convex cells by the lines of the cracks, with the tips as vertices; the cells into
/// triangles no longer than `size` nor than their distance from the nearest tip; each triangle carries a Gauss rule
/// collapsed at its first vertex, the tip if it has one, in the square root of the distance.
/// @param[in]  cracks   number of segments
/// @param[in]  segment  [cracks, 4] from x, y, to x, y; inside the rectangle, not touching one another
/// @param[out] rule     free with pdmc_area_rule_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_ARG, or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_area_rule_create(double width, double height, int cracks,
                                                          const double segment[], double size, pdmc_area_rule *rule);

/// A zeroed rule is allowed.
PDMC_API void pdmc_area_rule_clear(pdmc_area_rule *rule);

/// int |x| dV over the part of a ball about the origin that lies within a box whose faces are at distances `below` and
/// `above` along the three axes: one face, an edge, a corner, or several of them, in closed form. By the theorem of Gauss
/// the integral becomes those over the sphere's part in the box and over the discs that its faces cut from the ball. (For
/// the volume see pdmc/horizon.h.)
/// @param[in] radius  > 0
/// @param[in] below   [3] >= 0, INFINITY where there is no face
/// @param[in] above   [3] >= 0, the same
/// @return length^4
PDMC_API double pdmc_integrate_distance_in_box(double radius, const double below[3], const double above[3]);

/// How a circle meets a triangle.
typedef struct {
    int crossings[3]; // of the circle with the edges, most first
    int corners;      // inside the disc
    bool is_whole;    // the disc lies in the triangle; without crossings and corners it lies outside otherwise
} pdmc_triangle_disc_case;

/// @param[in] corner  [3, 2] in any order, as for the functions below
PDMC_API pdmc_triangle_disc_case pdmc_triangle_disc_classify(const double corner[6], const double centre[2],
                                                             double radius);

/// Area of the intersection of a triangle and a disc.
PDMC_API double pdmc_triangle_disc_area(const double corner[6], const double centre[2], double radius);

/// A rule over intersections of triangles and discs, exact to rounding for polynomials up to a degree: a triangle rule
/// over each triangle of the polygon between the ends of the arcs, and a rule over each segment between an arc and its
/// chord. Whole and half discs are segments too. All weights are positive.
enum { PDMC_TRIANGLE_DISC_DEGREE = 12, PDMC_TRIANGLE_DISC_LINE = 32 };
typedef struct {
    int degree;
    int capacity;                          // the most points that an intersection can need
    double *x, *w;                         // Gauss rules on [0, 1] of 1, 2, ... points, one after the other
    double reach[PDMC_TRIANGLE_DISC_LINE]; // degree + 2 times the longest half arc of which 1, 2, ... points suffice
} pdmc_triangle_disc_rule;

/// @param[in]  degree  0 to PDMC_TRIANGLE_DISC_DEGREE
/// @param[out] rule    free with pdmc_triangle_disc_rule_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_ARG, or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_triangle_disc_rule_create(int degree, pdmc_triangle_disc_rule *rule);

/// A zeroed rule is allowed.
PDMC_API void pdmc_triangle_disc_rule_clear(pdmc_triangle_disc_rule *rule);

/// The points of one intersection.
/// @param[out] points  count and the arrays, which the caller has made for `rule->capacity` points
PDMC_API void pdmc_triangle_disc_points(const pdmc_triangle_disc_rule *rule, const double corner[6],
                                        const double centre[2], double radius, pdmc_area_rule *points);
