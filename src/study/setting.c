// SPDX-License-Identifier: GPL-3.0-or-later

/// What can be asked of a setting or a section: whether it belongs, where it is kept, in what unit, and what it may be.

#include "study/schema.h"

#include <math.h>
#include <string.h>

pdmc_study_solver pdmc_study_solver_of(const pdmc_problem *problem)
{
    static const pdmc_study_solver of_cracks[] = {[PDMC_CRACKS_ANALYTIC] = SOLVER_ANALYTIC,
                                                  [PDMC_CRACKS_PAPER] = SOLVER_PAPER,
                                                  [PDMC_CRACKS_VISIBLE] = SOLVER_VISIBLE};
    switch (problem->solver.method) {
    case PDMC_METHOD_KANSA: break;
    case PDMC_METHOD_BOND: return SOLVER_BOND;
    case PDMC_METHOD_GALERKIN: return SOLVER_GALERKIN;
    }
    return of_cracks[problem->solver.crack_model];
}

const pdmc_study_setting *pdmc_study_find_setting(pdmc_study_section_id section, const char *key)
{
    for (const pdmc_study_setting *s = pdmc_study_settings; s->key; s++)
        if (s->section == section && strcmp(s->key, key) == 0) return s;
    return NULL;
}

static bool has_value(const pdmc_study_setting *setting, const void *base)
{
    int value;
    const pdmc_study_setting *of = pdmc_study_find_setting(setting->section, setting->of);
    memcpy(&value, (const char *)base + of->offset, sizeof value);
    return setting->values & ONLY(value);
}

bool pdmc_study_setting_belongs(const pdmc_study_setting *setting, const void *base)
{
    if (setting->of) return has_value(setting, base);
    if (setting->solvers != 0) return setting->solvers & ONLY(pdmc_study_solver_of(base));
    if (setting->quantities == 0) return true;
    const pdmc_uncertainty *uncertainty = base;
    return setting->quantities & ONLY(uncertainty->quantity);
}

bool pdmc_study_setting_of_kind(const pdmc_study_setting *setting, pdmc_problem_kind kind)
{
    return setting->kinds == 0 || setting->kinds & ONLY(kind);
}

void *pdmc_study_home(const pdmc_study_section *section, const pdmc_study *study)
{
    const unsigned of_bodies = ONLY(PDMC_EXPLICIT) | ONLY(PDMC_QUASI_STATIC);
    if (section->kinds == ONLY(PDMC_SCALAR)) return (void *)&study->scalar;
    if (section->kinds == ONLY(PDMC_ELASTIC)) return (void *)&study->elastic;
    if (section->kinds == ONLY(PDMC_QUADRATURE)) return (void *)&study->quadrature;
    if (section->kinds != 0 && (section->kinds & ~of_bodies) == 0) return (void *)&study->motion;
    return (void *)&study->problem;
}

bool pdmc_study_section_belongs(const pdmc_study_section *section, pdmc_problem_kind kind)
{
    return section->kinds == 0 || section->kinds & ONLY(kind);
}

void pdmc_study_print_unit(FILE *out, pdmc_study_unit unit, const pdmc_study_units *units)
{
    const char *length = units->length, *force = units->force, *time = units->time;
    switch (unit) {
    case UNIT_NONE: break;
    case UNIT_LENGTH: fputs(length, out); break;
    case UNIT_STRESS: fprintf(out, "%s/%s^2", force, length); break;
    case UNIT_LINE_FORCE: fprintf(out, "%s/%s", force, length); break;
    case UNIT_TIME: fputs(time, out); break;
    case UNIT_RATE: fprintf(out, "1/%s", time); break;
    case UNIT_MASS_DENSITY: fprintf(out, "%s %s^2/%s^4", force, time, length); break;
    case UNIT_MASS: fprintf(out, "%s %s^2/%s", force, time, length); break;
    case UNIT_VELOCITY: fprintf(out, "%s/%s", length, time); break;
    case UNIT_MICROMODULUS: fprintf(out, "%s/%s^6", force, length); break;
    case UNIT_PENALTY: fprintf(out, "%s/%s^5", force, length); break;
    case UNIT_DAMPING: fprintf(out, "%s %s/%s^4", force, time, length); break;
    case UNIT_PER_LENGTH: fprintf(out, "1/%s", length); break;
    case UNIT_SLOWNESS: fprintf(out, "%s/%s", time, length); break;
    }
}

static void print_choices(FILE *out, const char *const choices[])
{
    for (int i = 0; choices[i]; i++) {
        if (i > 0) fputs(choices[i + 1] ? ", " : " or ", out);
        fprintf(out, "\"%s\"", choices[i]);
    }
}

static void print_bounds(FILE *out, const pdmc_study_range *range)
{
    if (!isfinite(range->low)) fputs("finite", out);
    else if (!isfinite(range->high)) fprintf(out, "%s %.15g", range->excluded ? ">" : ">=", range->low);
    else if (range->excluded) fprintf(out, "> %.15g and %s %.15g", range->low, range->below ? "<" : "<=", range->high);
    else fprintf(out, "from %.15g to %.15g", range->low, range->high);
}

static void print_array(FILE *out, const pdmc_study_range *range)
{
    fputs("an array of 2 reals or more, [x1, x2, ...]", out);
    if (isfinite(range->low)) fputs(", each ", out);
    if (isfinite(range->low)) print_bounds(out, range);
}

void pdmc_study_print_range(FILE *out, const pdmc_study_setting *setting)
{
    if (setting->kind == KIND_CHOICE) print_choices(out, setting->choices);
    else if (setting->kind == KIND_TEXT) fputs("a text, not empty and without control characters", out);
    else if (setting->kind == KIND_NAME) fprintf(out, "a text of 1 to %d letters, digits, _ or -", PDMC_NAME_SIZE - 1);
    else if (setting->kind == KIND_CRACK) fputs("the name of a crack", out);
    else if (setting->kind == KIND_MATERIAL) fputs("the name of one of the materials", out);
    else if (setting->kind == KIND_BODY) fputs(setting->flag > 0 ? "the name of an earlier body" : "the name of one of the bodies", out);
    else if (setting->kind == KIND_TIPS) fputs("an array of names of tips", out);
    else if (setting->kind == KIND_REALS) print_array(out, &setting->range);
    else print_bounds(out, &setting->range);
}

const char *pdmc_study_kind_noun(pdmc_study_kind kind)
{
    static const char *const nouns[KINDS] = {
        [KIND_REAL] = "a real",
        [KIND_OPTIONAL] = "a real that is",
        [KIND_PAIR] = "two reals [x, y], each",
        [KIND_VECTOR] = "as many reals as grid.dimension, [x, y] or [x, y, z], each",
        [KIND_INT] = "an integer",
        [KIND_SEED] = "an integer",
    };
    return nouns[kind] ? nouns[kind] : "";
}
