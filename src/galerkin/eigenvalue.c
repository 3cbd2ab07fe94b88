// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "galerkin/solve.h"
#include "pdmc/random.h"

#include <float.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

enum { MOST_STEPS = 200, STEPS_BETWEEN_LOOKS = 10 };

// Lanczos' vectors q_j, orthonormal in the mass, with M q_j beside them; T of q' A q has the diagonal and the other
// one.
typedef struct {
    int n, steps;
    double *q, *mq; // [MOST_STEPS + 1, n]
    double diagonal[MOST_STEPS], other[MOST_STEPS];
} lanczos;

static double dot(int n, const double a[], const double b[])
{
    double sum = 0.0;
    for (int i = 0; i < n; i++) sum += a[i] * b[i];
    return sum;
}

// Orthogonal to all vectors so far; twice, since once leaves what was cancelled.
static void orthogonalise(const lanczos *l, double w[])
{
    for (int pass = 0; pass < 2; pass++)
        for (int j = 0; j < l->steps; j++) {
            const double share = dot(l->n, &l->mq[(size_t)j * (size_t)l->n], w);
            const double *q = &l->q[(size_t)j * (size_t)l->n];
            for (int i = 0; i < l->n; i++) w[i] -= share * q[i];
        }
}

// Takes w as the next vector, with norm 1; returns the norm that it had.
static double take_vector(lanczos *l, const pdmc_form *mass, double all[])
{
    double *q = &l->q[(size_t)l->steps * (size_t)l->n], *mq = &l->mq[(size_t)l->steps * (size_t)l->n];
    pdmc_form_multiply(mass, all, mq);
    const double norm = sqrt(fmax(0.0, dot(l->n, all, mq)));
    for (int i = 0; i < l->n; i++) {
        q[i] = norm > 0.0 ? all[i] / norm : 0.0;
        mq[i] = norm > 0.0 ? mq[i] / norm : 0.0;
    }
    return norm;
}

// The largest eigenvalue of T, and the residual of its vector with the rounding of the steps.
static pdmc_status look(const lanczos *l, double *largest, double *error)
{
    pdmc_status status = PDMC_OK;
    const int m = l->steps;
    double diagonal[MOST_STEPS], other[MOST_STEPS], *vectors = NULL;
    PDMC_NEW(vectors, m * m);
    memcpy(diagonal, l->diagonal, (size_t)m * sizeof *diagonal);
    memcpy(other, l->other, (size_t)m * sizeof *other);
    const int info = LAPACKE_dstev(LAPACK_COL_MAJOR, 'V', m, diagonal, other, vectors, m);
    if (info != 0) PDMC_FAIL(PDMC_ERR_EXTERN, "LAPACKE_dstev returned %d", info);
    *largest = diagonal[m - 1];
    *error = fabs(l->other[m - 1] * vectors[m * m - 1]) + m * DBL_EPSILON * *largest;
done:
    pdmc_free(vectors);
    return status;
}

// `all` has room for the prescribed values too, which stay zero.
static pdmc_status iterate(lanczos *l, const pdmc_form *form, const pdmc_form *mass, const pdmc_sparse_factor *factor,
                           double all[], double *largest, double *error)
{
    pdmc_status status = PDMC_OK;
    const double tolerance = 1e-8;
    pdmc_random_uniform(0, PDMC_STREAM_PROBES, 0, 0, (size_t)l->n, all);
    for (int i = 0; i < l->n; i++) all[i] -= 0.5;
    take_vector(l, mass, all);
    while (l->steps < MOST_STEPS && l->steps < l->n) {
        const double *q = &l->q[(size_t)l->steps * (size_t)l->n];
        memcpy(all, q, (size_t)l->n * sizeof *all);
        double *image = &l->q[((size_t)l->steps + 1) * (size_t)l->n]; // where the next vector will be
        pdmc_form_multiply(form, all, image);
        l->diagonal[l->steps++] = dot(l->n, q, image);
        PDMC_TRY(pdmc_sparse_factor_solve(factor, 1, image, all));
        orthogonalise(l, all);
        l->other[l->steps - 1] = take_vector(l, mass, all);
        const bool is_last = l->steps == MOST_STEPS || l->steps == l->n;
        if (l->steps % STEPS_BETWEEN_LOOKS != 0 && !is_last) continue;
        PDMC_TRY(look(l, largest, error));
        if (*error <= tolerance * *largest) break;
    }
done:
    return status;
}

static int largest_row(const pdmc_form *form)
{
    int64_t most = form->free_count;
    for (int64_t k = 0; k < form->start[form->free_count]; k++)
        if (form->row[k] >= most) most = form->row[k] + 1;
    return (int)most;
}

pdmc_status pdmc_form_largest_eigenvalue(const pdmc_form *form, const pdmc_form *mass, double *largest, double *error)
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)form->free_count, vectors = n < MOST_STEPS ? n + 1 : MOST_STEPS + 1;
    lanczos l = {.n = form->free_count};
    pdmc_sparse_factor *factor = NULL;
    double *all = NULL;
    PDMC_NEW(l.q, vectors * n);
    PDMC_NEW(l.mq, vectors * n);
    PDMC_NEW(all, largest_row(form));
    PDMC_TRY(pdmc_form_factor(mass, &factor));
    PDMC_TRY(iterate(&l, form, mass, factor, all, largest, error));
done:
    pdmc_sparse_factor_destroy(&factor);
    pdmc_free(l.q);
    pdmc_free(l.mq);
    pdmc_free(all);
    return status;
}

double pdmc_stable_step(double largest_eigenvalue)
{
    return 2.0 / sqrt(largest_eigenvalue);
}
