// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "reliability/average.h"
#include "reliability/normals.h"

#include <cblas.h>
#include <gsl/gsl_cdf.h>
#include <math.h>

static const double few = 10.0;            // effective samples below which their own variance is not believed
static const double heaviest_share = 0.05; // of one sample in the sum of squares, above which the variance is not known

typedef struct {
    const pdmc_limit_state *limit;
    const pdmc_importance_options *options;
    int centres;
    const double *centre;          // [centres, dimension]
    double *half_square;           // [centres] |c|^2 / 2
    double *z, *g;                 // [batch, dimension], [batch]
    pdmc_average events, possible; // weights of events; of events and failed points
    long taken, failed;
} sampling;

pdmc_importance_options pdmc_importance_options_default(void)
{
    return (pdmc_importance_options){
        .seed = 1, .confidence = 0.95, .variation = 0.05, .most_evaluations = 200000, .batch = 2000};
}

/// The variable after the point's own chooses the centre.
static void draw(const sampling *s, long sample, double z[])
{
    const int n = s->limit->dimension;
    double choice;
    pdmc_random_uniform(s->options->seed, PDMC_STREAM_IMPORTANCE, (uint64_t)sample, (uint64_t)n, 1, &choice);
    const double *c = &s->centre[(long)(choice * s->centres) * n];
    pdmc_random_normal(s->options->seed, PDMC_STREAM_IMPORTANCE, (uint64_t)sample, 0, n, z);
    for (int i = 0; i < n; i++) z[i] += c[i];
}

static double weight(const sampling *s, const double z[])
{
    const int n = s->limit->dimension;
    double density = 0.0; // over that of the standard normal
    for (int j = 0; j < s->centres; j++) density += exp(cblas_ddot(n, z, 1, &s->centre[j * n], 1) - s->half_square[j]);
    return s->centres / density;
}

static void count_in(sampling *s, const double z[], double g)
{
    const double w = g > 0.0 || isnan(g) ? weight(s, z) : 0.0;
    pdmc_average_add(&s->events, isnan(g) ? 0.0 : w);
    pdmc_average_add(&s->possible, w);
    s->failed += isnan(g);
}

static pdmc_status take_batch(sampling *s)
{
    const int n = s->limit->dimension, batch = s->options->batch;
    for (int k = 0; k < batch; k++) draw(s, s->taken + k, &s->z[(size_t)k * (size_t)n]);
    const pdmc_status status = s->limit->evaluate(s->limit->context, batch, s->z, s->g);
    if (status != PDMC_OK) return status;
    for (int k = 0; k < batch; k++) count_in(s, &s->z[(size_t)k * (size_t)n], s->g[k]);
    s->taken += batch;
    return PDMC_OK;
}

/// The most likely set that the mixture samples with a probability of no more than `share`: centre j alone samples it with no
/// more than centres * share, and by Neyman and Pearson no such set is likelier than a half-space across c_j.
static double most_probable(const sampling *s, double share)
{
    double most = 1.0;
    for (int j = 0; j < s->centres; j++) {
        const double q = fmin(1.0, s->centres * share);
        if (q < 1.0) most = fmin(most, gsl_cdf_ugaussian_P(sqrt(2.0 * s->half_square[j]) + gsl_cdf_ugaussian_Pinv(q)));
    }
    return most;
}

static bool settled(const sampling *s)
{
    return pdmc_average_variation(&s->events) <= s->options->variation &&
           pdmc_average_largest_share(&s->events) <= heaviest_share;
}

static void report(const sampling *s, pdmc_reliability *result)
{
    const double confidence = s->options->confidence;
    *result = (pdmc_reliability){.evaluations = s->taken, .failed = s->failed, .reached = s->events.positive > 0};
    pdmc_average_report(&s->events, &s->possible, confidence, result);
    if (result->effective_samples < few) {
        const size_t seen = (size_t)s->possible.positive;
        const double share = pdmc_statistics_proportion(seen, (size_t)s->taken, confidence).upper;
        result->probability.lower = 0.0;
        result->probability.upper = most_probable(s, share);
    }
    result->index = pdmc_reliability_index(result->probability);
    result->converged = settled(s);
}

static pdmc_status check(const pdmc_limit_state *limit, int centres, const pdmc_importance_options *o)
{
    PDMC_REQUIRE(limit->dimension >= 1, "dimension = %d is not positive", limit->dimension);
    PDMC_REQUIRE(centres >= 1, "%d centres", centres);
    PDMC_REQUIRE(o->confidence > 0.0 && o->confidence < 1.0, "confidence = %g not in (0, 1)", o->confidence);
    PDMC_REQUIRE(o->variation > 0.0, "coefficient of variation = %g is not positive", o->variation);
    PDMC_REQUIRE(o->batch >= 3, "batches of %d samples", o->batch);
    PDMC_REQUIRE(o->most_evaluations >= o->batch, "%ld evaluations are no batch of %d", o->most_evaluations, o->batch);
    return PDMC_OK;
}

pdmc_status pdmc_importance_sampling(const pdmc_limit_state *limit, int centres, const double centre[],
                                     const pdmc_importance_options *options, pdmc_reliability *result)
{
    pdmc_status status = check(limit, centres, options);
    if (status != PDMC_OK) return status;
    const int n = limit->dimension;
    sampling s = {.limit = limit, .options = options, .centres = centres, .centre = centre};
    PDMC_NEW(s.half_square, centres);
    PDMC_NEW(s.z, (size_t)options->batch * (size_t)n);
    PDMC_NEW(s.g, options->batch);
    for (int j = 0; j < centres; j++) s.half_square[j] = 0.5 * cblas_ddot(n, &centre[j * n], 1, &centre[j * n], 1);
    do PDMC_TRY(take_batch(&s));
    while (!settled(&s) && s.taken + options->batch <= options->most_evaluations);
    report(&s, result);

done:
    pdmc_free(s.g);
    pdmc_free(s.z);
    pdmc_free(s.half_square);
    return status;
}
