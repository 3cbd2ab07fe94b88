// SPDX-License-Identifier: GPL-3.0-or-later

/// The table of settings as text.

#include "study/study_impl.h"

#include "base/base_impl.h"

/// "thickness  a real > 0; length; default 1.0; extent out of the plane".
static void print_setting(FILE *out, const pdmc_study_setting *s)
{
    const char *noun = pdmc_study_kind_noun(s->kind);
    fprintf(out, "    %-19s%s%s", s->key, noun, *noun ? " " : "");
    pdmc_study_print_range(out, s);
    if (s->unit != UNIT_NONE) fputs("; ", out);
    pdmc_study_print_unit(out, s->unit, &(pdmc_study_units){"length", "force", "time"});
    fprintf(out, s->fallback ? "; default %s" : "; required", s->fallback);
    fprintf(out, "; %s\n", s->doc);
}

pdmc_status pdmc_study_describe(char **description)
{
    pdmc_status status = PDMC_OK;
    pdmc_study_text text = {0};
    PDMC_TRY(pdmc_study_text_open(&text));
    for (pdmc_study_section_id id = SECTION_TOP; id < SECTIONS; id++) {
        const pdmc_study_section *section = &pdmc_study_sections[id];
        fprintf(text.out, "%s: %s\n", *section->name ? section->name : "(top)", section->doc);
        for (const pdmc_study_setting *s = pdmc_study_settings; s->key; s++)
            if (s->section == id) print_setting(text.out, s);
    }
    PDMC_TRY(pdmc_study_text_close(&text));
    *description = text.bytes;
    text.bytes = NULL;
done:
    pdmc_study_text_drop(&text);
    return status;
}
