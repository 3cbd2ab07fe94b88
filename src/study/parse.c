// SPDX-License-Identifier: GPL-3.0-or-later

/// Follows the table of settings through the file: unknown keys, kinds, ranges, defaults, storing.

#include "study/study_impl.h"

#include "base/base_impl.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/// One group of the file, or its absence, and the struct that it fills.
typedef struct {
    const pdmc_study_reader *reader;
    const config_setting_t *group; // NULL where the file does not have it
    pdmc_study_section_id section;
    int index; // in a list; -1 otherwise
    void *base;
} record;

static pdmc_study_address address_of(const record *r, const pdmc_study_setting *s)
{
    return (pdmc_study_address){r->section, r->index, s->key};
}

static void store(const record *r, const pdmc_study_setting *s, const void *value, size_t size)
{
    if (s->offset != NOT_STORED) memcpy((char *)r->base + s->offset, value, size);
}

// ---- what is wrong with a value ----

static void print_found(FILE *out, const config_setting_t *value)
{
    switch (config_setting_type(value)) {
    case CONFIG_TYPE_INT:
    case CONFIG_TYPE_INT64: fprintf(out, "%lld", config_setting_get_int64(value)); break;
    case CONFIG_TYPE_FLOAT: pdmc_study_print_real(out, config_setting_get_float(value)); break;
    case CONFIG_TYPE_STRING: fprintf(out, "\"%.80s\"", config_setting_get_string(value)); break;
    case CONFIG_TYPE_BOOL: fputs(config_setting_get_bool(value) ? "true" : "false", out); break;
    case CONFIG_TYPE_GROUP: fputs("a group", out); break;
    case CONFIG_TYPE_ARRAY: fprintf(out, "an array of %d", config_setting_length(value)); break;
    default: fprintf(out, "a list of %d", config_setting_length(value)); break;
    }
}

static void print_allowed(FILE *out, const pdmc_study_setting *s, const char *noun)
{
    fprintf(out, "must be %s%s", noun, *noun ? " " : "");
    pdmc_study_print_range(out, s);
}

/// Says what was found and what is allowed; `noun` is "" where the kind is right and only the range is not.
static pdmc_status refuse_value(const record *r, const pdmc_study_setting *s, const config_setting_t *value,
                                const char *noun)
{
    pdmc_status status = PDMC_OK;
    pdmc_study_text text = {0};
    PDMC_TRY(pdmc_study_text_open(&text));
    if (value) print_found(text.out, value);
    else fprintf(text.out, "the default, %s,", s->fallback);
    fputs(" is not allowed, ", text.out);
    print_allowed(text.out, s, noun);
    PDMC_TRY(pdmc_study_text_close(&text));
    status = pdmc_study_refuse(r->reader, address_of(r, s), "%s", text.bytes);
done:
    pdmc_study_text_drop(&text);
    return status;
}

static pdmc_status refuse_kind(const record *r, const pdmc_study_setting *s, const config_setting_t *value)
{
    return refuse_value(r, s, value, pdmc_study_kind_noun(s->kind));
}

static pdmc_status refuse_missing(const record *r, const pdmc_study_setting *s)
{
    pdmc_status status = PDMC_OK;
    pdmc_study_text allowed = {0};
    PDMC_TRY(pdmc_study_text_open(&allowed));
    print_allowed(allowed.out, s, pdmc_study_kind_noun(s->kind));
    PDMC_TRY(pdmc_study_text_close(&allowed));
    status = pdmc_study_refuse(r->reader, address_of(r, s), "is missing, %s", allowed.bytes);
done:
    pdmc_study_text_drop(&allowed);
    return status;
}

// ---- values by kind; `value` is NULL where the file leaves it to the default ----

typedef pdmc_status read_function(const record *r, const pdmc_study_setting *s, const config_setting_t *value);

static bool in_range(const pdmc_study_range *range, double x)
{
    return isfinite(x) && (range->excluded ? range->low < x : range->low <= x) && x <= range->high;
}

static double number(const config_setting_t *value)
{
    if (config_setting_type(value) == CONFIG_TYPE_FLOAT) return config_setting_get_float(value);
    return (double)config_setting_get_int64(value);
}

static pdmc_status read_real(const record *r, const pdmc_study_setting *s, const config_setting_t *value)
{
    double x;
    if (value && !config_setting_is_number(value)) return refuse_kind(r, s, value);
    if (value) x = number(value);
    else x = s->derive ? s->derive(r->reader->problem) : strtod(s->fallback, NULL);
    if (!in_range(&s->range, x)) return refuse_value(r, s, value, isfinite(x) ? "" : "a finite real");
    store(r, s, &x, sizeof x);
    return PDMC_OK;
}

static pdmc_status read_optional(const record *r, const pdmc_study_setting *s, const config_setting_t *value)
{
    if (!value) return PDMC_OK;
    const bool present = true;
    memcpy((char *)r->base + s->flag, &present, sizeof present);
    return read_real(r, s, value);
}

static pdmc_status read_pair(const record *r, const pdmc_study_setting *s, const config_setting_t *value)
{
    double x[2];
    const bool sequence = config_setting_type(value) == CONFIG_TYPE_ARRAY || config_setting_is_list(value);
    if (!sequence || config_setting_length(value) != 2) return refuse_kind(r, s, value);
    for (unsigned i = 0; i < 2; i++) {
        const config_setting_t *element = config_setting_get_elem(value, i);
        if (!config_setting_is_number(element)) return refuse_kind(r, s, element);
        x[i] = number(element);
        if (!in_range(&s->range, x[i])) return refuse_value(r, s, element, "");
    }
    store(r, s, x, sizeof x);
    return PDMC_OK;
}

static bool is_integer(const config_setting_t *value)
{
    return config_setting_is_number(value) && config_setting_type(value) != CONFIG_TYPE_FLOAT;
}

static pdmc_status read_integer(const record *r, const pdmc_study_setting *s, const config_setting_t *value,
                                long long *n)
{
    if (value && !is_integer(value)) return refuse_kind(r, s, value);
    *n = value ? config_setting_get_int64(value) : strtoll(s->fallback, NULL, 10);
    return in_range(&s->range, (double)*n) ? PDMC_OK : refuse_value(r, s, value, "");
}

static pdmc_status read_int(const record *r, const pdmc_study_setting *s, const config_setting_t *value)
{
    long long wide;
    const pdmc_status status = read_integer(r, s, value, &wide);
    if (status != PDMC_OK) return status;
    const int n = (int)wide; // the table's ranges are narrower than an int
    store(r, s, &n, sizeof n);
    return PDMC_OK;
}

static pdmc_status read_seed(const record *r, const pdmc_study_setting *s, const config_setting_t *value)
{
    long long wide;
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

static pdmc_status read_text(const record *r, const pdmc_study_setting *s, const config_setting_t *value)
{
    if (value && config_setting_type(value) != CONFIG_TYPE_STRING) return refuse_kind(r, s, value);
    const char *text = value ? config_setting_get_string(value) : s->fallback;
    // Control characters would end the comments of the resolved study, and spoil axis labels.
    if (!*text || !is_printable(text)) return refuse_value(r, s, value, "");
    char *copy = pdmc_strdup(text);
    if (!copy) return PDMC_ERR_NOMEM;
    store(r, s, &copy, sizeof copy);
    return PDMC_OK;
}

static pdmc_status read_name(const record *r, const pdmc_study_setting *s, const config_setting_t *value)
{
    char name[PDMC_NAME_SIZE] = {0};
    if (value && config_setting_type(value) != CONFIG_TYPE_STRING) return refuse_kind(r, s, value);
    if (value) {
        const char *text = config_setting_get_string(value);
        const size_t length = strlen(text);
        const size_t allowed = strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-");
        if (length == 0 || length >= sizeof name || allowed < length) return refuse_value(r, s, value, "");
        memcpy(name, text, length);
    } else {
        snprintf(name, sizeof name, "crack%d", r->index + 1);
    }
    store(r, s, name, sizeof name);
    return PDMC_OK;
}

static int choice_index(const char *const choices[], const char *name)
{
    for (int i = 0; choices && choices[i]; i++)
        if (strcmp(choices[i], name) == 0) return i;
    return -1;
}

static pdmc_status read_choice(const record *r, const pdmc_study_setting *s, const config_setting_t *value)
{
    if (value && config_setting_type(value) != CONFIG_TYPE_STRING) return refuse_kind(r, s, value);
    const char *name = value ? config_setting_get_string(value) : s->fallback;
    const int choice = choice_index(s->choices, name);
    if (choice_index(s->planned, name) >= 0)
        return pdmc_study_refuse(r->reader, address_of(r, s), "\"%s\" is not available yet, must be \"%s\"", name,
                                 s->choices[0]);
    if (choice < 0) return refuse_value(r, s, value, "");
    store(r, s, &choice, sizeof choice);
    return PDMC_OK;
}

static pdmc_status read_tips(const record *r, const pdmc_study_setting *s, const config_setting_t *value)
{
    if (value && config_setting_type(value) != CONFIG_TYPE_ARRAY && !config_setting_is_list(value))
        return refuse_kind(r, s, value);
    return pdmc_study_parse_tips(r->reader, address_of(r, s), value);
}

static read_function *const readers[KINDS] = {
    [KIND_REAL] = read_real, [KIND_OPTIONAL] = read_optional, [KIND_PAIR] = read_pair,
    [KIND_INT] = read_int,   [KIND_SEED] = read_seed,         [KIND_TEXT] = read_text,
    [KIND_NAME] = read_name, [KIND_CHOICE] = read_choice,     [KIND_TIPS] = read_tips,
};

// ---- groups ----

static const pdmc_study_setting *find_setting(pdmc_study_section_id section, const char *key)
{
    for (const pdmc_study_setting *s = pdmc_study_settings; s->key; s++)
        if (s->section == section && strcmp(s->key, key) == 0) return s;
    return NULL;
}

static bool is_section(const char *name)
{
    for (int i = SECTION_TOP + 1; i < SECTIONS; i++)
        if (strcmp(pdmc_study_sections[i].name, name) == 0) return true;
    return false;
}

static pdmc_status refuse_unknown(const record *r, const char *key)
{
    const pdmc_study_address address = {r->section, r->index, key};
    pdmc_study_nearest nearest = pdmc_study_nearest_to(key);
    for (const pdmc_study_setting *s = pdmc_study_settings; s->key; s++)
        if (s->section == r->section) pdmc_study_nearest_offer(&nearest, s->key);
    if (r->section == SECTION_TOP)
        for (int i = SECTION_TOP + 1; i < SECTIONS; i++)
            pdmc_study_nearest_offer(&nearest, pdmc_study_sections[i].name);
    if (!*nearest.best) return pdmc_study_refuse(r->reader, address, "unknown setting");
    return pdmc_study_refuse(r->reader, address, "unknown setting, did you mean \"%s\"?", nearest.best);
}

static pdmc_status check_keys(const record *r)
{
    for (int i = 0; r->group && i < config_setting_length(r->group); i++) {
        const char *key = config_setting_name(config_setting_get_elem(r->group, (unsigned)i));
        const bool known = find_setting(r->section, key) || (r->section == SECTION_TOP && is_section(key));
        if (!known) return refuse_unknown(r, key);
    }
    return PDMC_OK;
}

static pdmc_status read_setting(const record *r, const pdmc_study_setting *s)
{
    const config_setting_t *value = r->group ? config_setting_get_member(r->group, s->key) : NULL;
    if (!pdmc_study_setting_belongs(s, r->base))
        return value ? pdmc_study_refuse(r->reader, address_of(r, s), "is no setting of this quantity") : PDMC_OK;
    if (!value && !s->fallback) return refuse_missing(r, s);
    return readers[s->kind](r, s, value);
}

static pdmc_status read_record(const record *r)
{
    pdmc_status status = check_keys(r);
    for (const pdmc_study_setting *s = pdmc_study_settings; s->key && status == PDMC_OK; s++)
        if (s->section == r->section) status = read_setting(r, s);
    return status;
}

static pdmc_status refuse_section(const pdmc_study_reader *reader, pdmc_study_address address, const char *allowed)
{
    pdmc_status status = PDMC_OK;
    pdmc_study_text found = {0};
    PDMC_TRY(pdmc_study_text_open(&found));
    print_found(found.out, pdmc_study_locate(reader, address));
    PDMC_TRY(pdmc_study_text_close(&found));
    status = pdmc_study_refuse(reader, address, "%s is not allowed, must be %s", found.bytes, allowed);
done:
    pdmc_study_text_drop(&found);
    return status;
}

static pdmc_status read_list(const pdmc_study_reader *reader, pdmc_study_section_id id, const config_setting_t *list)
{
    const pdmc_study_section *section = &pdmc_study_sections[id];
    if (!list) return PDMC_OK;
    if (!config_setting_is_list(list))
        return refuse_section(reader, (pdmc_study_address){id, -1, NULL}, "a list of groups, ( { ... }, { ... } )");

    const int count = config_setting_length(list);
    char *items = pdmc_calloc((size_t)count, section->size);
    if (!items) return PDMC_ERR_NOMEM;
    memcpy((char *)reader->problem + section->items, &items, sizeof items); // owned by the problem from here on
    memcpy((char *)reader->problem + section->count, &count, sizeof count);

    pdmc_status status = PDMC_OK;
    for (int i = 0; i < count && status == PDMC_OK; i++) {
        const config_setting_t *group = config_setting_get_elem(list, (unsigned)i);
        if (!config_setting_is_group(group))
            return refuse_section(reader, (pdmc_study_address){id, i, NULL}, "a group, { ... }");
        status = read_record(&(record){reader, group, id, i, items + (size_t)i * section->size});
    }
    return status;
}

static pdmc_status read_group(const pdmc_study_reader *reader, pdmc_study_section_id id, const config_setting_t *group)
{
    if (group && !config_setting_is_group(group))
        return refuse_section(reader, (pdmc_study_address){id, -1, NULL}, "a group, { ... }");
    return read_record(&(record){reader, group, id, -1, reader->problem});
}

pdmc_status pdmc_study_parse(const pdmc_study_reader *reader)
{
    pdmc_status status = PDMC_OK;
    for (pdmc_study_section_id id = SECTION_TOP; id < SECTIONS; id++) {
        const pdmc_study_section *section = &pdmc_study_sections[id];
        const config_setting_t *at =
            id == SECTION_TOP ? reader->root : config_setting_get_member(reader->root, section->name);
        PDMC_TRY((section->size > 0 ? read_list : read_group)(reader, id, at));
        if (section->check) PDMC_TRY(section->check(reader));
    }
done:
    return status;
}
