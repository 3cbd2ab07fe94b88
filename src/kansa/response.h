// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kansa/kansa_impl.h"

/// The space in which the answers to every sample lie.
///
/// In coordinates y = R x the mean operator is Q, and the Neumann expansion of a sample is a combination of words
/// M_q1 M_q2 .. y_0, M_q = Q^T A_q R^-1. Each ring is nearly a multiple of the local operator, so that the words span few
/// directions: they are collected breadth first, each scaled by the size of its coefficients, until nothing larger
/// than rounding is new. The space also holds A_q^T times the mean residual, by which the least-squares solution of a
/// sample differs from the limit of its expansion.
typedef struct {
    int dimension;
    double *basis;        // [dimension, unknowns] orthonormal rows, in y
    double *coefficients; // [dimension, unknowns] R^-1 basis: unknowns of the collocation
    double *image;        // [terms, dimension, dimension] row j: basis^T M_q basis_j
} pdmc_response;

/// @param[in]  terms  number of rings with a random coefficient; 0 gives the span of the mean solutions
/// @param[in]  size   [terms] size of the coefficients that are to be expected
PDMC_NODISCARD pdmc_status pdmc_response_create(const pdmc_kansa *kansa, int terms, const double size[],
                                                pdmc_response *response);
void pdmc_response_clear(pdmc_response *response);
