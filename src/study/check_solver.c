// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/study_impl.h"

#include <math.h>

static pdmc_study_address at(const char *key)
{
    return (pdmc_study_address){SECTION_SOLVER, -1, key};
}

static bool is_paper(const pdmc_study_reader *reader)
{
    return reader->problem->solver.crack_model == PDMC_CRACKS_PAPER;
}

// The paper's first example is a single element.
static pdmc_status check_spacing(const pdmc_study_reader *reader)
{
    const double node_limit = 5000.0; // twice as many unknowns, in a dense matrix
    const pdmc_plate *plate = &reader->problem->plate;
    const double h = reader->problem->solver.spacing;
    const double share = is_paper(reader) ? 1.0 : 0.25, largest = share * fmin(plate->width, plate->height);
    const double nodes = (plate->width / h) * (plate->height / h);
    if (!(h <= pdmc_study_with_rounding(largest)))
        return pdmc_study_refuse(reader, at("spacing"), "%g is too large, must be at most %g, %sthe shorter side", h,
                                 largest, is_paper(reader) ? "" : "a quarter of ");
    if (!(nodes <= pdmc_study_with_rounding(node_limit)))
        return pdmc_study_refuse(
            reader, at("spacing"),
            "%g gives %.0f nodes, must be at most %.0f: the unknowns grow as 1/h^2, the cost as 1/h^6", h, nodes,
            node_limit);
    return PDMC_OK;
}

/// Beyond half of a the analytic crack fields are no longer those of the horizon: at 0.8 a the stress intensity factor
/// was 33 % off. With bonds that are really cut any horizon has its solution, but beyond a no contour round a tip is
/// left on which the field is that of local elasticity.
static pdmc_status check_horizon(const pdmc_study_reader *reader)
{
    const pdmc_problem *p = reader->problem;
    const bool is_visible = p->solver.crack_model == PDMC_CRACKS_VISIBLE;
    const double horizon = p->solver.horizon, half_crack = pdmc_study_shortest_half_crack(p);
    const double by_crack = is_visible ? half_crack : 0.5 * half_crack;
    const double by_plate = 0.3 * fmin(p->plate.width, p->plate.height);
    if (!(horizon <= pdmc_study_with_rounding(by_crack)))
        return pdmc_study_refuse(
            reader, at("horizon"), "%g is too large, must be at most %g, %s", horizon, by_crack,
            is_visible ? "the shortest crack's half length: beyond it there are no stress intensity factors"
                       : "half of the shortest crack's half length: beyond it stress intensity factors "
                         "are wrong while the residual stays small (33 % at 0.8)");
    if (!(horizon <= pdmc_study_with_rounding(by_plate)))
        return pdmc_study_refuse(reader, at("horizon"), "%g is too large, must be at most %g, 0.3 of the shorter side",
                                 horizon, by_plate);
    return PDMC_OK;
}

static void warn_of_paper(const pdmc_study_reader *reader)
{
    pdmc_study_warn(
        reader, at("crack_model"),
        "\"paper\" does not converge and is there for the record: its stress intensity factors are tens to hundreds "
        "of percent off");
}

static void warn_of_shape(const pdmc_study_reader *reader)
{
    const pdmc_solver_options *kansa = &reader->problem->solver;
    const double ratio = kansa->shape / kansa->spacing;
    if (kansa->crack_model != PDMC_CRACKS_ANALYTIC) return;
    if (pdmc_study_with_rounding(ratio) < 2.0 || ratio > pdmc_study_with_rounding(8.0))
        pdmc_study_warn(reader, at("shape"),
                        "%g is %g spacings: advised are 2 to 8, less is inaccurate, more is near singular",
                        kansa->shape, ratio);
}

pdmc_status pdmc_study_check_solver(const pdmc_study_reader *reader)
{
    const pdmc_solver_options *solver = &reader->problem->solver;
    if (solver->method == PDMC_METHOD_BOND) return pdmc_study_check_grid(reader);
    if (solver->method == PDMC_METHOD_GALERKIN) return pdmc_study_check_triangles(reader);
    pdmc_status status = PDMC_OK;
    if (solver->crack_model != PDMC_CRACKS_VISIBLE)
        status = pdmc_study_check_inner_tips(reader, "crack_model = \"visible\" or method = \"bond\"");
    if (status == PDMC_OK) status = pdmc_study_check_apart(reader, "method = \"bond\"");
    if (status == PDMC_OK) status = check_spacing(reader);
    if (status != PDMC_OK) return status;
    if (is_paper(reader)) { // its discs end at cracks and edges, and its shape is as advised when it is narrow
        warn_of_paper(reader);
        return PDMC_OK;
    }
    status = check_horizon(reader);
    if (status == PDMC_OK) warn_of_shape(reader);
    return status;
}
