// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/galerkin.h"

/// For each element those, itself included, whose discs about the middle that hold them come nearer than a reach: all
/// that a bond can lead to, and some more. Ascending.
typedef struct {
    int64_t *start; // [element_count + 1]
    int *element;   // [start[element_count]]
} pdmc_neighbours;

/// In time that grows with the elements and what is found. A reach of 0 finds the elements themselves alone.
/// @param[out] neighbours  free with pdmc_neighbours_clear(); zero on failure
PDMC_NODISCARD pdmc_status pdmc_neighbours_create(const pdmc_mesh *mesh, double reach, pdmc_neighbours *neighbours);
void pdmc_neighbours_clear(pdmc_neighbours *neighbours);
