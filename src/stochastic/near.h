// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/affine.h"

/// The unknowns near the tips, which the bonds of sparse crossings connect: few of all. Of a block they are kept sample by
/// sample in each row, so that one instruction stretches a bond of several samples.
typedef struct {
    int count;
    int *place;    // [unknowns, or observed displacements] among the near ones, or -1
    int *unknown;  // [count] its inverse
    double *value; // [count, PDMC_BLOCK]
} pdmc_near;

/// Numbers what sparse crossings look at, in the order in which they do.
/// @param[out] place  [unknowns, or observed displacements] -1 for those that none looks at
/// @return how many there are
int pdmc_near_number(const pdmc_affine *model, int place[]);

/// @param[out] near  clear with pdmc_near_clear(), whatever is returned
/// @return PDMC_OK or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_near_create(const pdmc_affine *model, pdmc_near *near);
void pdmc_near_clear(pdmc_near *near);

/// Takes the values of a block.
/// @param[in] width  of y, as many as `place` has
/// @param[in] y      [PDMC_BLOCK, width]
void pdmc_near_take(pdmc_near *near, int width, const double y[]);

/// The stretches of a crossing's bonds.
/// @param[out] stretch  [bonds, PDMC_BLOCK]
void pdmc_near_stretch(const pdmc_near *near, const pdmc_crossing *crossing, double stretch[]);
