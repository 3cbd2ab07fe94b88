// SPDX-License-Identifier: GPL-3.0-or-later

/// Sides: each is loaded and held once, there is a load, and nothing that is loaded is free to fly off.

#include "study/study_impl.h"

static const char axes[2] = {'x', 'y'};

static pdmc_status check_supports(const pdmc_study_reader *reader)
{
    const pdmc_problem *p = reader->problem;
    for (int i = 0; i < p->support_count; i++) {
        const pdmc_support *support = &p->supports[i];
        if (!support->held[0] && !support->held[1])
            return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_SUPPORTS, i, NULL},
                                     "holds nothing, must have x or y or both");
        for (int j = 0; j < i; j++)
            for (int k = 0; k < 2; k++)
                if (p->supports[j].side == support->side && p->supports[j].held[k] && support->held[k])
                    return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_SUPPORTS, i, "side"},
                                             "held in %c by an earlier support already", axes[k]);
    }
    return PDMC_OK;
}

static pdmc_status check_load(const pdmc_study_reader *reader, int index)
{
    const pdmc_problem *p = reader->problem;
    const pdmc_load *load = &p->loads[index];
    for (int i = 0; i < index; i++)
        if (p->loads[i].side == load->side)
            return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_LOADS, index, "side"},
                                     "loaded already, must be once for each side");
    for (int i = 0; i < p->support_count; i++)
        for (int k = 0; k < 2; k++)
            if (p->supports[i].side == load->side && p->supports[i].held[k] && load->traction[k] != 0.0)
                return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_LOADS, index, "traction"},
                                         "acts in %c, in which a support holds the side; one of the two must go",
                                         axes[k]);
    return PDMC_OK;
}

static bool is_loaded(const pdmc_problem *p)
{
    for (int i = 0; i < p->load_count; i++)
        if (p->loads[i].traction[0] != 0.0 || p->loads[i].traction[1] != 0.0) return true;
    for (int i = 0; i < p->support_count; i++)
        if (p->supports[i].displacement[0] != 0.0 || p->supports[i].displacement[1] != 0.0) return true;
    return false;
}

static pdmc_status check_equilibrium(const pdmc_study_reader *reader)
{
    const pdmc_status status = pdmc_problem_check_equilibrium(reader->problem);
    if (status != PDMC_ERR_CONFIG) return status;
    return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_LOADS, -1, NULL}, "%s", pdmc_last_error());
}

pdmc_status pdmc_study_check_loads(const pdmc_study_reader *reader)
{
    pdmc_status status = check_supports(reader);
    for (int i = 0; i < reader->problem->load_count && status == PDMC_OK; i++) status = check_load(reader, i);
    if (status != PDMC_OK) return status;
    if (!is_loaded(reader->problem))
        return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_LOADS, -1, NULL},
                                 "no load: every traction and every prescribed displacement is zero");
    return check_equilibrium(reader);
}
