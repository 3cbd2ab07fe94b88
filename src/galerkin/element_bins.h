// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/galerkin.h"

/// Elements in square bins, by their middles.
typedef struct {
    double origin[2], size;
    int count[2];
    int *first; // [bins] of a chain of elements, or -1
    int *next;  // [elements]
    double (*middle)[2];
    double *radius;
} pdmc_element_bins;

/// Bins no smaller than what the middles of two elements can be apart that come nearer than `reach`.
/// @param[out] b  zero before; free with pdmc_element_bins_clear(), also after a failure
PDMC_NODISCARD pdmc_status pdmc_element_bins_create(const pdmc_mesh *mesh, double reach, pdmc_element_bins *b);
void pdmc_element_bins_clear(pdmc_element_bins *b);

/// The bin along an axis; of what lies beyond them, the last one there.
int pdmc_element_bin(const pdmc_element_bins *b, int axis, double x);
