// SPDX-License-Identifier: GPL-3.0-or-later

/// What finite elements of a plate need of the study.

#include "study/study_impl.h"

#include <math.h>

static pdmc_study_address at(const char *key)
{
    return (pdmc_study_address){SECTION_SOLVER, -1, key};
}

static pdmc_status check_kind(const pdmc_study_reader *reader)
{
    if (reader->problem->kind == PDMC_STATIC) return PDMC_OK;
    return pdmc_study_refuse(reader, at("method"), "\"galerkin\" has no dynamic studies yet, must be \"kansa\"");
}

// Beyond a side that is held the mesh would go on.
static pdmc_status check_mesh(const pdmc_study_reader *reader)
{
    pdmc_slit slits[PDMC_GALERKIN_CRACKS];
    const pdmc_mesh_plate plate = pdmc_problem_mesh_plate(reader->problem, slits);
    if (reader->problem->support_count > 0)
        return pdmc_study_refuse(reader, at("mesh"),
                                 "\"triangles\" is not available with supports yet, must be \"cells\"");
    if (pdmc_mesh_check_plate(&plate) == PDMC_OK) return PDMC_OK;
    return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_CRACKS, -1, NULL}, "%s", pdmc_last_error());
}

// The lines of the mesh go through cracks.
static pdmc_status check_cracks(const pdmc_study_reader *reader)
{
    const pdmc_problem *p = reader->problem;
    if (p->crack_count > PDMC_GALERKIN_CRACKS)
        return pdmc_study_refuse(reader, at("method"),
                                 "\"galerkin\" has at most %d cracks, must be \"kansa\" or \"bond\"",
                                 PDMC_GALERKIN_CRACKS);
    if (p->solver.mesh == PDMC_PLATE_TRIANGLES) return check_mesh(reader);
    for (int c = 0; c < p->crack_count; c++) {
        const pdmc_crack *crack = &p->cracks[c];
        const double width = fabs(crack->to[0] - crack->from[0]), height = fabs(crack->to[1] - crack->from[1]);
        if (fmin(width, height) > 1e-9 * fmax(width, height))
            return pdmc_study_refuse(
                reader, (pdmc_study_address){SECTION_CRACKS, c, NULL},
                "\"%s\" is at an angle to the sides of the plate: that needs mesh = \"triangles\", method = "
                "\"kansa\" or \"bond\", or a crack parallel to a side",
                crack->name);
    }
    return PDMC_OK;
}

// A triangle beyond the horizon of another one's points pulls nothing there.
static pdmc_status check_spacing(const pdmc_study_reader *reader)
{
    const double value_limit = 2e5;
    const pdmc_problem *p = reader->problem;
    const double h = p->solver.spacing, nodes = p->plate.width / h * (p->plate.height / h);
    const double values = nodes * (p->solver.space == PDMC_SPACE_DISCONTINUOUS ? 6.0 : 1.0);
    if (pdmc_study_with_rounding(p->solver.horizon) < h)
        return pdmc_study_refuse(reader, at("spacing"), "%g is too large, must be at most %g, the horizon", h,
                                 p->solver.horizon);
    if (!(values <= pdmc_study_with_rounding(value_limit)))
        return pdmc_study_refuse(reader, at("spacing"), "%g gives %.0f values, must be at most %.0f", h, values,
                                 value_limit);
    if (p->crack_count > 0 && p->solver.horizon < 3.0 * h * (1.0 - 1e-9))
        pdmc_study_warn(reader, at("spacing"), "%g is %.2g of the horizon: at cracks a third at most is advised", h,
                        h / p->solver.horizon);
    return PDMC_OK;
}

static pdmc_status check_horizon(const pdmc_study_reader *reader)
{
    const pdmc_problem *p = reader->problem;
    const double horizon = p->solver.horizon, h = p->solver.spacing, ratio = p->solver.horizon_ratio;
    const double largest = 0.5 * fmin(p->plate.width, p->plate.height);
    if (p->solver.has_horizon_ratio && fabs(horizon - ratio * h) > 1e-9 * horizon)
        return pdmc_study_refuse(reader, at("horizon_ratio"), "%g spacings are %g, but the horizon is %g: give one",
                                 ratio, ratio * h, horizon);
    if (horizon > pdmc_study_with_rounding(largest))
        return pdmc_study_refuse(reader, at("horizon"), "%g is too large, must be at most %g, half of the shorter side",
                                 horizon, largest);
    if (p->solver.load_layer > pdmc_study_with_rounding(largest))
        return pdmc_study_refuse(reader, at("load_layer"),
                                 "%g is too thick, must be at most %g, half of the shorter side", p->solver.load_layer,
                                 largest);
    return PDMC_OK;
}

pdmc_status pdmc_study_check_triangles(const pdmc_study_reader *reader)
{
    pdmc_status status = check_kind(reader);
    if (status == PDMC_OK) status = check_cracks(reader);
    if (status == PDMC_OK) status = check_spacing(reader);
    if (status == PDMC_OK) status = check_horizon(reader);
    return status;
}
