// SPDX-License-Identifier: GPL-3.0-or-later

/// What the settings of a scalar study mean together.

#include "study/study_impl.h"

#include "base/base_impl.h"

#include <math.h>

pdmc_status pdmc_study_check_kernel(const pdmc_study_reader *reader)
{
    const pdmc_scalar *s = reader->scalar;
    double sum = 0.0;
    for (int i = 0; i < s->weight_count; i++) sum += s->weights[i];
    const pdmc_study_address at = {SECTION_KERNEL, -1, "weights"};
    if (s->weight_count > PDMC_KERNEL_BINS)
        return pdmc_study_refuse(reader, at, "%d weights are not allowed, must be at most %d", s->weight_count,
                                 PDMC_KERNEL_BINS);
    if (s->weight_count > 0 && sum == 0.0) return pdmc_study_refuse(reader, at, "all are zero, one must be positive");
    return PDMC_OK;
}

// Bonds with a law are integrated by points.
static pdmc_status check_rules_of_law(const pdmc_study_reader *reader)
{
    const pdmc_scalar *s = reader->scalar;
    if (s->law.kind == PDMC_LAW_LINEAR) return PDMC_OK;
    if (s->outer == PDMC_OUTER_EXACT)
        return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_ELEMENTS, -1, "outer"},
                                 "\"exact\" is for linear bonds only, must be \"gauss\" or \"edges\" with a kernel.law");
    if (s->inner == PDMC_INNER_EXACT)
        return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_ELEMENTS, -1, "inner"},
                                 "\"exact\" is for linear bonds only, must be \"polynomial\" with a kernel.law");
    return PDMC_OK;
}

pdmc_status pdmc_study_check_elements(const pdmc_study_reader *reader)
{
    const pdmc_scalar *s = reader->scalar;
    const pdmc_study_address outer = {SECTION_ELEMENTS, -1, "outer"};
    if (s->outer == PDMC_OUTER_EXACT && s->dimension == 2)
        return pdmc_study_refuse(reader, outer, "\"exact\" is for one dimension only, must be \"gauss\" or \"edges\"");
    if (s->outer == PDMC_OUTER_EXACT && s->inner != PDMC_INNER_EXACT)
        return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_ELEMENTS, -1, "inner"},
                                 "the inner integral must be \"exact\" where the outer one is");
    if (s->outer == PDMC_OUTER_EDGES && s->dimension == 1 && s->power >= 1.0)
        return pdmc_study_refuse(reader, outer,
                                 "\"edges\" is not allowed in one dimension with kernel.power = %g: from the end of an "
                                 "interval the integral of the kernel is infinite, the power must be < 1",
                                 s->power);
    if (s->space == PDMC_SPACE_MIXED && s->rough_from >= s->rough_to)
        return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_ELEMENTS, -1, "rough_to"},
                                 "%g is not allowed, must be > rough_from = %g", s->rough_to, s->rough_from);
    const pdmc_status status = check_rules_of_law(reader);
    return status == PDMC_OK ? pdmc_study_check_mesh(reader) : status;
}

pdmc_status pdmc_study_check_wave(const pdmc_study_reader *reader)
{
    const pdmc_scalar *s = reader->scalar;
    if (s->dimension == 2 || s->angle == 0.0) return PDMC_OK;
    return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_WAVE, -1, "angle"},
                             "%g is not allowed in one dimension, must be 0", s->angle);
}

static pdmc_status read_table(const pdmc_study_reader *reader, pdmc_study_section_id section, pdmc_given *given)
{
    if (given->kind != PDMC_GIVEN_TABLE) return PDMC_OK;
    char *path = pdmc_study_path(reader, (pdmc_study_address){section, -1, "file"}, given->file);
    if (!path) return PDMC_ERR_NOMEM;
    const pdmc_status status = pdmc_given_read(path, reader->scalar->dimension, given);
    pdmc_free(path);
    return status;
}

pdmc_status pdmc_study_check_source(const pdmc_study_reader *reader)
{
    return read_table(reader, SECTION_SOURCE, &reader->scalar->source);
}

pdmc_status pdmc_study_check_prescribed(const pdmc_study_reader *reader)
{
    return read_table(reader, SECTION_PRESCRIBED, &reader->scalar->prescribed);
}

static bool is_zero(const pdmc_given *given)
{
    return given->kind == PDMC_GIVEN_CONSTANT && given->value == 0.0;
}

static pdmc_status check_sides(const pdmc_study_reader *reader)
{
    const pdmc_scalar *s = reader->scalar;
    if (s->open_count > 0 && s->mesh != PDMC_ELEMENTS_CELLS)
        return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_OPEN, -1, NULL},
                                 "open sides are for elements.mesh = \"cells\" only");
    for (int i = 0; i < s->open_count; i++) {
        const pdmc_study_address at = {SECTION_OPEN, i, "side"};
        if (s->open[i].side >= 2 * s->dimension)
            return pdmc_study_refuse(reader, at, "an interval has no such side, must be \"left\" or \"right\"");
        for (int j = 0; j < i; j++)
            if (s->open[j].side == s->open[i].side)
                return pdmc_study_refuse(reader, at, "is in the list already, must be another side");
    }
    if (s->open_count < 2 * s->dimension) return PDMC_OK;
    return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_OPEN, -1, NULL},
                             "all sides are open, one must be held: nothing else holds the field");
}

pdmc_status pdmc_study_check_open(const pdmc_study_reader *reader)
{
    const pdmc_scalar *s = reader->scalar;
    const pdmc_study_address wave = {SECTION_WAVE, -1, "length"};
    const bool is_own = !is_zero(&s->source) || !is_zero(&s->prescribed) || s->open_count > 0;
    if (s->has_wave && is_own)
        return pdmc_study_refuse(reader, wave, "is not allowed beside source, prescribed or open_sides: the wave has its own");
    if (!s->has_wave && !is_own)
        return pdmc_study_refuse(reader, wave, "is missing: without a wave there must be a source, prescribed values or open_sides");
    return check_sides(reader);
}

pdmc_status pdmc_study_check_convergence(const pdmc_study_reader *reader)
{
    const pdmc_scalar *s = reader->scalar;
    if (s->vary == PDMC_VARY_HORIZON && s->law.kind != PDMC_LAW_LINEAR)
        return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_CONVERGENCE, -1, "vary"},
                                 "\"horizon\" is for linear bonds only, which become classical elements, must be "
                                 "\"spacing\" with a kernel.law");
    const double element_limit = 5e6, elements = pdmc_scalar_cost_of(s, s->levels - 1, 1).elements;
    if (elements <= element_limit) return PDMC_OK;
    return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_CONVERGENCE, -1, "levels"},
                             "the last of %d levels would have %.2g elements, must be at most %.2g", s->levels,
                             elements, element_limit);
}

pdmc_status pdmc_study_check_march(const pdmc_study_reader *reader)
{
    const pdmc_scalar *s = reader->scalar;
    if (s->has_duration && s->has_wave && s->law.kind != PDMC_LAW_LINEAR)
        return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_MARCH, -1, "duration"},
                                 "a wave does not stand where bonds have a kernel.law, motion must be that of a source of "
                                 "the study's own");
    if (!s->has_duration || s->vary == PDMC_VARY_SPACING) return PDMC_OK;
    return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_MARCH, -1, "duration"},
                             "motion is for convergence.vary = \"spacing\" only");
}
