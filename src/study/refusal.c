// SPDX-License-Identifier: GPL-3.0-or-later

/// What is wrong with a value: what was found, and what is allowed.

#include "study/study_impl.h"

#include <ctype.h>

pdmc_study_address pdmc_study_address_of(const pdmc_study_record *r, const pdmc_study_setting *s)
{
    return (pdmc_study_address){r->section, r->index, s->key};
}

static void print_quoted(FILE *out, const char *text)
{
    fputc('"', out);
    for (int i = 0; text[i] && i < 80; i++) fputc(iscntrl((unsigned char)text[i]) ? '?' : text[i], out); // one line
    fputc('"', out);
}

static void print_found(FILE *out, const config_setting_t *value)
{
    switch (config_setting_type(value)) {
    case CONFIG_TYPE_INT:
    case CONFIG_TYPE_INT64: fprintf(out, "%lld", config_setting_get_int64(value)); break;
    case CONFIG_TYPE_FLOAT: pdmc_study_print_real(out, config_setting_get_float(value)); break;
    case CONFIG_TYPE_STRING: print_quoted(out, config_setting_get_string(value)); break;
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

pdmc_status pdmc_study_refuse_value(const pdmc_study_record *r, const pdmc_study_setting *s,
                                    const config_setting_t *value, const char *noun)
{
    pdmc_study_text message;
    const pdmc_status status = pdmc_study_refusal_begin(r->reader, pdmc_study_address_of(r, s), &message);
    if (status != PDMC_OK) return status;
    if (value) print_found(message.out, value);
    else fprintf(message.out, "the default, %s,", s->fallback);
    fputs(" is not allowed, ", message.out);
    print_allowed(message.out, s, noun);
    return pdmc_study_refusal_end(&message);
}

pdmc_status pdmc_study_refuse_kind(const pdmc_study_record *r, const pdmc_study_setting *s,
                                   const config_setting_t *value)
{
    return pdmc_study_refuse_value(r, s, value, pdmc_study_kind_noun(s->kind));
}

pdmc_status pdmc_study_refuse_missing(const pdmc_study_record *r, const pdmc_study_setting *s)
{
    pdmc_study_text message;
    const pdmc_status status = pdmc_study_refusal_begin(r->reader, pdmc_study_address_of(r, s), &message);
    if (status != PDMC_OK) return status;
    fputs("is missing, ", message.out);
    print_allowed(message.out, s, pdmc_study_kind_noun(s->kind));
    return pdmc_study_refusal_end(&message);
}

pdmc_status pdmc_study_refuse_section(const pdmc_study_reader *reader, pdmc_study_address address, const char *allowed)
{
    pdmc_study_text message;
    const pdmc_status status = pdmc_study_refusal_begin(reader, address, &message);
    if (status != PDMC_OK) return status;
    print_found(message.out, pdmc_study_locate(reader, address));
    fprintf(message.out, " is not allowed, must be %s", allowed);
    return pdmc_study_refusal_end(&message);
}
