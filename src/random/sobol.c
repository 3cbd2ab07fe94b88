// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/random.h"

#include "random/design_impl.h"

enum { LEVEL_DIGITS = 8, LEVELS = PDMC_SOBOL_DIGITS / LEVEL_DIGITS };

static uint32_t sobol_digits(const uint32_t directions[], uint64_t index)
{
    uint32_t digits = 0;
    for (; index; index >>= 1, directions++)
        if (index & 1) digits ^= *directions;
    return digits;
}

/// Random words that belong to the digits before a place.
static pdmc_random_block words_below(const pdmc_design *design, uint64_t replicate, size_t dimension, uint32_t prefix,
                                     uint64_t purpose)
{
    const uint64_t counter[4] = {prefix, dimension, replicate, purpose};
    return pdmc_random_words(design->seed, PDMC_STREAM_SCRAMBLE, counter);
}

/// The next digits of a level, each flipped or not by a bit that belongs to all digits before it. The 2^8 - 1 bits of a
/// level are one block of four words, as a binary tree: below node v are nodes 2 v and 2 v + 1.
static uint32_t scramble_level(const pdmc_random_block *block, uint32_t digits)
{
    uint32_t scrambled = 0, node = 1;
    for (int k = LEVEL_DIGITS - 1; k >= 0; k--) {
        const uint32_t digit = digits >> k & 1, flip = (uint32_t)(block->word[node >> 6] >> (node & 63)) & 1;
        scrambled = scrambled << 1 | (digit ^ flip);
        node = node << 1 | digit;
    }
    return scrambled;
}

static uint64_t scramble(const pdmc_design *design, uint64_t replicate, size_t dimension, uint32_t digits)
{
    uint64_t word = 0;
    for (int level = 0; level < LEVELS; level++) {
        const uint32_t through = digits >> (PDMC_SOBOL_DIGITS - LEVEL_DIGITS * (level + 1));
        const pdmc_random_block block =
            words_below(design, replicate, dimension, through >> LEVEL_DIGITS, PDMC_SCRAMBLE_DIGITS + (uint64_t)level);
        word = word << LEVEL_DIGITS | scramble_level(&block, through);
    }
    // No two points of a replicate share all 32 digits: what follows is independent.
    const pdmc_random_block rest = words_below(design, replicate, dimension, digits, PDMC_SCRAMBLE_REST);
    return word << 32 | rest.word[0] >> 32;
}

void pdmc_sobol_point(const pdmc_design *design, uint64_t sample, double u[])
{
    const uint64_t replicate = sample % design->replicates, index = sample / design->replicates;
    for (size_t j = 0; j < design->dimension; j++) {
        const uint32_t digits = sobol_digits(&design->directions[j * PDMC_SOBOL_DIGITS], index);
        u[j] = pdmc_random_open_interval(scramble(design, replicate, j, digits));
    }
}
