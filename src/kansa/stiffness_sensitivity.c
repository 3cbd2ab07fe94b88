// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "kansa/stiffness_form.h"
#include "kansa/weak_rows.h"

#include <cblas.h>
#include <string.h>

// The displacement at the mean, and the adjoint of ln (K_I^2 + K_II^2): with K_0 = 1 a combination of the rows.
static void mean_and_adjoint(const pdmc_kansa_form *form, int tip, double vectors[])
{
    const int n = form->unknowns;
    const double *row = &form->intensity[2 * (size_t)tip * (size_t)n];
    double *mean = vectors, *adjoint = vectors + n;
    cblas_daxpy(n, 1.0, form->fixed, 1, mean, 1);
    cblas_daxpy(n, 1.0, form->load, 1, mean, 1);
    const double K[2] = {cblas_ddot(n, row, 1, mean, 1), cblas_ddot(n, row + n, 1, mean, 1)};
    const double square = K[0] * K[0] + K[1] * K[1];
    for (int k = 0; k < 2 && square > 0.0; k++) cblas_daxpy(n, 2.0 * K[k] / square, row + k * n, 1, adjoint, 1);
}

static pdmc_status find_one(const pdmc_kansa_form *form, int tip, pdmc_field_functional *functional)
{
    pdmc_status status = PDMC_OK;
    const pdmc_problem *problem = form->kansa->problem;
    const int points = form->points, number = problem->energy.tips[tip];
    const pdmc_crack *crack = &problem->cracks[number / 2];
    double *x = NULL, *weight = NULL, *vectors = NULL, *strain = NULL;
    PDMC_NEW(x, 2 * (points + 1));
    functional->x = x;
    PDMC_NEW(weight, points + 1);
    functional->weight = weight;
    functional->points = points + 1;
    PDMC_NEW(vectors, 2 * form->unknowns);
    PDMC_NEW(strain, 2 * PDMC_STRAIN_ROWS * points);
    memcpy(x, form->x, 2 * (size_t)points * sizeof *x);
    memcpy(&x[2 * points], number % 2 ? crack->to : crack->from, 2 * sizeof *x);
    mean_and_adjoint(form, tip, vectors);
    pdmc_kansa_form_strains(form, 0, points, 2, vectors, strain);
    for (int p = 0; p < points; p++)
        for (int k = 0; k < PDMC_STRAIN_ROWS; k++) {
            const double *e = &strain[2 * (PDMC_STRAIN_ROWS * p + k)];
            weight[p] -= e[0] * e[1];
        }
    weight[points] = 1.0;
done:
    pdmc_free(vectors);
    pdmc_free(strain);
    return status;
}

pdmc_status pdmc_kansa_form_find_sensitivity(pdmc_kansa_form *form)
{
    pdmc_status status = PDMC_OK;
    const int tips = form->kansa->problem->energy.tip_count;
    PDMC_NEW(form->sensitivity, tips);
    for (int t = 0; t < tips; t++) PDMC_TRY(find_one(form, t, &form->sensitivity[t]));
done:
    return status;
}

const pdmc_field_functional *pdmc_kansa_field_sensitivity(const pdmc_kansa_form *form)
{
    return form->sensitivity;
}
