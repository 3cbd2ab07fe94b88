// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/tally.h"
#include "statistics/exact_sum.h"

#include <string.h>

/// The bins of a tally: the leading bits of a double, with sign and exponent changed so that they are in the order of
/// the numbers. Bins of one sign and exponent are a page, which exists where it has been needed.
enum {
    TALLY_FRACTION_BITS = 11,
    TALLY_PAGE_BINS = 1 << TALLY_FRACTION_BITS,
    TALLY_PAGES = 1 << 12,
    TALLY_ZERO = TALLY_PAGES / 2 * TALLY_PAGE_BINS, // the first bin of the positive numbers
    TALLY_DROPPED_BITS = 52 - TALLY_FRACTION_BITS,
    TALLY_POWERS = 4,
};

typedef struct {
    double shift, scale; // z = (x - shift) scale; a power of two, so that no unit of x changes a bit
    pdmc_exact_sum power[TALLY_POWERS];
    uint32_t *page[TALLY_PAGES]; // [TALLY_PAGE_BINS] each, or NULL
} pdmc_tally_quantity;

struct pdmc_tally {
    size_t quantities, thresholds, samples;
    pdmc_tally_quantity *quantity; // [quantities]
    double *threshold;             // [quantities, thresholds]
    size_t *above;                 // [quantities, thresholds] number of values above
};

/// The bin of a number.
static inline uint32_t pdmc_tally_bin(double x)
{
    const uint64_t sign = UINT64_C(1) << 63;
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return (uint32_t)((bits ^ ((0 - (bits >> 63)) | sign)) >> TALLY_DROPPED_BITS);
}
