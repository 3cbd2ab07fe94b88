// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/json_parts.h"
#include "views/scalar.h"

static json_t *rates(const pdmc_scalar_record *s, const double values[])
{
    json_t *array = json_array();
    for (int i = 0; i < s->level_count; i++) pdmc_json_append(&array, pdmc_json_number(pdmc_rate_of(values, i)));
    return array;
}

json_t *pdmc_json_scalar(const pdmc_scalar_record *s)
{
    const struct {
        const char *name;
        const double *values;
    } columns[] = {
        {"spacing", s->spacing},     {"horizon", s->horizon},
        {"elements", s->elements},   {"unknowns", s->unknowns},
        {"entries", s->entries},     {"error", s->error},
        {"classical", s->classical}, {"stable_step", s->stable_step},
        {"steps", s->steps},         {"stable_step_error", s->stable_step_error},
        {"seconds", s->seconds},     {"motion_error", s->motion_error},
        {"drift", s->drift},         {"iterations", s->iterations},
        {"residual", s->residual},
    };
    json_t *object = json_object(), *levels = json_object();
    for (size_t i = 0; i < sizeof columns / sizeof columns[0]; i++)
        pdmc_json_put(&levels, columns[i].name, pdmc_json_numbers((size_t)s->level_count, columns[i].values));
    pdmc_json_put(&levels, "error_rate", rates(s, s->error));
    pdmc_json_put(&levels, "classical_rate", rates(s, s->classical));
    pdmc_json_put(&levels, "motion_error_rate", rates(s, s->motion_error));
    pdmc_json_put(&object, "dimension", json_integer(s->dimension));
    pdmc_json_put(&object, "power", pdmc_json_number(s->power));
    pdmc_json_put(&object, "wave_number", pdmc_json_number(s->wave_number));
    pdmc_json_put(&object, "levels", levels);
    pdmc_json_put(&object, "values", json_integer(s->value_count));
    return object;
}
