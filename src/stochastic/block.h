// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/results.h"
#include "stochastic/forms.h"
#include "stochastic/near.h"
#include "stochastic/reduced.h"
#include "stochastic/variables.h"

/// A block of samples on its way from random numbers to energies; one for each thread. Arrays are [PDMC_BLOCK, ...].
typedef struct {
    const pdmc_problem *problem;
    const pdmc_variables *variables;
    const pdmc_affine *model; // that the samples are solved by
    int sample[PDMC_BLOCK];   // -1 for the mean
    pdmc_draws drawn;
    double *x, *term, *next;        // [unknowns] solution, last and next term of the expansion
    double *scale;                  // [cases] of one sample's loads
    double contraction[PDMC_BLOCK]; // of the expansion
    double residual[PDMC_BLOCK];    // of the iteration
    pdmc_reduced_bound bound;       // of the reduced model; its errors are all NaN with another inverse
    pdmc_sample_failure failure[PDMC_BLOCK];
    pdmc_sample_solver solver[PDMC_BLOCK];
    double *stretch;   // [bonds, PDMC_BLOCK]
    double *observed;  // [model's observed]
    pdmc_near near;    // of sparse crossings
    double *ring_sum;  // [rings, PDMC_BLOCK] squared stretches
    double *intensity; // [2 tips, PDMC_BLOCK]
    double *energy;    // [PDMC_MEASURES, tips angles, PDMC_BLOCK], of which the first are those of bonds ...
    double *griffith;  // ... and these the others
    double *feature;   // scratch of the forms
    const pdmc_energy_forms *forms;       // of the energies of all bonds; NULL: bond by bond
    const pdmc_distribution *lone_load;   // of pdmc_variables_lone_load()
    bool measure_alone;                   // only pdmc_block_measure() is called; to be set before samples are solved
    bool has_own_plates;                  // its samples are solved on plates of their own, and their energies are there
    double solve_seconds, energy_seconds; // times the threads that a block's samples are shared out to
} pdmc_block;

/// Threads that blocks are shared out to: all, or one where the samples of a block are shared out instead.
int pdmc_block_threads(const pdmc_affine *model, int threads);

/// @param[in] model  that of the variables, or one reduced from it; both are kept by reference
PDMC_NODISCARD pdmc_status pdmc_block_create(const pdmc_variables *variables, const pdmc_affine *model,
                                             pdmc_block **block);
void pdmc_block_destroy(pdmc_block **block);

/// Draws samples first .. first + count - 1; the block's other columns are solved too, at the mean, so that the shape of
/// every matrix product is the same.
PDMC_NODISCARD pdmc_status pdmc_block_draw(pdmc_block *block, int first, int count);

/// Draws the samples that are named.
PDMC_NODISCARD pdmc_status pdmc_block_draw_samples(pdmc_block *block, const int sample[], int count);

/// Takes the random quantities at points z instead.
/// @param[in] z  [count, variables]
PDMC_NODISCARD pdmc_status pdmc_block_draw_points(pdmc_block *block, const double z[], int count);

/// Solves the block by an inverse; PDMC_INVERSE_REDUCED where the model is a reduced one.
PDMC_NODISCARD pdmc_status pdmc_block_solve_by(pdmc_block *block, pdmc_inverse inverse, int count);

/// Solves the block by the problem's inverse. Samples whose expansion does not contract fall back: on conjugate gradients
/// where the operator is symmetric, on what the expansion would tend to where the unknowns are few, and where that fails
/// on their own factorisation.
PDMC_NODISCARD pdmc_status pdmc_block_solve(pdmc_block *block, int count);

/// Solves one sample of the block by its own factorisation, whatever failed before.
PDMC_NODISCARD pdmc_status pdmc_block_solve_directly(pdmc_block *block, int s);

/// Stress intensity factors and bond energies of the solutions.
void pdmc_block_energies(pdmc_block *block, pdmc_bonds bonds);

/// Griffith's energies by the stress intensity factors, in the directions of the results.
void pdmc_block_griffith(pdmc_block *block, const pdmc_results *results);

/// What the problem's measure needs of pdmc_block_energies(), for the largest energies alone.
void pdmc_block_measure(pdmc_block *block);

/// Quadratic forms of the model's bond energies, from pilot samples for which the block is used. They depend on the problem
/// and the model, and not on the number of samples.
/// @param[out] forms  free with pdmc_energy_forms_destroy(); NULL where bonds are better summed one by one: of forms that
///                    are no cheaper, with bonds in tension only, and where the pilots' energies differ by more than 1e-13
PDMC_NODISCARD pdmc_status pdmc_block_make_forms(pdmc_block *block, pdmc_energy_forms **forms);

/// Lets the block use forms of its model, which are kept by reference; NULL is allowed. Samples for which they do not hold are
/// still summed bond by bond.
PDMC_NODISCARD pdmc_status pdmc_block_use_forms(pdmc_block *block, const pdmc_energy_forms *forms);

/// The largest energy of a tip by the problem's measure, over the directions; force / length.
double pdmc_block_largest_energy(const pdmc_block *block, int s, int tip);

/// The same of all samples by either measure.
/// @param[out] largest  [PDMC_BLOCK]
void pdmc_block_largest_energies(const pdmc_block *block, pdmc_measure measure, int tip, double largest[PDMC_BLOCK]);

/// Copies the first `count` samples of the block to their places in the results; c(r) and energies of those that are kept.
void pdmc_block_store(const pdmc_block *block, int count, pdmc_results *results);

/// Solves the mean sample and stores the nominal energies.
PDMC_NODISCARD pdmc_status pdmc_block_nominal(pdmc_block *block, pdmc_results *results);
