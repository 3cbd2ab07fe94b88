// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/comparison.h"
#include "views/json_parts.h"

static json_t *study(const pdmc_comparison *c, int which)
{
    const pdmc_results *r = c->results[which];
    json_t *object = json_object();
    pdmc_json_put(&object, "file", pdmc_json_text(c->labels[which]));
    pdmc_json_put(&object, "title", pdmc_json_text(r->title));
    pdmc_json_put(&object, "method", *c->method[which] ? pdmc_json_text(c->method[which]) : json_null());
    pdmc_json_put(&object, "status", pdmc_json_text(pdmc_run_status_names[r->status]));
    pdmc_json_put(&object, "seed", pdmc_json_seed(r->seed));
    pdmc_json_put(&object, "samples", json_integer(r->sample_count));
    pdmc_json_put(&object, "failed", json_integer(r->failed_count));
    pdmc_json_put(&object, "measure", pdmc_json_text(pdmc_measure_names[r->measure]));
    pdmc_json_put(&object, "fracture_energy", pdmc_json_number(r->fracture_energy));
    pdmc_json_put(&object, "nodes", json_integer(r->solver.nodes));
    pdmc_json_put(&object, "spacing", pdmc_json_number(r->solver.spacing));
    pdmc_json_put(&object, "horizon", pdmc_json_number(r->solver.horizon));
    pdmc_json_put(&object, "runtime", pdmc_json_runtime(&r->runtime));
    return object;
}

/// What one of the two says of a tip.
static json_t *tip_of(const pdmc_comparison *c, const pdmc_compared_tip *tip, int which)
{
    const pdmc_results *r = c->results[which];
    const pdmc_tip *t = &r->tips[tip->number[which]];
    const int best = pdmc_compared_direction(c, tip, which);
    double value, error;
    json_t *object = json_object();
    pdmc_compared_griffith(c, tip, which, &value, &error);
    pdmc_json_put(&object, "K_I", pdmc_json_number(t->stress_intensity[0]));
    pdmc_json_put(&object, "K_I_error", pdmc_json_number(t->stress_intensity_error[0]));
    pdmc_json_put(&object, "K_II", pdmc_json_number(t->stress_intensity[1]));
    pdmc_json_put(&object, "K_II_error", pdmc_json_number(t->stress_intensity_error[1]));
    pdmc_json_put(&object, "T", pdmc_json_number(t->t_stress));
    pdmc_json_put(&object, "T_error", pdmc_json_number(t->t_stress_error));
    pdmc_json_put(&object, "G", pdmc_json_number(value));
    pdmc_json_put(&object, "G_error", pdmc_json_number(error));
    pdmc_json_put(&object, "probability", pdmc_json_estimate(&r->probability[tip->number[which]]));
    if (best < 0) return object;
    pdmc_json_put(&object, "direction", pdmc_json_number(r->angles[best]));
    pdmc_json_put(&object, "direction_share",
                  pdmc_json_estimate(&r->direction[pdmc_place(r, tip->number[which], best)]));
    return object;
}

static json_t *energy_of(const pdmc_comparison *c, const pdmc_compared_angle *angle, int which)
{
    const pdmc_energy_statistics *s = &c->results[which]->statistics[c->measure];
    const pdmc_estimate *mean = &s->mean[angle->place[which]], *deviation = &s->standard_deviation[angle->place[which]];
    json_t *object = json_object();
    pdmc_json_put(&object, "nominal", pdmc_json_number(pdmc_compared_nominal(c, angle, which)));
    pdmc_json_put(&object, "mean", pdmc_json_estimate(mean));
    pdmc_json_put(&object, "standard_deviation", pdmc_json_estimate(deviation));
    pdmc_json_put(&object, "coefficient_of_variation", pdmc_json_number(deviation->value / mean->value));
    return object;
}

static json_t *pairs(const pdmc_compared_angle *angle)
{
    json_t *object = json_object();
    pdmc_json_put(&object, "count", json_integer((json_int_t)angle->pairs.count));
    pdmc_json_put(&object, "correlation", pdmc_json_estimate(&angle->pairs.correlation));
    pdmc_json_put(&object, "relative_difference", pdmc_json_estimate(&angle->pairs.difference));
    pdmc_json_put(&object, "largest_relative_difference", pdmc_json_number(angle->pairs.largest_difference));
    pdmc_json_put(&object, "largest_sample", json_integer(angle->largest_sample));
    return object;
}

static json_t *compared(const pdmc_comparison *c, const pdmc_compared_angle *angle)
{
    json_t *object = json_object();
    pdmc_json_put(&object, "angle", pdmc_json_number(angle->angle));
    pdmc_json_put(&object, "a", energy_of(c, angle, 0));
    pdmc_json_put(&object, "b", energy_of(c, angle, 1));
    pdmc_json_put(&object, "difference_of_means", pdmc_json_estimate(&angle->difference));
    pdmc_json_put(&object, "ratio_of_means", pdmc_json_estimate(&angle->ratio));
    pdmc_json_put(&object, "kolmogorov_smirnov", pdmc_json_estimate(&angle->distances.kolmogorov_smirnov));
    pdmc_json_put(&object, "p_value", pdmc_json_number(angle->distances.p_value));
    pdmc_json_put(&object, "wasserstein", pdmc_json_estimate(&angle->distances.wasserstein));
    pdmc_json_put(&object, "pairs", c->paired ? pairs(angle) : json_null());
    return object;
}

static json_t *tips(const pdmc_comparison *c)
{
    json_t *array = json_array();
    for (int t = 0; t < c->tip_count; t++) {
        const pdmc_compared_tip *tip = &c->tips[t];
        json_t *object = json_object(), *angles = json_array();
        for (int k = 0; k < tip->angle_count; k++) pdmc_json_append(&angles, compared(c, &tip->angles[k]));
        pdmc_json_put(&object, "name", pdmc_json_text(pdmc_compared_name(c, tip)));
        pdmc_json_put(&object, "a", tip_of(c, tip, 0));
        pdmc_json_put(&object, "b", tip_of(c, tip, 1));
        pdmc_json_put(&object, "angles", angles);
        pdmc_json_append(&array, object);
    }
    return array;
}

static json_t *everything(const pdmc_comparison *c)
{
    json_t *object = json_object();
    pdmc_json_put(&object, "a", study(c, 0));
    pdmc_json_put(&object, "b", study(c, 1));
    pdmc_json_put(&object, "units", pdmc_json_units(c->results[0]));
    pdmc_json_put(&object, "confidence", pdmc_json_number(c->results[0]->confidence));
    pdmc_json_put(&object, "measure", pdmc_json_text(pdmc_measure_names[c->measure]));
    pdmc_json_put(&object, "paired", json_boolean(c->paired));
    pdmc_json_put(&object, "same_load_factors", json_boolean(c->same_load));
    pdmc_json_put(&object, "same_micromodulus", json_boolean(c->same_micromodulus));
    pdmc_json_put(&object, "tips", tips(c));
    pdmc_json_put(&object, "notes", pdmc_json_text(c->notes));
    return object;
}

pdmc_status pdmc_view_comparison_json(const pdmc_comparison *comparison, FILE *stream)
{
    return pdmc_json_print(everything(comparison), stream);
}
