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

static bool is_inside(const pdmc_plate *plate, const double point[2])
{
    return fabs(point[0]) < 0.5 * plate->width && fabs(point[1]) < 0.5 * plate->height;
}

static pdmc_status check_crack(const pdmc_study_reader *reader, int index)
{
    const pdmc_crack *crack = &reader->problem->cracks[index];
    const pdmc_plate *plate = &reader->problem->plate;
    const char *outside =
        "ends outside the plate or on its edge: edge cracks are not available yet, a tip must be inside";
    if (!is_inside(plate, crack->from)) return refuse(reader, index, "from", outside);
    if (!is_inside(plate, crack->to)) return refuse(reader, index, "to", outside);
    if (!(pdmc_study_half_crack(crack) > 0.0)) return refuse(reader, index, NULL, "has zero length");
    return PDMC_OK;
}

static pdmc_status check_two(const pdmc_study_reader *reader, int first, int second)
{
    const pdmc_crack *a = &reader->problem->cracks[first], *b = &reader->problem->cracks[second];
    const pdmc_study_address address = {SECTION_CRACKS, second, NULL};
    if (strcmp(a->name, b->name) == 0)
        return refuse(reader, second, "name", "is the name of an earlier crack too, must be another");
    if (pdmc_segments_cross(a->from, a->to, b->from, b->to))
        return pdmc_study_refuse(reader, address,
                                 "\"%s\" crosses or touches \"%s\": not available yet, cracks must be apart", b->name,
                                 a->name);
    return PDMC_OK;
}

pdmc_status pdmc_study_check_cracks(const pdmc_study_reader *reader)
{
    pdmc_status status = PDMC_OK;
    for (int i = 0; i < reader->problem->crack_count && status == PDMC_OK; i++) {
        status = check_crack(reader, i);
        for (int j = 0; j < i && status == PDMC_OK; j++) status = check_two(reader, j, i);
    }
    return status;
}
