// SPDX-License-Identifier: GPL-3.0-or-later
#include "kansa/weights.h"

#include "base/base_impl.h"

pdmc_status pdmc_kansa_weights(const pdmc_kansa *kansa, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const int rings = kansa->rings.rings;
    PDMC_NEW(model->term_weight, model->bins * model->radial_terms);
    PDMC_NEW(model->modulus_weight, model->bins);
    for (int b = 0; b < model->bins; b++) {
        for (int q = 0; q < rings; q++) {
            const double weight = kansa->rings.weight[b * rings + q];
            if (model->radial_terms > 0) model->term_weight[b * rings + q] = weight;
            model->modulus_weight[b] += weight * kansa->share[q];
        }
    }
done:
    return status;
}
