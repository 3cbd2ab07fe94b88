// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/json_parts.h"

#include "base/base_impl.h"

#include <math.h>

void pdmc_json_put(json_t **object, const char *key, json_t *value)
{
    if (json_object_set_new(*object, key, value) == 0) return;
    json_decref(*object);
    *object = NULL;
}

void pdmc_json_append(json_t **array, json_t *value)
{
    if (json_array_append_new(*array, value) == 0) return;
    json_decref(*array);
    *array = NULL;
}

json_t *pdmc_json_number(double x)
{
    return isfinite(x) ? json_real(x) : json_null();
}

json_t *pdmc_json_text(const char *bytes)
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

json_t *pdmc_json_numbers(size_t count, const double x[])
{
    json_t *array = json_array();
    for (size_t i = 0; i < count; i++) pdmc_json_append(&array, pdmc_json_number(x[i]));
    return array;
}

json_t *pdmc_json_estimate(const pdmc_estimate *estimate)
{
    json_t *object = json_object();
    pdmc_json_put(&object, "value", pdmc_json_number(estimate->value));
    pdmc_json_put(&object, "lower", pdmc_json_number(estimate->lower));
    pdmc_json_put(&object, "upper", pdmc_json_number(estimate->upper));
    return object;
}

json_t *pdmc_json_runtime(const pdmc_runtime *t)
{
    json_t *object = json_object();
    pdmc_json_put(&object, "threads", json_integer(t->threads));
    pdmc_json_put(&object, "assembly", pdmc_json_number(t->assembly));
    pdmc_json_put(&object, "factorisation", pdmc_json_number(t->factorisation));
    pdmc_json_put(&object, "operators", pdmc_json_number(t->operators));
    pdmc_json_put(&object, "energy_rows", pdmc_json_number(t->energy_rows));
    pdmc_json_put(&object, "sampling", pdmc_json_number(t->sampling));
    pdmc_json_put(&object, "energy", pdmc_json_number(t->energy));
    pdmc_json_put(&object, "reliability", pdmc_json_number(t->reliability));
    pdmc_json_put(&object, "control", pdmc_json_number(t->control));
    pdmc_json_put(&object, "statistics", pdmc_json_number(t->statistics));
    pdmc_json_put(&object, "motion", pdmc_json_number(t->motion));
    pdmc_json_put(&object, "output", pdmc_json_number(t->output));
    pdmc_json_put(&object, "total", pdmc_json_number(t->total));
    pdmc_json_put(&object, "peak_memory", pdmc_json_number(t->peak_memory));
    return object;
}

json_t *pdmc_json_units(const pdmc_results *r)
{
    char unit[PDMC_UNIT_SIZE];
    json_t *object = json_object();
    pdmc_json_put(&object, "length", pdmc_json_text(r->length_unit));
    pdmc_json_put(&object, "force", pdmc_json_text(r->force_unit));
    pdmc_json_put(&object, "study_time", pdmc_json_text(r->time_unit));
    pdmc_results_unit(r, PDMC_UNIT_WORK, sizeof unit, unit);
    pdmc_json_put(&object, "work", pdmc_json_text(unit));
    pdmc_results_unit(r, PDMC_UNIT_ENERGY, sizeof unit, unit);
    pdmc_json_put(&object, "energy", pdmc_json_text(unit));
    pdmc_results_unit(r, PDMC_UNIT_STRESS_INTENSITY, sizeof unit, unit);
    pdmc_json_put(&object, "stress_intensity", pdmc_json_text(unit));
    pdmc_json_put(&object, "angle", pdmc_json_text("rad"));
    pdmc_json_put(&object, "time", pdmc_json_text("s"));
    pdmc_json_put(&object, "memory", pdmc_json_text("byte"));
    return object;
}

json_t *pdmc_json_seed(uint64_t seed)
{
    char digits[24];
    snprintf(digits, sizeof digits, "%llu", (unsigned long long)seed);
    return seed <= INT64_MAX ? json_integer((json_int_t)seed) : pdmc_json_text(digits);
}

pdmc_status pdmc_json_print(json_t *object, FILE *stream)
{
    const int failed = object ? json_dumpf(object, stream, JSON_COMPACT | JSON_REAL_PRECISION(17)) : -1;
    json_decref(object);
    if (!failed) fputc('\n', stream);
    if (fflush(stream) != 0 || ferror(stream)) return pdmc_raise(PDMC_ERR_IO, "the JSON cannot be written");
    return failed ? pdmc_raise(PDMC_ERR_NOMEM, "out of memory for the JSON") : PDMC_OK;
}
