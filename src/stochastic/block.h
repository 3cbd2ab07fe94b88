// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/results.h"
#include "stochastic/draw.h"

/// A block of samples on its way from random numbers to energies; one for each thread. Arrays are [PDMC_BLOCK, ...].
typedef struct {
    const pdmc_problem *problem;
    const pdmc_affine *model;
    int sample[PDMC_BLOCK]; // -1 for the mean
    pdmc_draw draw[PDMC_BLOCK];
    double *numbers;                // the draws' arrays
    double *xi;                     // [terms]
    double *x, *term, *next;        // [unknowns] solution, last and next term of the expansion
    double contraction[PDMC_BLOCK]; // of the expansion
    double residual[PDMC_BLOCK];    // of the iteration
    double error[PDMC_BLOCK];       // of the reduced model, bound of sqrt(e' K(xi) e); all NaN with another inverse
    pdmc_sample_failure failure[PDMC_BLOCK];
    double *stretch;   // [bonds, PDMC_BLOCK]
    double *observed;  // [model's observed]
    double *ring_sum;  // [rings, PDMC_BLOCK] squared stretches
    double *intensity; // [2 tips, PDMC_BLOCK]
    double *energy;    // [tips angles, PDMC_BLOCK]
    double solve_seconds, energy_seconds;
} pdmc_block;

PDMC_NODISCARD pdmc_status pdmc_block_create(const pdmc_problem *problem, const pdmc_affine *model, pdmc_block **block);
void pdmc_block_destroy(pdmc_block **block);

/// Draws samples first .. first + count - 1; the block's other columns are solved too, without load, so that the shape
/// of every matrix product is the same.
void pdmc_block_draw(pdmc_block *block, int first, int count);

/// Draws the samples that are named.
void pdmc_block_draw_samples(pdmc_block *block, const int sample[], int count);

/// Solves the block by an inverse; PDMC_INVERSE_REDUCED where the model is a reduced one.
PDMC_NODISCARD pdmc_status pdmc_block_solve_by(pdmc_block *block, pdmc_inverse inverse, int count);

/// Solves the block by the problem's inverse.
PDMC_NODISCARD pdmc_status pdmc_block_solve(pdmc_block *block, int count);

/// Stress intensity factors and bond energies of the solutions.
void pdmc_block_energies(pdmc_block *block, pdmc_bonds bonds);

/// Copies the first `count` samples of the block to their places in the results.
void pdmc_block_store(const pdmc_block *block, int count, pdmc_results *results);

/// Solves the mean sample and stores the nominal energies.
void pdmc_block_nominal(pdmc_block *block, pdmc_results *results);
