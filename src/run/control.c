// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/control.h"

#include "base/base_impl.h"
#include "pdmc/discretisation.h"
#include "run/family.h"
#include "stochastic/controlled.h"

// The bonds of a grid are counted along the whole line of growth.
pdmc_problem pdmc_control_problem(const pdmc_problem *problem, int own_samples)
{
    pdmc_problem cheaper = *problem;
    cheaper.solver = problem->control.solver;
    cheaper.sampling.samples = problem->control.samples;
    cheaper.sampling.keep = own_samples;
    cheaper.sampling.target = PDMC_TARGET_NONE;
    cheaper.sampling.inverse = PDMC_INVERSE_NEUMANN;
    cheaper.reliability.method = PDMC_RARE_NONE;
    cheaper.reliability.sensitivity = 0;
    if (problem->solver.method == PDMC_METHOD_BOND) cheaper.energy.line = PDMC_LINE_SEGMENT;
    return cheaper;
}

// What is asked is the same; tips and angles are lent.
static pdmc_results lend(const pdmc_results *results)
{
    return (pdmc_results){.accuracy = pdmc_no_accuracy,
                          .confidence = results->confidence,
                          .fracture_energy = results->fracture_energy,
                          .extension = results->extension,
                          .energy_horizon = results->energy_horizon,
                          .measure = results->measure,
                          .bonds = results->bonds,
                          .tip_count = results->tip_count,
                          .tips = results->tips,
                          .angle_count = results->angle_count,
                          .angles = results->angles,
                          .bin_count = results->bin_count};
}

static void take_back(pdmc_results *cheaper)
{
    cheaper->tips = NULL;
    cheaper->angles = NULL;
    pdmc_results_clear(cheaper);
}

static double seconds_of_a_sample(const pdmc_results *results)
{
    return (results->runtime.sampling + results->runtime.energy) / results->sample_count;
}

pdmc_status pdmc_run_control(const pdmc_problem *problem, const pdmc_run_options *options, pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    const double start = pdmc_seconds();
    const pdmc_problem own = pdmc_control_problem(problem, results->sample_count);
    const pdmc_affine_family family = pdmc_plate_family(&own, options->threads);
    pdmc_discretisation plate = {0};
    pdmc_affine model = {0};
    pdmc_sample_counts *counts = NULL;
    pdmc_results cheaper = lend(results);
    PDMC_TRY(pdmc_discretise(&own, options->threads, &plate));
    PDMC_TRY(plate.verbs->affine(plate.method, &model));
    if (pdmc_problem_moves_cracks(&own)) model.family = &family;
    PDMC_TRY(pdmc_monte_carlo(&own, &model, options, &cheaper, &counts));
    if (cheaper.status == PDMC_RUN_INTERRUPTED) results->status = PDMC_RUN_INTERRUPTED;
    if (cheaper.sample_count <= results->sample_count) goto done;
    PDMC_TRY(pdmc_control_samples(&cheaper, counts, results));
    results->control.advised_samples =
        pdmc_control_advice(results, seconds_of_a_sample(results) / seconds_of_a_sample(&cheaper));
done:
    results->runtime.control = pdmc_seconds() - start;
    pdmc_sample_counts_destroy(&counts);
    take_back(&cheaper);
    pdmc_affine_clear(&model);
    pdmc_discretisation_clear(&plate);
    return status;
}
