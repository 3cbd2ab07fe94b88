// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/base_impl.h"

/// The operators of an affine model as seen from its mean: M_q = K_0^-1 K_q.
typedef struct {
    int unknowns, terms;
    const double *size; // [terms] size of the coefficients that are to be expected
    double norm;        // of the mean solution
    double tolerance;   // share of the norm below which a direction is left out
    /// out = M_term v, vector by vector.
    /// @param[in]  v    [count, unknowns]
    /// @param[out] out  [count, unknowns]
    pdmc_status (*apply)(void *context, int term, int count, const double v[], double out[]);
    void *context;
} pdmc_response_operator;

/// The space in which the answers to every sample lie.
///
/// The Neumann expansion of a sample is a combination of words M_q1 M_q2 .. x_0. The operators are nearly multiples of
/// one another, so that the words span few directions: they are collected breadth first, each scaled by the size of its
/// coefficients, until nothing larger than the tolerance is new. There the expansion has the numbers that it has in
/// full, to rounding, at a small part of the cost.
typedef struct {
    int dimension;
    double *basis; // [dimension, unknowns] orthonormal rows
    double *image; // [terms, dimension, dimension] row j: basis M_q basis_j
} pdmc_response;

/// @param[in]     starts  number of vectors that the space is to hold, the mean solutions among them
/// @param[in,out] start   [starts, unknowns] overwritten
/// @param[out]    response  free with pdmc_response_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_SINGULAR where the words span more directions than there is room for, PDMC_ERR_NOMEM, or the
/// failure of `apply`
PDMC_NODISCARD pdmc_status pdmc_response_create(const pdmc_response_operator *operator, int starts, double start[],
                                                pdmc_response *response);
void pdmc_response_clear(pdmc_response *response);

/// The products of a block with the images: y = sum_q xi_q basis M_q basis^T x, in the space's coordinates.
/// @param[in]  xi    [count, terms]
/// @param[in]  x     [count, dimension]
/// @param[out] y     [count, dimension]
PDMC_NODISCARD pdmc_status pdmc_response_perturb(const pdmc_response *response, int terms, int count, const double xi[],
                                                 const double x[], double y[]);
