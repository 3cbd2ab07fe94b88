// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "check.h"
#include "pdmc/stochastic.h"

/// A discretisation of one unknown: K(xi) = 1 + xi, xi = the deviation of a single bin; load 1, so that x = S / (1 +
/// xi). One tip with four directions; in direction d one bond with the stretch d x.
enum { ANGLES = 4 };

typedef struct {
    pdmc_problem problem;
    pdmc_uncertainty uncertainties[2];
    int tip;
    pdmc_affine model;
    double term, modulus, solution[2], intensity[2];
    pdmc_crossing crossing[ANGLES];
    double row[ANGLES];
    int ring;
    double ring_weight;
} toy;

static inline pdmc_status toy_perturb(const pdmc_affine *model, const double xi[], const double x[], double y[])
{
    (void)model;
    for (int s = 0; s < PDMC_BLOCK; s++) y[s] = xi[s] * x[s];
    return PDMC_OK;
}

static inline pdmc_status toy_solve(const pdmc_affine *model, const double xi[], const double scale[], double x[])
{
    (void)model;
    if (fabs(1.0 + xi[0]) < 0.05) return PDMC_ERR_SINGULAR;
    x[0] = scale[1] / (1.0 + xi[0]);
    return PDMC_OK;
}

static inline void toy_destroy(void *discretisation)
{
    (void)discretisation;
}

static const pdmc_affine_verbs toy_verbs = {.perturb = toy_perturb, .solve = toy_solve, .destroy = toy_destroy};

/// A scalar by the location and the scale of its distribution.
static inline pdmc_uncertainty toy_scalar(pdmc_quantity quantity, pdmc_distribution_kind kind, double location,
                                          double scale)
{
    return (pdmc_uncertainty){
        quantity,
        .law = {.kind = kind, .location = location, .scale = scale, .least = -INFINITY, .most = INFINITY},
    };
}

static inline void toy_make(toy *t, double micromodulus_variation, double load_variation)
{
    *t = (toy){.solution = {0.0, 1.0}, .term = 1.0, .modulus = 0.0, .intensity = {1.0, 0.0}};
    t->uncertainties[0] =
        (pdmc_uncertainty){PDMC_QUANTITY_MICROMODULUS, .bins = 1, .variation = micromodulus_variation};
    t->uncertainties[1] = toy_scalar(PDMC_QUANTITY_LOAD, PDMC_NORMAL, 1.0, load_variation);
    t->problem = (pdmc_problem){
        .plate = {1, 1, 1},
        .material = {1.0, PDMC_PLANE_STRESS, 1.0},
        .uncertainty_count = 2,
        .uncertainties = t->uncertainties,
        .sampling = {.seed = 7, .samples = 1000, .keep = 1000000, .inverse = PDMC_INVERSE_NEUMANN, .order = 4},
        .energy = {.tip_count = 1, .tips = &t->tip, .angles = ANGLES, .extension = 0.1, .horizon = 1.0},
    };
    t->model = (pdmc_affine){
        .unknowns = 1,
        .terms = 1,
        .radial_terms = 1,
        .bins = 1,
        .term_weight = &t->term,
        .modulus_weight = &t->modulus,
        .cases = 2,
        .solution = t->solution,
        .tips = 1,
        .angles = ANGLES,
        .stress_intensity = t->intensity,
        .micromodulus = 2.0,
        .rings = 1,
        .ring_weight = &t->ring_weight,
        .crossings = t->crossing,
        .verbs = &toy_verbs,
        .discretisation = t,
    };
    t->ring_weight = 0.25;
    for (int d = 0; d < ANGLES; d++) {
        t->row[d] = d;
        t->crossing[d] = (pdmc_crossing){.bonds = 1, .row = &t->row[d], .ring = &t->ring};
    }
}

/// What the run fills in before Monte Carlo.
static inline pdmc_status toy_run(toy *t, const pdmc_run_options *options, pdmc_results *r)
{
    const bool is_designed = t->problem.sampling.design != PDMC_DESIGN_MONTE_CARLO;
    *r = (pdmc_results){.confidence = 0.95,
                        .replicates = is_designed ? t->problem.sampling.replicates : 0.0,
                        .bin_count = 1,
                        .tip_count = t->model.tips,
                        .angle_count = t->model.angles,
                        .measure = t->problem.energy.measure,
                        .histogram_bins = 10,
                        .fracture_energy = 1.0};
    r->tips = pdmc_calloc((size_t)t->model.tips, sizeof *r->tips);
    r->angles = pdmc_calloc(ANGLES, sizeof *r->angles);
    if (!r->tips || !r->angles) return PDMC_ERR_NOMEM;
    for (int d = 0; d < ANGLES; d++) r->angles[d] = 1.5707963267948966 * d;
    pdmc_sample_counts *counts = NULL;
    pdmc_status status = pdmc_monte_carlo(&t->problem, &t->model, options, r, &counts);
    if (status == PDMC_OK) status = pdmc_summarise(options, counts, r);
    pdmc_sample_counts_destroy(&counts);
    return status;
}

static const pdmc_run_options one_thread = {.threads = 1};
