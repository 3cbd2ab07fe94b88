// SPDX-License-Identifier: GPL-3.0-or-later

/// Follows the table of settings through the groups of the file, and meets every key that is not in the table.

#include "study/study_impl.h"

#include "base/base_impl.h"

#include <string.h>

static bool is_section(const char *name)
{
    for (int i = SECTION_TOP + 1; i < SECTIONS; i++)
        if (strcmp(pdmc_study_sections[i].name, name) == 0) return true;
    return false;
}

static void offer(const char *candidate, pdmc_study_nearest *nearest, FILE *list)
{
    pdmc_study_nearest_offer(nearest, candidate);
    fprintf(list, "%s%s", ftell(list) > 0 ? ", " : "", candidate);
}

static pdmc_status refuse_unknown(const pdmc_study_record *r, const char *key)
{
    pdmc_status status = PDMC_OK;
    const pdmc_study_address address = {r->section, r->index, key};
    pdmc_study_nearest nearest = pdmc_study_nearest_to(key);
    pdmc_study_text list = {0};
    PDMC_TRY(pdmc_study_text_open(&list));
    for (const pdmc_study_setting *s = pdmc_study_settings; s->key; s++)
        if (s->section == r->section) offer(s->key, &nearest, list.out);
    for (int i = SECTION_TOP + 1; r->section == SECTION_TOP && i < SECTIONS; i++)
        if (i != SECTION_PLANAR_CRACKS) offer(pdmc_study_sections[i].name, &nearest, list.out); // named once already
    PDMC_TRY(pdmc_study_text_close(&list));
    status = *nearest.best
                 ? pdmc_study_refuse(r->reader, address, "unknown setting, did you mean \"%s\"?", nearest.best)
                 : pdmc_study_refuse(r->reader, address, "unknown setting, must be one of %s", list.bytes);
done:
    pdmc_study_text_drop(&list);
    return status;
}

static pdmc_status check_keys(const pdmc_study_record *r)
{
    for (int i = 0; r->group && i < config_setting_length(r->group); i++) {
        const char *key = config_setting_name(config_setting_get_elem(r->group, (unsigned)i));
        const bool known = pdmc_study_find_setting(r->section, key) || (r->section == SECTION_TOP && is_section(key));
        if (!known) return refuse_unknown(r, key);
    }
    return PDMC_OK;
}

// The setting that it depends on is a choice or an integer.
static pdmc_status refuse_of_value(const pdmc_study_record *r, const pdmc_study_setting *s)
{
    int value;
    const pdmc_study_setting *of = pdmc_study_find_setting(r->section, s->of);
    memcpy(&value, (const char *)r->base + of->offset, sizeof value);
    if (of->choices)
        return pdmc_study_refuse(r->reader, pdmc_study_address_of(r, s), "is no setting of the %s \"%s\"", s->of,
                                 of->choices[value]);
    return pdmc_study_refuse(r->reader, pdmc_study_address_of(r, s), "is no setting of the %s %d", s->of, value);
}

static pdmc_status refuse_of_other(const pdmc_study_record *r, const pdmc_study_setting *s)
{
    if (s->of) return refuse_of_value(r, s);
    const pdmc_problem *problem = r->reader->problem;
    const char *of = "quantity", *name;
    if (s->quantities) {
        const pdmc_uncertainty *uncertainty = r->base;
        name = pdmc_study_find_setting(r->section, of)->choices[uncertainty->quantity];
    } else if (problem->solver.method != PDMC_METHOD_KANSA) {
        name = pdmc_study_find_setting(SECTION_SOLVER, of = "method")->choices[problem->solver.method];
    } else {
        name = pdmc_study_find_setting(SECTION_SOLVER, of = "crack_model")->choices[problem->solver.crack_model];
    }
    return pdmc_study_refuse(r->reader, pdmc_study_address_of(r, s), "is no setting of the %s \"%s\"", of, name);
}

static pdmc_status refuse_of_kind_of_study(const pdmc_study_record *r, const pdmc_study_setting *s)
{
    const pdmc_study_setting *kind = pdmc_study_find_setting(SECTION_TOP, "kind");
    return pdmc_study_refuse(r->reader, pdmc_study_address_of(r, s), "is no setting of a study of kind \"%s\"",
                             kind->choices[r->reader->problem->kind]);
}

static pdmc_status read_setting(const pdmc_study_record *r, const pdmc_study_setting *s)
{
    const config_setting_t *value = r->group ? config_setting_get_member(r->group, s->key) : NULL;
    if (!pdmc_study_setting_of_kind(s, r->reader->problem->kind)) return value ? refuse_of_kind_of_study(r, s) : PDMC_OK;
    if (!pdmc_study_setting_belongs(s, r->base)) return value ? refuse_of_other(r, s) : PDMC_OK;
    if (!value && !s->fallback) return pdmc_study_refuse_missing(r, s);
    return pdmc_study_read_value(r, s, value);
}

static pdmc_status read_record(const pdmc_study_record *r)
{
    pdmc_status status = check_keys(r);
    for (const pdmc_study_setting *s = pdmc_study_settings; s->key && status == PDMC_OK; s++)
        if (s->section == r->section) status = read_setting(r, s);
    return status;
}

static pdmc_status read_list(const pdmc_study_reader *reader, pdmc_study_section_id id, const config_setting_t *list)
{
    const pdmc_study_section *section = &pdmc_study_sections[id];
    if (!list) return PDMC_OK;
    if (!config_setting_is_list(list))
        return pdmc_study_refuse_section(reader, (pdmc_study_address){id, -1, NULL},
                                         "a list of groups, ( { ... }, { ... } )");

    const int count = config_setting_length(list);
    char *items = pdmc_calloc((size_t)count, section->size);
    if (!items) return PDMC_ERR_NOMEM;
    char *home = pdmc_study_home(section, reader->study);
    memcpy(home + section->items, &items, sizeof items); // owned by the problem from here on
    memcpy(home + section->count, &count, sizeof count);

    pdmc_status status = PDMC_OK;
    for (int i = 0; i < count && status == PDMC_OK; i++) {
        const config_setting_t *group = config_setting_get_elem(list, (unsigned)i);
        if (!config_setting_is_group(group))
            return pdmc_study_refuse_section(reader, (pdmc_study_address){id, i, NULL}, "a group, { ... }");
        status = read_record(&(pdmc_study_record){reader, group, id, i, items + (size_t)i * section->size});
    }
    return status;
}

static pdmc_status read_group(const pdmc_study_reader *reader, pdmc_study_section_id id, const config_setting_t *group)
{
    if (group && !config_setting_is_group(group))
        return pdmc_study_refuse_section(reader, (pdmc_study_address){id, -1, NULL}, "a group, { ... }");
    void *home = pdmc_study_home(&pdmc_study_sections[id], reader->study);
    return read_record(&(pdmc_study_record){reader, group, id, -1, home});
}

// Only what a study of its kind is made of may be in its file.
static pdmc_status refuse_of_kind(const pdmc_study_reader *reader, pdmc_study_section_id id)
{
    const pdmc_study_section *section = &pdmc_study_sections[id];
    const pdmc_study_setting *kind = pdmc_study_find_setting(SECTION_TOP, "kind");
    return pdmc_study_refuse(reader, (pdmc_study_address){id, -1, NULL}, "is not part of a study of kind \"%s\"%s%s",
                             kind->choices[reader->problem->kind], section->instead ? ": " : "",
                             section->instead ? section->instead : "");
}

// Whether the study has the section, or another of the same name.
static bool has_name(const pdmc_study_reader *reader, const char *name)
{
    for (int i = SECTION_TOP; i < SECTIONS; i++) {
        const pdmc_study_section *section = &pdmc_study_sections[i];
        if (strcmp(section->name, name) == 0 && pdmc_study_section_belongs(section, reader->problem->kind)) return true;
    }
    return false;
}

pdmc_status pdmc_study_parse(const pdmc_study_reader *reader)
{
    pdmc_status status = PDMC_OK;
    for (pdmc_study_section_id id = SECTION_TOP; id < SECTIONS; id++) {
        const pdmc_study_section *section = &pdmc_study_sections[id];
        const config_setting_t *at =
            id == SECTION_TOP ? reader->root : config_setting_get_member(reader->root, section->name);
        if (!pdmc_study_section_belongs(section, reader->problem->kind)) {
            if (at && !has_name(reader, section->name)) PDMC_TRY(refuse_of_kind(reader, id));
            continue;
        }
        PDMC_TRY((section->size > 0 ? read_list : read_group)(reader, id, at));
        if (section->check) PDMC_TRY(section->check(reader));
    }
done:
    return status;
}
