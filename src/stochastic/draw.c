// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/draw.h"

#include "pdmc/random.h"

static void apply_weights(const pdmc_affine *model, pdmc_draw *draw)
{
    const int rings = model->rings;
    draw->effective_modulus = 1.0;
    for (int m = 0; m < model->terms; m++) draw->xi[m] = 0.0;
    for (int q = 0; q < rings; q++) draw->ring_weight[q] = 0.0;
    for (int b = 0; b < model->bins; b++) {
        const double c = draw->micromodulus[b], eta = c - 1.0;
        draw->effective_modulus += eta * model->modulus_weight[b];
        for (int m = 0; m < model->terms; m++) draw->xi[m] += eta * model->term_weight[b * model->terms + m];
        for (int q = 0; q < rings; q++) draw->ring_weight[q] += c * model->ring_weight[b * rings + q];
    }
}

void pdmc_draw_mean(const pdmc_affine *model, pdmc_draw *draw)
{
    draw->load_factor = 1.0;
    for (int b = 0; b < model->bins; b++) draw->micromodulus[b] = 1.0;
    apply_weights(model, draw);
}

void pdmc_draw_sample(const pdmc_problem *problem, const pdmc_affine *model, uint64_t sample, pdmc_draw *draw)
{
    const uint64_t seed = problem->sampling.seed;
    const pdmc_uncertainty *noise = pdmc_problem_uncertainty(problem, PDMC_QUANTITY_MICROMODULUS);
    const pdmc_uncertainty *load = pdmc_problem_uncertainty(problem, PDMC_QUANTITY_LOAD);
    pdmc_draw_mean(model, draw);
    if (load) {
        double u;
        pdmc_random_uniform(seed, PDMC_STREAM_LOAD, sample, 0, 1, &u);
        draw->load_factor = pdmc_unit_mean_quantile(load->distribution, load->variation, u);
    }
    if (noise) {
        pdmc_random_uniform(seed, PDMC_STREAM_MICROMODULUS, sample, 0, (size_t)model->bins, draw->micromodulus);
        for (int b = 0; b < model->bins; b++)
            draw->micromodulus[b] = pdmc_unit_mean_quantile(PDMC_NORMAL, noise->variation, draw->micromodulus[b]);
        apply_weights(model, draw);
    }
}
