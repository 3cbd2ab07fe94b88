// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Points within a distance, by bins of about one point each.

#include "mesh/mesh_impl.h"

typedef struct {
    int dimension;
    const double *x; // [points, dimension], which must outlive it
    double origin[PDMC_MESH_AXES], size;
    int count[PDMC_MESH_AXES]; // of bins
    int *start;                // [bins + 1] in `point`
    int *point;                // [points] bin by bin
    int *found;                // [points] by the last search, in a fixed order
} pdmc_vicinity;

/// @param[out] vicinity  free with pdmc_vicinity_clear(); zero on failure
PDMC_NODISCARD pdmc_status pdmc_vicinity_create(int dimension, int points, const double x[], pdmc_vicinity *vicinity);

/// Returns how many points are found.
int pdmc_vicinity_find(pdmc_vicinity *vicinity, const double middle[], double distance);

void pdmc_vicinity_clear(pdmc_vicinity *vicinity);
