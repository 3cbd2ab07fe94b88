// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/design.h"
#include "random/random_impl.h"

enum { PDMC_SOBOL_DIGITS = 32 };

struct pdmc_design {
    pdmc_design_kind kind;
    uint64_t seed, samples, replicates;
    size_t dimension;
    uint32_t *directions; // [dimension, PDMC_SOBOL_DIGITS] of Sobol' sequences, NULL otherwise
};

/// Purposes of the numbers of PDMC_STREAM_SCRAMBLE, in the last word of the counter; 0 are those of
/// pdmc_random_uniform(), which places a point in its interval of a Latin hypercube.
enum {
    PDMC_SCRAMBLE_DIGITS = 1,      // and the level of the digits
    PDMC_SCRAMBLE_REST = 16,       // the digits that a sequence does not have
    PDMC_SCRAMBLE_PERMUTATION = 32 // and the round
};

void pdmc_latin_hypercube_point(const pdmc_design *design, uint64_t sample, double u[]);
void pdmc_sobol_point(const pdmc_design *design, uint64_t sample, double u[]);

/// The images of 0 ... n - 1 under a random permutation that belongs to (seed, replicate, dimension), one at a time.
/// @param[in] index  < n, n >= 1
uint64_t pdmc_random_permutation(uint64_t seed, uint64_t replicate, uint64_t dimension, uint64_t n, uint64_t index);

/// The generator matrices of Sobol' sequences by their columns: digit k of the index adds directions[j][k] to the
/// number in dimension j, whose first digit is the highest bit.
/// @param[out] directions  [dimension, PDMC_SOBOL_DIGITS]
PDMC_NODISCARD pdmc_status pdmc_sobol_directions(size_t dimension, uint32_t directions[]);

/// Whether a polynomial over GF(2), bit k the coefficient of x^k, is primitive. Its degree is in [1, 31].
bool pdmc_polynomial_is_primitive(uint32_t polynomial);

int pdmc_polynomial_degree(uint32_t polynomial);
