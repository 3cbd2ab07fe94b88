// SPDX-License-Identifier: GPL-3.0-or-later

/// Where in the file stands what turned out to be wrong after it was read.

#include "study/study_impl.h"

#include "base/base_impl.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

static bool is_name(const char *name, const char *text, size_t length)
{
    return length > 0 && strlen(name) == length && strncmp(name, text, length) == 0;
}

static size_t length_of_word(const char *text)
{
    size_t length = 0;
    while (islower((unsigned char)text[length]) || text[length] == '_') length++;
    return length;
}

static bool find_section(pdmc_problem_kind kind, const char *text, size_t length, pdmc_study_section_id *id)
{
    for (int i = 0; i < SECTIONS; i++) {
        const pdmc_study_section *section = &pdmc_study_sections[i];
        if (!is_name(section->name, text, length) || !pdmc_study_section_belongs(section, kind)) continue;
        *id = (pdmc_study_section_id)i;
        return true;
    }
    return false;
}

static const char *find_key(pdmc_study_section_id section, const char *text, size_t length)
{
    for (const pdmc_study_setting *s = pdmc_study_settings; s->key; s++)
        if (s->section == section && is_name(s->key, text, length)) return s->key;
    return NULL;
}

/// Reads "section: ", "section[index]: ", "section.key: " or "section[index].key: ".
/// @return what is behind it; NULL where the message does not begin so
static const char *read_address(pdmc_problem_kind kind, const char *message, pdmc_study_address *address)
{
    size_t length = length_of_word(message);
    const char *at = message + length;
    *address = (pdmc_study_address){SECTION_TOP, -1, NULL};
    if (!find_section(kind, message, length, &address->section)) return NULL;
    if (*at == '[') {
        char *end;
        address->index = (int)strtol(at + 1, &end, 10);
        if (*end != ']') return NULL;
        at = end + 1;
    }
    if (*at == '.') {
        length = length_of_word(++at);
        address->key = find_key(address->section, at, length);
        at += length;
        if (!address->key) return NULL;
    }
    return strncmp(at, ": ", 2) == 0 ? at + 2 : NULL;
}

pdmc_status pdmc_study_place(const pdmc_study *study, pdmc_status status)
{
    pdmc_study_address address;
    if (status != PDMC_ERR_CONFIG || !study->source) return status;
    const char *what = read_address(study->problem.kind, pdmc_last_error(), &address);
    if (!what) return status;
    config_t config;
    config_init(&config);
    status = pdmc_study_source_parse(study->source, &config);
    if (status == PDMC_OK)
        status = pdmc_study_refuse(
            &(pdmc_study_reader){.source = study->source, .root = config_root_setting(&config), .study = study},
            address, "%s", what);
    config_destroy(&config);
    return status;
}
