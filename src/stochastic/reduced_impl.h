// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/base_impl.h"
#include "stochastic/reduced.h"

enum { PDMC_PROBES = PDMC_BLOCK, PDMC_REDUCED_CAPACITY = 6 * PDMC_BLOCK };

/// What a reduced model solves with; r is its dimension, the capacity the leading dimension of what grows.
typedef struct {
    const pdmc_affine *full;
    int dimension, terms;
    double *matrix;       // [terms, capacity, capacity] V' K_m V; V' K_0 V is the identity
    double *load;         // [capacity] V' F
    double *probe_matrix; // [1 + terms, capacity, PDMC_PROBES] z_k' K_m v_j, m = 0 the mean
    double *probe_load;   // [PDMC_PROBES] z_k' F
    double quantile;      // of chi-square with PDMC_PROBES degrees of freedom, at the probability of a failing bound
} pdmc_reduced_system;

PDMC_NODISCARD pdmc_status pdmc_reduced_system_create(const pdmc_affine *full, pdmc_reduced_system **system);
void pdmc_reduced_system_destroy(void *system);

/// As pdmc_reduced_solve(), with rows of x of length system->dimension.
PDMC_NODISCARD pdmc_status pdmc_reduced_system_solve(const pdmc_reduced_system *system, const double xi[], double x[],
                                                     double error[PDMC_BLOCK]);

/// As pdmc_reduced_coercivity().
PDMC_NODISCARD pdmc_status pdmc_reduced_system_coercivity(const pdmc_reduced_system *system, const double xi[],
                                                          double alpha[PDMC_BLOCK]);

/// What a basis is made with. Vectors are [count, unknowns]; B = PDMC_BLOCK.
typedef struct {
    const pdmc_variables *variables;
    const pdmc_affine *full;
    int threads, n;
    pdmc_reduced_system *system;
    double *basis, *image;   // [PDMC_REDUCED_CAPACITY] V and K_0 V
    double *probe;           // [PDMC_PROBES]
    double *load;            // [1] F
    double *block, *product; // [B]
    double *overlap;         // [B, PDMC_REDUCED_CAPACITY]
    pdmc_draws training;
    double *none; // [B, terms] zero
} pdmc_reduced_builder;

PDMC_NODISCARD pdmc_status pdmc_reduced_builder_create(pdmc_reduced_builder *b);
void pdmc_reduced_builder_clear(pdmc_reduced_builder *b);

/// Makes the basis and the system, until the bound of the training samples' errors is at most `wanted`.
PDMC_NODISCARD pdmc_status pdmc_reduced_build(pdmc_reduced_builder *b, double wanted);
