// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/reduced_impl.h"

#include "pdmc/random.h"
#include "stochastic/draw.h"

#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

static const double share_left_out = 0.2; // of the error that is wanted: smaller directions do not enter the basis

enum { B = PDMC_BLOCK, CAPACITY = PDMC_REDUCED_CAPACITY, MOST_ROUNDS = 24, MOST_OF_A_ROUND = B / 2 };

static const uint64_t training_samples = UINT64_C(1) << 63; // the first; far from those of any study

pdmc_status pdmc_reduced_builder_create(pdmc_reduced_builder *b)
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)b->n, terms = (size_t)b->full->terms;
    PDMC_TRY(pdmc_reduced_system_create(b->full, &b->system));
    PDMC_NEW(b->basis, CAPACITY * n);
    PDMC_NEW(b->image, CAPACITY * n);
    PDMC_NEW(b->probe, PDMC_PROBES * n);
    PDMC_NEW(b->load, n);
    PDMC_NEW(b->block, B * n);
    PDMC_NEW(b->product, B * n);
    PDMC_NEW(b->overlap, B * CAPACITY);
    PDMC_TRY(pdmc_draws_create(b->variables, &b->training));
    PDMC_NEW(b->none, B * terms);
done:
    return status;
}

void pdmc_reduced_builder_clear(pdmc_reduced_builder *b)
{
    pdmc_reduced_system_destroy(b->system);
    pdmc_free(b->basis);
    pdmc_free(b->image);
    pdmc_free(b->probe);
    pdmc_free(b->load);
    pdmc_free(b->block);
    pdmc_free(b->product);
    pdmc_free(b->overlap);
    pdmc_draws_clear(&b->training);
    pdmc_free(b->none);
}

static pdmc_status make_probes(pdmc_reduced_builder *b)
{
    const size_t n = (size_t)b->n;
#pragma omp parallel for schedule(static) num_threads(b->threads)
    for (int k = 0; k < PDMC_PROBES; k++) {
        double *g = &b->block[(size_t)k * n];
        pdmc_random_uniform(b->variables->problem->sampling.seed, PDMC_STREAM_PROBES, (uint64_t)k, 0, n, g);
        for (size_t i = 0; i < n; i++) g[i] = pdmc_normal_quantile(g[i]);
    }
    return b->full->verbs->color(b->full, b->block, b->probe);
}

// The first vector of the block is the answer to the mean load, the others are zero; so are those of the product.
static void take_mean(pdmc_reduced_builder *b)
{
    const size_t n = (size_t)b->n;
    memset(b->block, 0, B * n * sizeof *b->block);
    memcpy(b->block, b->full->solution[1], n * sizeof *b->block);
}

// F = K_0 times the answer to it, and its products with the probes.
static pdmc_status make_load(pdmc_reduced_builder *b)
{
    take_mean(b);
    const pdmc_status status = b->full->verbs->multiply(b->full, 1.0, b->none, b->block, b->product);
    if (status != PDMC_OK) return status;
    memcpy(b->load, b->product, (size_t)b->n * sizeof *b->load);
    cblas_dgemv(CblasRowMajor, CblasNoTrans, PDMC_PROBES, b->n, 1.0, b->probe, b->n, b->load, 1, 0.0,
                b->system->probe_load, 1);
    return PDMC_OK;
}

// Others in every round: the samples of the last one are in the basis, and say nothing of those that are not.
static pdmc_status draw_training(pdmc_reduced_builder *b, int round)
{
    for (int s = 0; s < B; s++)
        pdmc_variables_sample(b->variables, training_samples + (uint64_t)(round * B + s),
                              &b->training.z[s * b->variables->count]);
    return pdmc_variables_draw(b->variables, B, b->training.z, b->training.draw);
}

// block -= V (K_0 V)' block
static void project_out(pdmc_reduced_builder *b)
{
    const int n = b->n, r = b->system->dimension;
    if (r == 0) return;
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, B, r, n, 1.0, b->block, n, b->image, n, 0.0, b->overlap,
                CAPACITY);
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, B, n, r, -1.0, b->overlap, CAPACITY, b->basis, n, 1.0,
                b->block, n);
}

// Scratch of one thread: blocks, and coefficients that select a term.
typedef struct {
    double *xi, *vectors, *products;
} selection;

static pdmc_status selection_create(const pdmc_reduced_builder *b, selection *made)
{
    pdmc_status status = PDMC_OK;
    *made = (selection){0};
    PDMC_NEW(made->xi, B * b->full->terms);
    PDMC_NEW(made->vectors, (size_t)B * (size_t)b->n);
    PDMC_NEW(made->products, (size_t)B * (size_t)b->n);
done:
    return status;
}

static void selection_clear(selection *made)
{
    pdmc_free(made->xi);
    pdmc_free(made->vectors);
    pdmc_free(made->products);
}

// products = K_m times `count` vectors of the basis from `first` on, m >= 1.
static pdmc_status apply_term(const pdmc_reduced_builder *b, selection *work, int m, int first, int count)
{
    const int n = b->n, terms = b->full->terms;
    const size_t at = (size_t)first * (size_t)n;
    memset(work->xi, 0, (size_t)(B * terms) * sizeof *work->xi);
    for (int s = 0; s < count; s++) work->xi[s * terms + m - 1] = 1.0;
    memcpy(work->vectors, &b->basis[at], (size_t)count * (size_t)n * sizeof *work->vectors);
    return b->full->verbs->multiply(b->full, 0.0, work->xi, work->vectors, work->products);
}

static void project_on_probes(const pdmc_reduced_builder *b, int m, int first, int count, const double product[])
{
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, count, PDMC_PROBES, b->n, 1.0, product, b->n, b->probe, b->n,
                0.0, &b->system->probe_matrix[((size_t)m * CAPACITY + (size_t)first) * PDMC_PROBES], PDMC_PROBES);
}

static void mirror(int first, int r, double matrix[])
{
    for (size_t j = (size_t)first; j < (size_t)r; j++)
        for (size_t i = 0; i < j; i++) matrix[i * CAPACITY + j] = matrix[j * CAPACITY + i];
}

static double *matrix_of_term(const pdmc_reduced_builder *b, int m)
{
    return &b->system->matrix[(size_t)(m - 1) * CAPACITY * CAPACITY];
}

// Rows first .. first + count - 1 of V' K_m V, and by symmetry its columns.
static void project_on_basis(const pdmc_reduced_builder *b, int m, int first, int count, const double product[])
{
    const int n = b->n, r = first + count;
    double *matrix = matrix_of_term(b, m);
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, count, r, n, 1.0, product, n, b->basis, n, 0.0,
                &matrix[(size_t)first * CAPACITY], CAPACITY);
    mirror(first, r, matrix);
}

// The terms one by one, each applied to the new vectors.
static pdmc_status project_terms(pdmc_reduced_builder *b, int first, int count)
{
    pdmc_status status = PDMC_OK;
#pragma omp parallel num_threads(b->threads)
    {
        selection work;
        pdmc_status mine = selection_create(b, &work);
#pragma omp for schedule(dynamic)
        for (int m = 1; m <= b->full->terms; m++) {
            if (mine == PDMC_OK) mine = apply_term(b, &work, m, first, count);
            if (mine != PDMC_OK) continue;
            project_on_probes(b, m, first, count, work.products);
            project_on_basis(b, m, first, count, work.products);
        }
        selection_clear(&work);
        if (mine != PDMC_OK) {
#pragma omp critical(pdmc_reduced)
            status = mine;
        }
    }
    return status;
}

// All terms at once, by the model's own verb.
static pdmc_status project_at_once(pdmc_reduced_builder *b, int first, int count)
{
    pdmc_status status = PDMC_OK;
    const pdmc_affine *full = b->full;
    const size_t terms = (size_t)full->terms, r = (size_t)(first + count), rows = (size_t)count;
    const double *vectors = &b->basis[(size_t)first * (size_t)b->n];
    double *on_probes = NULL, *on_basis = NULL;
    PDMC_NEW(on_probes, terms * rows * PDMC_PROBES);
    PDMC_NEW(on_basis, terms * rows * r);
    PDMC_TRY(full->verbs->project(full, count, vectors, PDMC_PROBES, b->probe, on_probes));
    PDMC_TRY(full->verbs->project(full, count, vectors, (int)r, b->basis, on_basis));
    for (size_t m = 0; m < terms; m++) {
        double *matrix = matrix_of_term(b, (int)m + 1);
        memcpy(&b->system->probe_matrix[((m + 1) * CAPACITY + (size_t)first) * PDMC_PROBES],
               &on_probes[m * rows * PDMC_PROBES], rows * PDMC_PROBES * sizeof *on_probes);
        for (size_t i = 0; i < rows; i++)
            memcpy(&matrix[((size_t)first + i) * CAPACITY], &on_basis[(m * rows + i) * r], r * sizeof *on_basis);
        mirror(first, (int)r, matrix);
    }
done:
    pdmc_free(on_probes);
    pdmc_free(on_basis);
    return status;
}

// Everything that solving needs of `count` <= B new vectors at the end of the basis.
static pdmc_status project(pdmc_reduced_builder *b, int count)
{
    const int n = b->n, first = b->system->dimension;
    const double *vectors = &b->basis[(size_t)first * (size_t)n];
    b->system->dimension += count;
    cblas_dgemv(CblasRowMajor, CblasNoTrans, count, n, 1.0, vectors, n, b->load, 1, 0.0, &b->system->load[first], 1);
    project_on_probes(b, 0, first, count, &b->image[(size_t)first * (size_t)n]);
    return (b->full->verbs->project ? project_at_once : project_terms)(b, first, count);
}

// Appends to the basis those combinations of the block that are new and large: the eigenvectors of its Gram matrix in the
// energy of the mean. What is `small` against the error that is wanted is left out.
static pdmc_status enrich(pdmc_reduced_builder *b, double small, int *added)
{
    pdmc_status status = PDMC_OK;
    const int n = b->n, room = CAPACITY - b->system->dimension;
    const double rounding = 1e-10; // of the largest eigenvalue: beyond it vectors are no longer orthogonal
    double gram[B * B], eigenvalue[B];
    for (int pass = 0; pass < 2; pass++) project_out(b); // twice is enough (Kahan)
    PDMC_TRY(b->full->verbs->multiply(b->full, 1.0, b->none, b->block, b->product));
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, B, B, n, 1.0, b->block, n, b->product, n, 0.0, gram, B);
    const int info = LAPACKE_dsyev(LAPACK_COL_MAJOR, 'V', 'L', B, gram, B, eigenvalue); // ascending
    if (info != 0) PDMC_FAIL(PDMC_ERR_EXTERN, "LAPACKE_dsyev returned %d", info);
    const double negligible = fmax(rounding * eigenvalue[B - 1], small * small);
    *added = 0;
    while (*added < MOST_OF_A_ROUND && *added < room && eigenvalue[B - 1 - *added] > negligible) ++*added;
    for (int k = 0; k < *added; k++) cblas_dscal(B, 1.0 / sqrt(eigenvalue[B - 1 - k]), &gram[(B - 1 - k) * B], 1);
    const size_t end = (size_t)b->system->dimension * (size_t)n;
    const double *combination = &gram[(B - *added) * B];
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, *added, n, B, 1.0, combination, B, b->block, n, 0.0,
                &b->basis[end], n);
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, *added, n, B, 1.0, combination, B, b->product, n, 0.0,
                &b->image[end], n);
    if (*added > 0) PDMC_TRY(project(b, *added));
done:
    return status;
}

// The block becomes the preconditioned residuals K_0^-1 (F - K(xi) V x) of the training samples.
static pdmc_status residuals(pdmc_reduced_builder *b, const double x[])
{
    const pdmc_affine_verbs *verbs = b->full->verbs;
    const int n = b->n, r = b->system->dimension;
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, B, n, r, 1.0, x, r, b->basis, n, 0.0, b->block, n);
    pdmc_status status = verbs->multiply(b->full, 1.0, b->training.xi, b->block, b->product);
    if (status != PDMC_OK) return status;
    for (int s = 0; s < B; s++) {
        double *row = &b->product[(size_t)s * (size_t)n];
        for (int k = 0; k < n; k++) row[k] = b->load[k] - row[k];
    }
    return verbs->precondition(b->full, b->product, b->block);
}

// Solves the training samples; tells the largest bound of their errors, of those that have one.
static pdmc_status train(pdmc_reduced_builder *b, double x[], double *worst)
{
    double error[B];
    const pdmc_status status = pdmc_reduced_system_solve(b->system, b->training.xi, x, error);
    *worst = 0.0;
    for (int s = 0; s < B && status == PDMC_OK; s++)
        if (isfinite(error[s])) *worst = fmax(*worst, error[s]);
    return status;
}

pdmc_status pdmc_reduced_build(pdmc_reduced_builder *b, double wanted)
{
    pdmc_status status = PDMC_OK;
    double *x = NULL, worst = INFINITY;
    int added = 0;
    PDMC_NEW(x, B * CAPACITY);
    PDMC_TRY(make_probes(b));
    PDMC_TRY(make_load(b));
    take_mean(b);
    PDMC_TRY(enrich(b, 0.0, &added));
    for (int round = 0; round < MOST_ROUNDS && added > 0; round++) {
        PDMC_TRY(draw_training(b, round));
        PDMC_TRY(train(b, x, &worst));
        if (worst <= wanted) break;
        PDMC_TRY(residuals(b, x));
        PDMC_TRY(enrich(b, share_left_out * wanted, &added));
    }
done:
    pdmc_free(x);
    return status;
}
