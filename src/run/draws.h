// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What is random in an explicit study, sample by sample.

#include "pdmc/random.h"
#include "pdmc/results.h"

/// Factors of one random field at all nodes: a law's value at every point, of normal variables with a covariance in space.
typedef struct {
    int modes;        // 0 where there is no such field
    double *function; // [nodes, modes] of the normal variable at the nodes, scaled so that its variance is 1 everywhere
    pdmc_distribution law;
    pdmc_stream stream;
    double retained; // share of the variance that the modes hold before that
} pdmc_node_field;

typedef struct {
    const pdmc_problem *problem;
    const pdmc_explicit *study;
    int node_count;
    const int *node_body;
    pdmc_node_field stiffness, toughness;
    double copula[PDMC_SCALARS * PDMC_SCALARS];
    double *bond_strengths; // [PDMC_STRENGTH_CLASSES], or NULL
} pdmc_ensemble_draws;

/// @param[in]  record  of the study at its means, whose nodes are those of all samples; kept by reference
/// @param[out] out     clear with pdmc_ensemble_draws_clear(), whatever is returned
/// @return PDMC_OK, PDMC_ERR_CONFIG (more modes than can be resolved), PDMC_ERR_NOMEM or PDMC_ERR_EXTERN
PDMC_NODISCARD pdmc_status pdmc_ensemble_draws_create(const pdmc_study *study, const pdmc_explicit_record *record,
                                                      int threads, pdmc_ensemble_draws *out);
void pdmc_ensemble_draws_clear(pdmc_ensemble_draws *draws);

/// Draws a sample. @param[out] stiffness, strength  [node_count] room for its factors
/// @return whether all factors are positive
bool pdmc_ensemble_draws_sample(const pdmc_ensemble_draws *draws, uint64_t index, double stiffness[], double strength[],
                                pdmc_explicit_sample *sample);
