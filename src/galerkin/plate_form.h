// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The form of bonds that pull along themselves, over a plate of unit thickness with a mesh that its cracks open:
///     1/2 int int c r^-3 (xi . (u' - u)) (xi . (v' - v)) dA' dA
/// over all pairs of points whose bond is no longer than the horizon and crosses no crack, in planes: one for each of equal
/// bins of the radius.

#include "pdmc/galerkin.h"
#include "pdmc/problem.h"
#include "sparse/matrix.h"

enum { PDMC_PLATE_PLANES = 16 };

/// The lower triangle by columns of values; each entry is a symmetric block xx, xy, yy in every plane. Unknowns 2 k and
/// 2 k + 1 are u and v of value k.
typedef struct {
    int count, planes; // of values
    int64_t *start;    // [count + 1]
    int64_t *row;      // ascending in each column, from the diagonal on
    double *value;     // [entries, planes, 3] force / length
} pdmc_plate_form;

/// The outer integral is by Gauss points in the elements, the inner one exact over what each point sees of the others.
/// @param[in]  space    on a mesh of no layer: all values are free
/// @param[in]  parts    of each side of an element, with Gauss points in every one
/// @param[in]  threads  >= 1; the result does not depend on it
/// @param[out] form     free with pdmc_plate_form_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_ARG, or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_plate_form_create(const pdmc_problem *problem, const pdmc_space *space, int parts,
                                                  int planes, int threads, pdmc_plate_form *form);

/// A zeroed form is allowed.
void pdmc_plate_form_clear(pdmc_plate_form *form);

/// y = sum_p weight_p K_p x.
/// @param[in]  weight  [planes]
/// @param[in]  x       [2 count]
/// @param[out] y       [2 count]
void pdmc_plate_form_multiply(const pdmc_plate_form *form, const double weight[], const double x[], double y[]);

/// sum_p weight_p K_p as a matrix for a factor; held unknowns have a 1 on the diagonal and nothing else.
/// @param[in]  held    [count] bits: 1 where u is held, 2 where v is
/// @param[out] matrix  free with pdmc_sparse_matrix_clear(); zero on failure
PDMC_NODISCARD pdmc_status pdmc_plate_form_matrix(const pdmc_plate_form *form, const double weight[],
                                                  const uint8_t held[], pdmc_sparse_matrix *matrix);
