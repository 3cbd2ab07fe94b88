// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Designs: points of the unit cube that fill it more evenly than independent ones, so that fewer samples do.
///
/// A design is R independent randomised replicates. Sample i is point i / R of replicate i % R. In each replicate every
/// single point is uniform in the cube, so that estimates are unbiased, and the spread between the replicates, which
/// are independent, gives the interval of an estimate: pdmc_statistics_replicates_moments() and its kin.

#include "pdmc/base.h"

typedef enum {
    PDMC_DESIGN_MONTE_CARLO, // independent points: no design, drawn by the streams of pdmc/random.h
    PDMC_DESIGN_LATIN_HYPERCUBE,
    PDMC_DESIGN_SOBOL,
} pdmc_design_kind;

enum {
    PDMC_DESIGN_REPLICATES = 16,          // enough for Student's t: 2.13 at 95 %, with ever more 1.96
    PDMC_DESIGN_SOBOL_DIMENSIONS = 21201, // primitive polynomials up to degree 18
};

typedef struct pdmc_design pdmc_design;

/// Latin hypercube (McKay, Beckman & Conover 1979): in every dimension each of the n = samples / replicates points of a
/// replicate lies in another of n equal intervals. The points depend on n.
///
/// Sobol' (1967), with Owen's (1995) nested uniform scrambling: each replicate begins a (t, d)-sequence in base 2. The
/// points do not depend on `samples`, so that a smaller study is the beginning of a larger one.
/// @param[in]  kind        PDMC_DESIGN_LATIN_HYPERCUBE or PDMC_DESIGN_SOBOL
/// @param[in]  seed        any number
/// @param[in]  dimension   d >= 1; <= PDMC_DESIGN_SOBOL_DIMENSIONS for Sobol'
/// @param[in]  samples     >= 1; a multiple of `replicates` for a Latin hypercube
/// @param[in]  replicates  R >= 1, by default PDMC_DESIGN_REPLICATES; at most 2^32 samples each
/// @param[out] design      owned by the caller; written on success
/// @return PDMC_OK, PDMC_ERR_ARG, or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_design_create(pdmc_design_kind kind, uint64_t seed, size_t dimension,
                                                       uint64_t samples, uint64_t replicates, pdmc_design **design);

/// NULL and a pointer to NULL are allowed.
PDMC_API void pdmc_design_destroy(pdmc_design **design);

/// The point of a sample; from any thread, in any order.
/// @param[in]  sample  < samples
/// @param[out] u       [d] in (0, 1), odd multiples of 2^-53 as those of pdmc_random_uniform()
PDMC_API void pdmc_design_point(const pdmc_design *design, uint64_t sample, double u[]);
