// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/json_parts.h"

/// A column of an array [samples, columns].
static json_t *column(const pdmc_ensemble_results *e, const double values[], int columns, int at)
{
    json_t *array = json_array();
    for (int s = 0; s < e->sample_count; s++)
        pdmc_json_append(&array, pdmc_json_number(values[(size_t)s * (size_t)columns + (size_t)at]));
    return array;
}

static json_t *estimates(int count, int stride, const pdmc_estimate values[])
{
    json_t *array = json_array();
    for (int i = 0; i < count; i++) pdmc_json_append(&array, pdmc_json_estimate(&values[i * stride]));
    return array;
}

static json_t *outcomes(const pdmc_ensemble_results *e, int t)
{
    json_t *array = json_array();
    for (int s = 0; s < e->sample_count; s++) {
        const bool is_solved = e->failure[s] == PDMC_SAMPLE_OK;
        pdmc_json_append(&array, is_solved ? pdmc_json_text(pdmc_outcome_names[e->outcome[s * e->tip_count + t]])
                                           : json_null());
    }
    return array;
}

static json_t *samples(const pdmc_ensemble_results *e, int t)
{
    const int tips = e->tip_count;
    json_t *object = json_object();
    pdmc_json_put(&object, "outcome", outcomes(e, t));
    pdmc_json_put(&object, "growth", column(e, e->growth, tips, t));
    pdmc_json_put(&object, "begin", column(e, e->begin, tips, t));
    pdmc_json_put(&object, "mean_speed", column(e, e->mean_speed, tips, t));
    pdmc_json_put(&object, "most_speed", column(e, e->most_speed, tips, t));
    pdmc_json_put(&object, "end_x", column(e, e->end, 2 * tips, 2 * t));
    pdmc_json_put(&object, "end_y", column(e, e->end, 2 * tips, 2 * t + 1));
    return object;
}

static json_t *path(const pdmc_ensemble_results *e, int t)
{
    static const char *const names[PDMC_QUANTILES] = {"low", "median", "high"};
    const size_t first = (size_t)t * (size_t)e->station_count;
    json_t *object = json_object();
    pdmc_json_put(&object, "samples", pdmc_json_numbers((size_t)e->station_count, &e->path_samples[first]));
    pdmc_json_put(&object, "mean", estimates(e->station_count, 1, &e->path_mean[first]));
    for (size_t q = 0; q < PDMC_QUANTILES; q++)
        pdmc_json_put(&object, names[q],
                      estimates(e->station_count, PDMC_QUANTILES, &e->path_quantiles[first * PDMC_QUANTILES + q]));
    return object;
}

static json_t *tip(const pdmc_results *r, int t)
{
    const pdmc_ensemble_results *e = &r->ensemble;
    json_t *object = json_object(), *share = json_object();
    for (int k = 0; k < PDMC_OUTCOMES; k++)
        pdmc_json_put(&share, pdmc_outcome_names[k], pdmc_json_estimate(&e->share[t * PDMC_OUTCOMES + k]));
    pdmc_json_put(&object, "name", pdmc_json_text(r->particles.tips[t].name));
    pdmc_json_put(&object, "probability", share);
    pdmc_json_put(&object, "mean_growth", pdmc_json_estimate(&e->mean_growth[t]));
    pdmc_json_put(&object, "deviation", pdmc_json_estimate(&e->deviation[t]));
    pdmc_json_put(&object, "quantiles", estimates(PDMC_QUANTILES, 1, &e->growth_quantiles[t * PDMC_QUANTILES]));
    pdmc_json_put(&object, "samples", samples(e, t));
    pdmc_json_put(&object, "path", path(e, t));
    return object;
}

static json_t *condition(const pdmc_results *r, int c)
{
    const pdmc_ensemble_results *e = &r->ensemble;
    json_t *object = json_object();
    pdmc_json_put(&object, "name", pdmc_json_text(r->particles.conditions[c].name));
    pdmc_json_put(&object, "mean_largest_force", pdmc_json_estimate(&e->mean_force[c]));
    pdmc_json_put(&object, "deviation", pdmc_json_estimate(&e->force_deviation[c]));
    pdmc_json_put(&object, "quantiles", estimates(PDMC_QUANTILES, 1, &e->force_quantiles[c * PDMC_QUANTILES]));
    pdmc_json_put(&object, "largest_force", column(e, e->largest_force, e->condition_count, c));
    pdmc_json_put(&object, "load_of_largest_force", column(e, e->load_of_force, e->condition_count, c));
    return object;
}

json_t *pdmc_json_ensemble(const pdmc_results *r)
{
    const pdmc_ensemble_results *e = &r->ensemble;
    json_t *object = json_object(), *tips = json_array(), *conditions = json_array();
    pdmc_json_put(&object, "samples", json_integer(e->sample_count));
    pdmc_json_put(&object, "failed", json_integer(e->failed_count));
    pdmc_json_put(&object, "seed", pdmc_json_seed(r->seed));
    pdmc_json_put(&object, "confidence", pdmc_json_number(r->confidence));
    pdmc_json_put(&object, "load", column(e, e->load, 1, 0));
    pdmc_json_put(&object, "velocity", column(e, e->velocity, 1, 0));
    pdmc_json_put(&object, "youngs_modulus", column(e, e->youngs_modulus, 1, 0));
    pdmc_json_put(&object, "fracture_energy", column(e, e->fracture_energy, 1, 0));
    pdmc_json_put(&object, "fracture", column(e, e->fracture, 1, 0));
    pdmc_json_put(&object, "stations", pdmc_json_numbers((size_t)e->station_count, e->station));
    for (int t = 0; t < e->tip_count; t++) pdmc_json_append(&tips, tip(r, t));
    pdmc_json_put(&object, "tips", tips);
    for (int c = 0; c < e->condition_count; c++) pdmc_json_append(&conditions, condition(r, c));
    if (e->condition_count > 0) pdmc_json_put(&object, "conditions", conditions);
    else json_decref(conditions);
    return object;
}
