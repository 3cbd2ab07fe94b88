// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "statistics/tally_impl.h"

#include <math.h>

enum { LANES = 8, BATCH = 64 };

typedef double lanes __attribute__((vector_size(LANES * sizeof(double))));

/// 2^-k with 2^k about the size of x. The limits keep it, and what is scaled by it, away from 0 and infinity.
static double scale_of(double size)
{
    int exponent;
    frexp(size, &exponent);
    return ldexp(1.0, -(int)fmin(fmax(exponent, -1000), 1000));
}

static pdmc_status set_frame(size_t pilots, const double pilot[], pdmc_tally_quantity *quantity)
{
    pdmc_estimate mean, deviation;
    pdmc_statistics_moments(pilots, pilot, 0.5, &mean, &deviation);
    PDMC_REQUIRE(isfinite(mean.value), "pilots with the mean %g", mean.value);
    quantity->shift = mean.value;
    quantity->scale = scale_of(deviation.value > 0.0 ? deviation.value : fabs(mean.value));
    return PDMC_OK;
}

pdmc_status pdmc_tally_create(size_t quantities, size_t pilots, const double pilot[], size_t thresholds,
                              const double threshold[], pdmc_tally **tally)
{
    PDMC_REQUIRE(quantities > 0, "a tally of no quantities");
    PDMC_REQUIRE(pilots > 0, "a tally needs pilot samples");
    pdmc_status status = PDMC_OK;
    pdmc_tally *made = NULL;
    PDMC_NEW(made, 1);
    *made = (pdmc_tally){.quantities = quantities, .thresholds = thresholds};
    PDMC_NEW(made->quantity, quantities);
    PDMC_NEW(made->threshold, quantities * thresholds);
    PDMC_NEW(made->above, quantities * thresholds);
    if (thresholds > 0) memcpy(made->threshold, threshold, quantities * thresholds * sizeof *threshold);
    for (size_t q = 0; q < quantities; q++) PDMC_TRY(set_frame(pilots, &pilot[q * pilots], &made->quantity[q]));
    *tally = made;
    made = NULL;

done:
    pdmc_tally_destroy(&made);
    return status;
}

void pdmc_tally_destroy(pdmc_tally **tally)
{
    if (!*tally) return;
    for (size_t q = 0; (*tally)->quantity && q < (*tally)->quantities; q++)
        for (int p = 0; p < TALLY_PAGES; p++) pdmc_free((*tally)->quantity[q].page[p]);
    pdmc_free((*tally)->quantity);
    pdmc_free((*tally)->threshold);
    pdmc_free((*tally)->above);
    pdmc_free(*tally);
    *tally = NULL;
}

/// Sums of z, z^2, z^3, z^4, each in LANES that are then added in their order.
PDMC_VECTORS("avx512f")
static void sum_powers(size_t count, const double x[], double shift, double scale, double sum[TALLY_POWERS])
{
    const double scaled_shift = shift * scale; // the difference of two large numbers may be too large before scaling
    lanes total[TALLY_POWERS] = {0};
    for (size_t i = 0; i < count; i += LANES) {
        const size_t left = count - i < LANES ? count - i : LANES;
        lanes z = shift - (lanes){0}; // what the last lanes are filled with adds nothing
        memcpy(&z, &x[i], left * sizeof *x);
        z = z * scale - scaled_shift;
        const lanes square = z * z;
        total[0] += z;
        total[1] += square;
        total[2] += square * z;
        total[3] += square * square;
    }
    for (int k = 0; k < TALLY_POWERS; k++) {
        sum[k] = 0.0;
        for (int j = 0; j < LANES; j++) sum[k] += total[k][j];
    }
}

PDMC_VECTORS("avx512f")
static size_t count_above(size_t count, const double x[], double threshold)
{
    size_t above = 0;
    for (size_t i = 0; i < count; i++) above += x[i] > threshold;
    return above;
}

static pdmc_status count_bins(size_t count, const double x[], uint32_t *page[TALLY_PAGES])
{
    for (size_t first = 0; first < count; first += BATCH) {
        const size_t batch = count - first < BATCH ? count - first : BATCH;
        uint32_t *place[BATCH];
        for (size_t i = 0; i < batch; i++) {
            const uint32_t bin = pdmc_tally_bin(x[first + i]);
            uint32_t **counts = &page[bin / TALLY_PAGE_BINS];
            if (!*counts && !(*counts = pdmc_calloc(TALLY_PAGE_BINS, sizeof **counts))) return PDMC_ERR_NOMEM;
            place[i] = &(*counts)[bin % TALLY_PAGE_BINS];
            __builtin_prefetch(place[i], 1);
        }
        for (size_t i = 0; i < batch; i++) ++*place[i];
    }
    return PDMC_OK;
}

static pdmc_status require_room(const pdmc_tally *tally, size_t count)
{
    PDMC_REQUIRE(count <= UINT32_MAX - tally->samples, "%zu samples and %zu are more than a tally counts",
                 tally->samples, count);
    return PDMC_OK;
}

pdmc_status pdmc_tally_add(pdmc_tally *tally, size_t count, size_t stride, const double value[])
{
    pdmc_status status = PDMC_OK;
    PDMC_REQUIRE(count <= stride, "%zu samples with a stride of %zu", count, stride);
    PDMC_TRY(require_room(tally, count));
    for (size_t q = 0; q < tally->quantities; q++) {
        pdmc_tally_quantity *quantity = &tally->quantity[q];
        const double *x = &value[q * stride];
        double sum[TALLY_POWERS];
        sum_powers(count, x, quantity->shift, quantity->scale, sum);
        if (!isfinite(sum[TALLY_POWERS - 1]))
            PDMC_FAIL(PDMC_ERR_DATA, "quantity %zu has a value that is not finite", q);
        for (int k = 0; k < TALLY_POWERS; k++) pdmc_exact_sum_add(&quantity->power[k], sum[k]);
        for (size_t k = q * tally->thresholds; k < (q + 1) * tally->thresholds; k++)
            tally->above[k] += count_above(count, x, tally->threshold[k]);
        PDMC_TRY(count_bins(count, x, quantity->page));
    }
    tally->samples += count;

done:
    return status;
}

static bool are_alike(const pdmc_tally *a, const pdmc_tally *b)
{
    if (a->quantities != b->quantities || a->thresholds != b->thresholds) return false;
    for (size_t q = 0; q < a->quantities; q++)
        if (a->quantity[q].shift != b->quantity[q].shift || a->quantity[q].scale != b->quantity[q].scale) return false;
    for (size_t k = 0; k < a->quantities * a->thresholds; k++)
        if (a->threshold[k] != b->threshold[k]) return false;
    return true;
}

static pdmc_status merge_bins(uint32_t *into[TALLY_PAGES], uint32_t *const from[TALLY_PAGES])
{
    for (int p = 0; p < TALLY_PAGES; p++) {
        if (!from[p]) continue;
        if (!into[p] && !(into[p] = pdmc_calloc(TALLY_PAGE_BINS, sizeof *into[p]))) return PDMC_ERR_NOMEM;
        for (int b = 0; b < TALLY_PAGE_BINS; b++) into[p][b] += from[p][b];
    }
    return PDMC_OK;
}

pdmc_status pdmc_tally_merge(pdmc_tally *into, const pdmc_tally *from)
{
    pdmc_status status = PDMC_OK;
    PDMC_REQUIRE(are_alike(into, from), "the tallies have other quantities, pilots or thresholds");
    PDMC_TRY(require_room(into, from->samples));
    for (size_t q = 0; q < into->quantities; q++) {
        for (int k = 0; k < TALLY_POWERS; k++)
            pdmc_exact_sum_join(&into->quantity[q].power[k], &from->quantity[q].power[k]);
        PDMC_TRY(merge_bins(into->quantity[q].page, from->quantity[q].page));
    }
    for (size_t k = 0; k < into->quantities * into->thresholds; k++) into->above[k] += from->above[k];
    into->samples += from->samples;

done:
    return status;
}

size_t pdmc_tally_samples(const pdmc_tally *tally)
{
    return tally->samples;
}
