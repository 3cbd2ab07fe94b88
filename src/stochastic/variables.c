// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/variables.h"

#include "base/base_impl.h"
#include "stochastic/toughness.h"

#include <gsl/gsl_math.h>
#include <math.h>

static const pdmc_stream streams[PDMC_QUANTITIES] = {
    [PDMC_QUANTITY_MICROMODULUS] = PDMC_STREAM_MICROMODULUS,
    [PDMC_QUANTITY_STIFFNESS] = PDMC_STREAM_FIELD,
    [PDMC_QUANTITY_LOAD_NOISE_LEFT] = PDMC_STREAM_LOAD_NOISE + PDMC_SIDE_LEFT,
    [PDMC_QUANTITY_LOAD_NOISE_RIGHT] = PDMC_STREAM_LOAD_NOISE + PDMC_SIDE_RIGHT,
    [PDMC_QUANTITY_LOAD_NOISE_BOTTOM] = PDMC_STREAM_LOAD_NOISE + PDMC_SIDE_BOTTOM,
    [PDMC_QUANTITY_LOAD_NOISE_TOP] = PDMC_STREAM_LOAD_NOISE + PDMC_SIDE_TOP,
    [PDMC_QUANTITY_LOAD] = PDMC_STREAM_LOAD,
    [PDMC_QUANTITY_YOUNGS_MODULUS] = PDMC_STREAM_YOUNGS_MODULUS,
    [PDMC_QUANTITY_FRACTURE_ENERGY] = PDMC_STREAM_FRACTURE_ENERGY,
    [PDMC_QUANTITY_THICKNESS] = PDMC_STREAM_THICKNESS,
    [PDMC_QUANTITY_VELOCITY] = PDMC_STREAM_VELOCITY,
    [PDMC_QUANTITY_BOND_STRENGTH] = PDMC_STREAM_BONDS,
    [PDMC_QUANTITY_LOAD_LEFT] = PDMC_STREAM_LOAD_SIDE + PDMC_SIDE_LEFT,
    [PDMC_QUANTITY_LOAD_RIGHT] = PDMC_STREAM_LOAD_SIDE + PDMC_SIDE_RIGHT,
    [PDMC_QUANTITY_LOAD_BOTTOM] = PDMC_STREAM_LOAD_SIDE + PDMC_SIDE_BOTTOM,
    [PDMC_QUANTITY_LOAD_TOP] = PDMC_STREAM_LOAD_SIDE + PDMC_SIDE_TOP,
    [PDMC_QUANTITY_LOAD_DIRECTION_LEFT] = PDMC_STREAM_LOAD_DIRECTION + PDMC_SIDE_LEFT,
    [PDMC_QUANTITY_LOAD_DIRECTION_RIGHT] = PDMC_STREAM_LOAD_DIRECTION + PDMC_SIDE_RIGHT,
    [PDMC_QUANTITY_LOAD_DIRECTION_BOTTOM] = PDMC_STREAM_LOAD_DIRECTION + PDMC_SIDE_BOTTOM,
    [PDMC_QUANTITY_LOAD_DIRECTION_TOP] = PDMC_STREAM_LOAD_DIRECTION + PDMC_SIDE_TOP,
    [PDMC_QUANTITY_CRACK_LENGTH] = PDMC_STREAM_CRACK_LENGTH,
    [PDMC_QUANTITY_CRACK_ANGLE] = PDMC_STREAM_CRACK_ANGLE,
    [PDMC_QUANTITY_CRACK_X] = PDMC_STREAM_CRACK_X,
    [PDMC_QUANTITY_CRACK_Y] = PDMC_STREAM_CRACK_Y,
};

pdmc_stream pdmc_quantity_stream(pdmc_quantity quantity)
{
    return streams[quantity];
}

static int count_of(const pdmc_affine *model, const pdmc_uncertainty *uncertainty)
{
    switch (uncertainty->quantity) {
    case PDMC_QUANTITY_MICROMODULUS:
        return uncertainty->model == PDMC_RADIAL_PROCESS && uncertainty->modes < model->bins ? uncertainty->modes
                                                                                             : model->bins;
    case PDMC_QUANTITY_STIFFNESS: return model->field ? pdmc_field_modes(model->field) : 0;
    case PDMC_QUANTITY_LOAD_NOISE_LEFT:
    case PDMC_QUANTITY_LOAD_NOISE_RIGHT:
    case PDMC_QUANTITY_LOAD_NOISE_BOTTOM:
    case PDMC_QUANTITY_LOAD_NOISE_TOP: return uncertainty->modes;
    case PDMC_QUANTITY_FRACTURE_ENERGY: return uncertainty->has_length ? model->tips : 1;
    default: return 1;
    }
}

static void add_group(pdmc_variables *v, pdmc_quantity quantity)
{
    const pdmc_uncertainty *uncertainty = pdmc_problem_uncertainty(v->problem, quantity);
    const int count = uncertainty ? count_of(v->model, uncertainty) : 0;
    if (count == 0) return;
    v->groups[v->group_count++] = (pdmc_variable_group){quantity, streams[quantity], v->count, count};
    v->count += count;
}

static pdmc_status correlate_radius(pdmc_variables *v)
{
    pdmc_status status = PDMC_OK;
    const pdmc_uncertainty *process = pdmc_problem_uncertainty(v->problem, PDMC_QUANTITY_MICROMODULUS);
    if (!process || process->model != PDMC_RADIAL_PROCESS) return PDMC_OK;
    const int bins = v->model->bins, modes = pdmc_variables_group(v, PDMC_QUANTITY_MICROMODULUS)->count;
    double retained;
    PDMC_NEW(v->radial_factor, bins * modes);
    PDMC_TRY(
        pdmc_radial_modes(&process->covariance, v->problem->solver.horizon, bins, modes, v->radial_factor, &retained));
done:
    return status;
}

// What a field shares with other quantities has one value, and the rest is the field's own: it is the last to be drawn.
static pdmc_status correlate_scalars(pdmc_variables *v)
{
    const bool has_field = pdmc_problem_varies_toughness(v->problem);
    double of_all[PDMC_SCALARS * PDMC_SCALARS], ordered[PDMC_SCALARS * PDMC_SCALARS];
    int count = 0;
    for (int q = PDMC_FIRST_SCALAR; q < PDMC_QUANTITIES; q++)
        if (!has_field || q != PDMC_QUANTITY_FRACTURE_ENERGY) v->order[count++] = (pdmc_quantity)q;
    if (has_field) v->order[count] = PDMC_QUANTITY_FRACTURE_ENERGY;
    pdmc_problem_correlation(v->problem, of_all);
    for (int i = 0; i < PDMC_SCALARS; i++)
        for (int j = 0; j < PDMC_SCALARS; j++)
            ordered[i * PDMC_SCALARS + j] =
                of_all[((int)v->order[i] - PDMC_FIRST_SCALAR) * PDMC_SCALARS + (int)v->order[j] - PDMC_FIRST_SCALAR];
    return pdmc_copula_factor(PDMC_SCALARS, ordered, v->copula);
}

// Once for all samples where the tips stay where they are.
static pdmc_status correlate_tips(pdmc_variables *v)
{
    pdmc_status status = PDMC_OK;
    const int tips = v->model->tips;
    const double none[PDMC_SCALARS] = {0.0}; // places no crack
    const bool is_of_all = pdmc_problem_varies_toughness(v->problem) && !pdmc_problem_moves_cracks(v->problem);
    if (tips == 0 || !is_of_all) return PDMC_OK;
    PDMC_NEW(v->toughness_factor, tips * tips);
    PDMC_TRY(pdmc_toughness_factor(v->problem, none, v->toughness_factor));
done:
    return status;
}

pdmc_status pdmc_variables_create(const pdmc_problem *problem, const pdmc_affine *model, pdmc_variables *out)
{
    pdmc_status status = PDMC_OK;
    *out = (pdmc_variables){.problem = problem, .model = model};
    for (int q = PDMC_FIRST_SCALAR; q < PDMC_QUANTITIES; q++) add_group(out, (pdmc_quantity)q);
    for (int side = 0; side < PDMC_SIDES; side++)
        add_group(out, (pdmc_quantity)(PDMC_QUANTITY_LOAD_NOISE_LEFT + side));
    add_group(out, PDMC_QUANTITY_STIFFNESS);
    add_group(out, PDMC_QUANTITY_MICROMODULUS);
    PDMC_TRY(correlate_scalars(out));
    PDMC_TRY(correlate_tips(out));
    PDMC_TRY(correlate_radius(out));
    PDMC_NEW(out->load_case, pdmc_load_case_count(problem));
    pdmc_load_case_list(problem, out->load_case);
    if (problem->sampling.design != PDMC_DESIGN_MONTE_CARLO && out->count > 0)
        PDMC_TRY(pdmc_design_create(problem->sampling.design, problem->sampling.seed, (size_t)out->count,
                                    (uint64_t)problem->sampling.samples, (uint64_t)problem->sampling.replicates,
                                    &out->design));
done:
    if (status != PDMC_OK) pdmc_variables_clear(out);
    return status;
}

void pdmc_variables_clear(pdmc_variables *variables)
{
    pdmc_free(variables->radial_factor);
    pdmc_free(variables->toughness_factor);
    pdmc_free(variables->load_case);
    pdmc_design_destroy(&variables->design);
    *variables = (pdmc_variables){0};
}

const pdmc_variable_group *pdmc_variables_group(const pdmc_variables *variables, pdmc_quantity quantity)
{
    for (int g = 0; g < variables->group_count; g++)
        if (variables->groups[g].quantity == quantity) return &variables->groups[g];
    return NULL;
}

const pdmc_distribution *pdmc_variables_lone_load(const pdmc_variables *variables)
{
    const double negligible = 1e-12; // the probability of a negative load, whose energies are others
    const pdmc_problem *problem = variables->problem;
    const pdmc_uncertainty *load = pdmc_problem_uncertainty(problem, PDMC_QUANTITY_LOAD);
    if (!load || pdmc_problem_moves_sides(problem)) return NULL;
    for (int k = 0; k < problem->correlation_count; k++)
        if (problem->correlations[k].first == PDMC_QUANTITY_LOAD ||
            problem->correlations[k].second == PDMC_QUANTITY_LOAD)
            return NULL;
    return pdmc_distribution_lower_tail(&load->law, 0.0) <= negligible ? &load->law : NULL;
}

static void sample_streams(const pdmc_variables *variables, uint64_t sample, double u[])
{
    for (int g = 0; g < variables->group_count; g++) {
        const pdmc_variable_group *group = &variables->groups[g];
        pdmc_random_uniform(variables->problem->sampling.seed, group->stream, sample, 0, (size_t)group->count,
                            &u[group->first]);
    }
}

void pdmc_variables_sample(const pdmc_variables *variables, uint64_t sample, double z[])
{
    const bool is_designed = variables->design && sample < (uint64_t)variables->problem->sampling.samples;
    if (is_designed) pdmc_design_point(variables->design, sample, z);
    else sample_streams(variables, sample, z);
    pdmc_normal_quantiles((size_t)variables->count, z);
}

static double draw_scalar(const pdmc_variables *v, int place, const double normal[])
{
    const pdmc_uncertainty *uncertainty = pdmc_problem_uncertainty(v->problem, v->order[place]);
    double correlated = 0.0;
    if (!uncertainty) return pdmc_problem_nominal(v->problem, v->order[place]);
    for (int k = 0; k <= place; k++) correlated += v->copula[place * PDMC_SCALARS + k] * normal[k];
    return pdmc_distribution_value(&uncertainty->law, correlated);
}

// Every tip has the field's value in the place of that of the first.
// normal: [PDMC_SCALARS] in the copula's order
static void draw_toughness(const pdmc_variables *v, const double factor[], const double w[], double normal[],
                           double toughness[])
{
    const int tips = v->model->tips, last = PDMC_SCALARS - 1;
    for (int t = 0; t < tips; t++) {
        normal[last] = 0.0;
        for (int k = 0; k <= t; k++) normal[last] += factor[t * tips + k] * w[k];
        toughness[t] = draw_scalar(v, last, normal);
    }
}

static pdmc_status draw_toughness_of_moved_tips(const pdmc_variables *v, const double w[], double normal[],
                                                pdmc_draw *draw)
{
    pdmc_status status = PDMC_OK;
    double *factor = NULL;
    PDMC_NEW(factor, v->model->tips * v->model->tips);
    PDMC_TRY(pdmc_toughness_factor(v->problem, draw->value, factor));
    draw_toughness(v, factor, w, normal, draw->fracture_energy);
done:
    pdmc_free(factor);
    return status;
}

static pdmc_status draw_scalars(const pdmc_variables *v, const double z[], pdmc_draw *draw)
{
    double normal[PDMC_SCALARS] = {0};
    const pdmc_variable_group *toughness = pdmc_variables_group(v, PDMC_QUANTITY_FRACTURE_ENERGY);
    for (int i = 0; i < PDMC_SCALARS; i++) {
        const pdmc_variable_group *group = pdmc_variables_group(v, v->order[i]);
        if (group) normal[i] = z[group->first];
    }
    for (int i = 0; i < PDMC_SCALARS; i++)
        draw->value[(int)v->order[i] - PDMC_FIRST_SCALAR] = draw_scalar(v, i, normal);
    for (int t = 0; t < v->model->tips; t++)
        draw->fracture_energy[t] = draw->value[PDMC_QUANTITY_FRACTURE_ENERGY - PDMC_FIRST_SCALAR];
    if (!toughness || toughness->count == 1) return PDMC_OK;
    if (!v->toughness_factor) return draw_toughness_of_moved_tips(v, &z[toughness->first], normal, draw);
    draw_toughness(v, v->toughness_factor, &z[toughness->first], normal, draw->fracture_energy);
    return PDMC_OK;
}

static void draw_micromodulus(const pdmc_variables *v, const double z[], double micromodulus[])
{
    const pdmc_variable_group *group = pdmc_variables_group(v, PDMC_QUANTITY_MICROMODULUS);
    for (int b = 0; b < v->model->bins; b++) micromodulus[b] = 1.0;
    if (!group) return;
    const double variation = pdmc_problem_uncertainty(v->problem, PDMC_QUANTITY_MICROMODULUS)->variation;
    for (int b = 0; b < v->model->bins; b++) {
        double normal = 0.0;
        if (v->radial_factor)
            for (int k = 0; k < group->count; k++)
                normal += v->radial_factor[b * group->count + k] * z[group->first + k];
        else normal = z[group->first + b];
        micromodulus[b] += variation * normal;
    }
}

static double scalar_of_side(const pdmc_draw *draw, pdmc_quantity first, pdmc_side side)
{
    return draw->value[(int)first + (int)side - PDMC_FIRST_SCALAR];
}

static double draw_load(const pdmc_variables *v, const pdmc_load_case *load, const double z[], const pdmc_draw *draw)
{
    if (load->kind == PDMC_LOAD_GIVEN) return 1.0;
    const double factor = scalar_of_side(draw, PDMC_QUANTITY_LOAD_LEFT, load->side);
    const double turn = M_PI / 180.0 * scalar_of_side(draw, PDMC_QUANTITY_LOAD_DIRECTION_LEFT, load->side);
    if (load->kind == PDMC_LOAD_SIDE) return factor * cos(turn) - 1.0;
    if (load->kind == PDMC_LOAD_TURNED) return factor * sin(turn);
    const pdmc_variable_group *noise =
        pdmc_variables_group(v, (pdmc_quantity)(PDMC_QUANTITY_LOAD_NOISE_LEFT + (int)load->side));
    return factor * z[noise->first + load->mode];
}

// The field's coefficients of all points at once, which is what makes a lognormal one cheap.
static pdmc_status draw_field(const pdmc_variables *v, int count, const double z[], pdmc_draw draw[])
{
    pdmc_status status = PDMC_OK;
    const pdmc_variable_group *group = pdmc_variables_group(v, PDMC_QUANTITY_STIFFNESS);
    const int radial = v->model->radial_terms, terms = v->model->terms - radial;
    double *own = NULL, *xi = NULL;
    if (!group) return PDMC_OK;
    PDMC_NEW(own, count * group->count);
    PDMC_NEW(xi, count * terms);
    for (int s = 0; s < count; s++)
        for (int k = 0; k < group->count; k++) own[s * group->count + k] = z[s * v->count + group->first + k];
    PDMC_TRY(pdmc_field_coefficients(v->model->field, count, own, xi));
    for (int s = 0; s < count; s++)
        for (int k = 0; k < terms; k++) draw[s].xi[radial + k] = xi[s * terms + k];
done:
    pdmc_free(own);
    pdmc_free(xi);
    return status;
}

pdmc_status pdmc_variables_draw(const pdmc_variables *variables, int count, const double z[], pdmc_draw draw[])
{
    pdmc_status status = draw_field(variables, count, z, draw);
    for (int s = 0; s < count && status == PDMC_OK; s++) {
        const double *point = &z[s * variables->count];
        status = draw_scalars(variables, point, &draw[s]);
        draw_micromodulus(variables, point, draw[s].micromodulus);
        for (int l = 1; l < variables->model->cases; l++)
            draw[s].load_pattern[l] = draw_load(variables, &variables->load_case[l - 1], point, &draw[s]);
        pdmc_draw_complete(variables->problem, variables->model, &draw[s]);
    }
    return status;
}

pdmc_status pdmc_draws_create(const pdmc_variables *variables, pdmc_draws *out)
{
    pdmc_status status = PDMC_OK;
    const pdmc_affine *model = variables->model;
    const int each = model->bins + model->rings + 2 * model->tips + model->tips * model->angles + model->cases;
    *out = (pdmc_draws){0};
    PDMC_NEW(out->z, PDMC_BLOCK * (size_t)variables->count);
    PDMC_NEW(out->xi, PDMC_BLOCK * (size_t)model->terms);
    PDMC_NEW(out->numbers, PDMC_BLOCK * (size_t)each);
    for (int s = 0; s < PDMC_BLOCK; s++) {
        pdmc_draw *draw = &out->draw[s];
        draw->xi = &out->xi[s * model->terms];
        draw->micromodulus = &out->numbers[s * each];
        draw->ring_weight = draw->micromodulus + model->bins;
        draw->tip_modulus = draw->ring_weight + model->rings;
        draw->direction_modulus = draw->tip_modulus + model->tips;
        draw->load_pattern = draw->direction_modulus + model->tips * model->angles;
        draw->fracture_energy = draw->load_pattern + model->cases;
    }
done:
    if (status != PDMC_OK) pdmc_draws_clear(out);
    return status;
}

void pdmc_draws_clear(pdmc_draws *draws)
{
    pdmc_free(draws->z);
    pdmc_free(draws->xi);
    pdmc_free(draws->numbers);
    *draws = (pdmc_draws){0};
}
