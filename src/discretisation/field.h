// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/discretisation.h"
#include "pdmc/problem.h"

/// Fills a field from displacements at any point: those of the nodes, and of both faces of every crack at points that are
/// dense at its tips.
/// @param[in]  nodes    [count, 2] positions, copied
/// @param[in]  displacement, method  as the verb of a discretisation
/// @param[out] field    free its arrays with pdmc_free or by pdmc_results_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_NOMEM, or the failure of `displacement`
PDMC_NODISCARD pdmc_status pdmc_field_fill(const pdmc_problem *problem, int count, const double nodes[],
                                           pdmc_status (*displacement)(const void *method, const double x[2],
                                                                       const double anchor[2], double u[2]),
                                           const void *method, pdmc_displacement_field *field);
