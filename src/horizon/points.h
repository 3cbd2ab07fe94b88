// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A rule as it grows, cell by cell.

#include "pdmc/horizon.h"

typedef struct {
    pdmc_horizon_rule *rule;
    int cells, points; // that there is room for
} pdmc_points;

/// Adds a point to the cell that was begun last.
PDMC_NODISCARD pdmc_status pdmc_points_add(pdmc_points *points, const double position[3], double weight);

/// The adaptive rule's points of a cell that the horizon does not miss.
PDMC_NODISCARD pdmc_status pdmc_adapt(const pdmc_horizon_options *options, const pdmc_cell *cell, pdmc_points *points);
