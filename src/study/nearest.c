// SPDX-License-Identifier: GPL-3.0-or-later

/// The nearest known word, by the number of single slips: a letter wrong, missing, too many, or two exchanged
/// (optimal string alignment distance).

#include "study/study_impl.h"

#include <string.h>

static size_t least(size_t a, size_t b)
{
    return a < b ? a : b;
}

/// Both words are shorter than PDMC_STUDY_WORD_SIZE.
static size_t distance(const char *a, const char *b)
{
    size_t rows[3][PDMC_STUDY_WORD_SIZE]; // of the table of prefixes: [i % 3] is row i
    const size_t columns = strlen(b);
    for (size_t j = 0; j <= columns; j++) rows[0][j] = j;
    size_t i = 0;
    for (; a[i]; i++) {
        const size_t *above = rows[i % 3], *second_above = rows[(i + 2) % 3];
        size_t *row = rows[(i + 1) % 3];
        row[0] = i + 1;
        for (size_t j = 0; j < columns; j++) {
            row[j + 1] = least(above[j] + (a[i] != b[j]), 1 + least(above[j + 1], row[j]));
            if (i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j])
                row[j + 1] = least(row[j + 1], second_above[j - 1] + 1);
        }
    }
    return rows[i % 3][columns];
}

pdmc_study_nearest pdmc_study_nearest_to(const char *word)
{
    // One slip for every three letters, at least one: anything further off is another word.
    const size_t slips = strlen(word) / 3;
    return (pdmc_study_nearest){.word = word, .distance = (slips > 0 ? slips : 1) + 1};
}

void pdmc_study_nearest_offer(pdmc_study_nearest *nearest, const char *candidate)
{
    if (strlen(nearest->word) >= PDMC_STUDY_WORD_SIZE || strlen(candidate) >= PDMC_STUDY_WORD_SIZE) return;
    const size_t slips = distance(nearest->word, candidate);
    if (slips >= nearest->distance) return;
    nearest->distance = slips;
    snprintf(nearest->best, sizeof nearest->best, "%s", candidate);
}
