// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/galerkin.h"

enum { PDMC_CORNERS = 3 }; // of an element at most

/// An interval or a triangle: barycentric coordinates are value[a](x) = value[a](0) + gradient[a].x.
typedef struct {
    double corner[PDMC_CORNERS][2]; // second coordinate 0 in one dimension
    double gradient[PDMC_CORNERS][2];
    double middle[2], size, radius; // length or area; of the corners about the middle
} pdmc_element;

pdmc_element pdmc_element_of(const pdmc_mesh *mesh, int element);

/// Barycentric coordinates of a point.
void pdmc_element_coordinates(const pdmc_element *element, int dimension, const double x[2],
                              double value[PDMC_CORNERS]);

/// Points of an element in barycentric coordinates, with weights that sum to 1.
typedef struct {
    int count;
    double *at;     // [count, PDMC_CORNERS]
    double *weight; // [count]
} pdmc_element_rule;

/// Gauss points, or points on the edges, in each of parts^dimension equal parts.
PDMC_NODISCARD pdmc_status pdmc_element_rule_outer(int dimension, const pdmc_form_rule *rule, pdmc_element_rule *out);
/// For smooth functions: 5 points in each direction, exact to degree 8.
PDMC_NODISCARD pdmc_status pdmc_element_rule_smooth(int dimension, pdmc_element_rule *out);
void pdmc_element_rule_clear(pdmc_element_rule *rule);

/// The point of a rule in an element.
void pdmc_element_point(const pdmc_element *element, int dimension, const double at[PDMC_CORNERS], double x[2]);
