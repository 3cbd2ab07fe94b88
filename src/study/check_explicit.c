// SPDX-License-Identifier: GPL-3.0-or-later

/// Grid, time and record of an explicit study, and those of their defaults that rest on other settings.

#include "study/study_impl.h"

#include <math.h>

static pdmc_status refuse(const pdmc_study_reader *reader, pdmc_study_section_id section, const char *key, double found,
                          const char *what, double bound, const char *of)
{
    return pdmc_study_refuse(reader, (pdmc_study_address){section, -1, key}, "%g is too %s %g, %s", found, what, bound,
                             of);
}

pdmc_status pdmc_study_check_particle_grid(const pdmc_study_reader *reader)
{
    pdmc_explicit *m = reader->motion;
    if (m->has_horizon && m->has_horizon_ratio)
        return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_PARTICLE_GRID, -1, "horizon_ratio"},
                                 "is given beside a horizon, must be one of the two");
    if (!m->has_horizon) m->horizon = (m->has_horizon_ratio ? m->horizon_ratio : 3.0) * m->spacing;
    m->has_horizon = true;
    m->has_horizon_ratio = false;
    if (pdmc_study_with_rounding(m->horizon) < m->spacing)
        return refuse(reader, SECTION_PARTICLE_GRID, "horizon", m->horizon, "small, must be at least", m->spacing,
                      "the spacing");
    if (m->horizon > pdmc_study_with_rounding(20.0 * m->spacing))
        return refuse(reader, SECTION_PARTICLE_GRID, "horizon", m->horizon, "large, must be at most", 20.0 * m->spacing,
                      "20 spacings");
    if (m->precision == PDMC_PRECISION_SINGLE && reader->problem->kind == PDMC_QUASI_STATIC)
        return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_PARTICLE_GRID, -1, "precision"},
                                 "\"single\" is not allowed in a quasi-static study, must be \"double\": rounded "
                                 "displacements keep forces from being in balance");
    return PDMC_OK;
}

// At rest there is no velocity.
static pdmc_status refuse_motion(const pdmc_study_reader *reader)
{
    const pdmc_explicit *m = reader->motion;
    for (int i = 0; i < m->condition_count; i++)
        if (m->conditions[i].layer.kind == PDMC_CONDITION_VELOCITY)
            return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_CONDITIONS, i, "prescribed"},
                                     "\"velocity\" is not allowed in a quasi-static study, must be \"displacement\" or "
                                     "\"force\"");
    for (int i = 0; i < m->body_count; i++)
        for (int a = 0; a < PDMC_AXES; a++)
            if (m->bodies[i].body.velocity[a] != 0.0)
                return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_BODIES, i, "velocity"},
                                         "is not zero, must be in a quasi-static study");
    return PDMC_OK;
}

pdmc_status pdmc_study_check_loading(const pdmc_study_reader *reader)
{
    reader->motion->load_ends[0] = 0.0;
    return refuse_motion(reader);
}

// Nodes that are not those of the grid have a stable step of their own, which the engine finds; so have those of interfaces.
static bool are_on_the_grid(const pdmc_explicit *m)
{
    for (int i = 0; i < m->body_count; i++)
        if (pdmc_shape_has_nodes(m->bodies[i].body.shape.kind)) return false;
    return true;
}

pdmc_status pdmc_study_check_time(const pdmc_study_reader *reader)
{
    const pdmc_explicit *m = reader->motion;
    const double step_limit = 1e9;
    if (!m->has_step) return PDMC_OK;
    if (m->step > pdmc_study_with_rounding(m->duration))
        return refuse(reader, SECTION_TIME, "step", m->step, "large, must be at most", m->duration, "the duration");
    if (m->duration / m->step > step_limit)
        return refuse(reader, SECTION_TIME, "step", m->step, "small, must be at least", m->duration / step_limit,
                      "a thousand millionth of the duration");
    if (are_on_the_grid(m) && !pdmc_explicit_has_joints(m) && m->step > pdmc_explicit_stable_step(m))
        return refuse(reader, SECTION_TIME, "step", m->step, "large, must be at most", pdmc_explicit_stable_step(m),
                      "the largest stable one");
    return PDMC_OK;
}

// A quasi-static study records every load.
static pdmc_status check_record_of_loads(const pdmc_study_reader *reader)
{
    const char *key = reader->motion->has_interval ? "interval" : "speed_window";
    if (!reader->motion->has_interval && !reader->motion->has_speed_window) return PDMC_OK;
    return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_RECORD, -1, key},
                             "is no setting of a quasi-static study, which has no time");
}

pdmc_status pdmc_study_check_record(const pdmc_study_reader *reader)
{
    pdmc_explicit *m = reader->motion;
    const double record_limit = 1e6;
    if (reader->problem->kind == PDMC_QUASI_STATIC) return check_record_of_loads(reader);
    if (!m->has_interval) m->interval = m->duration / 100.0;
    if (!m->has_speed_window) m->speed_window = 10.0 * m->interval;
    m->has_interval = m->has_speed_window = true;
    if (m->interval > pdmc_study_with_rounding(m->duration))
        return refuse(reader, SECTION_RECORD, "interval", m->interval, "large, must be at most", m->duration,
                      "the duration");
    if (m->duration / m->interval > pdmc_study_with_rounding(record_limit))
        return refuse(reader, SECTION_RECORD, "interval", m->interval, "small, must be at least",
                      m->duration / record_limit, "a millionth of the duration");
    return PDMC_OK;
}
