// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/design.h"
#include "pdmc/load_cases.h"
#include "pdmc/random.h"
#include "stochastic/draw.h"

/// The independent standard normal variables z behind the random quantities of a study, in groups: the scalars first, then
/// the functions, so that the first variables are those that tend to matter most.
typedef struct {
    pdmc_quantity quantity;
    pdmc_stream stream; // of plain Monte Carlo
    int first, count;   // of its variables
} pdmc_variable_group;

/// The stream of a quantity in plain Monte Carlo.
pdmc_stream pdmc_quantity_stream(pdmc_quantity quantity);

typedef struct {
    const pdmc_problem *problem;
    const pdmc_affine *model;
    int count, group_count;
    pdmc_variable_group groups[PDMC_QUANTITIES];
    pdmc_quantity order[PDMC_SCALARS]; // of the scalars in the copula: a field comes last, the others as they are
    double copula[PDMC_SCALARS * PDMC_SCALARS]; // the factor of pdmc_copula_factor()
    double *toughness_factor;  // [tips, tips] of pdmc_toughness_factor(); NULL where there is none for all
    double *radial_factor;     // [bins, modes] of a radial process; NULL for noise
    pdmc_load_case *load_case; // [pdmc_load_case_count()]
    pdmc_design *design;       // NULL for plain Monte Carlo
} pdmc_variables;

/// The draws of a block, with the arrays that they point to.
typedef struct {
    pdmc_draw draw[PDMC_BLOCK];
    double *z;  // [PDMC_BLOCK, variables]
    double *xi; // [PDMC_BLOCK, terms]
    double *numbers;
} pdmc_draws;

/// @param[in]  problem, model  kept by reference
/// @param[out] out             free with pdmc_variables_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_NOMEM, PDMC_ERR_ARG, or PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status pdmc_variables_create(const pdmc_problem *problem, const pdmc_affine *model,
                                                 pdmc_variables *out);
void pdmc_variables_clear(pdmc_variables *variables);

/// The group of a quantity, or NULL where it is certain.
const pdmc_variable_group *pdmc_variables_group(const pdmc_variables *variables, pdmc_quantity quantity);

/// The distribution of a positive load that depends on no other quantity and alone moves the plate, so that its part can be
/// integrated analytically; NULL where there is none.
const pdmc_distribution *pdmc_variables_lone_load(const pdmc_variables *variables);

/// z of a sample. In plain Monte Carlo every quantity has its own stream, so that a quantity more or less in the study
/// leaves the others as they are; in a design the samples from its number on are plain ones.
/// @param[out] z  [count]
void pdmc_variables_sample(const pdmc_variables *variables, uint64_t sample, double z[]);

/// The random quantities at points, and what follows from them.
/// @param[in]     count  of the points, <= PDMC_BLOCK
/// @param[in]     z      [count, variables]
/// @param[in,out] draw   [count] their arrays are the caller's
/// @return PDMC_OK or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_variables_draw(const pdmc_variables *variables, int count, const double z[],
                                               pdmc_draw draw[]);

/// @param[out] out  free with pdmc_draws_clear(); zero on failure
/// @return PDMC_OK or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_draws_create(const pdmc_variables *variables, pdmc_draws *out);
void pdmc_draws_clear(pdmc_draws *draws);
