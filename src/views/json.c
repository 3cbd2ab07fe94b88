// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/json_parts.h"

typedef double pdmc_part(const pdmc_estimate *);
static double value_of(const pdmc_estimate *e)
{
    return e->value;
}
static double lower_of(const pdmc_estimate *e)
{
    return e->lower;
}
static double upper_of(const pdmc_estimate *e)
{
    return e->upper;
}

/// One part of every `stride`-th estimate.
static json_t *parts(size_t count, size_t stride, const pdmc_estimate x[], pdmc_part *part)
{
    json_t *array = json_array();
    for (size_t i = 0; i < count; i++) pdmc_json_append(&array, pdmc_json_number(part(&x[i * stride])));
    return array;
}

static json_t *intervals(size_t count, size_t stride, const pdmc_estimate x[])
{
    json_t *array = json_array();
    for (size_t i = 0; i < count; i++)
        pdmc_json_append(&array, pdmc_json_numbers(2, (const double[]){x[i * stride].lower, x[i * stride].upper}));
    return array;
}

static json_t *energy(const pdmc_results *r, int tip, const pdmc_energy_statistics *s)
{
    const size_t count = (size_t)r->angle_count, at = pdmc_place(r, tip, 0);
    json_t *object = json_object(), *values = json_object(), *bounds = json_object();
    pdmc_json_put(&object, "mean", parts(count, 1, &s->mean[at], value_of));
    pdmc_json_put(&object, "mean_interval", intervals(count, 1, &s->mean[at]));
    pdmc_json_put(&object, "standard_deviation", parts(count, 1, &s->standard_deviation[at], value_of));
    pdmc_json_put(&object, "standard_deviation_interval", intervals(count, 1, &s->standard_deviation[at]));
    for (size_t q = 0; q < PDMC_QUANTILES; q++) {
        char level[16];
        snprintf(level, sizeof level, "%.2f", pdmc_quantile_levels[q]);
        pdmc_json_put(&values, level, parts(count, PDMC_QUANTILES, &s->quantiles[at * PDMC_QUANTILES + q], value_of));
        pdmc_json_put(&bounds, level, intervals(count, PDMC_QUANTILES, &s->quantiles[at * PDMC_QUANTILES + q]));
    }
    pdmc_json_put(&object, "quantiles", values);
    pdmc_json_put(&object, "quantile_intervals", bounds);
    return object;
}

static json_t *nominal(const pdmc_results *r, int tip)
{
    const size_t count = (size_t)r->angle_count, at = pdmc_place(r, tip, 0);
    const pdmc_tip *t = &r->tips[tip];
    json_t *object = json_object();
    pdmc_json_put(&object, "K_I", pdmc_json_number(t->stress_intensity[0]));
    pdmc_json_put(&object, "K_II", pdmc_json_number(t->stress_intensity[1]));
    pdmc_json_put(&object, "T", pdmc_json_number(t->t_stress));
    pdmc_json_put(&object, "K_I_error", pdmc_json_number(t->stress_intensity_error[0]));
    pdmc_json_put(&object, "K_II_error", pdmc_json_number(t->stress_intensity_error[1]));
    pdmc_json_put(&object, "T_error", pdmc_json_number(t->t_stress_error));
    pdmc_json_put(&object, "bond_energy", pdmc_json_numbers(count, &r->nominal_bond_energy[at]));
    pdmc_json_put(&object, "bond_energy_tensile", pdmc_json_numbers(count, &r->nominal_bond_energy_tensile[at]));
    pdmc_json_put(&object, "griffith_energy", pdmc_json_numbers(count, &r->nominal_griffith_energy[at]));
    return object;
}

static json_t *direction(const pdmc_results *r, int tip)
{
    const size_t count = (size_t)r->angle_count;
    const pdmc_estimate *share = &r->direction[pdmc_place(r, tip, 0)];
    json_t *object = json_object();
    pdmc_json_put(&object, "measure", pdmc_json_text(pdmc_measure_names[r->measure]));
    pdmc_json_put(&object, "probability", parts(count, 1, share, value_of));
    pdmc_json_put(&object, "lower", parts(count, 1, share, lower_of));
    pdmc_json_put(&object, "upper", parts(count, 1, share, upper_of));
    return object;
}

static json_t *controlled(const pdmc_results *r, int tip)
{
    const size_t count = (size_t)r->angle_count, at = pdmc_place(r, tip, 0);
    const pdmc_control_results *c = &r->control;
    json_t *object = json_object();
    pdmc_json_put(&object, "measure", pdmc_json_text(pdmc_measure_names[r->measure]));
    pdmc_json_put(&object, "probability", pdmc_json_estimate(&c->probability[tip]));
    pdmc_json_put(&object, "probability_gain", pdmc_json_number(c->probability_gain[tip]));
    pdmc_json_put(&object, "mean", parts(count, 1, &c->mean[at], value_of));
    pdmc_json_put(&object, "mean_interval", intervals(count, 1, &c->mean[at]));
    pdmc_json_put(&object, "mean_gain", pdmc_json_numbers(count, &c->mean_gain[at]));
    pdmc_json_put(&object, "correlation", pdmc_json_numbers(count, &c->correlation[at]));
    return object;
}

static json_t *control(const pdmc_control_results *c)
{
    json_t *object = json_object();
    pdmc_json_put(&object, "samples", pdmc_json_number(c->samples));
    pdmc_json_put(&object, "failed", pdmc_json_number(c->failed));
    pdmc_json_put(&object, "advised_samples", pdmc_json_number(c->advised_samples));
    return object;
}

static json_t *tips(const pdmc_results *r)
{
    json_t *array = json_array();
    for (int t = 0; t < r->tip_count; t++) {
        json_t *object = json_object();
        pdmc_json_put(&object, "name", pdmc_json_text(r->tips[t].name));
        pdmc_json_put(&object, "position", pdmc_json_numbers(2, r->tips[t].position));
        pdmc_json_put(&object, "straight_ahead", pdmc_json_number(r->tips[t].direction));
        pdmc_json_put(&object, "nominal", nominal(r, t));
        pdmc_json_put(&object, "angles", pdmc_json_numbers((size_t)r->angle_count, r->angles));
        for (int m = 0; m < PDMC_MEASURES; m++)
            pdmc_json_put(&object, pdmc_measure_names[m], energy(r, t, &r->statistics[m]));
        pdmc_json_put(&object, "direction", direction(r, t));
        pdmc_json_put(&object, "probability", pdmc_json_estimate(&r->probability[t]));
        if (r->conditional_probability)
            pdmc_json_put(&object, "conditional_probability", pdmc_json_estimate(&r->conditional_probability[t]));
        if (r->control.tip_count > 0) pdmc_json_put(&object, "controlled", controlled(r, t));
        pdmc_json_append(&array, object);
    }
    return array;
}

static json_t *probe(const pdmc_motion_record *m, int p)
{
    json_t *object = json_object(), *x = json_array(), *y = json_array();
    pdmc_json_put(&object, "name", pdmc_json_text(m->probes[p].name));
    pdmc_json_put(&object, "position", pdmc_json_numbers(2, m->probes[p].position));
    pdmc_json_put(&object, "side", pdmc_json_text(pdmc_face_name(m->probes[p].face)));
    for (int i = 0; i < m->time_count; i++) {
        pdmc_json_append(&x, pdmc_json_number(pdmc_probe_displacement(m, i, p)[0]));
        pdmc_json_append(&y, pdmc_json_number(pdmc_probe_displacement(m, i, p)[1]));
    }
    pdmc_json_put(&object, "x", x);
    pdmc_json_put(&object, "y", y);
    return object;
}

static json_t *motion(const pdmc_results *r)
{
    const pdmc_motion_record *m = &r->motion;
    const size_t count = (size_t)m->time_count;
    json_t *object = json_object(), *probes = json_array();
    pdmc_json_put(&object, "time", pdmc_json_numbers(count, m->time));
    pdmc_json_put(&object, "load_factor", pdmc_json_numbers(count, m->load_factor));
    pdmc_json_put(&object, "kinetic", pdmc_json_numbers(count, m->kinetic));
    pdmc_json_put(&object, "elastic", pdmc_json_numbers(count, m->elastic));
    pdmc_json_put(&object, "dissipated", pdmc_json_numbers(count, m->dissipated));
    pdmc_json_put(&object, "work", pdmc_json_numbers(count, m->work));
    pdmc_json_put(&object, "balance_error", pdmc_json_number(pdmc_balance_error(m)));
    for (int p = 0; p < m->probe_count; p++) pdmc_json_append(&probes, probe(m, p));
    pdmc_json_put(&object, "probes", probes);
    return object;
}

static json_t *model_error(const pdmc_sample_accuracy *a, int measure)
{
    json_t *object = json_object();
    pdmc_json_put(&object, "mean", pdmc_json_number(a->mean_error[measure]));
    for (int q = 0; q < PDMC_QUANTILES; q++) {
        char key[16];
        snprintf(key, sizeof key, "%.2f", pdmc_quantile_levels[q]);
        pdmc_json_put(&object, key, pdmc_json_number(a->quantile_error[measure][q]));
    }
    return object;
}

// null where the inverse has no such figure.
static json_t *accuracy(const pdmc_sample_accuracy *a)
{
    json_t *object = json_object();
    pdmc_json_put(&object, "iteration_residual", pdmc_json_number(a->iteration_residual));
    pdmc_json_put(&object, "reduced_unknowns", pdmc_json_number(a->reduced_unknowns));
    for (int m = 0; m < PDMC_MEASURES; m++) {
        char key[64];
        snprintf(key, sizeof key, "%s_error", pdmc_measure_names[m]);
        pdmc_json_put(&object, key, pdmc_json_number(a->energy_error[m]));
        snprintf(key, sizeof key, "%s_typical_error", pdmc_measure_names[m]);
        pdmc_json_put(&object, key, pdmc_json_number(a->typical_error[m]));
        snprintf(key, sizeof key, "%s_model_error", pdmc_measure_names[m]);
        pdmc_json_put(&object, key, model_error(a, m));
    }
    pdmc_json_put(&object, "solved_in_full", pdmc_json_number(a->solved_in_full));
    return object;
}

static json_t *solver(const pdmc_solver_report *s)
{
    json_t *object = json_object();
    pdmc_json_put(&object, "nodes", json_integer(s->nodes));
    pdmc_json_put(&object, "unknowns", json_integer(s->unknowns));
    pdmc_json_put(&object, "rows", json_integer(s->rows));
    pdmc_json_put(&object, "rank", json_integer(s->rank));
    pdmc_json_put(&object, "condition", pdmc_json_number(s->condition));
    pdmc_json_put(&object, "residual", pdmc_json_number(s->residual));
    pdmc_json_put(&object, "horizon", pdmc_json_number(s->horizon));
    pdmc_json_put(&object, "spacing", pdmc_json_number(s->spacing));
    return object;
}

static void put_samples(const pdmc_results *r, json_t **object)
{
    pdmc_json_put(object, "samples", json_integer(r->sample_count));
    pdmc_json_put(object, "kept", json_integer(r->kept_count));
    pdmc_json_put(object, "failed", json_integer(r->failed_count));
    pdmc_json_put(object, "seed", pdmc_json_seed(r->seed));
    pdmc_json_put(object, "measure", pdmc_json_text(pdmc_measure_names[r->measure]));
    pdmc_json_put(object, "bonds", pdmc_json_text(r->bonds == PDMC_BONDS_ALL ? "all" : "tensile"));
    pdmc_json_put(object, "fracture_energy", pdmc_json_number(r->fracture_energy));
}

static void put_plate(const pdmc_results *r, json_t **object)
{
    pdmc_json_put(object, "confidence", pdmc_json_number(r->confidence));
    pdmc_json_put(object, "tips", tips(r));
    if (r->kind == PDMC_DYNAMIC) pdmc_json_put(object, "motion", motion(r));
    pdmc_json_put(object, "solver", solver(&r->solver));
    if (r->reliability.group_count > 0) pdmc_json_put(object, "reliability", pdmc_json_reliability(&r->reliability));
    if (r->control.tip_count > 0) pdmc_json_put(object, "control", control(&r->control));
    if (r->kind == PDMC_STATIC) pdmc_json_put(object, "accuracy", accuracy(&r->accuracy));
}

static json_t *everything(const pdmc_results *r)
{
    static const char *const kinds[] = {
        [PDMC_STATIC] = "static",
        [PDMC_DYNAMIC] = "dynamic",
        [PDMC_EXPLICIT] = "explicit",
        [PDMC_QUASI_STATIC] = "quasi_static",
        [PDMC_SCALAR] = "scalar",
        [PDMC_ELASTIC] = "elastic",
        [PDMC_QUADRATURE] = "quadrature"};
    json_t *object = json_object();
    pdmc_json_put(&object, "kind", pdmc_json_text(kinds[r->kind]));
    pdmc_json_put(&object, "title", pdmc_json_text(r->title));
    pdmc_json_put(&object, "date_and_time", pdmc_json_text(r->date_and_time));
    pdmc_json_put(&object, "pdmc_version", pdmc_json_text(r->pdmc_version));
    pdmc_json_put(&object, "git_sha1", pdmc_json_text(r->git_sha1));
    if (r->mesh_generator && *r->mesh_generator)
        pdmc_json_put(&object, "mesh_generator", pdmc_json_text(r->mesh_generator));
    pdmc_json_put(&object, "status", pdmc_json_text(pdmc_run_status_names[r->status]));
    if (pdmc_is_of_plate(r->kind)) put_samples(r, &object);
    pdmc_json_put(&object, "units", pdmc_json_units(r));
    if (pdmc_is_of_plate(r->kind)) put_plate(r, &object);
    if (pdmc_is_of_bodies(r->kind)) pdmc_json_put(&object, kinds[r->kind], pdmc_json_explicit(&r->particles));
    if (r->kind == PDMC_ELASTIC) pdmc_json_put(&object, "elastic", pdmc_json_elastic(&r->elastic));
    if (r->ensemble.sample_count > 0) pdmc_json_put(&object, "ensemble", pdmc_json_ensemble(r));
    if (r->kind == PDMC_SCALAR) pdmc_json_put(&object, "scalar", pdmc_json_scalar(&r->scalar));
    if (r->kind == PDMC_QUADRATURE) pdmc_json_put(&object, "quadrature", pdmc_json_quadrature(&r->quadrature));
    pdmc_json_put(&object, "runtime", pdmc_json_runtime(&r->runtime));
    return object;
}

pdmc_status pdmc_view_json(const pdmc_results *results, FILE *stream)
{
    return pdmc_json_print(everything(results), stream);
}
