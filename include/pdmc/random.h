// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Random numbers that depend on (seed, sample, variable) alone: any sample can be drawn by itself, in any order, on
/// any thread, and a smaller study is the beginning of a larger one.

#include "pdmc/problem.h"

/// What a stream of numbers is for; streams of different purposes are independent.
typedef enum {
    PDMC_STREAM_MICROMODULUS = 1,
    PDMC_STREAM_LOAD = 2,
    PDMC_STREAM_PROBES = 3, // of the error bound of a reduced model
    PDMC_STREAM_SCRAMBLE = 4, // of Sobol' sequences and Latin hypercubes
    PDMC_STREAM_IMPORTANCE = 5,
    PDMC_STREAM_SUBSET = 6,
    PDMC_STREAM_SENSITIVITY = 7,
    PDMC_STREAM_FIELD = 8, // of the stiffness in space
    PDMC_STREAM_YOUNGS_MODULUS = 9,
    PDMC_STREAM_FRACTURE_ENERGY = 10,
    PDMC_STREAM_THICKNESS = 11,
    PDMC_STREAM_CRACK_LENGTH = 12,
    PDMC_STREAM_RESAMPLING = 13, // of bootstraps
    PDMC_STREAM_CRACK_ANGLE = 14,
    PDMC_STREAM_CRACK_X = 15,
    PDMC_STREAM_CRACK_Y = 16,
    PDMC_STREAM_BONDS = 17, // the key of the strengths of single bonds
    PDMC_STREAM_VELOCITY = 18,
    PDMC_STREAM_TOUGHNESS = 19, // of the fracture energy in space
    PDMC_STREAM_LOAD_NOISE = 32,     // of the first side; others in the order of pdmc_side
    PDMC_STREAM_LOAD_SIDE = 36,      // ...
    PDMC_STREAM_LOAD_DIRECTION = 40, // ...
} pdmc_stream;

/// Uniform numbers in the open interval (0, 1): the odd multiples of 2^-53, so that 1 - u is exact and as likely as u.
/// (The half of a 53-bit cell has no double: its greatest would round to 1.)
///
/// Philox4x64-10 (Salmon, Moraes, Dror & Shaw, SC'11) with key {seed, stream} and counter {sample, variable, 0, 0}: the
/// first word of the block belongs to the variable, so that variables too can be drawn one by one.
/// @param[in]  seed    any number, 0 included
/// @param[in]  sample  index of the sample
/// @param[in]  first   index of the first variable
/// @param[in]  count   number of variables
/// @param[out] u       [count] uniforms of variables first, first + 1, ...
PDMC_API void pdmc_random_uniform(uint64_t seed, pdmc_stream stream, uint64_t sample, uint64_t first, size_t count,
                                  double u[]);

/// The standard normal quantile of u; accurate in both tails.
/// @param[in] u  in (0, 1)
PDMC_API double pdmc_normal_quantile(double u);

/// The same of many numbers at once, in their place; faster, and the same to the bit where GSL is built without contraction to
/// FMA, as on x86-64.
/// @param[in,out] u  [count] in (0, 1), odd multiples of 2^-53 as those above; the quantiles
PDMC_API void pdmc_normal_quantiles(size_t count, double u[]);

/// The quantile at u of a positive-mean variable with mean 1 and the given coefficient of variation:
/// normal, 1 + variation Z; lognormal, exp(s Z - s^2 / 2) with s^2 = log(1 + variation^2).
/// @param[in] u          in (0, 1)
/// @param[in] variation  >= 0
PDMC_API double pdmc_unit_mean_quantile(pdmc_distribution_kind kind, double variation, double u);
