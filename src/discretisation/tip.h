// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A tip as every method reports it, from its rows of K_I and K_II.

#include "pdmc/discretisation.h"

/// K_I and K_II of a tip as functionals of the unknowns.
/// @param[in]     tip           2 * crack for "from", 2 * crack + 1 for "to"
/// @param[in,out] row_1, row_2  [unknowns] added to
typedef pdmc_status pdmc_tip_rows(const void *method, int tip, double row_1[], double row_2[]);

/// Name, position and direction of a tip, with K_I and K_II of a solution; T is not known, NaN.
/// @param[in] solution  [unknowns]
/// @return PDMC_OK, PDMC_ERR_ARG where the plate has no such tip, PDMC_ERR_NOMEM, or the failure of rows()
PDMC_NODISCARD pdmc_status pdmc_tip_of(const pdmc_problem *problem, int tip, int unknowns, const double solution[],
                                       pdmc_tip_rows *rows, const void *method, pdmc_tip *out);

/// Half the length of the part of a crack that is inside the plate.
double pdmc_tip_half_length(const pdmc_problem *problem, int tip);
