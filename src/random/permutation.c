// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/random.h"

#include "random/design_impl.h"

#include <math.h>

/// The indices in a table of rows and columns, not fewer than n cells, of about equal sides.
typedef struct {
    uint64_t seed, replicate, dimension;
    uint64_t rows, columns;
    int rounds;
} shuffle;

/// Two rounds bring the joint distribution of two images nearer to a uniform permutation's by the factor 1 / cells:
/// as many as make it less than 2^-24, and no fewer than six, for what three and more images have in common.
static int rounds_for(uint64_t cells)
{
    return cells > 256 ? 6 : 2 * (int)ceil(24.0 / log2((double)cells));
}

static shuffle shuffle_of(uint64_t seed, uint64_t replicate, uint64_t dimension, uint64_t n)
{
    const uint64_t rows = (uint64_t)ceil(sqrt((double)n)), columns = (n + rows - 1) / rows;
    return (shuffle){seed, replicate, dimension, rows, columns, n > 1 ? rounds_for(rows * columns) : 0};
}

static uint64_t shift(const shuffle *s, int round, uint64_t line)
{
    const uint64_t counter[4] = {line, s->dimension, s->replicate, PDMC_SCRAMBLE_PERMUTATION + (uint64_t)round};
    return pdmc_random_words(s->seed, PDMC_STREAM_SCRAMBLE, counter).word[0];
}

/// Each column is turned by a random shift of its own, then each row, and so on.
static uint64_t turn(const shuffle *s, uint64_t cell)
{
    uint64_t row = cell / s->columns, column = cell % s->columns;
    for (int round = 0; round < s->rounds; round++) {
        if (round % 2 == 0) row = (row + shift(s, round, column) % s->rows) % s->rows;
        else column = (column + shift(s, round, row) % s->columns) % s->columns;
    }
    return row * s->columns + column;
}

uint64_t pdmc_random_permutation(uint64_t seed, uint64_t replicate, uint64_t dimension, uint64_t n, uint64_t index)
{
    const shuffle s = shuffle_of(seed, replicate, dimension, n);
    // Along a cycle of the table's permutation the next index below n comes after fewer than `rows` others.
    do index = turn(&s, index);
    while (index >= n);
    return index;
}
