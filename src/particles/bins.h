// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Points sorted into cubic bins, so that those near one another are found by looking into 27 of them.

#include "pdmc/particles.h"

typedef struct {
    int points, most; // most: bins
    double low[PDMC_AXES], width;
    int count[PDMC_AXES];
    int *bin;             // [points]
    int *start;           // [most + 1]
    int *sorted;          // [points] by bin, in the order of the points
    double *x[PDMC_AXES]; // [points] in that order
} pdmc_bins;

/// @param[out] bins  clear with pdmc_bins_clear(), whatever is returned
PDMC_NODISCARD pdmc_status pdmc_bins_create(int points, pdmc_bins *bins);
void pdmc_bins_clear(pdmc_bins *bins);

/// Where a point is: the bin at place[a] along every axis.
void pdmc_bins_place(const pdmc_bins *bins, const double x[PDMC_AXES], int place[PDMC_AXES]);

/// Points nearer than `width` are in bins that touch. Points far from the others share the outermost bins.
/// @param[in] x  [points] of every axis
void pdmc_bins_fill(pdmc_bins *bins, double *const x[PDMC_AXES], double width);

/// The bins that touch one, itself among them. @param[out] near  at most 27  @return how many
int pdmc_bins_near(const pdmc_bins *bins, int bin, int near[27]);
