// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "views/views_impl.h"

#include <jansson.h>
#include <math.h>
#include <string.h>

// Whatever is NULL for want of memory makes the object that takes it fail, and with it the whole.

/// Sets a key; an object without it becomes NULL.
static void put(json_t **object, const char *key, json_t *value)
{
    if (json_object_set_new(*object, key, value) == 0) return;
    json_decref(*object);
    *object = NULL;
}

static void append(json_t **array, json_t *value)
{
    if (json_array_append_new(*array, value) == 0) return;
    json_decref(*array);
    *array = NULL;
}

/// JSON has no NaN and no infinity.
static json_t *number(double x)
{
    return isfinite(x) ? json_real(x) : json_null();
}

/// A text that is not UTF-8 loses what is not ASCII.
static json_t *text(const char *bytes)
{
    json_t *value = json_string(bytes);
    char *copy = value ? NULL : pdmc_strdup(bytes);
    if (copy) {
        for (char *c = copy; *c; c++)
            if (*c & 0x80) *c = '?';
        value = json_string(copy);
    }
    pdmc_free(copy);
    return value;
}

static json_t *numbers(size_t count, const double x[])
{
    json_t *array = json_array();
    for (size_t i = 0; i < count; i++) append(&array, number(x[i]));
    return array;
}

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
    for (size_t i = 0; i < count; i++) append(&array, number(part(&x[i * stride])));
    return array;
}

static json_t *intervals(size_t count, size_t stride, const pdmc_estimate x[])
{
    json_t *array = json_array();
    for (size_t i = 0; i < count; i++)
        append(&array, numbers(2, (const double[]){x[i * stride].lower, x[i * stride].upper}));
    return array;
}

static json_t *energy(const pdmc_results *r, int tip, const pdmc_energy_statistics *s)
{
    const size_t count = (size_t)r->angle_count, at = pdmc_place(r, tip, 0);
    json_t *object = json_object(), *values = json_object(), *bounds = json_object();
    put(&object, "mean", parts(count, 1, &s->mean[at], value_of));
    put(&object, "mean_interval", intervals(count, 1, &s->mean[at]));
    put(&object, "standard_deviation", parts(count, 1, &s->standard_deviation[at], value_of));
    put(&object, "standard_deviation_interval", intervals(count, 1, &s->standard_deviation[at]));
    for (size_t q = 0; q < PDMC_QUANTILES; q++) {
        char level[16];
        snprintf(level, sizeof level, "%.2f", pdmc_quantile_levels[q]);
        put(&values, level, parts(count, PDMC_QUANTILES, &s->quantiles[at * PDMC_QUANTILES + q], value_of));
        put(&bounds, level, intervals(count, PDMC_QUANTILES, &s->quantiles[at * PDMC_QUANTILES + q]));
    }
    put(&object, "quantiles", values);
    put(&object, "quantile_intervals", bounds);
    return object;
}

static json_t *nominal(const pdmc_results *r, int tip)
{
    const size_t count = (size_t)r->angle_count, at = pdmc_place(r, tip, 0);
    const pdmc_tip *t = &r->tips[tip];
    json_t *object = json_object();
    put(&object, "K_I", number(t->stress_intensity[0]));
    put(&object, "K_II", number(t->stress_intensity[1]));
    put(&object, "T", number(t->t_stress));
    put(&object, "K_I_error", number(t->stress_intensity_error[0]));
    put(&object, "K_II_error", number(t->stress_intensity_error[1]));
    put(&object, "T_error", number(t->t_stress_error));
    put(&object, "bond_energy", numbers(count, &r->nominal_bond_energy[at]));
    put(&object, "bond_energy_tensile", numbers(count, &r->nominal_bond_energy_tensile[at]));
    put(&object, "griffith_energy", numbers(count, &r->nominal_griffith_energy[at]));
    return object;
}

static json_t *direction(const pdmc_results *r, int tip)
{
    const size_t count = (size_t)r->angle_count;
    const pdmc_estimate *share = &r->direction[pdmc_place(r, tip, 0)];
    json_t *object = json_object();
    put(&object, "measure", text(pdmc_measure_names[r->measure]));
    put(&object, "probability", parts(count, 1, share, value_of));
    put(&object, "lower", parts(count, 1, share, lower_of));
    put(&object, "upper", parts(count, 1, share, upper_of));
    return object;
}

static json_t *probability(const pdmc_estimate *estimate)
{
    json_t *object = json_object();
    put(&object, "value", number(estimate->value));
    put(&object, "lower", number(estimate->lower));
    put(&object, "upper", number(estimate->upper));
    return object;
}

static json_t *tips(const pdmc_results *r)
{
    json_t *array = json_array();
    for (int t = 0; t < r->tip_count; t++) {
        json_t *object = json_object();
        put(&object, "name", text(r->tips[t].name));
        put(&object, "position", numbers(2, r->tips[t].position));
        put(&object, "straight_ahead", number(r->tips[t].direction));
        put(&object, "nominal", nominal(r, t));
        put(&object, "angles", numbers((size_t)r->angle_count, r->angles));
        for (int m = 0; m < PDMC_MEASURES; m++) put(&object, pdmc_measure_names[m], energy(r, t, &r->statistics[m]));
        put(&object, "direction", direction(r, t));
        put(&object, "probability", probability(&r->probability[t]));
        append(&array, object);
    }
    return array;
}

static json_t *probe(const pdmc_motion_record *m, int p)
{
    json_t *object = json_object(), *x = json_array(), *y = json_array();
    put(&object, "name", text(m->probes[p].name));
    put(&object, "position", numbers(2, m->probes[p].position));
    put(&object, "side", text(pdmc_face_name(m->probes[p].face)));
    for (int i = 0; i < m->time_count; i++) {
        append(&x, number(pdmc_probe_displacement(m, i, p)[0]));
        append(&y, number(pdmc_probe_displacement(m, i, p)[1]));
    }
    put(&object, "x", x);
    put(&object, "y", y);
    return object;
}

static json_t *motion(const pdmc_results *r)
{
    const pdmc_motion_record *m = &r->motion;
    const size_t count = (size_t)m->time_count;
    json_t *object = json_object(), *probes = json_array();
    put(&object, "time", numbers(count, m->time));
    put(&object, "load_factor", numbers(count, m->load_factor));
    put(&object, "kinetic", numbers(count, m->kinetic));
    put(&object, "elastic", numbers(count, m->elastic));
    put(&object, "dissipated", numbers(count, m->dissipated));
    put(&object, "work", numbers(count, m->work));
    put(&object, "balance_error", number(pdmc_balance_error(m)));
    for (int p = 0; p < m->probe_count; p++) append(&probes, probe(m, p));
    put(&object, "probes", probes);
    return object;
}

static json_t *solver(const pdmc_solver_report *s)
{
    json_t *object = json_object();
    put(&object, "nodes", json_integer(s->nodes));
    put(&object, "unknowns", json_integer(s->unknowns));
    put(&object, "rows", json_integer(s->rows));
    put(&object, "rank", json_integer(s->rank));
    put(&object, "condition", number(s->condition));
    put(&object, "residual", number(s->residual));
    put(&object, "horizon", number(s->horizon));
    put(&object, "spacing", number(s->spacing));
    return object;
}

static json_t *runtime(const pdmc_runtime *t)
{
    json_t *object = json_object();
    put(&object, "threads", json_integer(t->threads));
    put(&object, "assembly", number(t->assembly));
    put(&object, "factorisation", number(t->factorisation));
    put(&object, "operators", number(t->operators));
    put(&object, "energy_rows", number(t->energy_rows));
    put(&object, "sampling", number(t->sampling));
    put(&object, "energy", number(t->energy));
    put(&object, "statistics", number(t->statistics));
    put(&object, "motion", number(t->motion));
    put(&object, "output", number(t->output));
    put(&object, "total", number(t->total));
    put(&object, "peak_memory", number(t->peak_memory));
    return object;
}

static json_t *units(const pdmc_results *r)
{
    char unit[PDMC_UNIT_SIZE];
    json_t *object = json_object();
    put(&object, "length", text(r->length_unit));
    put(&object, "force", text(r->force_unit));
    put(&object, "study_time", text(r->time_unit));
    pdmc_results_unit(r, PDMC_UNIT_WORK, sizeof unit, unit);
    put(&object, "work", text(unit));
    pdmc_results_unit(r, PDMC_UNIT_ENERGY, sizeof unit, unit);
    put(&object, "energy", text(unit));
    pdmc_results_unit(r, PDMC_UNIT_STRESS_INTENSITY, sizeof unit, unit);
    put(&object, "stress_intensity", text(unit));
    put(&object, "angle", text("rad"));
    put(&object, "time", text("s"));
    put(&object, "memory", text("byte"));
    return object;
}

static json_t *everything(const pdmc_results *r)
{
    json_t *object = json_object();
    put(&object, "kind", text(r->kind == PDMC_DYNAMIC ? "dynamic" : "static"));
    put(&object, "title", text(r->title));
    put(&object, "date_and_time", text(r->date_and_time));
    put(&object, "pdmc_version", text(r->pdmc_version));
    put(&object, "git_sha1", text(r->git_sha1));
    put(&object, "status", text(r->status == PDMC_RUN_COMPLETE ? "complete" : "interrupted"));
    put(&object, "samples", json_integer(r->sample_count));
    put(&object, "failed", json_integer(r->failed_count));
    // JSON's integers are signed; a seed beyond them is written as text rather than changed.
    char seed[24];
    snprintf(seed, sizeof seed, "%llu", (unsigned long long)r->seed);
    put(&object, "seed", r->seed <= INT64_MAX ? json_integer((json_int_t)r->seed) : text(seed));
    put(&object, "measure", text(pdmc_measure_names[r->measure]));
    put(&object, "bonds", text(r->bonds == PDMC_BONDS_ALL ? "all" : "tensile"));
    put(&object, "fracture_energy", number(r->fracture_energy));
    put(&object, "units", units(r));
    put(&object, "confidence", number(r->confidence));
    put(&object, "tips", tips(r));
    if (r->kind == PDMC_DYNAMIC) put(&object, "motion", motion(r));
    put(&object, "solver", solver(&r->solver));
    put(&object, "runtime", runtime(&r->runtime));
    return object;
}

pdmc_status pdmc_view_json(const pdmc_results *results, FILE *stream)
{
    json_t *object = everything(results);
    const int failed = object ? json_dumpf(object, stream, JSON_COMPACT | JSON_REAL_PRECISION(17)) : -1;
    json_decref(object);
    if (!failed) fputc('\n', stream);
    if (fflush(stream) != 0 || ferror(stream)) return pdmc_raise(PDMC_ERR_IO, "the JSON cannot be written");
    return failed ? pdmc_raise(PDMC_ERR_NOMEM, "out of memory for the JSON of %d tips", results->tip_count) : PDMC_OK;
}
