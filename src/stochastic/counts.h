// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/stochastic.h"
#include "pdmc/tally.h"
#include "stochastic/block.h"

/// Blocks whose samples are tallied at once: the longer, the better the tally's counts stay in the cache.
enum { PDMC_COUNTED_BLOCKS = 16 };

/// What is counted of all samples where only the first are kept. Each thread has its own; merged, they do not depend on which
/// of them counted what.
struct pdmc_sample_counts {
    int tips, angles;
    pdmc_measure measure; // of the direction
    int64_t *largest;     // [tips, angles, angles] samples whose energy is largest at an angle and n others, by n
    pdmc_tally *tally;    // of the energies, [PDMC_MEASURES, tips, angles]
    size_t waiting;       // samples to be tallied
    double *energy;       // [PDMC_MEASURES, tips, angles, PDMC_COUNTED_BLOCKS * PDMC_BLOCK]
};

/// @param[in]  results  whose nominal energies are the tally's pilots
/// @param[out] counts   free with pdmc_sample_counts_destroy(); written only on success
PDMC_NODISCARD pdmc_status pdmc_sample_counts_create(const pdmc_results *results, pdmc_sample_counts **counts);

/// Counts those of the first `count` samples of a block that did not fail and are wanted; with pdmc_sample_counts_flush() at
/// the latest after PDMC_COUNTED_BLOCKS blocks.
void pdmc_sample_counts_add(pdmc_sample_counts *counts, const pdmc_block *block, int count, const bool wanted[]);
PDMC_NODISCARD pdmc_status pdmc_sample_counts_flush(pdmc_sample_counts *counts);

PDMC_NODISCARD pdmc_status pdmc_sample_counts_merge(pdmc_sample_counts *into, const pdmc_sample_counts *from);

/// Whether an energy is that of the largest, but for rounding: a symmetric plate has two equal maxima, which rounding would
/// otherwise deal out.
static inline bool pdmc_is_largest(double energy, double largest)
{
    const double tie = 1e-6;
    return energy >= (1.0 - tie) * largest;
}
