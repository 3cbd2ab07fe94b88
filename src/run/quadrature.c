// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/quadrature.h"

#include "base/base_impl.h"

#include <gsl/gsl_fit.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { MOST_REPEATS = 20 };
static const double shortest_time = 0.005; // s, of all repeats, of which the fastest counts

static pdmc_status prepare(const pdmc_horizon_study *study, pdmc_quadrature_record *record)
{
    pdmc_status status = PDMC_OK;
    const size_t ratios = (size_t)study->ratio_count, cells = PDMC_HORIZON_RULES * ratios;
    record->dimension = study->dimension;
    record->horizon = study->horizon;
    record->state_count = study->integral == PDMC_INTEGRAL_STRESS;
    PDMC_NEW(record->rules, PDMC_HORIZON_RULES);
    PDMC_NEW(record->ratio, ratios);
    PDMC_NEW(record->error, cells);
    PDMC_NEW(record->points, cells);
    PDMC_NEW(record->distance, cells);
    PDMC_NEW(record->seconds, cells);
    PDMC_NEW(record->stress, 9 * cells);
    PDMC_NEW(record->exact_stress, 9);
    record->rule_count = PDMC_HORIZON_RULES;
    record->ratio_count = study->ratio_count;
    memcpy(record->ratio, study->ratios, ratios * sizeof *record->ratio);
    for (int r = 0; r < PDMC_HORIZON_RULES; r++)
        snprintf(record->rules[r].name, sizeof record->rules[r].name, "%s", pdmc_horizon_rule_names[r]);
    pdmc_horizon_study_stress(study, record->exact_stress);
done:
    return status;
}

static pdmc_status measure(const pdmc_horizon_study *study, int rule, int ratio, pdmc_quadrature_record *record)
{
    const size_t at = (size_t)(rule * record->ratio_count + ratio);
    double fastest = INFINITY, total = 0.0;
    pdmc_horizon_outcome outcome;
    for (int i = 0; i < MOST_REPEATS && total < shortest_time; i++) {
        const double start = pdmc_seconds();
        const pdmc_status status = pdmc_horizon_study_measure(study, rule, record->ratio[ratio], &outcome);
        if (status != PDMC_OK) return status;
        const double seconds = pdmc_seconds() - start;
        fastest = fmin(fastest, seconds);
        total += seconds;
    }
    record->error[at] = outcome.error;
    record->points[at] = outcome.points;
    record->distance[at] = outcome.distance;
    record->seconds[at] = fastest;
    memcpy(&record->stress[9 * at], outcome.stress, sizeof outcome.stress);
    return PDMC_OK;
}

/// The slope of log |error| over log x; NaN where errors are rounding.
static double order(int count, const double x[], const double error[])
{
    double constant, slope, c00, c01, c11, sum, logs[2][128];
    for (int i = 0; i < count; i++) {
        if (!(fabs(error[i]) > 1e-12)) return NAN;
        logs[0][i] = log(x[i]);
        logs[1][i] = log(fabs(error[i]));
    }
    gsl_fit_linear(logs[0], 1, logs[1], 1, (size_t)count, &constant, &slope, &c00, &c01, &c11, &sum);
    return slope;
}

static void find_orders(pdmc_quadrature_record *record)
{
    for (int r = 0; r < record->rule_count; r++) {
        const int n = record->ratio_count;
        record->rules[r].spacing_order = -order(n, record->ratio, &record->error[r * n]);
        record->rules[r].distance_order = order(n, &record->distance[r * n], &record->error[r * n]);
    }
}

pdmc_status pdmc_run_quadrature(const pdmc_horizon_study *study, const pdmc_run_options *options, pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    pdmc_quadrature_record *record = &results->quadrature;
    const int total = PDMC_HORIZON_RULES * study->ratio_count;
    const double start = pdmc_seconds();
    PDMC_TRY(prepare(study, record));
    for (int i = 0; i <= total; i++) {
        if (options->progress && !options->progress(options->context, i, total) && i < total)
            PDMC_FAIL(PDMC_ERR_INTERRUPTED, "stopped before all rules were measured: there is nothing to save");
        if (i < total) PDMC_TRY(measure(study, i / study->ratio_count, i % study->ratio_count, record));
    }
    find_orders(record);
    results->runtime.motion = pdmc_seconds() - start;
    results->runtime.threads = 1;
done:
    return status;
}
