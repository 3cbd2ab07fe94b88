// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "kansa/energy.h"
#include "kansa/stiffness_operator.h"

#include <cblas.h>
#include <gsl/gsl_math.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

// The bonds of a tip's energy lie in a small disc, where the trial functions are smooth but for the tip: displacements at
// some points of it span all of them, in far fewer directions than there are unknowns.
enum { RADII = 12, ANGLES = 30, SAMPLES = 2 * RADII * ANGLES };
static const double negligible = 1e-7; // of the largest direction; below it there is the rounding of the rows

// The rows of displacements in the disc round a tip, by rings that gather at it as the field varies.
static void sample_disc(const pdmc_kansa_form *form, pdmc_row_builder *builder, int tip, double row[])
{
    const pdmc_problem *problem = form->kansa->problem;
    const int number = problem->energy.tips[tip], n = form->unknowns;
    const pdmc_crack *crack = &problem->cracks[number / 2];
    const double *centre = number % 2 ? crack->to : crack->from;
    const double radius = problem->energy.extension + problem->energy.horizon;
    for (int i = 0; i < RADII; i++) {
        const double share = (i + 1.0) / RADII, r = radius * share * share;
        for (int k = 0; k < ANGLES; k++, row += 2 * n) {
            const double theta = 2.0 * M_PI * (k + 0.5) / ANGLES;
            const double x[2] = {centre[0] + r * cos(theta), centre[1] + r * sin(theta)};
            pdmc_displacement_rows(builder, x, x, row, row + n);
        }
    }
}

// A basis of the rows, orthonormal in z. row: [SAMPLES tips, unknowns]; the first of them become the basis.
static pdmc_status orthogonalise(const pdmc_kansa_form *form, int count, double row[], int *rank)
{
    pdmc_status status = PDMC_OK;
    const int n = form->unknowns, least = n < count ? n : count;
    double *tau = NULL;
    lapack_int *pivot = NULL;
    PDMC_NEW(tau, least);
    PDMC_NEW(pivot, count);
    int info = LAPACKE_dgeqp3(LAPACK_COL_MAJOR, n, count, row, n, pivot, tau);
    if (info != 0) PDMC_FAIL(PDMC_ERR_EXTERN, "LAPACKE_dgeqp3 returned %d", info);
    *rank = 0;
    while (*rank < least && fabs(row[(size_t)*rank * (size_t)(n + 1)]) > negligible * fabs(row[0])) ++*rank;
    info = LAPACKE_dorgqr(LAPACK_COL_MAJOR, n, *rank, *rank, row, n, tau);
    if (info != 0) PDMC_FAIL(PDMC_ERR_EXTERN, "LAPACKE_dorgqr returned %d", info);
done:
    pdmc_free(tau);
    pdmc_free(pivot);
    return status;
}

static pdmc_status find_observed(const pdmc_kansa_form *form, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)form->unknowns;
    const int count = SAMPLES * model->tips;
    pdmc_row_builder builder = {0};
    double *row = NULL;
    PDMC_TRY(pdmc_row_builder_create(&form->kansa->basis, &builder));
    PDMC_NEW(row, (size_t)count * n);
    for (int t = 0; t < model->tips; t++) {
        double *disc = &row[(size_t)(t * SAMPLES) * n];
        sample_disc(form, &builder, t, disc);
        pdmc_kansa_whiten(form->kansa, SAMPLES, disc);
    }
    pdmc_kansa_form_transform(form, count, row);
    if (count > 0) PDMC_TRY(orthogonalise(form, count, row, &model->observed));
    PDMC_NEW(model->observe, (size_t)model->observed * n);
    memcpy(model->observe, row, (size_t)model->observed * n * sizeof *row);
done:
    pdmc_row_builder_clear(&builder);
    pdmc_free(row);
    return status;
}

// The crossings of the directions that are observed, whose fields have the coefficients R^-1 L^-T of them.
static pdmc_status fill_rows(const pdmc_kansa_form *form, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const int n = form->unknowns, observed = model->observed;
    double *coefficients = NULL;
    PDMC_NEW(coefficients, (size_t)observed * (size_t)n);
    memcpy(coefficients, model->observe, (size_t)observed * (size_t)n * sizeof *coefficients);
    if (observed > 0)
        cblas_dtrsm(CblasColMajor, CblasLeft, CblasLower, CblasTrans, CblasNonUnit, n, observed, 1.0, form->root, n,
                    coefficients, n);
    if (observed > 0) pdmc_kansa_unwhiten(form->kansa, observed, coefficients);
    model->unknowns = observed;
    status = pdmc_kansa_energy(form->kansa, coefficients, model);
    model->unknowns = n;
done:
    pdmc_free(coefficients);
    return status;
}

// The largest singular value of a direction's rows, weighted by the mean of c(r), squared.
static pdmc_status largest_square(const pdmc_affine *model, const pdmc_crossing *crossing, double *square)
{
    pdmc_status status = PDMC_OK;
    const int m = model->observed;
    double *weighted = NULL, *gram = NULL, *eigenvalue = NULL;
    PDMC_NEW(weighted, (size_t)crossing->bonds * (size_t)m);
    PDMC_NEW(gram, (size_t)m * (size_t)m);
    PDMC_NEW(eigenvalue, m);
    for (int k = 0; k < crossing->bonds; k++) {
        double weight = 0.0;
        for (int bin = 0; bin < model->bins; bin++)
            weight += model->ring_weight[bin * model->rings + crossing->ring[k]];
        cblas_daxpy(m, 0.5 * model->micromodulus * weight, &crossing->row[(size_t)k * (size_t)m], 1,
                    &weighted[(size_t)k * (size_t)m], 1);
    }
    *square = 0.0;
    if (crossing->bonds == 0) goto done;
    cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, m, m, crossing->bonds, 1.0, crossing->row, m, weighted, m, 0.0,
                gram, m);
    const int info = LAPACKE_dsyev(LAPACK_COL_MAJOR, 'N', 'L', m, gram, m, eigenvalue); // ascending
    if (info != 0) PDMC_FAIL(PDMC_ERR_EXTERN, "LAPACKE_dsyev returned %d", info);
    *square = eigenvalue[m - 1];
done:
    pdmc_free(weighted);
    pdmc_free(gram);
    pdmc_free(eigenvalue);
    return status;
}

static pdmc_status bound_crossings(const pdmc_kansa_form *form, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    const int directions = model->tips * model->angles;
    double *square = NULL, largest = 0.0;
    PDMC_NEW(square, directions);
#pragma omp parallel for schedule(dynamic) num_threads(form->kansa->threads)
    for (int d = 0; d < directions; d++) {
        const pdmc_status mine = largest_square(model, &model->crossings[d], &square[d]);
        if (mine != PDMC_OK) {
#pragma omp critical(pdmc_stiffness_crossings)
            status = mine;
        }
    }
    for (int d = 0; d < directions; d++) largest = fmax(largest, square[d]);
    model->crossing_bound = sqrt(largest);
done:
    pdmc_free(square);
    return status;
}

pdmc_status pdmc_kansa_form_crossings(const pdmc_kansa_form *form, pdmc_affine *model)
{
    pdmc_status status = PDMC_OK;
    PDMC_TRY(find_observed(form, model));
    PDMC_TRY(fill_rows(form, model));
    PDMC_TRY(bound_crossings(form, model));
done:
    return status;
}
