// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "pdmc/random.h"
#include "pdmc/statistics.h"

#include <gsl/gsl_sort.h>
#include <math.h>
#include <string.h>

enum { RESAMPLES = 999 };                           // so that p is a multiple of 1 / 1000, and no less
static const uint64_t resampling_seed = UINT64_MAX; // which no study can have: its samples are drawn with others

/// Two samples as one: z holds the values of both in ascending order, of which place[k] says where it stands in x, or,
/// from n on, in y.
typedef struct {
    size_t n, m;
    double *z;     // [n + m]
    size_t *place; // [n + m]
    int *weight;   // [n + m] how often each x, then each y, is counted
    double *draw;  // [max(n, m)]
} pooled;

typedef struct {
    double largest, area;
} norms;

static void pooled_clear(pooled *p)
{
    pdmc_free(p->z);
    pdmc_free(p->place);
    pdmc_free(p->weight);
    pdmc_free(p->draw);
}

static pdmc_status pooled_make(size_t n, const double x[], size_t m, const double y[], pooled *p)
{
    pdmc_status status = PDMC_OK;
    double *both = NULL;
    *p = (pooled){.n = n, .m = m};
    PDMC_NEW(both, n + m);
    PDMC_NEW(p->z, n + m);
    PDMC_NEW(p->place, n + m);
    PDMC_NEW(p->weight, n + m);
    PDMC_NEW(p->draw, n > m ? n : m);
    memcpy(both, x, n * sizeof *x);
    memcpy(&both[n], y, m * sizeof *y);
    gsl_sort_index(p->place, both, 1, n + m);
    for (size_t k = 0; k < n + m; k++) p->z[k] = both[p->place[k]];

done:
    pdmc_free(both);
    return status;
}

/// The largest magnitude of the difference of the two weighted distribution functions, and the area below it.
static norms measure(const pooled *p)
{
    norms found = {0};
    long long from_x = 0, from_y = 0;
    for (size_t k = 0; k < p->n + p->m; k++) {
        if (p->place[k] < p->n) from_x += p->weight[p->place[k]];
        else from_y += p->weight[p->place[k]];
        if (k + 1 < p->n + p->m && p->z[k + 1] == p->z[k]) continue; // equal values are one step
        const double gap = fabs((double)from_x / (double)p->n - (double)from_y / (double)p->m);
        found.largest = fmax(found.largest, gap);
        if (k + 1 < p->n + p->m) found.area += gap * (p->z[k + 1] - p->z[k]);
    }
    return found;
}

/// What a sample drawn from the sample, with replacement, has more of each value than the sample.
static void resample(uint64_t number, uint64_t which, size_t count, double draw[], int weight[])
{
    pdmc_random_uniform(resampling_seed, PDMC_STREAM_RESAMPLING, 2 * number + which, 0, count, draw);
    for (size_t i = 0; i < count; i++) weight[i] = -1;
    for (size_t i = 0; i < count; i++) weight[(size_t)(draw[i] * (double)count)]++;
}

/// How far the difference of two resamples is from that of the samples. Pairs are drawn as pairs.
static norms deviation(const pooled *p, bool paired, uint64_t number)
{
    resample(number, 0, p->n, p->draw, p->weight);
    if (paired) memcpy(&p->weight[p->n], p->weight, p->n * sizeof *p->weight);
    else resample(number, 1, p->m, p->draw, &p->weight[p->n]);
    return measure(p);
}

/// A norm of the difference cannot be off by more than the norm of the difference's error, the triangle inequality.
static pdmc_estimate interval(double value, double deviations[RESAMPLES], double confidence, double most)
{
    gsl_sort(deviations, 1, RESAMPLES);
    const double rank = fmin(ceil(confidence * (RESAMPLES + 1)), RESAMPLES), c = deviations[(int)rank - 1];
    return (pdmc_estimate){value, fmax(0.0, value - c), fmin(most, value + c)};
}

/// Of pairs, by how often a resample is as far from the samples as these are from each other.
static double chance(const pooled *p, bool paired, double distance, const double deviations[RESAMPLES])
{
    const double n = (double)p->n, m = (double)p->m;
    int as_far = 1;
    if (!paired) return pdmc_statistics_kolmogorov(sqrt(n / (n + m) * m) * distance);
    for (int b = 0; b < RESAMPLES; b++) as_far += deviations[b] >= distance;
    return as_far / (RESAMPLES + 1.0);
}

pdmc_status pdmc_statistics_distances(size_t n, const double x[], size_t m, const double y[], bool paired,
                                      double confidence, pdmc_distances *distances)
{
    pdmc_status status = PDMC_OK;
    pooled p = {0};
    double *largest = NULL, *area = NULL; // [RESAMPLES]
    const pdmc_estimate unknown = {NAN, NAN, NAN};
    *distances = (pdmc_distances){unknown, NAN, unknown};
    PDMC_REQUIRE(!paired || n == m, "%zu and %zu samples are not pairs", n, m);
    if (n == 0 || m == 0) return PDMC_OK;
    PDMC_NEW(largest, RESAMPLES);
    PDMC_NEW(area, RESAMPLES);
    PDMC_TRY(pooled_make(n, x, m, y, &p));
    for (size_t k = 0; k < n + m; k++) p.weight[k] = 1;
    const norms found = measure(&p);
    for (int b = 0; b < RESAMPLES; b++) {
        const norms off = deviation(&p, paired, (uint64_t)b);
        largest[b] = off.largest;
        area[b] = off.area;
    }
    distances->p_value = chance(&p, paired, found.largest, largest);
    distances->kolmogorov_smirnov = interval(found.largest, largest, confidence, 1.0);
    distances->wasserstein = interval(found.area, area, confidence, INFINITY);

done:
    pooled_clear(&p);
    pdmc_free(area);
    pdmc_free(largest);
    return status;
}
