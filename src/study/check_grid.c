// SPDX-License-Identifier: GPL-3.0-or-later

/// What the grid of the bond method needs of the study.

#include "study/study_impl.h"

#include <math.h>

static pdmc_study_address at(const char *key)
{
    return (pdmc_study_address){SECTION_SOLVER, -1, key};
}

static pdmc_status check_division(const pdmc_study_reader *reader, double side, const char *name)
{
    const double h = reader->problem->solver.spacing, cells = side / h, whole = fmax(1.0, round(cells));
    if (fabs(cells - whole) <= 1e-9 * whole) return PDMC_OK;
    return pdmc_study_refuse(reader, at("spacing"), "%g does not divide the plate's %s %g, must be such as %.17g", h,
                             name, side, side / whole);
}

static pdmc_status check_size(const pdmc_study_reader *reader)
{
    const double node_limit = 4e6;
    const pdmc_problem *p = reader->problem;
    const double nodes = p->plate.width / p->solver.spacing * (p->plate.height / p->solver.spacing);
    if (nodes <= pdmc_study_with_rounding(node_limit)) return PDMC_OK;
    return pdmc_study_refuse(reader, at("spacing"), "%g gives %.0f nodes, must be at most %.0f", p->solver.spacing,
                             nodes, node_limit);
}

static pdmc_status check_horizon(const pdmc_study_reader *reader)
{
    const pdmc_problem *p = reader->problem;
    const double horizon = p->solver.horizon, h = p->solver.spacing, ratio = p->solver.horizon_ratio;
    const double largest = 0.5 * fmin(p->plate.width, p->plate.height);
    if (p->solver.has_horizon_ratio && fabs(horizon - ratio * h) > 1e-9 * horizon)
        return pdmc_study_refuse(reader, at("horizon_ratio"), "%g spacings are %g, but the horizon is %g: give one",
                                 ratio, ratio * h, horizon);
    if (pdmc_study_with_rounding(horizon) < h)
        return pdmc_study_refuse(reader, at("horizon"), "%g is too small, must be at least %g, the spacing", horizon,
                                 h);
    if (horizon > pdmc_study_with_rounding(100.0 * h))
        return pdmc_study_refuse(reader, at("horizon"), "%g is too large, must be at most %g, 100 spacings", horizon,
                                 100.0 * h);
    if (horizon > pdmc_study_with_rounding(largest))
        return pdmc_study_refuse(reader, at("horizon"), "%g is too large, must be at most %g, half of the shorter side",
                                 horizon, largest);
    return PDMC_OK;
}

static pdmc_status check_layer(const pdmc_study_reader *reader)
{
    const pdmc_problem *p = reader->problem;
    const double layer = p->solver.load_layer, rows = layer / p->solver.spacing;
    const double largest = 0.5 * fmin(p->plate.width, p->plate.height);
    if (fabs(rows - round(rows)) > 1e-9 * rows || round(rows) < 1.0)
        return pdmc_study_refuse(reader, at("load_layer"), "%g is not a whole number of spacings of %g", layer,
                                 p->solver.spacing);
    if (layer > pdmc_study_with_rounding(largest))
        return pdmc_study_refuse(reader, at("load_layer"),
                                 "%g is too thick, must be at most %g, half of the shorter "
                                 "side",
                                 layer, largest);
    return PDMC_OK;
}

static pdmc_status check_kind(const pdmc_study_reader *reader)
{
    if (reader->problem->kind == PDMC_STATIC) return PDMC_OK;
    return pdmc_study_refuse(reader, at("method"), "\"bond\" has no dynamic studies yet, must be \"kansa\"");
}

pdmc_status pdmc_study_check_grid(const pdmc_study_reader *reader)
{
    pdmc_status status = check_kind(reader);
    if (status == PDMC_OK) status = check_division(reader, reader->problem->plate.width, "width");
    if (status == PDMC_OK) status = check_division(reader, reader->problem->plate.height, "height");
    if (status == PDMC_OK) status = check_size(reader);
    if (status == PDMC_OK) status = check_horizon(reader);
    if (status == PDMC_OK) status = check_layer(reader);
    return status;
}
