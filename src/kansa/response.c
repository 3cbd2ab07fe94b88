// SPDX-License-Identifier: GPL-3.0-or-later
#include "kansa/response.h"

#include "base/base_impl.h"

#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

static const double tolerance = 1e-13; // of the solution's norm

// Scratch and state of the collection; columns of vectors are stored one after another, [count, unknowns].
typedef struct {
    const pdmc_kansa *kansa;
    int terms;
    const double *size;
    double norm;     // of the mean solution
    double *fresh;   // [capacity, unknowns] directions found last, times their size
    double *found;   // [capacity, unknowns] candidates
    double *rows;    // [capacity, rows]
    double *overlap; // [capacity, capacity]
    double *tau;     // [capacity]
    int *pivot;      // [capacity]
    int capacity;
} collection;

static pdmc_status collection_create(const pdmc_kansa *kansa, int terms, const double size[], collection *c)
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)kansa->unknowns;
    *c = (collection){.kansa = kansa, .terms = terms, .size = size};
    c->capacity = kansa->unknowns;
    PDMC_NEW(c->fresh, (size_t)c->capacity * n);
    PDMC_NEW(c->found, (size_t)c->capacity * n);
    PDMC_NEW(c->rows, (size_t)c->capacity * (size_t)kansa->rows);
    PDMC_NEW(c->overlap, (size_t)c->capacity * (size_t)c->capacity);
    PDMC_NEW(c->tau, c->capacity);
    PDMC_NEW(c->pivot, c->capacity);
    for (int l = 0; l < 2; l++) c->norm += cblas_dnrm2(kansa->unknowns, kansa->whitened[l], 1);
done:
    return status;
}

static void collection_clear(collection *c)
{
    pdmc_free(c->fresh);
    pdmc_free(c->found);
    pdmc_free(c->rows);
    pdmc_free(c->overlap);
    pdmc_free(c->tau);
    pdmc_free(c->pivot);
}

static const double *ring_rows(const pdmc_kansa *kansa, int q)
{
    return &kansa->ring_rows[(size_t)q * 2 * (size_t)kansa->points.interior_count * (size_t)kansa->unknowns];
}

// Rows of traction scale with the effective modulus, of which a ring has its share; all others of the boundary are fixed.
static void scale_boundary(const pdmc_kansa *kansa, int q, int count, double rows[])
{
    const int m = kansa->rows, interior = 2 * kansa->points.interior_count, boundary = 2 * kansa->points.boundary_count;
    for (int k = 0; k < count; k++)
        for (int i = interior; i < m; i++)
            rows[(size_t)k * (size_t)m + (size_t)i] *=
                i < interior + boundary && kansa->is_traction[i - interior] ? kansa->share[q] : 0.0;
}

// out = M_q v for `count` vectors, given also their coefficients R^-1 v.
static void apply_ring(collection *c, int q, int count, const double v[], const double coefficients[], double out[])
{
    const pdmc_kansa *kansa = c->kansa;
    const int n = kansa->unknowns, m = kansa->rows, interior = 2 * kansa->points.interior_count;
    cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, m - interior, count, n, 1.0, kansa->q + interior, m, v, n, 0.0,
                c->rows + interior, m);
    cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, interior, count, n, 1.0, ring_rows(kansa, q), n, coefficients, n,
                0.0, c->rows, m);
    scale_boundary(kansa, q, count, c->rows);
    cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, n, count, m, 1.0, kansa->q, m, c->rows, m, 0.0, out, n);
}

// R^-T A_q^T times the mean residual F - Q y of load l.
static void residual_direction(collection *c, int q, int l, double out[])
{
    const pdmc_kansa *kansa = c->kansa;
    const int n = kansa->unknowns, m = kansa->rows, interior = 2 * kansa->points.interior_count;
    double *residual = c->rows, *boundary = c->rows + m;
    memcpy(residual, kansa->load[l], (size_t)m * sizeof *residual);
    cblas_dgemv(CblasColMajor, CblasNoTrans, m, n, -1.0, kansa->q, m, kansa->whitened[l], 1, 1.0, residual, 1);
    cblas_dgemv(CblasColMajor, CblasNoTrans, n, interior, 1.0, ring_rows(kansa, q), n, residual, 1, 0.0, out, 1);
    pdmc_kansa_whiten(kansa, 1, out);
    memset(boundary, 0, (size_t)interior * sizeof *boundary);
    memcpy(boundary + interior, residual + interior, (size_t)(m - interior) * sizeof *boundary);
    scale_boundary(kansa, q, 1, boundary);
    cblas_dgemv(CblasColMajor, CblasTrans, m, n, 1.0, kansa->q, m, boundary, 1, 1.0, out, 1);
}

static void unwhiten(const pdmc_kansa *kansa, int count, double v[])
{
    cblas_dtrsm(CblasColMajor, CblasLeft, CblasUpper, CblasNoTrans, CblasNonUnit, kansa->unknowns, count, 1.0, kansa->r,
                kansa->unknowns, v, kansa->unknowns);
}

// v -= basis basis^T v
static void project_out(collection *c, const pdmc_response *response, int count, double v[])
{
    const int n = c->kansa->unknowns, r = response->dimension;
    if (r == 0 || count == 0) return;
    cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, r, count, n, 1.0, response->basis, n, v, n, 0.0, c->overlap, r);
    cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, n, count, r, -1.0, response->basis, n, c->overlap, r, 1.0, v, n);
}

// Adds the directions of `count` candidates in c->found that are new, and leaves them, with their size, in c->fresh.
static pdmc_status append(collection *c, pdmc_response *response, int count, int *added)
{
    const int n = c->kansa->unknowns;
    for (int pass = 0; pass < 2; pass++) project_out(c, response, count, c->found); // twice is enough (Kahan)
    memset(c->pivot, 0, (size_t)count * sizeof *c->pivot);
    int info = LAPACKE_dgeqp3(LAPACK_COL_MAJOR, n, count, c->found, n, c->pivot, c->tau);
    if (info != 0) return pdmc_raise(PDMC_ERR_EXTERN, "LAPACKE_dgeqp3 returned %d", info);
    *added = 0;
    double *size = c->overlap;
    while (*added < count && response->dimension + *added < c->capacity) {
        size[*added] = fabs(c->found[(size_t)*added * (size_t)(n + 1)]);
        if (!(size[*added] > tolerance * c->norm)) break;
        ++*added;
    }
    if (*added == 0) return PDMC_OK;
    info = LAPACKE_dorgqr(LAPACK_COL_MAJOR, n, *added, *added, c->found, n, c->tau);
    if (info != 0) return pdmc_raise(PDMC_ERR_EXTERN, "LAPACKE_dorgqr returned %d", info);
    memcpy(&response->basis[(size_t)response->dimension * (size_t)n], c->found,
           (size_t)*added * (size_t)n * sizeof(double));
    memcpy(c->fresh, c->found, (size_t)*added * (size_t)n * sizeof(double));
    for (int k = 0; k < *added; k++) cblas_dscal(n, size[k], &c->fresh[(size_t)k * (size_t)n], 1);
    response->dimension += *added;
    return PDMC_OK;
}

static pdmc_status start(collection *c, pdmc_response *response, int *added)
{
    const size_t n = (size_t)c->kansa->unknowns;
    int count = 0;
    for (int l = 0; l < 2; l++) {
        memcpy(&c->found[(size_t)count++ * n], c->kansa->whitened[l], n * sizeof(double));
        for (int q = 0; q < c->terms; q++) {
            double *direction = &c->found[(size_t)count++ * n];
            residual_direction(c, q, l, direction);
            cblas_dscal((int)n, c->size[q], direction, 1);
        }
    }
    return append(c, response, count, added);
}

// The images of the `count` directions in c->fresh under every ring.
static pdmc_status extend(collection *c, pdmc_response *response, double coefficients[], int count, int *added)
{
    const size_t n = (size_t)c->kansa->unknowns;
    *added = 0;
    if ((size_t)count * (size_t)c->terms > (size_t)c->capacity)
        return pdmc_raise(PDMC_ERR_SINGULAR, "the answers to a random micromodulus span more than %d directions: take "
                                             "smaller variations or a smaller horizon", response->dimension);
    memcpy(coefficients, c->fresh, (size_t)count * n * sizeof(double));
    unwhiten(c->kansa, count, coefficients);
    for (int q = 0; q < c->terms; q++) {
        double *out = &c->found[(size_t)(q * count) * n];
        apply_ring(c, q, count, c->fresh, coefficients, out);
        cblas_dscal(count * (int)n, c->size[q], out, 1);
    }
    return append(c, response, count * c->terms, added);
}

static pdmc_status fill_images(collection *c, pdmc_response *response)
{
    pdmc_status status = PDMC_OK;
    const int n = c->kansa->unknowns, r = response->dimension;
    const size_t size = (size_t)r * (size_t)n;
    PDMC_NEW(response->coefficients, size);
    PDMC_NEW(response->image, (size_t)c->terms * (size_t)r * (size_t)r);
    memcpy(response->coefficients, response->basis, size * sizeof(double));
    unwhiten(c->kansa, r, response->coefficients);
    for (int q = 0; q < c->terms; q++) {
        apply_ring(c, q, r, response->basis, response->coefficients, c->found);
        cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, r, r, n, 1.0, response->basis, n, c->found, n, 0.0,
                    &response->image[(size_t)q * (size_t)r * (size_t)r], r);
    }
done:
    return status;
}

pdmc_status pdmc_response_create(const pdmc_kansa *kansa, int terms, const double size[], pdmc_response *response)
{
    pdmc_status status = PDMC_OK;
    collection c = {0};
    double *coefficients = NULL;
    int added;
    *response = (pdmc_response){0};
    PDMC_TRY(collection_create(kansa, terms, size, &c));
    PDMC_NEW(response->basis, (size_t)c.capacity * (size_t)kansa->unknowns);
    PDMC_NEW(coefficients, (size_t)c.capacity * (size_t)kansa->unknowns);
    PDMC_TRY(start(&c, response, &added));
    while (added > 0 && terms > 0) PDMC_TRY(extend(&c, response, coefficients, added, &added));
    PDMC_TRY(fill_images(&c, response));
done:
    pdmc_free(coefficients);
    collection_clear(&c);
    if (status != PDMC_OK) pdmc_response_clear(response);
    return status;
}

void pdmc_response_clear(pdmc_response *response)
{
    pdmc_free(response->basis);
    pdmc_free(response->coefficients);
    pdmc_free(response->image);
    *response = (pdmc_response){0};
}
