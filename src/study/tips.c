// SPDX-License-Identifier: GPL-3.0-or-later

/// Cracks and their tips by name.

#include "study/study_impl.h"

#include "base/base_impl.h"

#include <string.h>

void pdmc_study_tip_name(const pdmc_problem *problem, int tip, char name[PDMC_STUDY_TIP_NAME_SIZE])
{
    snprintf(name, PDMC_STUDY_TIP_NAME_SIZE, "%s.%s", problem->cracks[tip / 2].name, tip % 2 ? "to" : "from");
}

static pdmc_status refuse_crack(const pdmc_study_reader *reader, pdmc_study_address address, const char *wanted)
{
    pdmc_study_nearest nearest = pdmc_study_nearest_to(wanted);
    for (int c = 0; c < reader->problem->crack_count; c++)
        pdmc_study_nearest_offer(&nearest, reader->problem->cracks[c].name);
    return *nearest.best
               ? pdmc_study_refuse(reader, address, "no crack \"%.80s\", did you mean \"%s\"?", wanted, nearest.best)
               : pdmc_study_refuse(reader, address, "no crack \"%.80s\"", wanted);
}

pdmc_status pdmc_study_parse_crack(const pdmc_study_reader *reader, pdmc_study_address address,
                                   const config_setting_t *value, int *crack)
{
    const pdmc_problem *problem = reader->problem;
    if (problem->crack_count == 0) return pdmc_study_refuse(reader, address, "there are no cracks");
    const char *name = value ? config_setting_get_string(value) : problem->cracks[0].name;
    for (*crack = 0; *crack < problem->crack_count; ++*crack)
        if (strcmp(problem->cracks[*crack].name, name) == 0) return PDMC_OK;
    return refuse_crack(reader, address, name);
}

static int find_tip(const pdmc_problem *problem, const char *wanted)
{
    char name[PDMC_STUDY_TIP_NAME_SIZE];
    for (int tip = 0; tip < 2 * problem->crack_count; tip++) {
        pdmc_study_tip_name(problem, tip, name);
        if (strcmp(name, wanted) == 0) return tip;
    }
    return -1;
}

/// Names the tip that may have been meant, and all that there are.
static pdmc_status refuse_tip(const pdmc_study_reader *reader, pdmc_study_address address, const char *wanted)
{
    pdmc_status status = PDMC_OK;
    const int count = 2 * reader->problem->crack_count;
    char name[PDMC_STUDY_TIP_NAME_SIZE];
    pdmc_study_nearest nearest = pdmc_study_nearest_to(wanted);
    pdmc_study_text list = {0};
    PDMC_TRY(pdmc_study_text_open(&list));
    fprintf(list.out, "the tips are ");
    for (int tip = 0; tip < count; tip++) {
        pdmc_study_tip_name(reader->problem, tip, name);
        pdmc_study_nearest_offer(&nearest, name);
        fprintf(list.out, "%s%s", tip > 0 ? ", " : "", name);
    }
    PDMC_TRY(pdmc_study_text_close(&list));
    const char *tips = count > 0 ? list.bytes : "there are no cracks";
    status = *nearest.best ? pdmc_study_refuse(reader, address, "no tip \"%.80s\", did you mean \"%s\"? (%s)", wanted,
                                               nearest.best, tips)
                           : pdmc_study_refuse(reader, address, "no tip \"%.80s\", %s", wanted, tips);
done:
    pdmc_study_text_drop(&list);
    return status;
}

static pdmc_status read_tip(const pdmc_study_reader *reader, pdmc_study_address address, const config_setting_t *value)
{
    pdmc_energy_request *energy = &reader->problem->energy;
    if (config_setting_type(value) != CONFIG_TYPE_STRING)
        return pdmc_study_refuse(reader, address, "an element is no text, must be the name of a tip");
    const char *name = config_setting_get_string(value);
    const int tip = find_tip(reader->problem, name);
    if (tip < 0) return refuse_tip(reader, address, name);
    if (!pdmc_problem_is_tip(reader->problem, tip))
        return pdmc_study_refuse(reader, address, "\"%s\" is no tip: the crack goes through the edge there", name);
    for (int i = 0; i < energy->tip_count; i++)
        if (energy->tips[i] == tip) return pdmc_study_refuse(reader, address, "\"%s\" is there twice", name);
    energy->tips[energy->tip_count++] = tip;
    return PDMC_OK;
}

pdmc_status pdmc_study_parse_tips(const pdmc_study_reader *reader, pdmc_study_address address,
                                  const config_setting_t *value)
{
    pdmc_status status = PDMC_OK;
    pdmc_energy_request *energy = &reader->problem->energy;
    const int count = value ? config_setting_length(value) : 2 * reader->problem->crack_count;
    PDMC_NEW(energy->tips, count);
    for (int i = 0; value && i < count; i++)
        PDMC_TRY(read_tip(reader, address, config_setting_get_elem(value, (unsigned)i)));
    for (int tip = 0; !value && tip < count; tip++)
        if (pdmc_problem_is_tip(reader->problem, tip)) energy->tips[energy->tip_count++] = tip;
done:
    return status;
}
