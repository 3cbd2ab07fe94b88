// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Functions of position that a study gives: a constant, a polynomial, or a table in a file.

#include "pdmc/base.h"

typedef enum { PDMC_GIVEN_CONSTANT, PDMC_GIVEN_POLYNOMIAL, PDMC_GIVEN_TABLE } pdmc_given_kind;

typedef struct {
    pdmc_given_kind kind;
    double value;          // of a constant
    int coefficient_count; // of a polynomial: of 1, x, x^2, ...; or of 1, x, y, x^2, x y, y^2, x^3, ...
    double *coefficients;
    char *file;          // of a table
    int columns, rows;   // of its grid; 1 row in one dimension
    double *x, *y;       // [columns], [rows] ascending
    double *table;       // [rows, columns]
} pdmc_given;

/// The value at a point: of a table linear, or bilinear, between its points; beyond them that of the nearest place in it.
PDMC_API double pdmc_given_at(const pdmc_given *given, int dimension, const double x[]);

/// Reads a table, a line a point in any order: `x value`, or `x y value` for every point of a grid of two or more columns and
/// rows. What follows a # is a comment.
/// @param[in,out] given  gets columns, rows, x, y and table
/// @return PDMC_OK; PDMC_ERR_NO_INPUT; PDMC_ERR_DATA with file, line and reason; PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_given_read(const char *path, int dimension, pdmc_given *given);

/// Frees what it owns and sets it to zero; a zeroed one is allowed.
PDMC_API void pdmc_given_clear(pdmc_given *given);
