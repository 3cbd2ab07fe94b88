// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/karhunen_loeve.h"

#include "base/base_impl.h"
#include "field/field_impl.h"
#include "field/overlap.h"

#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>

enum {
    CLASSES = 4, // even and odd in x, times even and odd in y
    MOST_POLYNOMIALS = 10201,
};
static const double TAIL = 1e-8;          // of the variance, in the highest degrees
static const double SINGULAR_PART = 1e-3; // of the correlation length, in which the kink may be under-resolved

/// The eigenproblem of the polynomials that are even or odd in x and in y.
typedef struct {
    int parity[2], count[2], size; // size = count[0] count[1]
    double *matrix;                // [size, size], then the eigenvectors, one a row
    double *value;                 // [size] ascending
} parity_class;

typedef struct {
    double lambda;
    int parity_class, index;
} eigenpair;

static void clear_classes(parity_class class[CLASSES])
{
    for (int c = 0; c < CLASSES; c++) {
        pdmc_free(class[c].matrix);
        pdmc_free(class[c].value);
    }
}

/// The kernel at all pairs of separations [rx, ry].
static void tabulate(const pdmc_covariance *covariance, const pdmc_overlap overlap[2], int threads, double kernel[])
{
#pragma omp parallel for num_threads(threads) schedule(static)
    for (int i = 0; i < overlap[0].count; i++)
        for (int j = 0; j < overlap[1].count; j++) {
            const double r = hypot(overlap[0].r[i], overlap[1].r[j]);
            kernel[(size_t)i * (size_t)overlap[1].count + (size_t)j] = pdmc_covariance_at(covariance, r);
        }
}

/// Galerkin's matrix: the sums over the separations, first in x and then in y, and the pairs of pairs (m, m'), (n, n')
/// brought into the order (m, n), (m', n').
static pdmc_status assemble(const pdmc_overlap overlap[2], const double kernel[], parity_class *class)
{
    pdmc_status status = PDMC_OK;
    const double *in_x = overlap[0].overlap[class->parity[0]], *in_y = overlap[1].overlap[class->parity[1]];
    const int nx = class->count[0], ny = class->count[1], qx = overlap[0].count, qy = overlap[1].count;
    double *half = NULL, *sum = NULL;
    PDMC_NEW(half, (size_t)(nx * nx) * (size_t)qy);
    PDMC_NEW(sum, (size_t)(nx * nx) * (size_t)(ny * ny));
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, nx * nx, qy, qx, 1.0, in_x, qx, kernel, qy, 0.0, half, qy);
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, nx * nx, ny * ny, qy, 1.0, half, qy, in_y, qy, 0.0, sum,
                ny * ny);
    for (int i = 0; i < class->size; i++)
        for (int j = 0; j < class->size; j++) {
            const int in_sum_x = i / ny * nx + j / ny, in_sum_y = i % ny * ny + j % ny;
            class->matrix[(size_t)i * (size_t) class->size + (size_t)j] =
                sum[(size_t)in_sum_x * (size_t)(ny * ny) + (size_t)in_sum_y];
        }
done:
    pdmc_free(sum);
    pdmc_free(half);
    return status;
}

static pdmc_status solve_class(const pdmc_overlap overlap[2], const double kernel[], parity_class *class)
{
    pdmc_status status = assemble(overlap, kernel, class);
    if (status) return status;
    const int info = LAPACKE_dsyevd(LAPACK_COL_MAJOR, 'V', 'L', class->size, class->matrix, class->size, class->value);
    return info ? pdmc_raise(PDMC_ERR_EXTERN, "LAPACKE_dsyevd returned %d", info) : PDMC_OK;
}

static pdmc_status solve_classes(const pdmc_covariance *covariance, const pdmc_polynomials *space, int threads,
                                 parity_class class[CLASSES])
{
    pdmc_status status = PDMC_OK;
    pdmc_overlap overlap[2] = {{0}};
    double *kernel = NULL;
    for (int d = 0; d < 2; d++) {
        const double finest = SINGULAR_PART * fmin(covariance->length, space->size[d]);
        PDMC_TRY(pdmc_overlap_create(space->size[d], space->degree[d], finest, &overlap[d]));
    }
    PDMC_NEW(kernel, (size_t)overlap[0].count * (size_t)overlap[1].count);
    tabulate(covariance, overlap, threads, kernel);
    for (int c = 0; c < CLASSES; c++) {
        parity_class *own = &class[c];
        for (int d = 0; d < 2; d++) {
            own->parity[d] = c >> d & 1;
            own->count[d] = pdmc_parity_count(space->degree[d], own->parity[d]);
        }
        own->size = own->count[0] * own->count[1];
        PDMC_NEW(own->matrix, (size_t)own->size * (size_t)own->size);
        PDMC_NEW(own->value, own->size);
        PDMC_TRY(solve_class(overlap, kernel, own));
    }
done:
    pdmc_free(kernel);
    for (int d = 0; d < 2; d++) pdmc_overlap_clear(&overlap[d]);
    return status;
}

static int descending(const void *left, const void *right)
{
    const eigenpair *a = left, *b = right;
    return a->lambda != b->lambda ? (a->lambda < b->lambda ? 1 : -1) : a->parity_class - b->parity_class;
}

/// All eigenpairs in descending order. A square has pairs of different parity that are equal but for rounding; they stand
/// in the order of their classes.
static void sort_pairs(const parity_class class[CLASSES], int count, eigenpair pair[])
{
    int filled = 0;
    for (int c = 0; c < CLASSES; c++)
        for (int i = 0; i < class[c].size; i++) pair[filled++] = (eigenpair){fmax(class[c].value[i], 0.0), c, i};
    qsort(pair, (size_t)count, sizeof *pair, descending);
    for (int i = 1; i < count; i++) {
        const bool equal = pair[i - 1].lambda - pair[i].lambda <= 1e-10 * pair[i].lambda;
        if (equal && pair[i].parity_class < pair[i - 1].parity_class) {
            const eigenpair swapped = pair[i];
            pair[i] = pair[i - 1];
            pair[i - 1] = swapped;
        }
    }
}

/// Coefficients [polynomials] of one mode.
static void expand(const pdmc_polynomials *space, const parity_class *class, int index, double coefficient[])
{
    const double *vector = &class->matrix[(size_t)index * (size_t) class->size];
    const double sign = pdmc_field_sign(class->size, vector);
    for (int i = 0; i < class->size; i++) {
        const int m = class->parity[0] + 2 * (i / class->count[1]), n = class->parity[1] + 2 * (i % class->count[1]);
        coefficient[m * (space->degree[1] + 1) + n] = sign * vector[i];
    }
}

/// The share of the modes' variance in the two highest degrees of each direction.
static void tails(const pdmc_karhunen_loeve *result, int modes, double tail[2])
{
    const int nx = result->space.degree[0] + 1, ny = result->space.degree[1] + 1;
    double all = 0.0;
    tail[0] = tail[1] = 0.0;
    for (int k = 0; k < modes; k++) {
        const double *row = &result->coefficient[(size_t)k * (size_t)(nx * ny)];
        all += result->lambda[k];
        for (int i = 0; i < nx * ny; i++) {
            if (i / ny >= nx - 2) tail[0] += result->lambda[k] * row[i] * row[i];
            if (i % ny >= ny - 2) tail[1] += result->lambda[k] * row[i] * row[i];
        }
    }
    for (int d = 0; d < 2; d++) tail[d] /= all;
}

static pdmc_status solve(const pdmc_covariance *covariance, int modes, int threads, pdmc_karhunen_loeve *result)
{
    pdmc_status status = PDMC_OK;
    parity_class class[CLASSES] = {0};
    eigenpair *pair = NULL;
    const int polynomials = pdmc_polynomials_count(&result->space);
    result->modes = modes < polynomials ? modes : polynomials;
    PDMC_NEW(pair, polynomials);
    PDMC_NEW(result->lambda, result->modes);
    PDMC_NEW(result->coefficient, (size_t)result->modes * (size_t)polynomials);
    PDMC_TRY(solve_classes(covariance, &result->space, threads, class));
    sort_pairs(class, polynomials, pair);
    for (int k = 0; k < result->modes; k++) {
        result->lambda[k] = pair[k].lambda;
        expand(&result->space, &class[pair[k].parity_class], pair[k].index,
               &result->coefficient[(size_t)k * (size_t)polynomials]);
    }
done:
    pdmc_free(pair);
    clear_classes(class);
    return status;
}

/// The degree with which the shortest waves of the modes begin to be resolved: cosines of wave number below k number
/// k^2 area / (4 pi) + k (width + height) / (2 pi) + 1 over a rectangle (Weyl), a half wave needs pi / 2 degrees, and 12
/// more are needed for the ends of the interval.
static int first_degree(double length, double other, int modes)
{
    const double a = length * other / 12.566370614359172, b = (length + other) / 6.283185307179586;
    const double wave_number = (sqrt(b * b + 4.0 * a * modes) - b) / (2.0 * a);
    return 12 + (int)ceil(0.5 * wave_number * length);
}

pdmc_status pdmc_karhunen_loeve_create(const pdmc_covariance *covariance, double width, double height, int wanted,
                                       int modes, int threads, pdmc_karhunen_loeve *result)
{
    pdmc_status status = PDMC_OK;
    const int first[2] = {first_degree(width, height, wanted), first_degree(height, width, wanted)};
    pdmc_polynomials space = {.size = {width, height}, .degree = {first[0], first[1]}};
    *result = (pdmc_karhunen_loeve){0};
    for (;;) {
        double tail[2];
        const double polynomials = (space.degree[0] + 1.0) * (space.degree[1] + 1.0);
        if (polynomials > MOST_POLYNOMIALS || space.degree[0] > PDMC_HIGHEST_DEGREE ||
            space.degree[1] > PDMC_HIGHEST_DEGREE)
            PDMC_FAIL(PDMC_ERR_ARG, "%d modes of this covariance need polynomials up to the degrees %d and %d", wanted,
                      space.degree[0], space.degree[1]);
        pdmc_karhunen_loeve_clear(result);
        result->space = space;
        PDMC_TRY(solve(covariance, modes, threads, result));
        tails(result, wanted, tail);
        result->tail = fmax(tail[0], tail[1]);
        if (result->tail <= TAIL) break;
        for (int d = 0; d < 2; d++)
            if (tail[d] > TAIL) space.degree[d] += 2 + space.degree[d] / 4;
    }
done:
    if (status) pdmc_karhunen_loeve_clear(result);
    return status;
}

void pdmc_karhunen_loeve_clear(pdmc_karhunen_loeve *result)
{
    pdmc_free(result->lambda);
    pdmc_free(result->coefficient);
    *result = (pdmc_karhunen_loeve){0};
}
