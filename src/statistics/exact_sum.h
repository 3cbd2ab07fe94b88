// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Sums of doubles without rounding, and so without an order: a fixed-point number as long as the range of doubles
/// (U. Kulisch: Computer Arithmetic and Validity, 2nd ed., de Gruyter (2013), chapter 8).

#include <stdint.h>

enum { EXACT_SUM_WORDS = 67 }; // of 32 bits, from 2^-1074 past the largest double; what a word has more is its carry

typedef struct {
    int64_t word[EXACT_SUM_WORDS];
} pdmc_exact_sum;

/// Adds a finite x; no more than 2^30 of them in all, over all sums that are joined.
void pdmc_exact_sum_add(pdmc_exact_sum *sum, double x);

void pdmc_exact_sum_join(pdmc_exact_sum *into, const pdmc_exact_sum *from);

/// The sum as a double, within one rounding in its last place.
double pdmc_exact_sum_value(const pdmc_exact_sum *sum);
