// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/draws.h"

#include "base/base_impl.h"
#include "stochastic/variables.h"

#include <math.h>

// Of a fracture energy, whose modes the study does not say: as many as hold this share of the variance, or the most.
static const double wanted_share = 0.9;
enum { FIRST_MODES = 25, MOST_MODES = 400 };

// The rectangle round all nodes, a half spacing wider.
typedef struct {
    double middle[2], size[2];
} extent;

static extent extent_of(const pdmc_explicit_record *r)
{
    double least[2] = {INFINITY, INFINITY}, most[2] = {-INFINITY, -INFINITY};
    for (int i = 0; i < r->node_count; i++)
        for (int k = 0; k < 2; k++) {
            least[k] = fmin(least[k], r->node_position[PDMC_AXES * i + k]);
            most[k] = fmax(most[k], r->node_position[PDMC_AXES * i + k]);
        }
    extent e;
    for (int k = 0; k < 2; k++) {
        e.middle[k] = 0.5 * (least[k] + most[k]);
        e.size[k] = most[k] - least[k] + r->spacing;
    }
    return e;
}

static pdmc_status make_modes(const pdmc_covariance *covariance, int modes, const extent *e, int threads,
                              pdmc_field **field)
{
    const pdmc_field_request request = {
        .covariance = *covariance, .distribution = PDMC_NORMAL, .variation = 1.0, .modes = modes};
    const pdmc_status status = pdmc_field_create(&request, e->size[0], e->size[1], 0, NULL, threads, field);
    return status == PDMC_ERR_ARG ? pdmc_raise(PDMC_ERR_CONFIG, "%s", pdmc_last_error()) : status;
}

// Without a number of modes, more and more of them until they hold enough.
static pdmc_status find_modes(const pdmc_uncertainty *u, const extent *e, int threads, pdmc_field **field)
{
    if (u->modes > 0) return make_modes(&u->covariance, u->modes, e, threads, field);
    pdmc_status status = make_modes(&u->covariance, FIRST_MODES, e, threads, field);
    for (int modes = 2 * FIRST_MODES; modes <= MOST_MODES && status == PDMC_OK; modes *= 2) {
        if (pdmc_field_retained(*field) >= wanted_share) break;
        pdmc_field_destroy(field);
        status = make_modes(&u->covariance, modes, e, threads, field);
    }
    return status;
}

// The modes that are left out take variance with them, here more and there less: what is kept is scaled to 1 at every node.
static void scale_rows(int rows, int modes, double function[])
{
    for (int i = 0; i < rows; i++) {
        double variance = 0.0;
        for (int k = 0; k < modes; k++) variance += function[i * modes + k] * function[i * modes + k];
        for (int k = 0; k < modes; k++) function[i * modes + k] /= sqrt(variance);
    }
}

static pdmc_status make_field(const pdmc_uncertainty *u, const pdmc_explicit_record *r, int threads,
                              pdmc_node_field *out)
{
    pdmc_status status = PDMC_OK;
    const extent e = extent_of(r);
    pdmc_field *field = NULL;
    double *x = NULL;
    PDMC_TRY(find_modes(u, &e, threads, &field));
    const int modes = pdmc_field_modes(field);
    PDMC_NEW(x, 2 * r->node_count);
    PDMC_NEW(out->function, (size_t)r->node_count * (size_t)modes);
    for (int i = 0; i < r->node_count; i++)
        for (int k = 0; k < 2; k++) x[2 * i + k] = r->node_position[PDMC_AXES * i + k] - e.middle[k];
    PDMC_TRY(pdmc_field_terms_at(field, r->node_count, x, out->function));
    scale_rows(r->node_count, modes, out->function);
    out->modes = modes;
    out->retained = pdmc_field_retained(field);
done:
    pdmc_field_destroy(&field);
    pdmc_free(x);
    return status;
}

static pdmc_status make_fields(const pdmc_explicit_record *r, int threads, pdmc_ensemble_draws *d)
{
    pdmc_status status = PDMC_OK;
    const pdmc_uncertainty *stiffness = pdmc_problem_uncertainty(d->problem, PDMC_QUANTITY_STIFFNESS);
    const pdmc_uncertainty *toughness = pdmc_problem_uncertainty(d->problem, PDMC_QUANTITY_FRACTURE_ENERGY);
    if (stiffness) {
        PDMC_TRY(make_field(stiffness, r, threads, &d->stiffness));
        d->stiffness.stream = PDMC_STREAM_FIELD;
        PDMC_TRY(pdmc_distribution_by_moments(stiffness->distribution, 1.0, stiffness->variation, &d->stiffness.law));
        d->stiffness.law.least = -INFINITY, d->stiffness.law.most = INFINITY;
    }
    if (toughness && toughness->has_length) {
        PDMC_TRY(make_field(toughness, r, threads, &d->toughness));
        d->toughness.stream = PDMC_STREAM_TOUGHNESS;
        d->toughness.law = toughness->law;
    }
done:
    return status;
}

pdmc_status pdmc_ensemble_draws_create(const pdmc_study *study, const pdmc_explicit_record *record, int threads,
                                       pdmc_ensemble_draws *out)
{
    pdmc_status status = PDMC_OK;
    const pdmc_uncertainty *bonds = pdmc_problem_uncertainty(&study->problem, PDMC_QUANTITY_BOND_STRENGTH);
    double correlation[PDMC_SCALARS * PDMC_SCALARS];
    *out = (pdmc_ensemble_draws){.problem = &study->problem,
                                 .study = &study->motion,
                                 .node_count = record->node_count,
                                 .node_body = record->node_body};
    pdmc_problem_correlation(&study->problem, correlation);
    PDMC_TRY(pdmc_copula_factor(PDMC_SCALARS, correlation, out->copula));
    PDMC_TRY(make_fields(record, threads, out));
    if (bonds) {
        PDMC_NEW(out->bond_strengths, PDMC_STRENGTH_CLASSES);
        PDMC_TRY(pdmc_brittle_strengths(&bonds->law, out->bond_strengths));
    }
done:
    return status;
}

void pdmc_ensemble_draws_clear(pdmc_ensemble_draws *draws)
{
    pdmc_free(draws->stiffness.function);
    pdmc_free(draws->toughness.function);
    pdmc_free(draws->bond_strengths);
    *draws = (pdmc_ensemble_draws){0};
}

static double draw_normal(const pdmc_problem *problem, pdmc_quantity quantity, uint64_t index)
{
    double z;
    pdmc_random_uniform(problem->sampling.seed, pdmc_quantity_stream(quantity), index, 0, 1, &z);
    pdmc_normal_quantiles(1, &z);
    return z;
}

/// value: [PDMC_SCALARS]; 1 of a quantity that is certain
static void draw_scalars(const pdmc_ensemble_draws *d, uint64_t index, double value[])
{
    double normal[PDMC_SCALARS];
    for (int q = 0; q < PDMC_SCALARS; q++) {
        const pdmc_quantity quantity = (pdmc_quantity)(PDMC_FIRST_SCALAR + q);
        const pdmc_uncertainty *u = pdmc_problem_uncertainty(d->problem, quantity);
        double correlated = 0.0;
        normal[q] = u ? draw_normal(d->problem, quantity, index) : 0.0;
        for (int k = 0; k <= q; k++) correlated += d->copula[q * PDMC_SCALARS + k] * normal[k];
        value[q] = u ? pdmc_distribution_value(&u->law, correlated) : 1.0;
    }
}

/// A field's values at all nodes; 1 where there is none.
static void draw_field(const pdmc_ensemble_draws *d, const pdmc_node_field *field, uint64_t index, double value[])
{
    double z[2000]; // as many modes as a study may ask for
    pdmc_random_uniform(d->problem->sampling.seed, field->stream, index, 0, (size_t)field->modes, z);
    pdmc_normal_quantiles((size_t)field->modes, z);
    for (int i = 0; i < d->node_count; i++) {
        double normal = 0.0;
        for (int k = 0; k < field->modes; k++)
            normal += field->function[(size_t)i * (size_t)field->modes + (size_t)k] * z[k];
        value[i] = field->modes > 0 ? pdmc_distribution_value(&field->law, normal) : 1.0;
    }
}

/// From the toughness at the nodes to the factors of s_0.
static bool find_strengths(const pdmc_ensemble_draws *d, const double stiffness[], double strength[])
{
    for (int i = 0; i < d->node_count; i++) {
        const pdmc_body *body = &d->study->bodies[d->node_body[i]].body;
        if (!(stiffness[i] > 0.0) || !(strength[i] > 0.0)) return false;
        strength[i] = sqrt(strength[i]);
        if (d->study->materials[body->material].has_fracture_energy) strength[i] /= sqrt(stiffness[i]);
    }
    return true;
}

bool pdmc_ensemble_draws_sample(const pdmc_ensemble_draws *d, uint64_t index, double stiffness[], double strength[],
                                pdmc_explicit_sample *sample)
{
    double value[PDMC_SCALARS];
    draw_scalars(d, index, value);
    draw_field(d, &d->stiffness, index, stiffness);
    draw_field(d, &d->toughness, index, strength);
    const bool has_fields = d->stiffness.modes + d->toughness.modes > 0;
    const bool fracture_is_scalar = d->toughness.modes == 0;
    *sample = (pdmc_explicit_sample){
        .load = value[PDMC_QUANTITY_LOAD - PDMC_FIRST_SCALAR],
        .velocity = value[PDMC_QUANTITY_VELOCITY - PDMC_FIRST_SCALAR],
        .youngs_modulus = value[PDMC_QUANTITY_YOUNGS_MODULUS - PDMC_FIRST_SCALAR],
        .fracture_energy = fracture_is_scalar ? value[PDMC_QUANTITY_FRACTURE_ENERGY - PDMC_FIRST_SCALAR] : 1.0,
        .node_count = has_fields ? d->node_count : 0,
        .stiffness = d->stiffness.modes > 0 ? stiffness : NULL,
        .strength = has_fields ? strength : NULL,
        .bond_strengths = d->bond_strengths,
        .seed = d->problem->sampling.seed,
        .sample = index,
    };
    return sample->youngs_modulus > 0.0 && sample->fracture_energy > 0.0 && find_strengths(d, stiffness, strength);
}
