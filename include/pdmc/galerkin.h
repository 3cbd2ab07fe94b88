// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Finite elements of the scalar peridynamic problem in one and two dimensions,
///     u_tt = L u + b,  (L u)(x) = int_{|xi| < delta} c(|xi|) (u(x + xi) - u(x)) dxi,
/// with the weak form (L u, v) = -1/2 int int c (u' - u) (v' - v). What is prescribed lies in a layer of elements as
/// wide as the horizon round the body. Lengths in any unit; L is 1 / length^2.

#include "pdmc/mesh.h"
#include "pdmc/quadrature.h"

// ---- the kernel ----

enum { PDMC_KERNEL_BINS = 64 };

/// c(r) = scale weight[i] r^-power in bin i of equal bins of [0, horizon], 0 beyond it. The scale is such that L is the
/// Laplacian for functions that vary slowly: int c xi^2 = 2 in one dimension, int c |xi|^2 = 4 in two. With power 1 and
/// one bin these are 2 / (delta^2 r) and 6 / (pi delta^3 r).
typedef struct {
    int dimension; // 1 or 2
    double horizon, power, scale;
    int bins;
    double weight[PDMC_KERNEL_BINS];
    double constant[PDMC_KERNEL_BINS + 1][3]; // of the integrals of c r^m over the radius, see src/galerkin/kernel.h
} pdmc_scalar_kernel;

/// @param[in]  power   0 <= power < 2, so that jumps have a finite energy
/// @param[in]  bins    1 to PDMC_KERNEL_BINS
/// @param[in]  weight  [bins] >= 0, not all zero; NULL for 1 throughout
/// @return PDMC_OK or PDMC_ERR_ARG
PDMC_API PDMC_NODISCARD pdmc_status pdmc_scalar_kernel_create(int dimension, double horizon, double power, int bins,
                                                              const double weight[], pdmc_scalar_kernel *kernel);

/// c(r) for r > 0.
PDMC_API double pdmc_scalar_kernel_at(const pdmc_scalar_kernel *kernel, double r);

/// lambda(k) = int c (1 - cos k.xi) dxi, so that L e^{ik.x} = -lambda e^{ik.x} and a wave has the frequency
/// sqrt(lambda); 1 / length^2, to a relative error of 1e-12.
/// @return PDMC_OK or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_scalar_dispersion(const pdmc_scalar_kernel *kernel, double wave_number,
                                                           double *lambda);

// ---- spaces ----

/// Piecewise linear functions: values in the corners of elements. The free ones are the first.
typedef struct {
    const pdmc_mesh *mesh; // must outlive the space
    int count, free_count;
    int *value; // [element_count, dimension + 1] number of the value in each corner
    double *x;  // [count, dimension] where each value is
} pdmc_space;

/// Continuous functions share the values in the nodes; where they touch the layer, these are prescribed. Discontinuous
/// ones have values of their own in each element. A mixed space is discontinuous in the rough elements: their
/// neighbours share no value with them.
/// @param[out] space  free with pdmc_space_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_ARG (nothing is free), or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_space_create(const pdmc_mesh *mesh, pdmc_space_kind kind, pdmc_space *space);

/// A zeroed space is allowed.
PDMC_API void pdmc_space_clear(pdmc_space *space);

// ---- forms ----

/// Where the outer integral is taken: exactly (in one dimension), in Gauss points inside the elements (exact to degree
/// 5), or in points on their edges: the ends and the middle of an interval, the middles of the edges of a triangle.
typedef enum { PDMC_OUTER_EXACT, PDMC_OUTER_GAUSS, PDMC_OUTER_EDGES } pdmc_outer_rule;

/// How the inner one is taken over an element: over its intersection with the disc, exactly for the kernel; there, by a
/// rule for polynomials; or over the whole element by Gauss points, with a kernel that is zero beyond the horizon.
typedef enum { PDMC_INNER_EXACT, PDMC_INNER_POLYNOMIAL, PDMC_INNER_CARELESS } pdmc_inner_rule;

typedef struct {
    pdmc_outer_rule outer;
    pdmc_inner_rule inner; // of no meaning where the outer integral is exact
    int parts;             // >= 1, of each side of an element, every one with the outer rule
} pdmc_form_rule;

/// A symmetric form (u, v): its columns for the free values, from the diagonal down, with the rows of the prescribed
/// values behind those of the free ones.
typedef struct {
    int free_count;
    int64_t *start; // [free_count + 1]
    int64_t *row;   // ascending in each column
    double *value;
} pdmc_form;

/// 1/2 int int c (u' - u) (v' - v), over all pairs of points of which one at least is not in the layer. The layer must
/// be as wide as the horizon.
/// @param[in]  threads  >= 1; the result does not depend on it
/// @param[out] form     free with pdmc_form_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_ARG (an exact outer integral in two dimensions; points on edges in one dimension with
/// power >= 1, whose inner integral is infinite), or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_form_peridynamic(const pdmc_space *space, const pdmc_scalar_kernel *kernel,
                                                          const pdmc_form_rule *rule, int threads, pdmc_form *form);

/// int u v, and int grad u . grad v element by element, over the body.
PDMC_API PDMC_NODISCARD pdmc_status pdmc_form_mass(const pdmc_space *space, pdmc_form *form);
PDMC_API PDMC_NODISCARD pdmc_status pdmc_form_gradient(const pdmc_space *space, pdmc_form *form);

/// A zeroed form is allowed.
PDMC_API void pdmc_form_clear(pdmc_form *form);

/// y = A x for the free rows.
/// @param[in]  x  [count] all values
/// @param[out] y  [free_count]
PDMC_API void pdmc_form_multiply(const pdmc_form *form, const double x[], double y[]);

/// A function of position.
typedef double pdmc_scalar_function(const void *context, const double x[]);

/// (b, v) over the body for every free v, with rules of degree 9.
/// @param[out] load  [free_count]
PDMC_API PDMC_NODISCARD pdmc_status pdmc_space_load(const pdmc_space *space, pdmc_scalar_function *b,
                                                    const void *context, double load[]);

/// Adds (b, v) of a constant force b in the part of the body with from <= x[axis] <= to, however that cuts the elements. With
/// b = D / delta in a layer of depth delta along a side it becomes the flux D of the classical problem as delta goes to 0.
/// @param[in,out] load  [free_count]
PDMC_API void pdmc_space_add_layer(const pdmc_space *space, int axis, double from, double to, double force,
                                   double load[]);

/// Adds the integral of a constant flux times v over the side of the body at x[axis] = place, where the mesh ends.
PDMC_API void pdmc_space_add_flux(const pdmc_space *space, int axis, double place, double flux, double load[]);

/// The root of the mean over the body of (u - f)^2; f = NULL for 0.
/// @param[in]  u      [count]
PDMC_API PDMC_NODISCARD pdmc_status pdmc_space_distance(const pdmc_space *space, const double u[],
                                                        pdmc_scalar_function *f, const void *context, double *distance);

/// Finds the element of a point, in a time that does not depend on how many there are.
typedef struct pdmc_locator pdmc_locator;

/// @param[in]  mesh     must outlive the locator
/// @param[out] locator  destroy with pdmc_locator_destroy()
PDMC_API PDMC_NODISCARD pdmc_status pdmc_locator_create(const pdmc_mesh *mesh, pdmc_locator **locator);

/// NULL is allowed; sets the pointer to NULL.
PDMC_API void pdmc_locator_destroy(pdmc_locator **locator);

/// u at a point of the mesh, on an edge that of one of its elements; NaN outside.
/// @param[in] u  [count] values of a space on the locator's mesh
PDMC_API double pdmc_locator_value(const pdmc_locator *locator, const pdmc_space *space, const double u[],
                                   const double x[]);

/// A u = load for the free values of u, by CHOLMOD.
/// @param[in]     load  [free_count]
/// @param[in,out] u     [count] prescribed values; gets the free ones
/// @return PDMC_OK, PDMC_ERR_SINGULAR (parts that nothing holds: points inside discontinuous elements do not see across
/// an edge), PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_API PDMC_NODISCARD pdmc_status pdmc_form_solve(const pdmc_form *form, const double load[], double u[]);

// ---- bonds with a law ----

/// g(s) of the stretch s = (u' - u) / r of a bond, whose force is c(r) r g(s); g(s) = s is the problem above. With the
/// stretch S of the law:
///     saturating  S tanh(s / S)           towards a force that no stretch exceeds
///     stiffening  s (1 + (s / S)^2)
///     softening   s exp(-(s / S)^2)       a bond that breaks smoothly: beyond S / sqrt(2) it gives way (as the cohesive
///                                         bonds of R. Lipton, J. Elasticity 117 (2014) 21-50)
typedef enum { PDMC_LAW_LINEAR, PDMC_LAW_SATURATING, PDMC_LAW_STIFFENING, PDMC_LAW_SOFTENING } pdmc_law_kind;
typedef struct {
    pdmc_law_kind kind;
    double stretch; // S > 0, of no meaning where the law is linear
} pdmc_bond_law;

/// g(s), g'(s), and the integral of g from 0 to s, to rounding of the largest that the law has.
typedef struct {
    double force, slope, energy;
} pdmc_law_value;
PDMC_API pdmc_law_value pdmc_law_at(const pdmc_bond_law *law, double stretch);

/// Points xi of half a horizon, with weights for the sum over g(s(xi)) + g(s(-xi)): Gauss points of the radius, with the
/// kernel's power in the first bin, and equally spaced directions. Exact to rounding where the function is analytic and no wave
/// of it is shorter than the horizon.
/// @param[out] points  free with pdmc_area_rule_clear(); zero on failure
/// @return PDMC_OK or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_horizon_points(const pdmc_scalar_kernel *kernel, pdmc_area_rule *points);

/// (L u)(x) = int c r g((u' - u) / r) dxi of any function u, by these points.
/// @param[in]  x  [2], the second 0 in one dimension, as for u
PDMC_API double pdmc_law_operator(const pdmc_area_rule *points, const pdmc_bond_law *law, pdmc_scalar_function *u,
                              const void *context, const double x[]);

/// The bonds of a space, all with one law; to be integrated many times.
typedef struct pdmc_law_bonds pdmc_law_bonds;

/// @param[in]  space, kernel  must outlive the bonds
/// @param[in]  rule           with an inner rule by points: polynomial or careless
/// @param[out] bonds          destroy with pdmc_law_bonds_destroy()
/// @return PDMC_OK, PDMC_ERR_ARG (also where a rule is exact), or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_law_bonds_create(const pdmc_space *space, const pdmc_scalar_kernel *kernel,
                                                      const pdmc_bond_law *law, const pdmc_form_rule *rule, int threads,
                                                      pdmc_law_bonds **bonds);

/// NULL is allowed; sets the pointer to NULL.
PDMC_API void pdmc_law_bonds_destroy(pdmc_law_bonds **bonds);

/// F(u) = 1/2 int int c r g (v' - v) for every free v, and the energy 1/2 int int c r^2 int g. F is what holds u: in balance
/// with a load b it is (b, v).
/// @param[in]  u       [count]
/// @param[out] force   [free_count]
/// @param[out] energy  of all bonds that do not lie in the layer
PDMC_API void pdmc_law_bonds_force(const pdmc_law_bonds *bonds, const double u[], double force[], double *energy);

/// The derivative of F, 1/2 int int c g' (w' - w) (v' - v): symmetric, and definite where all g' > 0.
/// @param[out] form  free with pdmc_form_clear(); zero on failure
PDMC_API PDMC_NODISCARD pdmc_status pdmc_law_bonds_tangent(const pdmc_law_bonds *bonds, const double u[], pdmc_form *form);

enum { PDMC_NEWTON_MOST = 40 };

/// How Newton's method went: norms of F(u) - load over that of linear bonds' forces at the start, of which the first is where
/// linear bonds would be at rest.
typedef struct {
    int iterations;
    int halvings; // of steps, in all
    double residual[PDMC_NEWTON_MOST + 1];
} pdmc_newton;

/// F(u) = load for the free values by Newton's method with CHOLMOD on the tangent, from where linear bonds would be at rest; a
/// step that does not lessen the residual is halved. To 1e-11 in the residual.
/// @param[in]     load    [free_count]
/// @param[in,out] u       [count] prescribed values; gets the free ones
/// @param[out]    newton  also on failure
/// @return PDMC_OK, PDMC_ERR_SINGULAR (the tangent is not positive definite: bonds give way or nothing holds the elements;
/// or no step lessens the residual), PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_API PDMC_NODISCARD pdmc_status pdmc_law_bonds_solve(const pdmc_law_bonds *bonds, const double load[], double u[],
                                                     pdmc_newton *newton);

// ---- motion ----

/// The largest eigenvalue of M^-1 A for the free values, by Lanczos' method.
/// @param[out] largest  1 / length^2, not above the true one
/// @param[out] error    an eigenvalue is as near as that; a bound of the largest one's error once the iteration has
///                      settled on it, 1e-8 of it unless 200 steps were too few
/// @return PDMC_OK, PDMC_ERR_SINGULAR, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_API PDMC_NODISCARD pdmc_status pdmc_form_largest_eigenvalue(const pdmc_form *form, const pdmc_form *mass,
                                                                 double *largest, double *error);

/// The longest stable step of central differences, 2 / sqrt(largest eigenvalue).
PDMC_API double pdmc_stable_step(double largest_eigenvalue);

/// M u_tt + A u = load by central differences from rest, with prescribed values that go with cos(frequency t).
/// @param[in]     count      all values
/// @param[in]     load       [free_count], or NULL for none
/// @param[in]     step       of time, in units of length since waves have speed 1
/// @param[in]     steps      >= 1
/// @param[in]     frequency  1 / length
/// @param[in,out] u          [count] at the start, and after the last step
/// @return PDMC_OK, PDMC_ERR_ARG, PDMC_ERR_SINGULAR, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_API PDMC_NODISCARD pdmc_status pdmc_form_march(const pdmc_form *form, const pdmc_form *mass, int count,
                                                    const double load[], double step, int steps, double frequency,
                                                    double u[]);

/// M u_tt + F(u) = load from rest by central differences, with prescribed values that do not move.
/// @param[in]     load   [free_count]
/// @param[in]     step   of time; stable below the stable step of the tangent, wherever the motion leads
/// @param[in,out] u      [count] at the start, and after the last step
/// @param[out]    drift  the largest change of the energy, kinetic and of bonds and load, over the largest kinetic one; it
///                       goes with the square of the step
/// @return PDMC_OK, PDMC_ERR_ARG, PDMC_ERR_SINGULAR, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_API PDMC_NODISCARD pdmc_status pdmc_law_bonds_march(const pdmc_law_bonds *bonds, const pdmc_form *mass,
                                                     const double load[], double step, int steps, double u[],
                                                     double *drift);
