// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/own_plate.h"

#include "base/base_impl.h"

#include <math.h>
#include <stdio.h>

enum { B = PDMC_BLOCK };

// The first sample of another block becomes a sample of this one.
static void take_sample(pdmc_block *block, int s, const pdmc_block *own)
{
    const int tips = block->model->tips, directions = tips * block->model->angles;
    pdmc_draw *draw = &block->drawn.draw[s];
    const pdmc_draw *from = &own->drawn.draw[0];
    draw->load_factor = from->load_factor;
    draw->load_share = from->load_share;
    draw->effective_modulus = from->effective_modulus;
    draw->energy_factor = from->energy_factor;
    for (int t = 0; t < tips; t++) draw->tip_modulus[t] = from->tip_modulus[t];
    block->failure[s] = own->failure[0];
    block->solver[s] = own->solver[0];
    block->contraction[s] = own->contraction[0];
    block->residual[s] = own->residual[0];
    for (int k = 0; k < 2 * tips; k++) block->intensity[k * B + s] = own->intensity[k * B];
    for (int d = 0; d < directions; d++) block->energy[d * B + s] = own->energy[d * B];
}

static pdmc_status solve_on_model(pdmc_block *block, int s, const pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    pdmc_variables variables = *block->variables; // which own what they point to
    pdmc_block *own = NULL;
    variables.model = model;
    PDMC_TRY(pdmc_block_create(&variables, model, &own));
    PDMC_TRY(pdmc_block_draw_points(own, &block->drawn.z[s * variables.count], 1));
    PDMC_TRY(pdmc_block_solve(own, 1));
    if (block->measure_alone) pdmc_block_measure(own);
    else pdmc_block_energies(own, block->problem->energy.bonds);
    take_sample(block, s, own);
done:
    pdmc_block_destroy(&own);
    return status;
}

static pdmc_status solve_sample(pdmc_block *block, int s)
{
    const pdmc_affine_family *family = block->model->family;
    pdmc_affine model = {0};
    void *plate = NULL;
    pdmc_status status =
        family->make(family->context, block->drawn.draw[s].value, block->measure_alone, &model, &plate);
    if (status == PDMC_OK) {
        status = solve_on_model(block, s, &model);
    } else if (status != PDMC_ERR_NOMEM) {
        block->failure[s] = PDMC_SAMPLE_GEOMETRY;
        status = PDMC_OK;
    }
    family->release(&model, plate);
    return status;
}

pdmc_status pdmc_block_solve_own_plates(pdmc_block *block, int count)
{
    const int threads = block->model->family->threads;
    const double begin = pdmc_seconds();
    pdmc_status status = PDMC_OK;
    char message[512] = "";
#pragma omp parallel for schedule(dynamic) num_threads(threads)
    for (int s = 0; s < count; s++) {
        const pdmc_status mine = solve_sample(block, s);
        if (mine == PDMC_OK) continue;
#pragma omp critical(pdmc_own_plates)
        {
            status = mine;
            snprintf(message, sizeof message, "%s", pdmc_last_error());
        }
    }
    block->has_own_plates = true;
    block->solve_seconds += threads * (pdmc_seconds() - begin);
    return status == PDMC_OK ? PDMC_OK : pdmc_raise(status, "%s", message);
}
