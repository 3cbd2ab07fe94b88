// SPDX-License-Identifier: GPL-3.0-or-later

/// What the settings of a scalar study mean together.

#include "study/study_impl.h"

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
    return pdmc_study_check_mesh(reader);
}

pdmc_status pdmc_study_check_wave(const pdmc_study_reader *reader)
{
    const pdmc_scalar *s = reader->scalar;
    if (s->dimension == 2 || s->angle == 0.0) return PDMC_OK;
    return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_WAVE, -1, "angle"},
                             "%g is not allowed in one dimension, must be 0", s->angle);
}

pdmc_status pdmc_study_check_convergence(const pdmc_study_reader *reader)
{
    const pdmc_scalar *s = reader->scalar;
    const double element_limit = 5e6, elements = pdmc_scalar_cost_of(s, s->levels - 1, 1).elements;
    if (elements <= element_limit) return PDMC_OK;
    return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_CONVERGENCE, -1, "levels"},
                             "the last of %d levels would have %.2g elements, must be at most %.2g", s->levels,
                             elements, element_limit);
}

pdmc_status pdmc_study_check_march(const pdmc_study_reader *reader)
{
    const pdmc_scalar *s = reader->scalar;
    if (!s->has_duration || s->vary == PDMC_VARY_SPACING) return PDMC_OK;
    return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_MARCH, -1, "duration"},
                             "motion is for convergence.vary = \"spacing\" only");
}
