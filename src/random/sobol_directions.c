// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "pdmc/random.h"
#include "random/design_impl.h"

#include <gsl/gsl_qrng.h>

enum {
    PUBLISHED = 40,       // dimensions that GSL has
    PUBLISHED_DEGREE = 8, // of their last polynomials
    GREATEST_DEGREE = 18, // of all
    INITIAL_SEED = 1967,
};

/// A dimension's sequence is the recurrence of its polynomial, x^s + a_1 x^(s-1) + ... + a_(s-1) x + 1, from initial
/// numbers m_1 ... m_s, m_k odd and < 2^k; for a published one m_(s+1) too, from which the polynomial is found.
typedef struct {
    uint32_t polynomial;
    uint32_t m[GREATEST_DEGREE];
} generator;

/// m_k = 2 a_1 m_(k-1) + ... + 2^(s-1) a_(s-1) m_(k-s+1) + 2^s m_(k-s) + m_(k-s), with + the exclusive or.
/// @param[in] m  [k] of which the s before the last place are read
static uint32_t next_number(uint32_t polynomial, const uint32_t m[], int k)
{
    const int s = pdmc_polynomial_degree(polynomial);
    uint32_t next = m[k - s];
    for (int i = 1; i <= s; i++)
        if (polynomial >> (s - i) & 1) next ^= m[k - i] << i;
    return next;
}

/// GSL keeps the direction numbers to itself. It goes through the sequence in Gray's order, so that point 2^k differs
/// from the one before by direction k alone.
/// @param[out] generators  [PUBLISHED], whose m_1 ... m_(PUBLISHED_DEGREE + 1) are set
static pdmc_status read_published(generator generators[])
{
    pdmc_status status = PDMC_OK;
    double point[PUBLISHED];
    uint32_t last[PUBLISHED] = {0};
    char *sequence = NULL;
    PDMC_NEW(sequence, gsl_qrng_sobol->state_size(PUBLISHED));
    if (gsl_qrng_sobol->init_state(sequence, PUBLISHED) != 0) PDMC_FAIL(PDMC_ERR_EXTERN, "GSL's Sobol' sequence");
    for (uint32_t n = 1, k = 0; k <= PUBLISHED_DEGREE; n++) {
        if (gsl_qrng_sobol->get(sequence, PUBLISHED, point) != 0) PDMC_FAIL(PDMC_ERR_EXTERN, "GSL's Sobol' sequence");
        for (int j = 0; j < PUBLISHED; j++) {
            const uint32_t digits = (uint32_t)(point[j] * 0x1p32);
            if (n == UINT32_C(1) << k) generators[j].m[k] = (digits ^ last[j]) >> (31 - k);
            last[j] = digits;
        }
        if (n == UINT32_C(1) << k) k++;
    }

done:
    pdmc_free(sequence);
    return status;
}

/// The polynomial of degree s for which m_(s+1) follows: each m is odd, so that its digits give a_1, a_2, ... in turn.
static uint32_t published_polynomial(const uint32_t m[], int s)
{
    uint32_t polynomial = UINT32_C(1) << s | 1, rest = m[s] ^ next_number(polynomial, m, s);
    for (int i = 1; i < s; i++) {
        if (!(rest >> i & 1)) continue;
        polynomial |= UINT32_C(1) << (s - i);
        rest ^= m[s - i] << i;
    }
    return polynomial;
}

static uint32_t next_primitive(uint32_t polynomial)
{
    do polynomial++;
    while (!pdmc_polynomial_is_primitive(polynomial));
    return polynomial;
}

static bool is_published(const generator generators[], uint32_t polynomial)
{
    for (int j = 1; j < PUBLISHED; j++)
        if (generators[j].polynomial == polynomial) return true;
    return false;
}

static void set_published(generator generators[])
{
    uint32_t of_same_degree = 1;
    for (int j = 1; j < PUBLISHED; j++) {
        of_same_degree = next_primitive(of_same_degree);
        generators[j].polynomial = published_polynomial(generators[j].m, pdmc_polynomial_degree(of_same_degree));
    }
}

/// The other polynomials in ascending order, with random initial numbers.
static void set_further(size_t dimension, generator generators[])
{
    uint32_t polynomial = UINT32_C(1) << PUBLISHED_DEGREE;
    for (size_t j = PUBLISHED; j < dimension; j++) {
        do polynomial = next_primitive(polynomial);
        while (is_published(generators, polynomial));
        generators[j].polynomial = polynomial;
        for (int k = 0; k < pdmc_polynomial_degree(polynomial); k++) {
            const uint64_t counter[4] = {(uint64_t)k, j, 0, 0};
            const uint64_t word = pdmc_random_words(INITIAL_SEED, PDMC_STREAM_SCRAMBLE, counter).word[0];
            generators[j].m[k] = (uint32_t)(word >> (63 - k)) | 1;
        }
    }
}

static void columns_of(const generator *g, uint32_t columns[])
{
    uint32_t m[PDMC_SOBOL_DIGITS];
    const int s = pdmc_polynomial_degree(g->polynomial);
    for (int k = 0; k < PDMC_SOBOL_DIGITS; k++) {
        m[k] = k < s ? g->m[k] : next_number(g->polynomial, m, k);
        columns[k] = m[k] << (31 - k);
    }
}

pdmc_status pdmc_sobol_directions(size_t dimension, uint32_t directions[])
{
    pdmc_status status = PDMC_OK;
    generator *generators = NULL;
    PDMC_NEW(generators, dimension > PUBLISHED ? dimension : PUBLISHED);
    PDMC_TRY(read_published(generators));
    set_published(generators);
    set_further(dimension, generators);
    // The first dimension, van der Corput's sequence, has no polynomial: digit k of the index is digit k of the number.
    for (int k = 0; k < PDMC_SOBOL_DIGITS; k++) directions[k] = UINT32_C(1) << (31 - k);
    for (size_t j = 1; j < dimension; j++) columns_of(&generators[j], &directions[j * PDMC_SOBOL_DIGITS]);

done:
    pdmc_free(generators);
    return status;
}
