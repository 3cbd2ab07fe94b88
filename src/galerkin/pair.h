// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "galerkin/element.h"
#include "galerkin/kernel.h"
#include "pdmc/quadrature.h"

/// What the pairs of points of two elements add to the form: to the products of values of the first with each other, of
/// the second, and of both. Bonds with a law have forces and an energy too.
typedef struct {
    double own[PDMC_CORNERS][PDMC_CORNERS];   // [first, first]
    double cross[PDMC_CORNERS][PDMC_CORNERS]; // [other, first]
    double far[PDMC_CORNERS][PDMC_CORNERS];   // [other, other]
    double force[2][PDMC_CORNERS];            // on the values of the first, and of the other
    double energy;
} pdmc_pair_block;

/// How pairs are integrated.
typedef struct {
    const pdmc_scalar_kernel *kernel;
    pdmc_form_rule rule;
    pdmc_element_rule outer, careless;
    pdmc_triangle_disc_rule polynomial;
    double x[2][10], w[2][10]; // Gauss rules of 6 and 10 points on [0, 1]
} pdmc_pair_rule;

/// @param[out] out  free with pdmc_pair_rule_clear(); zero on failure
PDMC_NODISCARD pdmc_status pdmc_pair_rule_create(const pdmc_scalar_kernel *kernel, const pdmc_form_rule *rule,
                                                 pdmc_pair_rule *out);
void pdmc_pair_rule_clear(pdmc_pair_rule *rule);

/// Whether a pair of different elements is integrated in both orders, each of which gives a part of it.
bool pdmc_pair_is_ordered(const pdmc_pair_rule *rule);

/// 1/2 int_element int_other c (u' - u) (v' - v), and the other order too where pairs are not ordered: then `other`
/// must lie to the right. Where both are the same element all is in `own`.
void pdmc_pair_integrate(const pdmc_pair_rule *rule, const pdmc_element *element, const pdmc_element *other, bool same,
                         pdmc_pair_block *block);

/// What the bonds between the values u of two elements with a law add, in the order from the first to the other; by
/// points (stretch.c). The form is the forces' derivative.
/// @param[in] u  of the first, and of the other
void pdmc_pair_stretch(const pdmc_pair_rule *rule, const pdmc_bond_law *law, const pdmc_element *element,
                       const pdmc_element *other, bool same, double u[2][PDMC_CORNERS], pdmc_pair_block *block);

/// Points from an outer one to another element and their weights: of the part within the horizon, by the rule for
/// polynomials, or of the whole element where the inner rule is careless.
/// @param[out] points  count and the arrays, which have room for PDMC_INNER_POINTS
enum { PDMC_INNER_POINTS = 256 };
void pdmc_pair_points(const pdmc_pair_rule *rule, const pdmc_element *other, const double x[2],
                      pdmc_area_rule *points);

/// Adds to the block what an outer point sees of another element: moments of the bonds' stiffness about it.
/// @param[in] near, far  barycentric coordinates of the outer point in its own element, and in the other
void pdmc_pair_add_moments(int corners, const pdmc_element *element, const pdmc_element *other, bool same,
                           const double near[], const double far[], const pdmc_moments *m, double weight,
                           pdmc_pair_block *block);

/// Whether an element lies beyond the horizon of a point.
bool pdmc_pair_is_beyond(const pdmc_pair_rule *rule, const pdmc_element *other, const double x[2]);

/// The unordered pair of two intervals, exactly (interval_pair.c).
void pdmc_interval_pair(const pdmc_pair_rule *rule, const pdmc_element *element, const pdmc_element *other, bool same,
                        pdmc_pair_block *block);
