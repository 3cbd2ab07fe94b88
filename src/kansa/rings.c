// SPDX-License-Identifier: GPL-3.0-or-later
#include "kansa/rings.h"

#include <cblas.h>
#include <string.h>

enum { CAPACITY = 64 };

pdmc_status pdmc_ring_operator_create(const pdmc_kansa *kansa, pdmc_ring_operator *rings)
{
    pdmc_status status = PDMC_OK;
    *rings = (pdmc_ring_operator){.kansa = kansa, .capacity = CAPACITY};
    PDMC_NEW(rings->rows, CAPACITY * (size_t)kansa->rows);
done:
    return status;
}

void pdmc_ring_operator_clear(pdmc_ring_operator *rings)
{
    pdmc_free(rings->rows);
    *rings = (pdmc_ring_operator){0};
}

static const double *ring_rows(const pdmc_kansa *kansa, int q)
{
    return &kansa->ring_rows[(size_t)q * 2 * (size_t)kansa->points.interior_count * (size_t)kansa->unknowns];
}

// Rows of traction scale with the effective modulus, of which a ring has its share; all others of the boundary are
// fixed.
static void scale_boundary(const pdmc_kansa *kansa, int q, int count, double rows[])
{
    const int m = kansa->rows, interior = 2 * kansa->points.interior_count, boundary = 2 * kansa->points.boundary_count;
    for (int k = 0; k < count; k++)
        for (int i = interior; i < m; i++)
            rows[(size_t)k * (size_t)m + (size_t)i] *=
                i < interior + boundary && kansa->is_traction[i - interior] ? kansa->share[q] : 0.0;
}

static void apply_some(pdmc_ring_operator *rings, int q, int count, const double v[], double out[])
{
    const pdmc_kansa *kansa = rings->kansa;
    const int n = kansa->unknowns, m = kansa->rows, interior = 2 * kansa->points.interior_count;
    cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, m - interior, count, n, 1.0, kansa->q + interior, m, v, n,
                0.0, rings->rows + interior, m);
    memcpy(out, v, (size_t)count * (size_t)n * sizeof *out);
    pdmc_kansa_unwhiten(kansa, count, out);
    cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, interior, count, n, 1.0, ring_rows(kansa, q), n, out, n, 0.0,
                rings->rows, m);
    scale_boundary(kansa, q, count, rings->rows);
    cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, n, count, m, 1.0, kansa->q, m, rings->rows, m, 0.0, out, n);
}

pdmc_status pdmc_ring_operator_apply(void *context, int q, int count, const double v[], double out[])
{
    pdmc_ring_operator *rings = context;
    const size_t n = (size_t)rings->kansa->unknowns;
    for (int first = 0; first < count; first += rings->capacity) {
        const int some = count - first < rings->capacity ? count - first : rings->capacity;
        apply_some(rings, q, some, &v[(size_t)first * n], &out[(size_t)first * n]);
    }
    return PDMC_OK;
}

void pdmc_ring_operator_residual(pdmc_ring_operator *rings, int q, int l, double out[])
{
    const pdmc_kansa *kansa = rings->kansa;
    const int n = kansa->unknowns, m = kansa->rows, interior = 2 * kansa->points.interior_count;
    double *residual = rings->rows, *boundary = rings->rows + m;
    memcpy(residual, &kansa->load[(size_t)l * (size_t)m], (size_t)m * sizeof *residual);
    cblas_dgemv(CblasColMajor, CblasNoTrans, m, n, -1.0, kansa->q, m,
                &kansa->whitened[(size_t)l * (size_t)n], 1, 1.0, residual, 1);
    cblas_dgemv(CblasColMajor, CblasNoTrans, n, interior, 1.0, ring_rows(kansa, q), n, residual, 1, 0.0, out, 1);
    pdmc_kansa_whiten(kansa, 1, out);
    memset(boundary, 0, (size_t)interior * sizeof *boundary);
    memcpy(boundary + interior, residual + interior, (size_t)(m - interior) * sizeof *boundary);
    scale_boundary(kansa, q, 1, boundary);
    cblas_dgemv(CblasColMajor, CblasTrans, m, n, 1.0, kansa->q, m, boundary, 1, 1.0, out, 1);
}
