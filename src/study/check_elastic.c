// SPDX-License-Identifier: GPL-3.0-or-later

/// What the settings of an elastic study mean together.

#include "study/study_impl.h"

pdmc_status pdmc_study_check_solid(const pdmc_study_reader *reader)
{
    const pdmc_elastic *e = reader->elastic;
    const double most = 20.0 * e->spacing, node_limit = 5e6;
    const pdmc_study_address at = {SECTION_SOLID, -1, "horizon"};
    if (pdmc_study_with_rounding(e->horizon) < e->spacing)
        return pdmc_study_refuse(reader, at, "%g is too small, must be at least %g, the spacing", e->horizon,
                                 e->spacing);
    if (e->horizon > pdmc_study_with_rounding(most))
        return pdmc_study_refuse(reader, at, "%g is too large, must be at most %g, 20 spacings", e->horizon, most);
    if (pdmc_elastic_cost_of(e, 1).nodes > node_limit)
        return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_SOLID, -1, NULL},
                                 "%.2g nodes are not allowed, must be at most %.2g", pdmc_elastic_cost_of(e, 1).nodes,
                                 node_limit);
    return PDMC_OK;
}

pdmc_status pdmc_study_check_integration(const pdmc_study_reader *reader)
{
    pdmc_elastic *e = reader->elastic;
    if (!e->has_support) e->support = 3.0 * e->spacing;
    e->has_support = true;
    if (e->support <= pdmc_study_with_rounding(8.0 * e->spacing)) return PDMC_OK;
    return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_INTEGRATION, -1, "support"},
                             "%g is too large, must be at most %g, 8 spacings", e->support, 8.0 * e->spacing);
}

static bool is_pulled(const pdmc_elastic_condition *condition)
{
    const double *t = condition->load.traction;
    return t[0] != 0.0 || t[1] != 0.0 || t[2] != 0.0;
}

static pdmc_status check_face(const pdmc_study_reader *reader, int index)
{
    const pdmc_elastic *e = reader->elastic;
    const pdmc_elastic_condition *condition = &e->conditions[index];
    const pdmc_study_address at = {SECTION_FACES, index, "layers"};
    const int nodes = e->nodes[condition->face / 2];
    for (int i = 0; i < index; i++)
        if (e->conditions[i].face == condition->face)
            return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_FACES, index, "face"},
                                     "the face has been given before, must be given once");
    if (condition->layers > nodes)
        return pdmc_study_refuse(reader, at, "%d layers are not allowed, must be at most the %d of the body",
                                 condition->layers, nodes);
    if (condition->layers > 0 && is_pulled(condition))
        return pdmc_study_refuse(reader, at,
                                 "a face has layers with a prescribed displacement or a traction, not both");
    if (condition->load.gradient[condition->face / 2] != 0.0)
        return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_FACES, index, NULL},
                                 "the gradient of a traction must lie along its face");
    return PDMC_OK;
}

pdmc_status pdmc_study_check_faces_of_solid(const pdmc_study_reader *reader)
{
    const pdmc_elastic *e = reader->elastic;
    bool held = false;
    for (int i = 0; i < e->condition_count; i++) {
        const pdmc_status status = check_face(reader, i);
        if (status != PDMC_OK) return status;
        held = held || e->conditions[i].layers > 0;
    }
    if (held || (e->rule == PDMC_SOLID_CUBIC_CELL && e->condition_count > 0)) return PDMC_OK;
    return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_FACES, -1, NULL},
                             e->condition_count == 0
                                 ? "nothing holds or pulls the body: a face needs layers or a traction"
                                 : "Gauss points need a body that is held: a face must have layers");
}
