// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Samples of an affine model, whichever method made it; two tips and eight angles.

#include "kansa/plate.h"
#include "stochastic/block.h"

#include <gsl/gsl_sort.h>

// Energies of the mean at every direction, [tips, angles].
static inline void nominal(const pdmc_problem *problem, const pdmc_affine *model, pdmc_bonds bonds, double energy[])
{
    pdmc_block *block = NULL;
    CHECK_OK(pdmc_block_create(problem, model, &block));
    pdmc_block_draw(block, 0, 0);
    pdmc_problem certain = *problem;
    certain.sampling.inverse = PDMC_INVERSE_NEUMANN;
    block->problem = &certain;
    CHECK_OK(pdmc_block_solve(block, 0));
    pdmc_block_energies(block, bonds);
    for (int d = 0; d < model->tips * model->angles; d++) energy[d] = block->energy[d * PDMC_BLOCK];
    pdmc_block_destroy(&block);
}

// Solves a block of samples and stores their energies, [64, 16], and K_I of the right tip, [64].
static inline void solve_samples(plate *p, const pdmc_affine *model, pdmc_inverse inverse, int order, int count,
                                 double energy[], double K[])
{
    pdmc_block *block = NULL;
    p->problem.sampling.inverse = inverse;
    p->problem.sampling.order = order;
    CHECK_OK(pdmc_block_create(&p->problem, model, &block));
    pdmc_block_draw(block, 0, count);
    CHECK_OK(pdmc_block_solve(block, count));
    pdmc_block_energies(block, PDMC_BONDS_ALL);
    for (int s = 0; s < count; s++) {
        assert_int_equal(block->failure[s], PDMC_SAMPLE_OK);
        for (int d = 0; d < 16; d++) energy[16 * s + d] = block->energy[d * PDMC_BLOCK + s];
        K[s] = block->draw[s].effective_modulus * block->intensity[2 * PDMC_BLOCK + s];
    }
    pdmc_block_destroy(&block);
}

static inline double largest_error(const double energy[], const double exact[], int count, double *median)
{
    double error[64];
    for (int s = 0; s < count; s++) {
        error[s] = 0.0;
        for (int d = 0; d < 16; d++)
            if (exact[16 * s + d] > 0.0) error[s] = fmax(error[s], fabs(energy[16 * s + d] / exact[16 * s + d] - 1.0));
    }
    gsl_sort(error, 1, (size_t)count);
    *median = error[count / 2];
    return error[count - 1];
}
