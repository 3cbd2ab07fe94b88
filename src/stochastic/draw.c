// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/draw.h"

#include <cblas.h>

static double scalar(const pdmc_draw *draw, pdmc_quantity quantity)
{
    return draw->value[quantity - PDMC_FIRST_SCALAR];
}

static double radial_modulus(const pdmc_affine *model, const double micromodulus[])
{
    double modulus = 1.0;
    for (int b = 0; b < model->bins; b++) modulus += (micromodulus[b] - 1.0) * model->modulus_weight[b];
    return modulus;
}

// A modulus that is not positive is not divided out: such a sample has no answer in any way.
static void fill_radial_terms(const pdmc_affine *model, double modulus, pdmc_draw *draw)
{
    const int radial = model->radial_terms, rings = model->rings;
    for (int m = 0; m < radial; m++) draw->xi[m] = 0.0;
    for (int q = 0; q < rings; q++) draw->ring_weight[q] = 0.0;
    for (int b = 0; b < model->bins; b++) {
        const double c = draw->micromodulus[b], eta = c / modulus - 1.0;
        for (int m = 0; m < radial; m++) draw->xi[m] += eta * model->term_weight[b * radial + m];
        for (int q = 0; q < rings; q++) draw->ring_weight[q] += c * model->ring_weight[b * rings + q];
    }
}

// M at the tips and where the energy's bonds cross.
static void fill_local_stiffness(const pdmc_affine *model, pdmc_draw *draw)
{
    const int directions = model->tips * model->angles, terms = model->terms - model->radial_terms;
    for (int t = 0; t < model->tips; t++) draw->tip_modulus[t] = draw->effective_modulus;
    for (int d = 0; d < directions; d++) draw->direction_modulus[d] = draw->energy_factor;
    if (!model->field) return;
    const double *xi = &draw->xi[model->radial_terms];
    for (int t = 0; t < model->tips; t++)
        draw->tip_modulus[t] *= 1.0 + cblas_ddot(terms, xi, 1, &model->tip_stiffness[t * terms], 1);
    for (int d = 0; d < directions; d++)
        draw->direction_modulus[d] *= 1.0 + cblas_ddot(terms, xi, 1, &model->direction_stiffness[d * terms], 1);
}

void pdmc_draw_complete(const pdmc_problem *problem, const pdmc_affine *model, pdmc_draw *draw)
{
    const double radial = radial_modulus(model, draw->micromodulus), divided = radial > 0.0 ? radial : 1.0;
    const double thickness = scalar(draw, PDMC_QUANTITY_THICKNESS) / problem->plate.thickness;
    draw->energy_factor = scalar(draw, PDMC_QUANTITY_YOUNGS_MODULUS) / problem->material.youngs_modulus;
    draw->effective_modulus = radial * draw->energy_factor;
    draw->load_factor = scalar(draw, PDMC_QUANTITY_LOAD) / thickness;
    draw->load_share = draw->load_factor / (divided * draw->energy_factor);
    fill_radial_terms(model, divided, draw);
    fill_local_stiffness(model, draw);
}

void pdmc_draw_mean(const pdmc_problem *problem, const pdmc_affine *model, pdmc_draw *draw)
{
    for (int q = 0; q < PDMC_SCALARS; q++)
        draw->value[q] = pdmc_problem_nominal(problem, (pdmc_quantity)(PDMC_FIRST_SCALAR + q));
    for (int t = 0; t < model->tips; t++) draw->fracture_energy[t] = scalar(draw, PDMC_QUANTITY_FRACTURE_ENERGY);
    for (int l = 0; l < model->cases; l++) draw->load_pattern[l] = l == 1;
    for (int b = 0; b < model->bins; b++) draw->micromodulus[b] = 1.0;
    for (int m = model->radial_terms; m < model->terms; m++) draw->xi[m] = 0.0;
    pdmc_draw_complete(problem, model, draw);
}
