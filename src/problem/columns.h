// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/base.h"

/// A file of numbers in columns.
typedef struct {
    int columns, count;
    double *number; // [count, columns]
    int *line;      // [count] of the file, from 1
} pdmc_columns;

/// Reads as many numbers a line as there are columns. What follows a # is a comment; empty lines do not count.
/// @param[in]  noun  what a line is, for messages: "node"
/// @param[in]  form  what it must be: "three numbers, x y volume"
/// @param[out] out   free with pdmc_columns_clear(); zero on failure
/// @return PDMC_OK; PDMC_ERR_NO_INPUT; PDMC_ERR_DATA with file, line and reason where a line has something else or a number
///         is not finite, or there is none; PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_columns_read(const char *path, int columns, const char *noun, const char *form,
                                             pdmc_columns *out);

/// Zeroed columns are allowed.
void pdmc_columns_clear(pdmc_columns *columns);
