// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/plate.h"

#include "base/base_impl.h"
#include "discretisation/response_affine.h"

#include <cblas.h>
#include <math.h>
#include <string.h>

// On the unknowns that are not held.
static pdmc_status apply(const void *method, int q, const double v[], double out[])
{
    const pdmc_plate_elements *plate = method;
    double weight[PDMC_PLATE_PLANES] = {0.0};
    weight[q] = 1.0;
    pdmc_plate_form_multiply(&plate->form, weight, v, out);
    for (int k = 0; k < plate->unknowns; k++)
        if (plate->held[k / 2] & (1U << (k % 2))) out[k] = 0.0;
    return pdmc_sparse_factor_solve(plate->factor, 1, out, out);
}

static pdmc_status solve(const void *method, const double xi[], const double scale[], double u[])
{
    pdmc_status status = PDMC_OK;
    const pdmc_plate_elements *plate = method;
    const bool is_random = pdmc_problem_uncertainty(plate->problem, PDMC_QUANTITY_MICROMODULUS) != NULL;
    double weight[PDMC_PLATE_PLANES];
    pdmc_sparse_matrix matrix = {0};
    pdmc_sparse_factor *factor = NULL;
    for (int p = 0; p < plate->form.planes; p++) weight[p] = is_random ? 1.0 + xi[p] : 1.0;
    PDMC_TRY(pdmc_plate_form_matrix(&plate->form, weight, plate->held, &matrix));
    PDMC_TRY(pdmc_sparse_factor_create(&matrix, plate->factor, NULL, &factor));
    PDMC_TRY(pdmc_plate_elements_solve(plate, factor, weight, scale, u));
done:
    pdmc_sparse_factor_destroy(&factor);
    pdmc_sparse_matrix_clear(&matrix);
    return status;
}

static pdmc_status intensity(const void *method, int tip, double row_1[], double row_2[])
{
    return pdmc_plate_intensity_rows(method, tip, row_1, row_2);
}

static int point(const void *method, const double x[2], int node[], double weight[])
{
    const pdmc_plate_point at = pdmc_plate_point_at(method, x, x);
    memcpy(node, at.value, sizeof at.value);
    memcpy(weight, at.weight, sizeof at.weight);
    return 3;
}

// A plane's deviation is the mean of those of its bins with the weight r^2, as in the effective modulus
// E_eff = (pi / 3) int c r^2 dr.
static pdmc_status fill_weights(pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const int bins = model->bins, terms = model->terms;
    PDMC_NEW(model->term_weight, bins * terms);
    PDMC_NEW(model->modulus_weight, bins);
    for (int b = 0; b < bins; b++) {
        const double from = (double)b / bins, to = (double)(b + 1) / bins;
        model->modulus_weight[b] = to * to * to - from * from * from;
        for (int p = 0; p < terms; p++) {
            const double inner = (double)p / terms, outer = (double)(p + 1) / terms;
            const double low = fmax(from, inner), high = fmin(to, outer);
            if (low < high)
                model->term_weight[b * terms + p] =
                    (high * high * high - low * low * low) / (outer * outer * outer - inner * inner * inner);
        }
    }
done:
    return status;
}

// The size that is to be expected of each coefficient: five standard deviations.
static void expected_sizes(const pdmc_affine *model, double variation, double size[])
{
    for (int p = 0; p < model->terms; p++)
        size[p] = 5.0 * variation * cblas_dnrm2(model->bins, &model->term_weight[p], model->terms);
}

pdmc_status pdmc_plate_affine(const pdmc_plate_elements *plate, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const pdmc_energy_request *energy = &plate->problem->energy;
    const pdmc_uncertainty *noise = pdmc_problem_uncertainty(plate->problem, PDMC_QUANTITY_MICROMODULUS);
    const pdmc_nodal_method nodal = {.problem = plate->problem,
                                     .unknowns = plate->unknowns,
                                     .cases = 1 + plate->loads.count,
                                     .threads = plate->threads,
                                     .solution = plate->solution,
                                     .method = plate,
                                     .apply = apply,
                                     .solve = solve,
                                     .intensity = intensity,
                                     .point = point};
    double size[PDMC_PLATE_PLANES];
    *model = (pdmc_affine){.tips = energy->tip_count, .angles = energy->angles, .bins = noise ? noise->bins : 1};
    model->terms = model->radial_terms = noise ? plate->form.planes : 0;
    PDMC_TRY(fill_weights(model));
    expected_sizes(model, noise ? noise->variation : 0.0, size);
    PDMC_TRY(pdmc_response_affine(&nodal, size, model));
done:
    if (status != PDMC_OK) pdmc_affine_clear(model);
    return status;
}
