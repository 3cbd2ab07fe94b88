// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Samples of an affine model, whichever method made it; two tips and eight angles.

#include "kansa/plate.h"
#include "support/drawn_block.h"

#include <gsl/gsl_sort.h>

// Energies of the mean at every direction, [tips, angles].
static inline void nominal(const pdmc_problem *problem, const pdmc_affine *model, pdmc_bonds bonds, double energy[])
{
    drawn_block drawn;
    pdmc_block *block = drawn_block_begin(&drawn, problem, model, 0);
    pdmc_problem certain = *problem;
    certain.sampling.inverse = PDMC_INVERSE_NEUMANN;
    block->problem = &certain;
    CHECK_OK(pdmc_block_solve(block, 0));
    pdmc_block_energies(block, bonds);
    for (int d = 0; d < model->tips * model->angles; d++) energy[d] = block->energy[d * PDMC_BLOCK];
    drawn_block_end(&drawn);
}

// Solves a block of samples and stores their energies, [64, 16], and K_I of the right tip, [64].
static inline void solve_samples(plate *p, const pdmc_affine *model, pdmc_inverse inverse, int order, int count,
                                 double energy[], double K[])
{
    drawn_block drawn;
    p->problem.sampling.inverse = inverse;
    p->problem.sampling.order = order;
    pdmc_block *block = drawn_block_begin(&drawn, &p->problem, model, count);
    CHECK_OK(pdmc_block_solve(block, count));
    pdmc_block_energies(block, PDMC_BONDS_ALL);
    for (int s = 0; s < count; s++) {
        assert_int_equal(block->failure[s], PDMC_SAMPLE_OK);
        for (int d = 0; d < 16; d++) energy[16 * s + d] = block->energy[d * PDMC_BLOCK + s];
        K[s] = block->drawn.draw[s].effective_modulus * block->intensity[2 * PDMC_BLOCK + s];
    }
    drawn_block_end(&drawn);
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
