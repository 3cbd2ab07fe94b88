// SPDX-License-Identifier: GPL-3.0-or-later

/// What an energy release rate means depends on two lengths: warn where they do not fit, since both are allowed.

#include "study/study_impl.h"

#include <math.h>

static pdmc_study_address at(const char *key)
{
    return (pdmc_study_address){SECTION_ENERGY, -1, key};
}

static void warn_of_extension(const pdmc_study_reader *reader)
{
    const pdmc_energy_request *energy = &reader->problem->energy;
    const double advised = 0.25;
    const double ratio = energy->extension / energy->horizon;
    if (ratio > pdmc_study_with_rounding(advised))
        pdmc_study_warn(
            reader, at("extension"),
            "extension %g is %g times the energy horizon %g: G_E then measures the field at a distance from "
            "the tip, not at it (advised: at most %g of the horizon); the paper's own case has extension = "
            "crack half length",
            energy->extension, ratio, energy->horizon, advised);
}

static void warn_of_horizon(const pdmc_study_reader *reader, int tip)
{
    const double large = 0.5; // of the half length; good is 0.1
    const double horizon = reader->problem->energy.horizon;
    const double half = pdmc_study_half_crack(&reader->problem->cracks[tip / 2]);
    char name[PDMC_STUDY_TIP_NAME_SIZE];
    if (!(horizon > pdmc_study_with_rounding(large * half))) return;
    pdmc_study_tip_name(reader->problem, tip, name);
    pdmc_study_warn(
        reader, at("horizon"),
        "%g is %g of the crack's half length %g at %s: G_E then sees the whole crack, not the tip (advised: at "
        "most 0.1)",
        horizon, horizon / half, half, name);
}

// A grid has the bonds of its own horizon, and needs a line that some of them cross.
static pdmc_status check_grid(const pdmc_study_reader *reader)
{
    const pdmc_problem *p = reader->problem;
    if (p->solver.method != PDMC_METHOD_BOND || p->energy.tip_count == 0) return PDMC_OK;
    if (fabs(p->energy.horizon - p->solver.horizon) > 1e-9 * p->solver.horizon)
        return pdmc_study_refuse(reader, at("horizon"), "%g is not allowed, must be %g, that of the bonds",
                                 p->energy.horizon, p->solver.horizon);
    if (pdmc_study_with_rounding(p->energy.extension) < p->solver.spacing)
        return pdmc_study_refuse(reader, at("extension"), "%g is too short, must be at least %g, the spacing",
                                 p->energy.extension, p->solver.spacing);
    return PDMC_OK;
}

// Sampling is read before the tips are.
static pdmc_status check_target(const pdmc_study_reader *reader)
{
    const pdmc_problem *p = reader->problem;
    if (p->sampling.target == PDMC_TARGET_NONE || p->energy.tip_count > 0) return PDMC_OK;
    return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_SAMPLING, -1, "target"},
                             "there is no tip whose energy could be known, must be \"none\"");
}

// A field of which only one value is seen.
static void warn_of_lone_tip(const pdmc_study_reader *reader)
{
    const pdmc_problem *p = reader->problem;
    int index = 0;
    if (!pdmc_problem_varies_toughness(p) || p->energy.tip_count != 1) return;
    while (p->uncertainties[index].quantity != PDMC_QUANTITY_FRACTURE_ENERGY) index++;
    pdmc_study_warn(reader, (pdmc_study_address){SECTION_RANDOM, index, "correlation_length"},
                    "changes nothing where energies are asked for at a single tip");
}

pdmc_status pdmc_study_check_energy(const pdmc_study_reader *reader)
{
    const pdmc_energy_request *energy = &reader->problem->energy;
    pdmc_status status = check_grid(reader);
    if (status == PDMC_OK) status = check_target(reader);
    if (status != PDMC_OK) return status;
    if (energy->tip_count > 0) warn_of_extension(reader);
    warn_of_lone_tip(reader);
    for (int i = 0; i < energy->tip_count; i++) warn_of_horizon(reader, energy->tips[i]);
    return PDMC_OK;
}
