// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/rare_event.h"

#include "base/base_impl.h"
#include "stochastic/growth.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// Points between two looks at the variation, where each is a plate of its own.
enum { DEAR_BATCH = 4 * PDMC_BLOCK };

enum { MOST_POINTS = 3 };             // design points of a tip
static const double at_the_limit = 0.1; // units of z

static const char *quantity_name(pdmc_quantity quantity)
{
    static const char *const names[PDMC_QUANTITIES] = {
        [PDMC_QUANTITY_MICROMODULUS] = "micromodulus",
        [PDMC_QUANTITY_STIFFNESS] = "stiffness",
        [PDMC_QUANTITY_LOAD_NOISE_LEFT] = "load_noise_left",
        [PDMC_QUANTITY_LOAD_NOISE_RIGHT] = "load_noise_right",
        [PDMC_QUANTITY_LOAD_NOISE_BOTTOM] = "load_noise_bottom",
        [PDMC_QUANTITY_LOAD_NOISE_TOP] = "load_noise_top",
        [PDMC_QUANTITY_LOAD] = "load",
        [PDMC_QUANTITY_YOUNGS_MODULUS] = "youngs_modulus",
        [PDMC_QUANTITY_FRACTURE_ENERGY] = "fracture_energy",
        [PDMC_QUANTITY_THICKNESS] = "thickness",
        [PDMC_QUANTITY_LOAD_LEFT] = "load_left",
        [PDMC_QUANTITY_LOAD_RIGHT] = "load_right",
        [PDMC_QUANTITY_LOAD_BOTTOM] = "load_bottom",
        [PDMC_QUANTITY_LOAD_TOP] = "load_top",
        [PDMC_QUANTITY_LOAD_DIRECTION_LEFT] = "load_direction_left",
        [PDMC_QUANTITY_LOAD_DIRECTION_RIGHT] = "load_direction_right",
        [PDMC_QUANTITY_LOAD_DIRECTION_BOTTOM] = "load_direction_bottom",
        [PDMC_QUANTITY_LOAD_DIRECTION_TOP] = "load_direction_top",
        [PDMC_QUANTITY_CRACK_LENGTH] = "crack_length",
        [PDMC_QUANTITY_CRACK_ANGLE] = "crack_angle",
        [PDMC_QUANTITY_CRACK_X] = "crack_x",
        [PDMC_QUANTITY_CRACK_Y] = "crack_y",
    };
    return names[quantity];
}

static pdmc_status describe_groups(const pdmc_variables *variables, pdmc_reliability_results *r)
{
    pdmc_status status = PDMC_OK;
    PDMC_NEW(r->groups, variables->group_count);
    r->group_count = variables->group_count;
    for (int g = 0; g < r->group_count; g++) {
        const pdmc_variable_group *group = &variables->groups[g];
        pdmc_reliability_group *out = &r->groups[g];
        *out = (pdmc_reliability_group){.variables = group->count, .importance = NAN};
        out->first = out->total = (pdmc_estimate){NAN, NAN, NAN};
        snprintf(out->name, sizeof out->name, "%s", quantity_name(group->quantity));
    }
done:
    return status;
}

static void add_record(pdmc_reliability_results *r, const char *name, const pdmc_reliability *found)
{
    pdmc_reliability_record *record = &r->records[r->record_count++];
    snprintf(record->name, sizeof record->name, "%s", name);
    record->found = *found;
    record->evaluations = (double)found->evaluations;
    record->failed = (double)found->failed;
    record->complete = found->converged;
}

static void store_point(const pdmc_variables *variables, const pdmc_first_order *point, pdmc_reliability_results *r)
{
    for (int g = 0; g < r->group_count; g++) {
        const pdmc_variable_group *group = &variables->groups[g];
        r->groups[g].importance = 0.0;
        for (int k = group->first; k < group->first + group->count; k++)
            r->groups[g].importance += point->importance[k];
    }
    for (int k = 0; k < point->dimension; k++) r->design_point[k] = point->z[k];
    r->first_order_index = point->index;
    r->first_order_probability = point->probability;
}

// The design points of one tip, of which two loads, say, that each can make it grow have one each. The first centre is where
// the search ended, which is nearer to growth than the origin also where it found no point; others have to be at the limit, but
// need not be points to the tolerance: where two directions of growth are as near, it has a kink.
static pdmc_status find_points_of_tip(const pdmc_growth *growth, const pdmc_limit_state *limit,
                                      pdmc_reliability_results *r, int *centres, double centre[])
{
    pdmc_status status = PDMC_OK;
    const int variables = growth->variables->count;
    const pdmc_first_order_options options = pdmc_first_order_options_default();
    pdmc_first_order point[MOST_POINTS] = {0};
    bool goes_on = true;
    for (int k = 0; k < MOST_POINTS && goes_on; k++) {
        PDMC_TRY(k == 0 ? pdmc_first_order_find(limit, &options, &point[0])
                        : pdmc_first_order_find_other(limit, &options, k, point, &point[k]));
        r->first_order_evaluations += (double)point[k].evaluations;
        goes_on = point[k].converged && point[k].index > 0.0;
        if (k > 0 && !(point[k].residual <= at_the_limit)) continue;
        if (point[k].converged && !(r->first_order_index <= point[k].index))
            store_point(growth->variables, &point[k], r);
        memcpy(&centre[variables * (*centres)++], point[k].z, (size_t)variables * sizeof *centre);
    }
done:
    for (int k = 0; k < MOST_POINTS; k++) pdmc_first_order_clear(&point[k]);
    return status;
}

// Those of every tip: growth of any is a union of events, whose limit has no gradient where two tips are as near to growing.
// The nearest is the one that is told.
// centre: [MOST_POINTS tips, variables]
static pdmc_status find_points(pdmc_growth *growth, pdmc_reliability_results *r, int *centres, double centre[])
{
    pdmc_status status = PDMC_OK;
    const pdmc_limit_state limit = pdmc_growth_limit(growth);
    r->first_order_evaluations = 0.0;
    for (growth->tip = 0; growth->tip < growth->results->tip_count; growth->tip++)
        PDMC_TRY(find_points_of_tip(growth, &limit, r, centres, centre));
done:
    growth->tip = -1;
    return status;
}

// Sampling at the design points and around the origin: what the points miss is then seen, if only dimly.
static pdmc_status sample_at_points(pdmc_growth *growth, double confidence, pdmc_reliability_results *r)
{
    pdmc_status status = PDMC_OK;
    const pdmc_variables *variables = growth->variables;
    const pdmc_reliability_request *request = &variables->problem->reliability;
    const pdmc_limit_state limit = pdmc_growth_limit(growth);
    pdmc_importance_options options = pdmc_importance_options_default();
    pdmc_reliability found;
    double *centre = NULL;
    int centres = 0;
    PDMC_NEW(centre, (MOST_POINTS * growth->results->tip_count + 1) * variables->count);
    PDMC_TRY(find_points(growth, r, &centres, centre));
    centres++; // the last one is the origin
    options.seed = variables->problem->sampling.seed;
    options.confidence = confidence;
    options.variation = request->variation;
    options.most_evaluations = request->evaluations;
    if (variables->model->family) options.batch = DEAR_BATCH;
    if (options.batch > request->evaluations) options.batch = request->evaluations;
    PDMC_TRY(pdmc_importance_sampling(&limit, centres, centre, &options, &found));
    add_record(r, "importance sampling", &found);
done:
    pdmc_free(centre);
    return status;
}

// A batch of runs is taken in any case, of some 50 to 100 times these samples.
static int samples_of_a_level(int most_evaluations)
{
    const int least = 100, samples = most_evaluations / 100, most = pdmc_subset_options_default().samples;
    return samples < least ? least : samples > most ? most : samples;
}

static pdmc_status sample_by_subsets(const pdmc_variables *variables, const pdmc_limit_state *limit, double confidence,
                                     pdmc_reliability_results *r)
{
    pdmc_subset_options options = pdmc_subset_options_default();
    pdmc_reliability found;
    options.seed = variables->problem->sampling.seed;
    options.confidence = confidence;
    options.variation = variables->problem->reliability.variation;
    options.most_evaluations = variables->problem->reliability.evaluations;
    options.samples = samples_of_a_level(variables->problem->reliability.evaluations);
    const pdmc_status status = pdmc_subset_simulation(limit, &options, &found);
    if (status == PDMC_OK) add_record(r, "subset simulation", &found);
    return status;
}

static pdmc_status find_sensitivity(const pdmc_variables *variables, const pdmc_limit_state *limit, double confidence,
                                    pdmc_reliability_results *r)
{
    pdmc_status status = PDMC_OK;
    pdmc_sensitivity sensitivity = {0};
    const pdmc_sensitivity_options options = {variables->problem->sampling.seed, confidence,
                                              variables->problem->reliability.sensitivity};
    int *group = NULL;
    PDMC_NEW(group, variables->count);
    for (int g = 0; g < variables->group_count; g++)
        for (int k = 0; k < variables->groups[g].count; k++) group[variables->groups[g].first + k] = g;
    PDMC_TRY(pdmc_sensitivity_find(limit, variables->group_count, group, &options, &sensitivity));
    for (int g = 0; g < variables->group_count; g++) {
        r->groups[g].first = sensitivity.first[g];
        r->groups[g].total = sensitivity.total[g];
    }
done:
    pdmc_sensitivity_clear(&sensitivity);
    pdmc_free(group);
    return status;
}

static pdmc_status find_all(pdmc_growth *growth, double confidence, pdmc_reliability_results *r)
{
    pdmc_status status = PDMC_OK;
    const pdmc_variables *variables = growth->variables;
    const pdmc_limit_state limit = pdmc_growth_limit(growth);
    const pdmc_reliability_request *request = &variables->problem->reliability;
    if (request->method == PDMC_RARE_IMPORTANCE || request->method == PDMC_RARE_BOTH)
        PDMC_TRY(sample_at_points(growth, confidence, r));
    if (request->method == PDMC_RARE_SUBSET || request->method == PDMC_RARE_BOTH)
        PDMC_TRY(sample_by_subsets(variables, &limit, confidence, r));
    if (request->sensitivity > 0) PDMC_TRY(find_sensitivity(variables, &limit, confidence, r));
done:
    return status;
}

pdmc_status pdmc_rare_event(const pdmc_variables *variables, const pdmc_affine *model, const pdmc_affine *full,
                            const pdmc_run_options *options, pdmc_results *results)
{
    enum { METHODS = 2 };
    pdmc_status status = PDMC_OK;
    const pdmc_reliability_request *request = &variables->problem->reliability;
    pdmc_reliability_results *r = &results->reliability;
    pdmc_growth growth = {0};
    const double begin = pdmc_seconds();
    r->first_order_index = r->first_order_probability = r->first_order_evaluations = NAN;
    if (variables->count == 0 || (request->method == PDMC_RARE_NONE && request->sensitivity == 0)) return PDMC_OK;
    PDMC_TRY(describe_groups(variables, r));
    PDMC_NEW(r->records, METHODS);
    PDMC_NEW(r->design_point, variables->count);
    r->variable_count = variables->count;
    PDMC_TRY(pdmc_growth_create(variables, model, full, options, results, &growth));
    status = find_all(&growth, results->confidence, r);
    if (status == PDMC_ERR_INTERRUPTED) {
        results->status = PDMC_RUN_INTERRUPTED;
        status = PDMC_OK;
    }
    results->runtime.reliability = pdmc_seconds() - begin;
    r->solved_in_full = (double)growth.solved_in_full;
done:
    pdmc_growth_clear(&growth);
    return status;
}
