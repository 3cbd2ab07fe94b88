// SPDX-License-Identifier: GPL-3.0-or-later

/// Places in the file, and what is said about them.

#include "study/study_impl.h"

#include "base/base_impl.h"

#include <stdarg.h>

const config_setting_t *pdmc_study_locate(const pdmc_study_reader *reader, pdmc_study_address address)
{
    const config_setting_t *at = reader->root, *inner = at;
    if (address.section != SECTION_TOP)
        inner = config_setting_get_member(at, pdmc_study_sections[address.section].name);
    if (inner) at = inner;
    if (inner && address.index >= 0 && config_setting_is_list(at))
        inner = config_setting_get_elem(at, (unsigned)address.index);
    if (inner) at = inner;
    if (inner && address.key) inner = config_setting_get_member(at, address.key);
    return inner ? inner : at;
}

// What kind of message it is stands behind the place, as in those of compilers.
static void print_place(FILE *out, const pdmc_study_reader *reader, pdmc_study_address address, const char *kind)
{
    int line;
    const config_setting_t *setting = pdmc_study_locate(reader, address);
    const char *file = pdmc_study_source_place(reader->source, config_setting_source_line(setting), &line);
    fputs(file, out);
    if (!config_setting_is_root(setting)) fprintf(out, ":%d", line); // no line is the place of what is not there
    const char *section = pdmc_study_sections[address.section].name;
    fprintf(out, ": %s%s", kind, section);
    if (address.index >= 0) fprintf(out, "[%d]", address.index);
    if (address.key) fprintf(out, "%s%s", *section ? "." : "", address.key);
    fputs(": ", out);
}

pdmc_status pdmc_study_refusal_begin(const pdmc_study_reader *reader, pdmc_study_address address,
                                     pdmc_study_text *message)
{
    *message = (pdmc_study_text){0};
    const pdmc_status status = pdmc_study_text_open(message);
    if (status == PDMC_OK) print_place(message->out, reader, address, "");
    return status;
}

pdmc_status pdmc_study_refusal_end(pdmc_study_text *message)
{
    pdmc_status status = pdmc_study_text_close(message);
    if (status == PDMC_OK) status = pdmc_raise(PDMC_ERR_CONFIG, "%s", message->bytes);
    pdmc_study_text_drop(message);
    return status;
}

pdmc_status pdmc_study_refuse(const pdmc_study_reader *reader, pdmc_study_address address, const char *format, ...)
{
    pdmc_study_text message;
    const pdmc_status status = pdmc_study_refusal_begin(reader, address, &message);
    if (status != PDMC_OK) return status;
    va_list arguments;
    va_start(arguments, format);
    vfprintf(message.out, format, arguments);
    va_end(arguments);
    return pdmc_study_refusal_end(&message);
}

void pdmc_study_warn(const pdmc_study_reader *reader, pdmc_study_address address, const char *format, ...)
{
    print_place(reader->warnings, reader, address, "warning: ");
    va_list arguments;
    va_start(arguments, format);
    vfprintf(reader->warnings, format, arguments);
    va_end(arguments);
    fputc('\n', reader->warnings);
}
