// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "pdmc/reliability.h"
#include "reliability/normals.h"

#include <math.h>

enum { POINTS = 8192 }; // evaluated at once, or one row's

typedef struct {
    const pdmc_limit_state *output;
    const pdmc_sensitivity_options *options;
    int groups;
    const int *group; // [dimension]
    double *z;        // [rows at once, groups + 2, dimension] A, B, then A with a group's variables from B
    double *f;        // [samples, groups + 2] the output of these; then less its mean
    int samples;      // rows of f without a NaN
} design;

pdmc_sensitivity_options pdmc_sensitivity_options_default(void)
{
    return (pdmc_sensitivity_options){.seed = 1, .confidence = 0.95, .samples = 10000};
}

static int rows_at_once(const design *p)
{
    const int rows = POINTS / (p->groups + 2), most = p->options->samples;
    return rows < 1 ? 1 : rows < most ? rows : most;
}

static void draw_row(const design *p, int sample, double z[])
{
    const int n = p->output->dimension;
    pdmc_random_normal(p->options->seed, PDMC_STREAM_SENSITIVITY, (uint64_t)sample, 0, 2 * n, z);
    for (int k = 0; k < p->groups; k++)
        for (int i = 0; i < n; i++) z[(k + 2) * n + i] = p->group[i] == k ? z[n + i] : z[i];
}

static pdmc_status evaluate(design *p)
{
    const int points = p->groups + 2, rows = rows_at_once(p);
    const size_t row = (size_t)points * (size_t)p->output->dimension;
    pdmc_status status = PDMC_OK;
    for (int first = 0; first < p->options->samples && status == PDMC_OK; first += rows) {
        const int left = p->options->samples - first, count = left < rows ? left : rows;
        for (int k = 0; k < count; k++) draw_row(p, first + k, &p->z[(size_t)k * row]);
        status = p->output->evaluate(p->output->context, count * points, p->z, &p->f[(size_t)first * (size_t)points]);
    }
    return status;
}

/// Moves the rows without a NaN together, and counts the failed points.
static long drop_failed(design *p)
{
    const int points = p->groups + 2;
    long failed = 0;
    p->samples = 0;
    for (int j = 0; j < p->options->samples; j++) {
        const double *from = &p->f[(size_t)j * (size_t)points];
        double *to = &p->f[(size_t)p->samples * (size_t)points];
        int unsolved = 0;
        for (int k = 0; k < points; k++) unsolved += isnan(from[k]);
        for (int k = 0; k < points && unsolved == 0; k++) to[k] = from[k];
        p->samples += unsolved == 0;
        failed += unsolved;
    }
    return failed;
}

/// Without the mean, the products of the first-order estimate have the least noise.
static void centre(design *p)
{
    const int points = p->groups + 2;
    double sum = 0.0;
    for (int j = 0; j < p->samples; j++) sum += p->f[(size_t)j * (size_t)points] + p->f[(size_t)j * (size_t)points + 1];
    const double mean = sum / (2.0 * p->samples);
    for (size_t k = 0; k < (size_t)p->samples * (size_t)points; k++) p->f[k] -= mean;
}

/// The two indices of a group as ratios of means over the rows.
/// @param[out] variance, first, total  [samples] for each row
static void indices(const design *p, int k, double variance[], double first[], double total[],
                    pdmc_sensitivity *sensitivity)
{
    const size_t count = (size_t)p->samples;
    const double confidence = p->options->confidence;
    pdmc_estimate difference;
    for (int j = 0; j < p->samples; j++) {
        const double *f = &p->f[(size_t)j * (size_t)(p->groups + 2)], mixed = f[k + 2];
        variance[j] = 0.5 * (f[0] * f[0] + f[1] * f[1]);
        first[j] = f[1] * (mixed - f[0]);
        total[j] = 0.5 * (f[0] - mixed) * (f[0] - mixed);
    }
    pdmc_statistics_means(count, variance, count, first, true, confidence, &difference, &sensitivity->first[k]);
    pdmc_statistics_means(count, variance, count, total, true, confidence, &difference, &sensitivity->total[k]);
}

static pdmc_status check(const pdmc_limit_state *output, int groups, const int group[],
                         const pdmc_sensitivity_options *o)
{
    PDMC_REQUIRE(output->dimension >= 1, "dimension = %d is not positive", output->dimension);
    PDMC_REQUIRE(groups >= 1, "%d groups", groups);
    PDMC_REQUIRE(o->confidence > 0.0 && o->confidence < 1.0, "confidence = %g not in (0, 1)", o->confidence);
    PDMC_REQUIRE(o->samples >= 2, "%d samples are less than 2", o->samples);
    for (int i = 0; i < output->dimension; i++)
        PDMC_REQUIRE(group[i] >= 0 && group[i] < groups, "group of variable %d = %d not in [0, %d)", i, group[i],
                     groups);
    return PDMC_OK;
}

static pdmc_status estimate(design *p, pdmc_sensitivity *sensitivity)
{
    pdmc_status status = PDMC_OK;
    double *row = NULL; // [3, samples]
    const size_t n = (size_t)p->options->samples, points = (size_t)p->groups + 2;
    PDMC_NEW(row, 3 * n);
    PDMC_NEW(p->f, n * points);
    PDMC_NEW(p->z, (size_t)rows_at_once(p) * points * (size_t)p->output->dimension);
    PDMC_TRY(evaluate(p));
    sensitivity->evaluations = (long)(n * points);
    sensitivity->failed = drop_failed(p);
    centre(p);
    for (int k = 0; k < p->groups; k++) indices(p, k, row, &row[n], &row[2 * n], sensitivity);

done:
    pdmc_free(p->z);
    pdmc_free(p->f);
    pdmc_free(row);
    return status;
}

pdmc_status pdmc_sensitivity_find(const pdmc_limit_state *output, int groups, const int group[],
                                  const pdmc_sensitivity_options *options, pdmc_sensitivity *sensitivity)
{
    *sensitivity = (pdmc_sensitivity){.groups = groups};
    pdmc_status status = check(output, groups, group, options);
    if (status != PDMC_OK) return status;
    design p = {.output = output, .options = options, .groups = groups, .group = group};
    PDMC_NEW(sensitivity->first, groups);
    PDMC_NEW(sensitivity->total, groups);
    PDMC_TRY(estimate(&p, sensitivity));

done:
    return status;
}

void pdmc_sensitivity_clear(pdmc_sensitivity *sensitivity)
{
    pdmc_free(sensitivity->first);
    pdmc_free(sensitivity->total);
    *sensitivity = (pdmc_sensitivity){0};
}
