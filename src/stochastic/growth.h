// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/limit_state.h"
#include "pdmc/stochastic.h"
#include "stochastic/block.h"

/// Growth of the crack as a limit state of the normal variables behind a study:
///     g = log of G / G_c, the largest of all tips, or of one, and of all directions,
/// by the problem's measure and inverse. A logarithm, since a product of powers of lognormal variables is then linear in z.
typedef struct {
    const pdmc_variables *variables;
    const pdmc_affine *model;        // that points are solved by
    const pdmc_affine *full;         // that points in doubt are solved by, where the model is a reduced one
    const pdmc_run_options *options; // progress is asked whether to go on
    pdmc_results *results;           // tips and angles
    pdmc_block **block;              // [threads]
    pdmc_block **full_block;         // [threads] or NULL
    pdmc_energy_forms *forms;        // of the model, or NULL
    int tip;                         // whose growth it is, or -1 for that of any
    long solved_in_full;
} pdmc_growth;

/// @param[out] growth  free with pdmc_growth_clear(), whatever is returned
PDMC_NODISCARD pdmc_status pdmc_growth_create(const pdmc_variables *variables, const pdmc_affine *model,
                                              const pdmc_affine *full, const pdmc_run_options *options,
                                              pdmc_results *results, pdmc_growth *growth);
void pdmc_growth_clear(pdmc_growth *growth);

/// The limit state; points whose reduced answer cannot be told from G_c are solved in full. PDMC_ERR_INTERRUPTED where
/// progress asks for a stop.
pdmc_limit_state pdmc_growth_limit(pdmc_growth *growth);
