// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "stochastic/toy.h"

/// Two unknowns, each with its own bin and its own tip: K_I = S / c_t, so that the tips grow by themselves but for the load.
/// A crack of length 1 has the tips.
typedef struct {
    toy base;
    double term[4], modulus[2], solution[2][2], intensity[8], ring_weight[2], row[2 * ANGLES][2];
    pdmc_crossing crossing[2 * ANGLES];
    pdmc_uncertainty quantities[2];
    pdmc_crack crack;
    int tips[2];
} two_tips;

static inline pdmc_status two_tips_solve(const pdmc_affine *model, const double xi[], const double scale[], double x[])
{
    (void)model;
    for (int t = 0; t < 2; t++) x[t] = scale[1] / (1.0 + xi[t]);
    return PDMC_OK;
}

static const pdmc_affine_verbs two_tips_verbs = {.solve = two_tips_solve, .destroy = toy_destroy};

static const double scatter = 0.08; // of c_t, and of the logarithm of the load

static inline void two_tips_make(two_tips *t)
{
    *t = (two_tips){.term = {1.0, 0.0, 0.0, 1.0},
                    .solution = {{0.0, 0.0}, {1.0, 1.0}},
                    .crack = {"c", {-0.5, 0.0}, {0.5, 0.0}},
                    .tips = {0, 1}};
    toy_make(&t->base, 0.0, 0.0);
    t->intensity[0] = t->intensity[5] = 1.0; // of K_I at either tip; those of K_II are 0
    t->quantities[0] = toy_scalar(PDMC_QUANTITY_LOAD, PDMC_LOGNORMAL, 0.0, scatter);
    t->quantities[1] = (pdmc_uncertainty){PDMC_QUANTITY_MICROMODULUS, .bins = 2, .variation = scatter};
    for (int d = 0; d < 2 * ANGLES; d++)
        t->crossing[d] = (pdmc_crossing){.bonds = 1, .row = t->row[d], .ring = &t->base.ring};
    pdmc_affine *model = &t->base.model;
    model->unknowns = model->terms = model->radial_terms = model->bins = model->tips = 2;
    model->term_weight = t->term;
    model->modulus_weight = t->modulus;
    model->stress_intensity = t->intensity;
    model->ring_weight = t->ring_weight;
    model->crossings = t->crossing;
    model->verbs = &two_tips_verbs;
    model->solution = t->solution[0];
    pdmc_problem *problem = &t->base.problem;
    problem->uncertainties = t->quantities;
    problem->sampling.samples = 100;
    problem->sampling.inverse = PDMC_INVERSE_DIRECT;
    problem->energy.measure = PDMC_MEASURE_GRIFFITH;
    problem->energy.tip_count = 2;
    problem->energy.tips = t->tips;
    problem->cracks = &t->crack;
    problem->crack_count = 1;
}
