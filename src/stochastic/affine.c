// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/affine.h"

#include "base/base_impl.h"

void pdmc_affine_clear(pdmc_affine *model)
{
    pdmc_free(model->term_weight);
    pdmc_free(model->modulus_weight);
    pdmc_free(model->tip_stiffness);
    pdmc_free(model->direction_stiffness);
    pdmc_free(model->solution);
    pdmc_free(model->stress_intensity);
    pdmc_free(model->ring_weight);
    for (int d = 0; model->crossings && d < model->tips * model->angles; d++) {
        pdmc_free(model->crossings[d].row);
        pdmc_free(model->crossings[d].column);
        pdmc_free(model->crossings[d].ring);
    }
    pdmc_free(model->crossings);
    pdmc_free(model->observe);
    pdmc_free(model->intensity_bound);
    if (model->discretisation) model->verbs->destroy(model->discretisation);
    *model = (pdmc_affine){0};
}
