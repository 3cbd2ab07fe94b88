// SPDX-License-Identifier: GPL-3.0-or-later

/// What belongs to motion: its steps, the history of the load, and the points that are watched.

#include "study/study_impl.h"

#include "base/base_impl.h"

#include <math.h>
#include <string.h>

// The energy that goes through a side which is moved is not accounted for yet.
static pdmc_status check_supports(const pdmc_study_reader *reader)
{
    static const char *const keys[2] = {"x", "y"};
    for (int i = 0; i < reader->problem->support_count; i++)
        for (int k = 0; k < 2; k++)
            if (reader->problem->supports[i].displacement[k] != 0.0)
                return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_SUPPORTS, i, keys[k]},
                                         "must be 0 in a dynamic study: sides that are moved are not available yet");
    return PDMC_OK;
}

static pdmc_status check_steps(const pdmc_study_reader *reader)
{
    const double limit = 1e6;
    const pdmc_dynamics *dynamics = &reader->problem->dynamics;
    const double steps = dynamics->duration / dynamics->step;
    const pdmc_study_address address = {SECTION_DYNAMICS, -1, "step"};
    if (dynamics->step > pdmc_study_with_rounding(dynamics->duration))
        return pdmc_study_refuse(reader, address, "%g is too large, must be at most %g, the duration", dynamics->step,
                                 dynamics->duration);
    if (!(steps <= limit))
        return pdmc_study_refuse(reader, address, "%g makes %.3g steps of the duration, must be at most %g",
                                 dynamics->step, steps, limit);
    return PDMC_OK;
}

pdmc_status pdmc_study_check_dynamics(const pdmc_study_reader *reader)
{
    if (reader->problem->solver.crack_model != PDMC_CRACKS_ANALYTIC)
        return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_SOLVER, -1, "crack_model"},
                                 "has no motion yet, must be \"analytic\" in a dynamic study");
    const pdmc_status status = check_supports(reader);
    return status == PDMC_OK ? check_steps(reader) : status;
}

static pdmc_status load_from_the_start(pdmc_problem *problem)
{
    pdmc_status status = PDMC_OK;
    pdmc_free(problem->history); // of a list without elements
    PDMC_NEW(problem->history, 1);
    problem->history[0] = (pdmc_history_point){.time = 0.0, .factor = 1.0};
    problem->history_count = 1;
done:
    return status;
}

pdmc_status pdmc_study_check_history(const pdmc_study_reader *reader)
{
    pdmc_problem *p = reader->problem;
    if (p->history_count == 0) return load_from_the_start(p);
    for (int i = 1; i < p->history_count; i++)
        if (!(p->history[i].time > p->history[i - 1].time))
            return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_HISTORY, i, "time"},
                                     "%g is not after %g, times must ascend", p->history[i].time,
                                     p->history[i - 1].time);
    return PDMC_OK;
}

static pdmc_status check_probe(const pdmc_study_reader *reader, int index)
{
    const pdmc_problem *p = reader->problem;
    const pdmc_probe *probe = &p->probes[index];
    const bool is_outside = fabs(probe->at[0]) > pdmc_study_with_rounding(0.5 * p->plate.width) ||
                            fabs(probe->at[1]) > pdmc_study_with_rounding(0.5 * p->plate.height);
    if (is_outside)
        return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_PROBES, index, "at"},
                                 "\"%s\" is outside the plate", probe->name);
    const int crack = pdmc_problem_crack_at(p, probe->at);
    const pdmc_study_address side = {SECTION_PROBES, index, "side"};
    if (crack >= 0 && probe->face == PDMC_FACE_NONE)
        return pdmc_study_refuse(reader, side, "\"%s\" lies on the crack \"%s\", must be \"left\" or \"right\"",
                                 probe->name, p->cracks[crack].name);
    if (crack < 0 && probe->face != PDMC_FACE_NONE)
        return pdmc_study_refuse(reader, side, "\"%s\" lies on no crack, must be \"none\"", probe->name);
    return PDMC_OK;
}

pdmc_status pdmc_study_check_probes(const pdmc_study_reader *reader)
{
    pdmc_status status = PDMC_OK;
    const pdmc_probe *probes = reader->problem->probes;
    for (int i = 0; i < reader->problem->probe_count && status == PDMC_OK; i++) {
        status = check_probe(reader, i);
        for (int j = 0; j < i && status == PDMC_OK; j++)
            if (strcmp(probes[i].name, probes[j].name) == 0)
                status =
                    pdmc_study_refuse(reader, (pdmc_study_address){SECTION_PROBES, i, "name"},
                                      "\"%s\" is the name of an earlier probe too, must be another", probes[i].name);
    }
    return status;
}
