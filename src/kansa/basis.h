// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The trial functions of the analytic crack model:
///     u = sum_k a_k g_k + sum_j alpha_j q_j + sum_l p_l Re U_l,   v = sum_k d_k g_k + sum_j beta_j q_j + sum_l p_l Im
/// U_l. g_k: inverse multiquadrics (Evangelatos & Spanos 2011, eq. 25, times psi), q_j: monomials, U_l: crack fields.
/// The scalars g and q serve both components; the unknowns are ordered [a, alpha | d, beta | p].
/// The fields U_l are those of a uniform material. Where the stiffness varies there are moments too, x / a times the first of
/// these in the crack's frame, which next to a tip hold what a gradient of the stiffness asks for, r^(3/2). (y / a times them
/// lies in the span of these and of the neighbouring orders.)

#include "pdmc/problem.h"

/// A straight crack in its own frame: z = x + i y from its middle, x along from -> to.
typedef struct {
    double centre[2], half_length, cosine, sine;
} pdmc_crack_frame;

typedef struct {
    int node_count;
    double *node_x, *node_y; // [node_count] centres of the multiquadrics
    double shape;            // psi
    int degree;              // of the monomials (x / scale)^i (y / scale)^j, i + j <= degree
    double scale;
    int crack_count, orders; // each crack has 4 fields an order
    int moments;             // orders whose fields are multiplied by x / a as well, <= PDMC_MOST_MOMENTS
    pdmc_crack_frame *cracks;
    double shear_modulus; // mu; a bond-based material has lambda = mu and kappa = 2 in both plane assumptions
    int monomials, scalars, fields, unknowns;
} pdmc_basis;

enum { PDMC_MOST_MOMENTS = 4 };

/// Values of the basis at a point, or of its derivative in one direction.
typedef struct {
    double *scalar; // [scalars] g, q
    double *u, *v;  // [fields] Re U, Im U
} pdmc_basis_values;

/// Completes a basis whose nodes, shape, degree, scale, orders and shear modulus are set; copies the cracks' geometry.
PDMC_NODISCARD pdmc_status pdmc_basis_complete(pdmc_basis *basis, int crack_count, const pdmc_crack cracks[]);
void pdmc_basis_clear(pdmc_basis *basis);

/// The first of an order's moments of a crack among the fields: x / a times each of the order's fields, in their order.
int pdmc_basis_moment(const pdmc_basis *basis, int crack, int order);

PDMC_NODISCARD pdmc_status pdmc_basis_values_create(const pdmc_basis *basis, pdmc_basis_values *values);
void pdmc_basis_values_clear(pdmc_basis_values *values);

/// The basis at x. The crack fields have two sheets: they are continued analytically along the straight line from
/// `anchor`, whose own sheet is the one bounded by the cracks. With anchor = x a field jumps at its crack; with a fixed
/// anchor it is analytic in every disc about the anchor that holds no tip, as if the crack were not there.
void pdmc_basis_evaluate(const pdmc_basis *basis, const double x[2], const double anchor[2], pdmc_basis_values *values);

/// The derivatives of the basis by x and y; anchor as above.
void pdmc_basis_gradient(const pdmc_basis *basis, const double x[2], const double anchor[2], pdmc_basis_values *by_x,
                         pdmc_basis_values *by_y);
