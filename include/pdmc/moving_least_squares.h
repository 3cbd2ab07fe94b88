// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Moving least squares: displacements between nodes from those of the nodes round about (K. Yu, Enhanced integration
/// methods for the peridynamic theory, Kansas State University (2011), section 3.3.2). u(x) ~ sum phi_i(x) u_i, where
/// phi_i comes from the quadratic polynomial that fits the nodes' values best with the weights of a quartic spline, w =
/// 1 - 6 d^2 + 8 d^3 - 3 d^4, d = |x - x_i| / support < 1. Quadratic fields are reproduced. Pure functions.

#include "pdmc/base.h"

typedef struct {
    int dimension;          // 2 or 3
    double support;         // radius, length; three spacings of a grid are a good choice
    double condition_limit; // of the moment matrix in either norm, above which a point is refused
} pdmc_moving_least_squares;

/// With a limit of 1e8 (section 3.3.2).
PDMC_API pdmc_moving_least_squares pdmc_moving_least_squares_default(int dimension, double support);

/// How good shape functions are. The moment matrix is that of powers of (x_i - x) / support, whose condition does not
/// change with position or unit.
typedef struct {
    double condition[2];   // of the moment matrix, in the row sum norm and in Frobenius'
    double consistency[3]; // largest error of a constant, of linear and of quadratic polynomials (eq. 3.42-3.44)
} pdmc_shape_quality;

/// Shape functions at one point, such as one that stands for all those of a regular grid.
/// @param[in]  node_count  any number
/// @param[in]  node        [node_count, 3] length; in two dimensions z is not read
/// @param[out] value       [node_count] phi_i, zero for nodes beyond the support
/// @param[out] quality     may be NULL
/// @return PDMC_OK; PDMC_ERR_SINGULAR, naming the nearest node, where the nodes do not determine a quadratic
/// polynomial, the condition is above the limit, or a polynomial is not reproduced to 1e-6; PDMC_ERR_ARG, or
/// PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_shape_functions_at(const pdmc_moving_least_squares *options,
                                                            const double point[3], int node_count, const double node[],
                                                            double value[], pdmc_shape_quality *quality);

/// Shape functions at many points.
typedef struct {
    int point_count;
    int64_t *first;           // [point_count + 1] of a point's nodes
    int *node;                // ascending for each point
    double *value;            // phi
    pdmc_shape_quality worst; // of all points
} pdmc_shape_functions;

/// @param[in]  node       [node_count, 3]
/// @param[in]  point      [point_count, 3]
/// @param[out] functions  free with pdmc_shape_functions_clear(); zero on failure
/// @return as pdmc_shape_functions_at()
PDMC_API PDMC_NODISCARD pdmc_status pdmc_shape_functions_create(const pdmc_moving_least_squares *options,
                                                                int node_count, const double node[], int point_count,
                                                                const double point[], pdmc_shape_functions *functions);

/// Zeroed ones are allowed.
PDMC_API void pdmc_shape_functions_clear(pdmc_shape_functions *functions);

/// A field with `components` values at each node, at all points.
/// @param[in]  at_nodes   [node_count, components]
/// @param[out] at_points  [point_count, components]
PDMC_API void pdmc_shape_functions_apply(const pdmc_shape_functions *functions, int components, const double at_nodes[],
                                         double at_points[]);
