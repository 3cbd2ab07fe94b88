// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/base_impl.h"

/// Area and first moments of the part of a square cell inside a disc about the origin, in closed form.
typedef struct {
    double area;      // length^2
    double moment[2]; // integrals of x and y, length^3
} pdmc_cell_part;

/// @param[in] middle  of the cell
/// @param[in] side    > 0
/// @param[in] radius  of the disc, >= 0
pdmc_cell_part pdmc_cell_in_disc(const double middle[2], double side, double radius);
