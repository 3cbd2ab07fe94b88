// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "pdmc/statistics.h"

#include <float.h>
#include <gsl/gsl_cdf.h>
#include <lapacke.h>
#include <limits.h>
#include <math.h>

/// Spread of a constant that is not exactly one, relative to it: no more than rounding.
static const double no_spread = 1e-12;

/// The controls about their means and of length 1, as the product of singular vectors and values.
typedef struct {
    size_t n, controls, rank;
    double *left;     // [controls, n] the controls, then the left vectors
    double *value;    // [controls] descending
    double *right;    // [controls, controls] right vector k at [j, k]: columns of LAPACK's V'
    double *distance; // [controls] from the true to the sample's mean, in the same units
    double *scratch;  // [controls]
} decomposition;

static pdmc_status decomposition_make(size_t n, size_t controls, decomposition *d)
{
    pdmc_status status = PDMC_OK;
    *d = (decomposition){.n = n, .controls = controls};
    PDMC_NEW(d->left, controls * n);
    PDMC_NEW(d->value, controls);
    PDMC_NEW(d->right, controls * controls);
    PDMC_NEW(d->distance, controls);
    PDMC_NEW(d->scratch, controls);

done:
    return status;
}

static void decomposition_clear(decomposition *d)
{
    pdmc_free(d->left);
    pdmc_free(d->value);
    pdmc_free(d->right);
    pdmc_free(d->distance);
    pdmc_free(d->scratch);
}

/// A control without spread is left out as a column of zeros.
static void standardise(const double c[], const double mean[], double confidence, decomposition *d)
{
    for (size_t j = 0; j < d->controls; j++) {
        double *column = &d->left[j * d->n];
        pdmc_estimate centre, deviation;
        for (size_t i = 0; i < d->n; i++) column[i] = c[i * d->controls + j];
        pdmc_statistics_moments(d->n, column, confidence, &centre, &deviation);
        const bool is_constant = deviation.value <= no_spread * fabs(centre.value);
        const double scale = is_constant ? 0.0 : 1.0 / (deviation.value * sqrt((double)d->n - 1.0));
        for (size_t i = 0; i < d->n; i++) column[i] = (column[i] - centre.value) * scale;
        d->distance[j] = (centre.value - mean[j]) * scale;
    }
}

/// Directions with a singular value of no more than rounding, of controls that depend on others, are left out.
static pdmc_status decompose(decomposition *d)
{
    if (d->controls == 0) return PDMC_OK;
    const lapack_int rows = (lapack_int)d->n, columns = (lapack_int)d->controls;
    pdmc_blas_prepare();
    const lapack_int info = LAPACKE_dgesvd(LAPACK_COL_MAJOR, 'O', 'S', rows, columns, d->left, rows, d->value, NULL, 1,
                                           d->right, columns, d->scratch);
    if (info != 0) return pdmc_raise(PDMC_ERR_EXTERN, "LAPACKE_dgesvd returned %d", (int)info);
    const double least = (double)d->n * DBL_EPSILON * fmax(d->value[0], DBL_MIN);
    while (d->rank < d->controls && d->value[d->rank] > least) d->rank++;
    return PDMC_OK;
}

/// The regression along one singular vector: takes it from the residual.
/// @return the coefficient
static double regress(size_t n, const double direction[], double residual[])
{
    double coefficient = 0.0;
    for (size_t i = 0; i < n; i++) coefficient += direction[i] * residual[i];
    for (size_t i = 0; i < n; i++) residual[i] -= coefficient * direction[i];
    return coefficient;
}

/// By how much a direction moves the estimate for each unit of its coefficient.
static double lever(const decomposition *d, size_t k)
{
    double sum = 0.0;
    for (size_t j = 0; j < d->controls; j++) sum += d->right[j * d->controls + k] * d->distance[j];
    return sum / d->value[k];
}

/// @param[in,out] residual  [n] x about its mean, in its deviations
static pdmc_controlled controlled_mean(const decomposition *d, pdmc_estimate mean, double deviation, double known_by,
                                       double confidence, double residual[])
{
    const double n = (double)d->n;
    double shift = 0.0, leverage = 1.0 / n, squares = 0.0;
    for (size_t k = 0; k < d->rank; k++) {
        const double arm = lever(d, k);
        shift += regress(d->n, &d->left[k * d->n], residual) * arm;
        leverage += arm * arm;
    }
    for (size_t i = 0; i < d->n; i++) squares += residual[i] * residual[i];
    const double explained = fmax(0.0, 1.0 - squares / (n - 1.0)), freedom = n - 1.0 - (double)d->rank;
    const double variance = squares / freedom * leverage + explained / known_by;
    const double value = mean.value - deviation * shift;
    const double half_width = gsl_cdf_tdist_Qinv(0.5 * (1.0 - confidence), freedom) * deviation * sqrt(variance);
    return (pdmc_controlled){.mean = {value, value - half_width, value + half_width},
                             .correlation = sqrt(explained),
                             .reduction = 1.0 / (n * variance),
                             .controls = d->rank};
}

pdmc_status pdmc_statistics_control(size_t n, const double x[], size_t controls, const double c[], const double mean[],
                                    double known_by, double confidence, pdmc_controlled *controlled)
{
    PDMC_REQUIRE(known_by >= (double)n, "means of %g samples, fewer than the %zu", known_by, n);
    PDMC_REQUIRE(n <= INT_MAX && n >= controls + 2, "%zu samples for %zu controls", n, controls);
    pdmc_status status = PDMC_OK;
    decomposition d = {0};
    double *residual = NULL; // [n]
    pdmc_estimate plain, deviation;
    pdmc_statistics_moments(n, x, confidence, &plain, &deviation);
    if (deviation.value == 0.0) {
        *controlled = (pdmc_controlled){.mean = plain, .reduction = 1.0};
        return PDMC_OK;
    }
    PDMC_NEW(residual, n);
    PDMC_TRY(decomposition_make(n, controls, &d));
    standardise(c, mean, confidence, &d);
    PDMC_TRY(decompose(&d));
    for (size_t i = 0; i < n; i++) residual[i] = (x[i] - plain.value) / deviation.value;
    *controlled = controlled_mean(&d, plain, deviation.value, known_by, confidence, residual);

done:
    decomposition_clear(&d);
    pdmc_free(residual);
    return status;
}
