// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/directions.h"

#include "base/base_impl.h"
#include "field/field_impl.h"
#include "pdmc/affine.h"

#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

static const double DEPENDENT = 1e-12; // of a functional's variance is less than this new, to rounding it has none
static const double NOTHING = 1e-13;   // of the largest eigenvalue: below, a remaining mode is rounding and is left 0

/// Whether a functional has the array of points of the one before.
static bool shares_points(const pdmc_field_functional functional[], int i)
{
    return i > 0 && functional[i].x == functional[i - 1].x && functional[i].points == functional[i - 1].points;
}

/// All points of the functionals, and their weights, a column each.
static pdmc_status gather(int functionals, const pdmc_field_functional functional[], pdmc_functions *result)
{
    pdmc_status status = PDMC_OK;
    for (int i = 0; i < functionals; i++)
        if (!shares_points(functional, i)) result->sources += functional[i].points;
    PDMC_NEW(result->source, 2 * (size_t)result->sources);
    PDMC_NEW(result->weight, (size_t)result->sources * (size_t)functionals);
    for (int i = 0, first = 0, end = 0; i < functionals; i++) {
        if (!shares_points(functional, i)) first = end;
        end = first + functional[i].points;
        for (int j = 0; j < functional[i].points; j++) {
            result->source[2 * (first + j)] = functional[i].x[2 * j];
            result->source[2 * (first + j) + 1] = functional[i].x[2 * j + 1];
            result->weight[(size_t)(first + j) * (size_t)functionals + (size_t)i] = functional[i].weight[j];
        }
    }
done:
    return status;
}

/// S' C S [functionals, functionals].
static pdmc_status covariances(const pdmc_functions *result, int functionals, int threads, double product[])
{
    pdmc_status status = PDMC_OK;
    double *sum = NULL; // C S
    PDMC_NEW(sum, (size_t)result->sources * (size_t)functionals);
#pragma omp parallel for num_threads(threads) schedule(static)
    for (int i = 0; i < result->sources; i++)
        pdmc_covariance_sum(&result->covariance, result->sources, result->source, functionals, result->weight,
                            &result->source[2 * i], &sum[(size_t)i * (size_t)functionals]);
    cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, functionals, functionals, result->sources, 1.0, result->weight,
                functionals, sum, functionals, 0.0, product, functionals);
done:
    pdmc_free(sum);
    return status;
}

/// a' C b of two combinations of the functionals.
static double inner(int functionals, const double covariance[], const double a[], const double b[])
{
    double sum = 0.0;
    for (int i = 0; i < functionals; i++) sum += a[i] * cblas_ddot(functionals, &covariance[i * functionals], 1, b, 1);
    return sum;
}

/// Gram and Schmidt's: combinations of the functionals, one a row [directions, functionals], with a' C b = delta.
/// @return how many are independent
static int orthonormalise(int functionals, const double covariance[], double combination[])
{
    const int n = functionals;
    int found = 0;
    for (int i = 0; i < n; i++) {
        double *own = &combination[found * n];
        memset(own, 0, sizeof *own * (size_t)n);
        own[i] = 1.0;
        for (int repeat = 0; repeat < 2; repeat++) // once more for what rounding left
            for (int d = 0; d < found; d++)
                cblas_daxpy(n, -inner(n, covariance, own, &combination[d * n]), &combination[d * n], 1, own, 1);
        const double left = inner(n, covariance, own, own);
        if (!(left > DEPENDENT * covariance[i * n + i])) continue;
        cblas_dscal(n, 1.0 / sqrt(left), own, 1);
        found++;
    }
    return found;
}

/// Replaces the functionals' weights by those of the directions.
static pdmc_status direct(int functionals, int threads, pdmc_functions *result)
{
    pdmc_status status = PDMC_OK;
    double *covariance = NULL, *combination = NULL, *weight = NULL;
    PDMC_NEW(covariance, functionals * functionals);
    PDMC_NEW(combination, functionals * functionals);
    PDMC_TRY(covariances(result, functionals, threads, covariance));
    const int directions = orthonormalise(functionals, covariance, combination);
    PDMC_NEW(weight, (size_t)result->sources * (size_t)directions);
    if (directions > 0)
        cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, result->sources, directions, functionals, 1.0,
                    result->weight, functionals, combination, functionals, 0.0, weight, directions);
    pdmc_free(result->weight);
    result->weight = weight;
    weight = NULL;
    result->directions = directions;
done:
    pdmc_free(weight);
    pdmc_free(combination);
    pdmc_free(covariance);
    return status;
}

/// The products of the directions with the pairs, d_i' phi_k = lambda_k t_i' phi_k [directions, pairs].
static pdmc_status multiply(const pdmc_karhunen_loeve *pairs, const pdmc_functions *result, double product[])
{
    pdmc_status status = PDMC_OK;
    const int n = pdmc_polynomials_count(&pairs->space), f = result->directions;
    double *polynomial = NULL, *sum = NULL; // [block, n], [f, n]
    PDMC_NEW(polynomial, PDMC_BLOCK * n);
    PDMC_NEW(sum, f * n);
    for (int first = 0; first < result->sources; first += PDMC_BLOCK) {
        const int left = result->sources - first, points = left < PDMC_BLOCK ? left : PDMC_BLOCK;
        pdmc_polynomials_at(&pairs->space, points, &result->source[2 * first], polynomial);
        cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, f, n, points, 1.0,
                    &result->weight[(size_t)first * (size_t)f], f, polynomial, n, 1.0, sum, n);
    }
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, f, pairs->modes, n, 1.0, sum, n, pairs->coefficient, n, 0.0,
                product, pairs->modes);
    for (int i = 0; i < f; i++)
        for (int k = 0; k < pairs->modes; k++) product[i * pairs->modes + k] *= pairs->lambda[k];
done:
    pdmc_free(sum);
    pdmc_free(polynomial);
    return status;
}

/// Eigenvectors v, one a row, and eigenvalues, ascending, of R in the pairs, diag(lambda) - product' product.
static pdmc_status decompose_rest(const pdmc_karhunen_loeve *pairs, int directions, const double product[],
                                  double vector[], double value[])
{
    const int m = pairs->modes;
    cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, m, m, directions, -1.0, product, m, product, m, 0.0, vector,
                m);
    for (int k = 0; k < m; k++) vector[(size_t)k * (size_t)m + (size_t)k] += pairs->lambda[k];
    const int info = LAPACKE_dsyevd(LAPACK_COL_MAJOR, 'V', 'L', m, vector, m, value);
    return info ? pdmc_raise(PDMC_ERR_EXTERN, "LAPACKE_dsyevd returned %d", info) : PDMC_OK;
}

/// R v / sqrt(v' R v) = (sum_k v_k lambda_k phi_k - sum_i (d_i' v) d_i) / sqrt(v' R v); v is destroyed.
static void take_mode(const pdmc_karhunen_loeve *pairs, const double product[], double mu, double v[],
                      const pdmc_functions *result, int mode)
{
    const int n = pdmc_polynomials_count(&pairs->space), m = pairs->modes, f = result->directions;
    double *coefficient = &result->coefficient[(size_t)mode * (size_t)n];
    cblas_dscal(m, pdmc_field_sign(m, v) / sqrt(mu), v, 1);
    cblas_dgemv(CblasRowMajor, CblasNoTrans, f, m, -1.0, product, m, v, 1, 0.0, &result->mix[mode * f], 1);
    for (int k = 0; k < m; k++) v[k] *= pairs->lambda[k];
    cblas_dgemv(CblasRowMajor, CblasTrans, m, n, 1.0, pairs->coefficient, n, v, 1, 0.0, coefficient, 1);
}

static void take_pairs(const pdmc_karhunen_loeve *pairs, pdmc_functions *result)
{
    const size_t n = (size_t)pdmc_polynomials_count(&pairs->space);
    for (size_t k = 0; k < (size_t)result->count; k++)
        for (size_t i = 0; i < n; i++)
            result->coefficient[k * n + i] = sqrt(pairs->lambda[k]) * pairs->coefficient[k * n + i];
}

static pdmc_status take_rest(const pdmc_karhunen_loeve *pairs, pdmc_functions *result)
{
    pdmc_status status = PDMC_OK;
    const int m = pairs->modes, f = result->directions;
    double *product = NULL, *vector = NULL, *value = NULL;
    PDMC_NEW(product, f * m);
    PDMC_NEW(vector, (size_t)m * (size_t)m);
    PDMC_NEW(value, m);
    for (int i = 0; i < f; i++) result->mix[i * f + i] = 1.0;
    PDMC_TRY(multiply(pairs, result, product));
    PDMC_TRY(decompose_rest(pairs, f, product, vector, value));
    for (int i = m - 1, mode = f; i >= 0 && mode < result->count && value[i] > NOTHING * pairs->lambda[0]; i--, mode++)
        take_mode(pairs, product, value[i], &vector[(size_t)i * (size_t)m], result, mode);
done:
    pdmc_free(value);
    pdmc_free(vector);
    pdmc_free(product);
    return status;
}

pdmc_status pdmc_directions_create(const pdmc_karhunen_loeve *pairs, const pdmc_covariance *covariance, int modes,
                                   int functionals, const pdmc_field_functional functional[], int threads,
                                   pdmc_functions *result)
{
    pdmc_status status = PDMC_OK;
    *result = (pdmc_functions){.count = modes, .space = pairs->space, .covariance = *covariance};
    PDMC_NEW(result->coefficient, (size_t)modes * (size_t)pdmc_polynomials_count(&pairs->space));
    if (functionals > 0) {
        PDMC_TRY(gather(functionals, functional, result));
        PDMC_TRY(direct(functionals, threads, result));
    }
    PDMC_NEW(result->mix, (size_t)modes * (size_t)result->directions);
    if (result->directions > 0) PDMC_TRY(take_rest(pairs, result));
    else take_pairs(pairs, result);
done:
    if (status) pdmc_functions_clear(result);
    return status;
}
