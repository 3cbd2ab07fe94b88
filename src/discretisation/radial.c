// SPDX-License-Identifier: GPL-3.0-or-later
#include "discretisation/radial.h"

#include "base/base_impl.h"

#include <cblas.h>

void pdmc_radial_legendre(int count, double s, double value[])
{
    value[0] = 1.0;
    if (count > 1) value[1] = s;
    for (int p = 2; p < count; p++) value[p] = ((2 * p - 1) * s * value[p - 1] - (p - 1) * value[p - 2]) / p;
}

pdmc_status pdmc_radial_weights(pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const int bins = model->bins, terms = model->terms;
    double *lower = NULL, *upper = NULL; // P_p at the ends of a bin
    PDMC_NEW(model->term_weight, bins * terms);
    PDMC_NEW(model->modulus_weight, bins);
    PDMC_NEW(lower, terms + 1);
    PDMC_NEW(upper, terms + 1);
    for (int b = 0; b < bins; b++) {
        const double from = (double)b / bins, to = (double)(b + 1) / bins;
        pdmc_radial_legendre(terms + 1, 2.0 * from - 1.0, lower);
        pdmc_radial_legendre(terms + 1, 2.0 * to - 1.0, upper);
        for (int p = 0; p < terms; p++) { // (2 p + 1) int P_p = P_(p + 1) - P_(p - 1)
            const double below = p > 0 ? upper[p - 1] - lower[p - 1] : 0.0;
            model->term_weight[b * terms + p] = 0.5 * (upper[p + 1] - lower[p + 1] - below);
        }
        model->modulus_weight[b] = to * to * to - from * from * from;
    }
done:
    pdmc_free(lower);
    pdmc_free(upper);
    return status;
}

void pdmc_radial_sizes(const pdmc_affine *model, double variation, double size[])
{
    for (int p = 0; p < model->terms; p++)
        size[p] = 5.0 * variation * cblas_dnrm2(model->bins, &model->term_weight[p], model->terms);
}
