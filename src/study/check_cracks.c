// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/study_impl.h"

#include "pdmc/geometry.h"

#include <math.h>
#include <string.h>

static pdmc_status refuse(const pdmc_study_reader *reader, int crack, const char *key, const char *what)
{
    return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_CRACKS, crack, key}, "\"%s\" %s",
                             reader->problem->cracks[crack].name, what);
}

static pdmc_status check_crack(const pdmc_study_reader *reader, int index)
{
    const pdmc_crack *crack = &reader->problem->cracks[index];
    if (!pdmc_problem_is_tip(reader->problem, 2 * index) && !pdmc_problem_is_tip(reader->problem, 2 * index + 1))
        return refuse(reader, index, NULL, "has no tip inside the plate, must have at least one");
    if (!(pdmc_study_half_crack(crack) > 0.0)) return refuse(reader, index, NULL, "has zero length");
    return PDMC_OK;
}

static pdmc_status check_name(const pdmc_study_reader *reader, int first, int second)
{
    const pdmc_crack *cracks = reader->problem->cracks;
    if (strcmp(cracks[first].name, cracks[second].name) != 0) return PDMC_OK;
    return refuse(reader, second, "name", "is the name of an earlier crack too, must be another");
}

pdmc_status pdmc_study_check_cracks(const pdmc_study_reader *reader)
{
    pdmc_status status = PDMC_OK;
    for (int i = 0; i < reader->problem->crack_count && status == PDMC_OK; i++) {
        status = check_crack(reader, i);
        for (int j = 0; j < i && status == PDMC_OK; j++) status = check_name(reader, j, i);
    }
    return status;
}

pdmc_status pdmc_study_check_inner_tips(const pdmc_study_reader *reader, const char *instead)
{
    const pdmc_problem *problem = reader->problem;
    for (int tip = 0; tip < 2 * problem->crack_count; tip++)
        if (!pdmc_problem_is_tip(problem, tip))
            return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_CRACKS, tip / 2, tip % 2 ? "to" : "from"},
                                     "\"%s\" ends outside the plate or on its edge: that needs %s, or a tip inside",
                                     problem->cracks[tip / 2].name, instead);
    return PDMC_OK;
}

pdmc_status pdmc_study_check_apart(const pdmc_study_reader *reader, const char *instead)
{
    const pdmc_problem *problem = reader->problem;
    for (int i = 0; i < problem->crack_count; i++)
        for (int j = 0; j < i; j++) {
            const pdmc_crack *a = &problem->cracks[j], *b = &problem->cracks[i];
            if (pdmc_segments_cross(a->from, a->to, b->from, b->to))
                return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_CRACKS, i, NULL},
                                         "\"%s\" crosses or touches \"%s\": that needs %s, or cracks apart", b->name,
                                         a->name, instead);
        }
    return PDMC_OK;
}
