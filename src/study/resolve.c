// SPDX-License-Identifier: GPL-3.0-or-later

/// The problem back as a study file, every setting written out.

#include "study/study_impl.h"

#include "base/base_impl.h"

#include <string.h>

typedef struct {
    FILE *out;
    const pdmc_problem *problem;
    const pdmc_explicit *motion;
    const pdmc_study *study;
    pdmc_study_units units;
} writer;

typedef void write_function(const writer *w, const pdmc_study_setting *s, const void *field);

static void write_quoted(FILE *out, const char *text)
{
    fputc('"', out);
    for (; *text; text++) fprintf(out, *text == '"' || *text == '\\' ? "\\%c" : "%c", *text);
    fputc('"', out);
}

static void write_real(const writer *w, const pdmc_study_setting *s, const void *field)
{
    (void)s;
    double x;
    memcpy(&x, field, sizeof x);
    pdmc_study_print_real(w->out, x);
}

static void write_reals(FILE *out, int count, const double x[])
{
    for (int i = 0; i < count; i++) {
        fputs(i > 0 ? ", " : "[", out);
        pdmc_study_print_real(out, x[i]);
    }
    fputc(']', out);
}

static void write_pair(const writer *w, const pdmc_study_setting *s, const void *field)
{
    (void)s;
    write_reals(w->out, 2, field);
}

static void write_vector(const writer *w, const pdmc_study_setting *s, const void *field)
{
    (void)s;
    write_reals(w->out, w->motion->dimension, field);
}

static void write_int(const writer *w, const pdmc_study_setting *s, const void *field)
{
    (void)s;
    fprintf(w->out, "%d", *(const int *)field);
}

static void write_seed(const writer *w, const pdmc_study_setting *s, const void *field)
{
    (void)s;
    fprintf(w->out, "%lluL", (unsigned long long)*(const uint64_t *)field);
}

static void write_text(const writer *w, const pdmc_study_setting *s, const void *field)
{
    (void)s;
    write_quoted(w->out, *(char *const *)field);
}

static void write_name(const writer *w, const pdmc_study_setting *s, const void *field)
{
    (void)s;
    write_quoted(w->out, field);
}

static void write_choice(const writer *w, const pdmc_study_setting *s, const void *field)
{
    int choice = 0; // where it is not stored there is only one
    if (field) memcpy(&choice, field, sizeof choice);
    write_quoted(w->out, s->choices[choice]);
}

static void write_crack(const writer *w, const pdmc_study_setting *s, const void *field)
{
    (void)s;
    write_quoted(w->out, w->problem->cracks[*(const int *)field].name);
}

static void write_tips(const writer *w, const pdmc_study_setting *s, const void *field)
{
    (void)s, (void)field;
    char name[PDMC_STUDY_TIP_NAME_SIZE];
    fputc('[', w->out);
    for (int i = 0; i < w->problem->energy.tip_count; i++) {
        if (i > 0) fputs(", ", w->out);
        pdmc_study_tip_name(w->problem, w->problem->energy.tips[i], name);
        write_quoted(w->out, name);
    }
    fputc(']', w->out);
}

static void write_material(const writer *w, const pdmc_study_setting *s, const void *field)
{
    (void)s;
    write_quoted(w->out, w->motion->materials[*(const int *)field].name);
}

static void write_body(const writer *w, const pdmc_study_setting *s, const void *field)
{
    (void)s;
    write_quoted(w->out, w->motion->bodies[*(const int *)field].body.name);
}

// A list of reals is present only with at least one.
static void write_array(const writer *w, const pdmc_study_setting *s, const void *field)
{
    int count;
    const double *x;
    memcpy(&count, (const char *)field - s->offset + s->flag, sizeof count);
    memcpy(&x, field, sizeof x);
    write_reals(w->out, count, x);
}

static write_function *const writers[KINDS] = {
    [KIND_REAL] = write_real, [KIND_OPTIONAL] = write_real, [KIND_PAIR] = write_pair, [KIND_INT] = write_int,
    [KIND_SEED] = write_seed, [KIND_TEXT] = write_text,     [KIND_NAME] = write_name, [KIND_CHOICE] = write_choice,
    [KIND_TIPS] = write_tips, [KIND_REALS] = write_array,       [KIND_CRACK] = write_crack,
    [KIND_VECTOR] = write_vector, [KIND_MATERIAL] = write_material, [KIND_BODY] = write_body,
};

static bool is_present(const writer *w, const pdmc_study_setting *s, const char *base)
{
    if (!pdmc_study_setting_of_kind(s, w->problem->kind) || !pdmc_study_setting_belongs(s, base)) return false;
    if (s->kind == KIND_REALS) return *(const int *)(base + s->flag) > 0;
    const bool is_optional = s->kind == KIND_OPTIONAL || (s->kind == KIND_BODY && s->flag > 0);
    return !is_optional || *(const bool *)(base + s->flag);
}

static void write_record(const writer *w, pdmc_study_section_id section, const char *base, const char *indent)
{
    for (const pdmc_study_setting *s = pdmc_study_settings; s->key; s++) {
        if (s->section != section || !is_present(w, s, base)) continue;
        fprintf(w->out, "%s%s = ", indent, s->key);
        writers[s->kind](w, s, s->offset == NOT_STORED ? NULL : base + s->offset);
        fputc(';', w->out);
        if (s->unit != UNIT_NONE) fputs(" # ", w->out);
        pdmc_study_print_unit(w->out, s->unit, &w->units);
        fputc('\n', w->out);
    }
}

static void write_list(const writer *w, pdmc_study_section_id id)
{
    const pdmc_study_section *section = &pdmc_study_sections[id];
    const char *home = pdmc_study_home(section, w->study);
    const char *items;
    int count;
    memcpy(&items, home + section->items, sizeof items);
    memcpy(&count, home + section->count, sizeof count);
    fprintf(w->out, "%s = (", section->name);
    for (int i = 0; i < count; i++) {
        fputs(i > 0 ? ", {\n" : "{\n", w->out);
        write_record(w, id, items + (size_t)i * section->size, "    ");
        fputc('}', w->out);
    }
    fputs(");\n", w->out);
}

static void write_section(const writer *w, pdmc_study_section_id id)
{
    const char *name = pdmc_study_sections[id].name;
    const char *home = pdmc_study_home(&pdmc_study_sections[id], w->study);
    if (pdmc_study_sections[id].size > 0) {
        write_list(w, id);
    } else if (*name) {
        fprintf(w->out, "%s = {\n", name);
        write_record(w, id, home, "    ");
        fputs("};\n", w->out);
    } else {
        write_record(w, id, home, "");
    }
}

pdmc_status pdmc_study_resolve(pdmc_study *study)
{
    pdmc_status status = PDMC_OK;
    pdmc_study_text text = {0};
    char *resolved = NULL;
    PDMC_TRY(pdmc_study_text_open(&text));
    const pdmc_problem *p = &study->problem;
    const writer w = {text.out, p, &study->motion, study, {p->length_unit, p->force_unit, p->time_unit}};
    for (pdmc_study_section_id id = SECTION_TOP; id < SECTIONS; id++)
        if (pdmc_study_section_belongs(&pdmc_study_sections[id], p->kind)) write_section(&w, id);
    PDMC_TRY(pdmc_study_text_close(&text));
    PDMC_TRY(pdmc_study_text_copy(&text, &resolved));
    pdmc_free(study->resolved);
    study->resolved = resolved;
done:
    pdmc_study_text_drop(&text);
    return status;
}
