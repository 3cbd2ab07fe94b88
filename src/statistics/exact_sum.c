// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/exact_sum.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>

enum { WORD_BITS = 32, LOWEST = DBL_MIN_EXP - DBL_MANT_DIG }; // the least double is 2^LOWEST

static const int64_t word_mask = ((int64_t)1 << WORD_BITS) - 1;

void pdmc_exact_sum_add(pdmc_exact_sum *sum, double x)
{
    int exponent;
    const double fraction = frexp(x, &exponent);
    const int top = exponent - DBL_MANT_DIG < LOWEST ? LOWEST : exponent - DBL_MANT_DIG;
    const int64_t sign = x < 0.0 ? -1 : 1, digits = (int64_t)ldexp(fabs(fraction), exponent - top); // x = digits 2^top
    const int place = (top - LOWEST) / WORD_BITS, shift = (top - LOWEST) % WORD_BITS;
    const int64_t low = (digits & word_mask) << shift, high = (digits >> WORD_BITS) << shift;
    sum->word[place] += sign * (low & word_mask);
    sum->word[place + 1] += sign * ((low >> WORD_BITS) + (high & word_mask));
    sum->word[place + 2] += sign * (high >> WORD_BITS);
}

void pdmc_exact_sum_join(pdmc_exact_sum *into, const pdmc_exact_sum *from)
{
    for (int w = 0; w < EXACT_SUM_WORDS; w++) into->word[w] += from->word[w];
}

/// Makes every word but the last a digit in [0, 2^32): the last has the sign of the whole.
static void carry(pdmc_exact_sum *sum)
{
    for (int w = 0; w + 1 < EXACT_SUM_WORDS; w++) {
        const int64_t digit = sum->word[w] & word_mask;
        sum->word[w + 1] += (sum->word[w] - digit) / (word_mask + 1);
        sum->word[w] = digit;
    }
}

double pdmc_exact_sum_value(const pdmc_exact_sum *sum)
{
    pdmc_exact_sum rest = *sum;
    double value = 0.0;
    carry(&rest);
    const bool is_negative = rest.word[EXACT_SUM_WORDS - 1] < 0;
    for (int w = 0; is_negative && w < EXACT_SUM_WORDS; w++) rest.word[w] = -rest.word[w];
    carry(&rest);
    for (int w = EXACT_SUM_WORDS - 1; w >= 0; w--) value += ldexp((double)rest.word[w], WORD_BITS * w + LOWEST);
    return is_negative ? -value : value;
}
