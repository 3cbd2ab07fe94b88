// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/lognormal.h"

#include "base/base_impl.h"
#include "field/field_impl.h"
#include "pdmc/affine.h"

#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

enum { MOST_POINTS = 12000 }; // whose matrix has 1.2 GB

/// Pivots of Cholesky's factorisation that are left out have a share of the squared error below this.
static const double SHARE_OF_PIVOTS = 0.01;

/// The functions s psi at the rule's points, [modes, points], and half the variances of their field.
static pdmc_status tabulate(const pdmc_functions *normal, double scale, const pdmc_area_rule *rule, int threads,
                            pdmc_lognormal *result)
{
    pdmc_status status = PDMC_OK;
    double *value = NULL; // [points, modes]
    PDMC_NEW(value, (size_t)rule->count * (size_t)normal->count);
    PDMC_TRY(pdmc_functions_at(normal, rule->count, rule->x, threads, value));
    for (int i = 0; i < rule->count; i++)
        for (int k = 0; k < normal->count; k++) {
            const double v = scale * value[(size_t)i * (size_t)normal->count + (size_t)k];
            result->mode[(size_t)k * (size_t)rule->count + (size_t)i] = v;
            result->half_variance[i] += 0.5 * v * v;
        }
done:
    pdmc_free(value);
    return status;
}

/// The covariance of M times the roots of the rule's weights [points, points]; returns its trace.
static double fill_covariance(const pdmc_lognormal *lognormal, const double weight[], int threads, double matrix[])
{
    const int n = lognormal->points;
    double trace = 0.0;
    cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, n, n, lognormal->modes, 1.0, lognormal->mode, n,
                lognormal->mode, n, 0.0, matrix, n);
#pragma omp parallel for num_threads(threads) schedule(static)
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            double *entry = &matrix[(size_t)i * (size_t)n + (size_t)j];
            *entry = sqrt(weight[i] * weight[j]) * expm1(*entry);
        }
    for (int i = 0; i < n; i++) trace += matrix[(size_t)i * (size_t)n + (size_t)i];
    return trace;
}

/// A factor of low rank of the covariance, A = B B', by Cholesky's factorisation with pivots.
/// @param      matrix  [points, points], destroyed
/// @param[out] factor  [rank, points], one column of B after the other; free with pdmc_free()
static pdmc_status factorise(int points, double matrix[], double pivot_tolerance, int *rank, double **factor)
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)points;
    int *pivot = NULL;
    PDMC_NEW(pivot, points);
    const int info = LAPACKE_dpstrf(LAPACK_COL_MAJOR, 'L', points, matrix, points, pivot, rank, pivot_tolerance);
    if (info < 0) PDMC_FAIL(PDMC_ERR_EXTERN, "LAPACKE_dpstrf returned %d", info);
    PDMC_NEW(*factor, (size_t)*rank * n);
    for (size_t k = 0; k < (size_t)*rank; k++)
        for (size_t i = k; i < n; i++) (*factor)[k * n + (size_t)(pivot[i] - 1)] = matrix[k * n + i];
done:
    pdmc_free(pivot);
    return status;
}

/// The eigenvectors of B' B [rank, rank], one a row, and its eigenvalues, ascending.
static pdmc_status decompose(int points, int rank, const double factor[], double vector[], double value[])
{
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, rank, rank, points, 1.0, factor, points, factor, points, 0.0,
                vector, rank);
    const int info = LAPACKE_dsyevd(LAPACK_COL_MAJOR, 'V', 'L', rank, vector, rank, value);
    return info ? pdmc_raise(PDMC_ERR_EXTERN, "LAPACKE_dsyevd returned %d", info) : PDMC_OK;
}

/// How many of the leading eigenvalues leave a sum of at most `allowed` of the trace.
static int count_terms(int rank, const double value[], double trace, double allowed)
{
    int terms = 0;
    for (double left = trace; terms < rank && left > allowed; terms++) left -= value[rank - 1 - terms];
    return terms > 0 ? terms : 1;
}

/// With an eigenvector u of B B', of eigenvalue lambda, the function at the rule's points is
/// psi = sqrt(lambda) u / sqrt(weight), the coefficient of a sample sum_i sqrt(weight_i) u_i (M_i - 1) / sqrt(lambda).
static pdmc_status take_terms(const pdmc_area_rule *rule, int rank, const double factor[], const double vector[],
                              const double value[], pdmc_functions *terms, pdmc_lognormal *result)
{
    pdmc_status status = PDMC_OK;
    const int points = rule->count, count = terms->count, polynomials = pdmc_polynomials_count(&terms->space);
    double *scaled = NULL, *polynomial = NULL; // sqrt(lambda) u sqrt(weight) [count, points], [points, polynomials]
    PDMC_NEW(scaled, (size_t)count * (size_t)points);
    PDMC_NEW(polynomial, (size_t)points * (size_t)polynomials);
    for (int k = 0; k < count; k++) {
        double *row = &scaled[(size_t)k * (size_t)points];
        const double *v = &vector[(size_t)(rank - 1 - k) * (size_t)rank], lambda = value[rank - 1 - k];
        cblas_dgemv(CblasRowMajor, CblasTrans, rank, points, 1.0, factor, points, v, 1, 0.0, row, 1);
        cblas_dscal(points, pdmc_field_sign(points, row), row, 1); // sqrt(lambda) u
        for (int i = 0; i < points; i++) {
            row[i] *= sqrt(rule->weight[i]);
            result->projection[(size_t)i * (size_t)count + (size_t)k] = row[i] / lambda;
        }
    }
    pdmc_polynomials_at(&terms->space, points, rule->x, polynomial);
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, count, polynomials, points, 1.0, scaled, points, polynomial,
                polynomials, 0.0, terms->coefficient, polynomials);
done:
    pdmc_free(polynomial);
    pdmc_free(scaled);
    return status;
}

static pdmc_status expand(const pdmc_area_rule *rule, double error, double area, int threads, pdmc_functions *terms,
                          pdmc_lognormal *result)
{
    pdmc_status status = PDMC_OK;
    const int points = rule->count;
    const double allowed = error * error * area;
    double *matrix = NULL, *factor = NULL, *vector = NULL, *value = NULL;
    int rank = 0;
    PDMC_NEW(matrix, (size_t)points * (size_t)points);
    const double trace = fill_covariance(result, rule->weight, threads, matrix);
    PDMC_TRY(factorise(points, matrix, SHARE_OF_PIVOTS * allowed / points, &rank, &factor));
    PDMC_NEW(vector, (size_t)rank * (size_t)rank);
    PDMC_NEW(value, rank);
    PDMC_TRY(decompose(points, rank, factor, vector, value));
    terms->count = result->terms = count_terms(rank, value, trace, allowed);
    PDMC_NEW(result->projection, (size_t)points * (size_t)terms->count);
    PDMC_NEW(terms->coefficient, (size_t)terms->count * (size_t)pdmc_polynomials_count(&terms->space));
    PDMC_TRY(take_terms(rule, rank, factor, vector, value, terms, result));
done:
    pdmc_free(value);
    pdmc_free(vector);
    pdmc_free(factor);
    pdmc_free(matrix);
    return status;
}

/// A power of a polynomial has more waves than itself.
static pdmc_polynomials finer(const pdmc_polynomials *space)
{
    pdmc_polynomials result = *space;
    for (int d = 0; d < 2; d++) result.degree[d] += result.degree[d] / 4;
    return result;
}

pdmc_status pdmc_lognormal_create(const pdmc_functions *normal, double variation, double error, int threads,
                                  pdmc_functions *terms, pdmc_lognormal *result)
{
    pdmc_status status = PDMC_OK;
    const double scale = sqrt(log1p(variation * variation));
    pdmc_area_rule rule = {0};
    *terms = (pdmc_functions){.space = finer(&normal->space)};
    *result = (pdmc_lognormal){.modes = normal->count, .points = pdmc_polynomials_count(&terms->space)};
    if (result->points > MOST_POINTS)
        PDMC_FAIL(PDMC_ERR_ARG, "%d modes are too many for a lognormal field: its matrix would have %d rows",
                  normal->count, result->points);
    PDMC_TRY(pdmc_polynomials_rule(&terms->space, &rule));
    PDMC_NEW(result->mode, (size_t)result->modes * (size_t)result->points);
    PDMC_NEW(result->half_variance, result->points);
    PDMC_TRY(tabulate(normal, scale, &rule, threads, result));
    PDMC_TRY(expand(&rule, error, terms->space.size[0] * terms->space.size[1], threads, terms, result));
done:
    pdmc_area_rule_clear(&rule);
    if (status) {
        pdmc_functions_clear(terms);
        pdmc_lognormal_clear(result);
    }
    return status;
}

/// One block of samples; `own` holds [PDMC_BLOCK, modes], [PDMC_BLOCK, points] and [PDMC_BLOCK, terms].
static void block_coefficients(const pdmc_lognormal *lognormal, int count, const double z[], double own[], double xi[])
{
    const int modes = lognormal->modes, points = lognormal->points, terms = lognormal->terms;
    double *normal = own, *value = &normal[PDMC_BLOCK * modes], *coefficient = &value[PDMC_BLOCK * points];
    memcpy(normal, z, sizeof *z * (size_t)count * (size_t)modes);
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, PDMC_BLOCK, points, modes, 1.0, normal, modes,
                lognormal->mode, points, 0.0, value, points);
    for (int s = 0; s < count; s++)
        for (int i = 0; i < points; i++)
            value[s * points + i] = expm1(value[s * points + i] - lognormal->half_variance[i]);
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, PDMC_BLOCK, terms, points, 1.0, value, points,
                lognormal->projection, terms, 0.0, coefficient, terms);
    memcpy(xi, coefficient, sizeof *xi * (size_t)count * (size_t)terms);
}

pdmc_status pdmc_lognormal_coefficients(const pdmc_lognormal *lognormal, int count, const double z[], double xi[])
{
    pdmc_status status = PDMC_OK;
    double *own = NULL;
    PDMC_NEW(own, PDMC_BLOCK * (lognormal->modes + lognormal->points + lognormal->terms));
    for (int first = 0; first < count; first += PDMC_BLOCK) {
        const int left = count - first;
        block_coefficients(lognormal, left < PDMC_BLOCK ? left : PDMC_BLOCK,
                           &z[(size_t)first * (size_t)lognormal->modes], own,
                           &xi[(size_t)first * (size_t)lognormal->terms]);
    }
done:
    pdmc_free(own);
    return status;
}

void pdmc_lognormal_clear(pdmc_lognormal *lognormal)
{
    pdmc_free(lognormal->mode);
    pdmc_free(lognormal->half_variance);
    pdmc_free(lognormal->projection);
    *lognormal = (pdmc_lognormal){0};
}
