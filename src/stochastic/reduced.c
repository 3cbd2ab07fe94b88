// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/reduced_impl.h"

#include "pdmc/random.h"
#include "stochastic/draw.h"

#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

enum { B = PDMC_BLOCK, CAPACITY = PDMC_REDUCED_CAPACITY, MOST_ROUNDS = 24, MOST_OF_A_ROUND = B / 2 };

static const uint64_t training_samples = UINT64_MAX - B; // far from those of any study

// Vectors are [count, unknowns].
typedef struct {
    const pdmc_problem *problem;
    const pdmc_affine *full;
    int threads, n;
    pdmc_reduced_system *system;
    double *basis, *image;   // [CAPACITY] V and K_0 V
    double *probe;           // [PDMC_PROBES]
    double *load;            // [1] F
    double *block, *product; // [B]
    double *overlap;         // [B, CAPACITY]
    double *xi;              // [B, terms] of the training samples
    double *none;            // [B, terms] zero
} builder;

static pdmc_status builder_create(builder *b)
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)b->n, terms = (size_t)b->full->terms;
    PDMC_TRY(pdmc_reduced_system_create(b->full->terms, &b->system));
    PDMC_NEW(b->basis, CAPACITY * n);
    PDMC_NEW(b->image, CAPACITY * n);
    PDMC_NEW(b->probe, PDMC_PROBES * n);
    PDMC_NEW(b->load, n);
    PDMC_NEW(b->block, B * n);
    PDMC_NEW(b->product, B * n);
    PDMC_NEW(b->overlap, B * CAPACITY);
    PDMC_NEW(b->xi, B * terms);
    PDMC_NEW(b->none, B * terms);
done:
    return status;
}

static void builder_clear(builder *b)
{
    pdmc_reduced_system_destroy(b->system);
    pdmc_free(b->basis);
    pdmc_free(b->image);
    pdmc_free(b->probe);
    pdmc_free(b->load);
    pdmc_free(b->block);
    pdmc_free(b->product);
    pdmc_free(b->overlap);
    pdmc_free(b->xi);
    pdmc_free(b->none);
}

static pdmc_status make_probes(builder *b)
{
    const size_t n = (size_t)b->n;
#pragma omp parallel for schedule(static) num_threads(b->threads)
    for (int k = 0; k < PDMC_PROBES; k++) {
        double *g = &b->block[(size_t)k * n];
        pdmc_random_uniform(b->problem->sampling.seed, PDMC_STREAM_PROBES, (uint64_t)k, 0, n, g);
        for (size_t i = 0; i < n; i++) g[i] = pdmc_normal_quantile(g[i]);
    }
    return b->full->verbs->color(b->full, b->block, b->probe);
}

// The first vector of the block is the answer to the mean load, the others are zero; so are those of the product.
static void take_mean(builder *b)
{
    const size_t n = (size_t)b->n;
    memset(b->block, 0, B * n * sizeof *b->block);
    memcpy(b->block, b->full->solution[1], n * sizeof *b->block);
}

// F = K_0 times the answer to it, and its products with the probes.
static pdmc_status make_load(builder *b)
{
    take_mean(b);
    const pdmc_status status = b->full->verbs->multiply(b->full, b->none, b->block, b->product);
    if (status != PDMC_OK) return status;
    memcpy(b->load, b->product, (size_t)b->n * sizeof *b->load);
    cblas_dgemv(CblasRowMajor, CblasNoTrans, PDMC_PROBES, b->n, 1.0, b->probe, b->n, b->load, 1, 0.0,
                b->system->probe_load, 1);
    return PDMC_OK;
}

static pdmc_status draw_training(builder *b)
{
    pdmc_status status = PDMC_OK;
    const pdmc_affine *full = b->full;
    pdmc_draw draw = {0};
    PDMC_NEW(draw.micromodulus, full->bins);
    PDMC_NEW(draw.ring_weight, full->rings);
    for (int s = 0; s < B; s++) {
        draw.xi = &b->xi[s * full->terms];
        pdmc_draw_sample(b->problem, full, training_samples + (uint64_t)s, &draw);
    }
done:
    pdmc_free(draw.micromodulus);
    pdmc_free(draw.ring_weight);
    return status;
}

// block -= V (K_0 V)' block
static void project_out(builder *b)
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

static pdmc_status selection_create(const builder *b, selection *made)
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
static pdmc_status apply_term(const builder *b, selection *work, int m, int first, int count)
{
    const int n = b->n, terms = b->full->terms;
    const size_t at = (size_t)first * (size_t)n;
    memset(work->xi, 0, (size_t)(B * terms) * sizeof *work->xi);
    for (int s = 0; s < B; s++) work->xi[s * terms + m - 1] = 1.0;
    memcpy(work->vectors, &b->basis[at], (size_t)count * (size_t)n * sizeof *work->vectors);
    const pdmc_status status = b->full->verbs->multiply(b->full, work->xi, work->vectors, work->products); // K_0 + K_m
    if (status == PDMC_OK) cblas_daxpy(count * n, -1.0, &b->image[at], 1, work->products, 1);
    return status;
}

static void project_on_probes(const builder *b, int m, int first, int count, const double product[])
{
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, count, PDMC_PROBES, b->n, 1.0, product, b->n, b->probe, b->n,
                0.0, &b->system->probe_matrix[((size_t)m * CAPACITY + (size_t)first) * PDMC_PROBES], PDMC_PROBES);
}

// Rows first .. first + count - 1 of V' K_m V, and by symmetry its columns.
static void project_on_basis(const builder *b, int m, int first, int count, const double product[])
{
    const int n = b->n, r = first + count;
    double *matrix = &b->system->matrix[(size_t)(m - 1) * CAPACITY * CAPACITY];
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, count, r, n, 1.0, product, n, b->basis, n, 0.0,
                &matrix[(size_t)first * CAPACITY], CAPACITY);
    for (size_t j = (size_t)first; j < (size_t)r; j++)
        for (size_t i = 0; i < j; i++) matrix[i * CAPACITY + j] = matrix[j * CAPACITY + i];
}

// Everything that solving needs of `count` <= B new vectors at the end of the basis.
static pdmc_status project(builder *b, int count)
{
    pdmc_status status = PDMC_OK;
    const int n = b->n, first = b->system->dimension;
    const double *vectors = &b->basis[(size_t)first * (size_t)n];
    b->system->dimension += count;
    cblas_dgemv(CblasRowMajor, CblasNoTrans, count, n, 1.0, vectors, n, b->load, 1, 0.0, &b->system->load[first], 1);
    project_on_probes(b, 0, first, count, &b->image[(size_t)first * (size_t)n]);
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

// Appends to the basis those combinations of the block that are new and large: the eigenvectors of its Gram matrix in the
// energy of the mean.
static pdmc_status enrich(builder *b, int *added)
{
    pdmc_status status = PDMC_OK;
    const int n = b->n, room = CAPACITY - b->system->dimension;
    const double negligible = 1e-10; // of the largest eigenvalue: beyond it rounding spoils orthogonality
    double gram[B * B], eigenvalue[B];
    for (int pass = 0; pass < 2; pass++) project_out(b); // twice is enough (Kahan)
    PDMC_TRY(b->full->verbs->multiply(b->full, b->none, b->block, b->product));
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, B, B, n, 1.0, b->block, n, b->product, n, 0.0, gram, B);
    const int info = LAPACKE_dsyev(LAPACK_COL_MAJOR, 'V', 'L', B, gram, B, eigenvalue); // ascending
    if (info != 0) PDMC_FAIL(PDMC_ERR_EXTERN, "LAPACKE_dsyev returned %d", info);
    *added = 0;
    while (*added < MOST_OF_A_ROUND && *added < room && eigenvalue[B - 1 - *added] > negligible * eigenvalue[B - 1])
        ++*added;
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
static pdmc_status residuals(builder *b, const double x[])
{
    const pdmc_affine_verbs *verbs = b->full->verbs;
    const int n = b->n, r = b->system->dimension;
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, B, n, r, 1.0, x, r, b->basis, n, 0.0, b->block, n);
    pdmc_status status = verbs->multiply(b->full, b->xi, b->block, b->product);
    if (status != PDMC_OK) return status;
    for (int s = 0; s < B; s++) {
        double *row = &b->product[(size_t)s * (size_t)n];
        for (int k = 0; k < n; k++) row[k] = b->load[k] - row[k];
    }
    return verbs->precondition(b->full, b->product, b->block);
}

// Solves the training samples; tells the largest bound of their errors, of those that have one.
static pdmc_status train(builder *b, double x[], double *worst)
{
    double error[B];
    const pdmc_status status = pdmc_reduced_system_solve(b->system, b->xi, x, error);
    *worst = 0.0;
    for (int s = 0; s < B && status == PDMC_OK; s++)
        if (isfinite(error[s])) *worst = fmax(*worst, error[s]);
    return status;
}

static pdmc_status build(builder *b, double wanted)
{
    pdmc_status status = PDMC_OK;
    double *x = NULL, worst = INFINITY;
    int added = 0;
    PDMC_NEW(x, B * CAPACITY);
    PDMC_TRY(make_probes(b));
    PDMC_TRY(make_load(b));
    PDMC_TRY(draw_training(b));
    take_mean(b);
    PDMC_TRY(enrich(b, &added));
    for (int round = 0; round < MOST_ROUNDS && added > 0; round++) {
        PDMC_TRY(train(b, x, &worst));
        if (worst <= wanted) break;
        PDMC_TRY(residuals(b, x));
        PDMC_TRY(enrich(b, &added));
    }
done:
    pdmc_free(x);
    return status;
}

// What the two models have in common.
static pdmc_status copy_weights(const pdmc_affine *full, pdmc_affine *reduced)
{
    pdmc_status status = PDMC_OK;
    const size_t bins = (size_t)full->bins, terms = (size_t)full->terms, rings = (size_t)full->rings;
    *reduced = (pdmc_affine){.terms = full->terms, .bins = full->bins, .rings = full->rings, .tips = full->tips,
                             .angles = full->angles, .micromodulus = full->micromodulus,
                             .crossing_bound = full->crossing_bound};
    PDMC_NEW(reduced->term_weight, bins * terms);
    PDMC_NEW(reduced->modulus_weight, bins);
    PDMC_NEW(reduced->ring_weight, bins * rings);
    memcpy(reduced->term_weight, full->term_weight, bins * terms * sizeof(double));
    memcpy(reduced->modulus_weight, full->modulus_weight, bins * sizeof(double));
    memcpy(reduced->ring_weight, full->ring_weight, bins * rings * sizeof(double));
done:
    return status;
}

// Numbers the unknowns that crossings look at; number: [unknowns], -1 for those that none does.
static int number_observed(const pdmc_affine *full, int number[])
{
    int observed = 0;
    for (int k = 0; k < full->unknowns; k++) number[k] = -1;
    for (int d = 0; d < full->tips * full->angles; d++) {
        const pdmc_crossing *crossing = &full->crossings[d];
        for (int k = 0; k < crossing->bonds * PDMC_BOND_ENDS; k++)
            if (number[crossing->column[k]] < 0) number[crossing->column[k]] = observed++;
    }
    return observed;
}

static pdmc_status copy_crossing(const pdmc_crossing *full, const int number[], pdmc_crossing *reduced)
{
    pdmc_status status = PDMC_OK;
    const size_t values = (size_t)full->bonds * PDMC_BOND_ENDS;
    PDMC_NEW(reduced->row, values);
    PDMC_NEW(reduced->column, values);
    PDMC_NEW(reduced->ring, full->bonds);
    reduced->bonds = full->bonds;
    for (size_t k = 0; k < values; k++) {
        reduced->row[k] = full->row[k];
        reduced->column[k] = number[full->column[k]];
    }
    for (int b = 0; b < full->bonds; b++) reduced->ring[b] = full->ring[b];
done:
    return status;
}

static pdmc_status reduce_crossings(const builder *b, pdmc_affine *reduced)
{
    pdmc_status status = PDMC_OK;
    const pdmc_affine *full = b->full;
    const int directions = full->tips * full->angles, r = reduced->unknowns;
    int *number = NULL;
    PDMC_NEW(number, full->unknowns);
    PDMC_NEW(reduced->crossings, directions);
    reduced->observed = number_observed(full, number);
    PDMC_NEW(reduced->observe, (size_t)reduced->observed * (size_t)r);
    for (int k = 0; k < full->unknowns; k++)
        for (int j = 0; j < r && number[k] >= 0; j++)
            reduced->observe[(size_t)number[k] * (size_t)r + (size_t)j] = b->basis[(size_t)j * (size_t)b->n + (size_t)k];
    for (int d = 0; d < directions; d++)
        PDMC_TRY(copy_crossing(&full->crossings[d], number, &reduced->crossings[d]));
done:
    pdmc_free(number);
    return status;
}

// The coordinates of a vector of the space are its products with the images of the basis.
static pdmc_status reduce_vectors(const builder *b, pdmc_affine *reduced)
{
    pdmc_status status = PDMC_OK;
    const int n = b->n, r = b->system->dimension;
    reduced->unknowns = r;
    for (int l = 0; l < 2; l++) PDMC_NEW(reduced->solution[l], r);
    PDMC_NEW(reduced->stress_intensity, 2 * reduced->tips * r);
    cblas_dgemv(CblasRowMajor, CblasNoTrans, r, n, 1.0, b->image, n, b->full->solution[1], 1, 0.0, reduced->solution[1], 1);
    if (reduced->tips > 0)
        cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, 2 * reduced->tips, r, n, 1.0, b->full->stress_intensity, n,
                    b->basis, n, 0.0, reduced->stress_intensity, r);
done:
    return status;
}

pdmc_status pdmc_reduced_create(const pdmc_problem *problem, const pdmc_affine *full, double tolerance, int threads,
                                pdmc_affine *reduced)
{
    static const pdmc_affine_verbs verbs = {.destroy = pdmc_reduced_system_destroy};
    pdmc_status status = PDMC_OK;
    builder b = {.problem = problem, .full = full, .threads = threads, .n = full->unknowns};
    *reduced = (pdmc_affine){0};
    PDMC_TRY(builder_create(&b));
    PDMC_TRY(build(&b, tolerance));
    PDMC_TRY(copy_weights(full, reduced));
    reduced->verbs = &verbs;
    PDMC_TRY(reduce_vectors(&b, reduced));
    PDMC_TRY(reduce_crossings(&b, reduced));
    reduced->discretisation = b.system;
    b.system = NULL;
done:
    builder_clear(&b);
    if (status != PDMC_OK) pdmc_affine_clear(reduced);
    return status;
}

pdmc_status pdmc_reduced_solve(const pdmc_affine *reduced, const double xi[], double x[], double error[PDMC_BLOCK])
{
    return pdmc_reduced_system_solve(reduced->discretisation, xi, x, error);
}
