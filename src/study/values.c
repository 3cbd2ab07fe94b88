// SPDX-License-Identifier: GPL-3.0-or-later

/// Values by kind. The default takes the same way as a value of the file, so that its range is checked too.

#include "study/study_impl.h"

#include "base/base_impl.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static void store(const pdmc_study_record *r, const pdmc_study_setting *s, const void *value, size_t size)
{
    if (s->offset != NOT_STORED) memcpy((char *)r->base + s->offset, value, size);
}

typedef pdmc_status read_function(const pdmc_study_record *r, const pdmc_study_setting *s,
                                  const config_setting_t *value);

static bool in_range(const pdmc_study_range *range, double x)
{
    return isfinite(x) && (range->excluded ? range->low < x : range->low <= x) &&
           (range->below ? x < range->high : x <= range->high);
}

static double number(const config_setting_t *value)
{
    if (config_setting_type(value) == CONFIG_TYPE_FLOAT) return config_setting_get_float(value);
    return (double)config_setting_get_int64(value);
}

static pdmc_status read_real(const pdmc_study_record *r, const pdmc_study_setting *s, const config_setting_t *value)
{
    double x;
    if (value && !config_setting_is_number(value)) return pdmc_study_refuse_kind(r, s, value);
    if (value) x = number(value);
    else x = s->derive ? s->derive(r->reader->problem) : strtod(s->fallback, NULL);
    const char *noun = isfinite(x) || !isfinite(s->range.low) ? "" : "a finite real";
    if (!in_range(&s->range, x)) return pdmc_study_refuse_value(r, s, value, noun);
    store(r, s, &x, sizeof x);
    return PDMC_OK;
}

static pdmc_status read_optional(const pdmc_study_record *r, const pdmc_study_setting *s, const config_setting_t *value)
{
    if (!value) return PDMC_OK;
    const bool present = true;
    memcpy((char *)r->base + s->flag, &present, sizeof present);
    return read_real(r, s, value);
}

static bool is_sequence(const config_setting_t *value)
{
    return config_setting_type(value) == CONFIG_TYPE_ARRAY || config_setting_is_list(value);
}

static pdmc_status read_elements(const pdmc_study_record *r, const pdmc_study_setting *s, const config_setting_t *value,
                                 int count, double x[])
{
    if (!is_sequence(value) || config_setting_length(value) != count) return pdmc_study_refuse_kind(r, s, value);
    for (int i = 0; i < count; i++) {
        const config_setting_t *element = config_setting_get_elem(value, (unsigned)i);
        if (!config_setting_is_number(element)) return pdmc_study_refuse_kind(r, s, element);
        x[i] = number(element);
        if (!in_range(&s->range, x[i])) return pdmc_study_refuse_value(r, s, element, "");
    }
    return PDMC_OK;
}

static pdmc_status read_pair(const pdmc_study_record *r, const pdmc_study_setting *s, const config_setting_t *value)
{
    double x[2];
    const pdmc_status status = read_elements(r, s, value, 2, x);
    if (status == PDMC_OK) store(r, s, x, sizeof x);
    return status;
}

// What is not said is zero, as it is out of a plane.
static pdmc_status read_vector(const pdmc_study_record *r, const pdmc_study_setting *s, const config_setting_t *value)
{
    double x[PDMC_AXES] = {0.0};
    const pdmc_status status = value ? read_elements(r, s, value, r->reader->motion->dimension, x) : PDMC_OK;
    if (status == PDMC_OK) store(r, s, x, sizeof x);
    return status;
}

static bool is_integer(const config_setting_t *value)
{
    return config_setting_is_number(value) && config_setting_type(value) != CONFIG_TYPE_FLOAT;
}

static pdmc_status read_integer(const pdmc_study_record *r, const pdmc_study_setting *s, const config_setting_t *value,
                                long long *n)
{
    if (value && !is_integer(value)) return pdmc_study_refuse_kind(r, s, value);
    *n = value ? config_setting_get_int64(value) : strtoll(s->fallback, NULL, 10);
    return in_range(&s->range, (double)*n) ? PDMC_OK : pdmc_study_refuse_value(r, s, value, "");
}

static pdmc_status read_int(const pdmc_study_record *r, const pdmc_study_setting *s, const config_setting_t *value)
{
    long long wide = 0;
    const pdmc_status status = read_integer(r, s, value, &wide);
    if (status != PDMC_OK) return status;
    const int n = (int)wide; // the table's ranges are narrower than an int
    store(r, s, &n, sizeof n);
    return PDMC_OK;
}

static pdmc_status read_seed(const pdmc_study_record *r, const pdmc_study_setting *s, const config_setting_t *value)
{
    long long wide = 0;
    const pdmc_status status = read_integer(r, s, value, &wide);
    if (status != PDMC_OK) return status;
    const uint64_t seed = (uint64_t)wide;
    store(r, s, &seed, sizeof seed);
    return PDMC_OK;
}

static bool is_printable(const char *text)
{
    for (; *text; text++)
        if (iscntrl((unsigned char)*text)) return false;
    return true;
}

static pdmc_status read_text(const pdmc_study_record *r, const pdmc_study_setting *s, const config_setting_t *value)
{
    if (value && config_setting_type(value) != CONFIG_TYPE_STRING) return pdmc_study_refuse_kind(r, s, value);
    const char *text = value ? config_setting_get_string(value) : s->fallback;
    // Control characters would end the comments of the resolved study, and spoil axis labels.
    if (!*text || !is_printable(text)) return pdmc_study_refuse_value(r, s, value, "");
    char *copy = pdmc_strdup(text);
    if (!copy) return PDMC_ERR_NOMEM;
    store(r, s, &copy, sizeof copy);
    return PDMC_OK;
}

static pdmc_status read_name(const pdmc_study_record *r, const pdmc_study_setting *s, const config_setting_t *value)
{
    char name[PDMC_NAME_SIZE] = {0};
    if (value && config_setting_type(value) != CONFIG_TYPE_STRING) return pdmc_study_refuse_kind(r, s, value);
    if (value) {
        const char *text = config_setting_get_string(value);
        const size_t length = strlen(text);
        const size_t allowed = strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-");
        if (length == 0 || length >= sizeof name || allowed < length) return pdmc_study_refuse_value(r, s, value, "");
        memcpy(name, text, length);
    } else {
        const int letters = (int)strcspn(s->fallback, "1"); // "crack1, crack2, ..."
        snprintf(name, sizeof name, "%.*s%d", letters, s->fallback, r->index + 1);
    }
    store(r, s, name, sizeof name);
    return PDMC_OK;
}

static int choice_index(const char *const choices[], const char *name)
{
    for (int i = 0; choices[i]; i++)
        if (strcmp(choices[i], name) == 0) return i;
    return -1;
}

static pdmc_status read_choice(const pdmc_study_record *r, const pdmc_study_setting *s, const config_setting_t *value)
{
    if (value && config_setting_type(value) != CONFIG_TYPE_STRING) return pdmc_study_refuse_kind(r, s, value);
    const char *name = value ? config_setting_get_string(value) : s->fallback;
    const int choice = choice_index(s->choices, name);
    if (choice < 0) return pdmc_study_refuse_value(r, s, value, "");
    store(r, s, &choice, sizeof choice);
    return PDMC_OK;
}

static pdmc_status read_crack(const pdmc_study_record *r, const pdmc_study_setting *s, const config_setting_t *value)
{
    int crack;
    if (value && config_setting_type(value) != CONFIG_TYPE_STRING) return pdmc_study_refuse_kind(r, s, value);
    const pdmc_status status = pdmc_study_parse_crack(r->reader, pdmc_study_address_of(r, s), value, &crack);
    if (status == PDMC_OK) store(r, s, &crack, sizeof crack);
    return status;
}

static pdmc_status read_material(const pdmc_study_record *r, const pdmc_study_setting *s, const config_setting_t *value)
{
    const pdmc_explicit *motion = r->reader->motion;
    int material = 0;
    if (value && config_setting_type(value) != CONFIG_TYPE_STRING) return pdmc_study_refuse_kind(r, s, value);
    if (value) {
        const char *name = config_setting_get_string(value);
        while (material < motion->material_count && strcmp(motion->materials[material].name, name) != 0) material++;
    }
    if (material >= motion->material_count) return pdmc_study_refuse_value(r, s, value, "");
    store(r, s, &material, sizeof material);
    return PDMC_OK;
}

// Of the list of bodies itself only those that were read have names.
static pdmc_status read_body(const pdmc_study_record *r, const pdmc_study_setting *s, const config_setting_t *value)
{
    const pdmc_explicit *motion = r->reader->motion;
    const bool given = true;
    int body = 0;
    if (!value) return PDMC_OK;
    if (config_setting_type(value) != CONFIG_TYPE_STRING) return pdmc_study_refuse_kind(r, s, value);
    const char *name = config_setting_get_string(value);
    while (body < motion->body_count && strcmp(motion->bodies[body].body.name, name) != 0) body++;
    if (!*name || body == motion->body_count) return pdmc_study_refuse_value(r, s, value, "");
    if (s->flag > 0) memcpy((char *)r->base + s->flag, &given, sizeof given);
    store(r, s, &body, sizeof body);
    return PDMC_OK;
}

static pdmc_status read_tips(const pdmc_study_record *r, const pdmc_study_setting *s, const config_setting_t *value)
{
    if (value && !is_sequence(value)) return pdmc_study_refuse_kind(r, s, value);
    return pdmc_study_parse_tips(r->reader, pdmc_study_address_of(r, s), value);
}

static pdmc_status read_reals(const pdmc_study_record *r, const pdmc_study_setting *s, const config_setting_t *value)
{
    if (!value) return PDMC_OK;
    if (!is_sequence(value) || config_setting_length(value) < 2) return pdmc_study_refuse_kind(r, s, value);
    const int count = config_setting_length(value);
    double *x = pdmc_calloc((size_t)count, sizeof *x);
    if (!x) return PDMC_ERR_NOMEM;
    store(r, s, &x, sizeof x); // owned by the problem from here on
    memcpy((char *)r->base + s->flag, &count, sizeof count);
    for (int i = 0; i < count; i++) {
        const config_setting_t *element = config_setting_get_elem(value, (unsigned)i);
        if (!config_setting_is_number(element)) return pdmc_study_refuse_kind(r, s, element);
        x[i] = number(element);
        if (!in_range(&s->range, x[i])) return pdmc_study_refuse_value(r, s, element, "");
    }
    return PDMC_OK;
}

static read_function *const readers[KINDS] = {
    [KIND_REAL] = read_real, [KIND_OPTIONAL] = read_optional, [KIND_PAIR] = read_pair,   [KIND_INT] = read_int,
    [KIND_SEED] = read_seed, [KIND_TEXT] = read_text,         [KIND_NAME] = read_name,   [KIND_CHOICE] = read_choice,
    [KIND_TIPS] = read_tips, [KIND_REALS] = read_reals,       [KIND_CRACK] = read_crack,
    [KIND_VECTOR] = read_vector, [KIND_MATERIAL] = read_material, [KIND_BODY] = read_body,
};

pdmc_status pdmc_study_read_value(const pdmc_study_record *r, const pdmc_study_setting *s,
                                  const config_setting_t *value)
{
    return readers[s->kind](r, s, value);
}
