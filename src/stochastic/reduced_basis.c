// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/reduced_impl.h"

#include "pdmc/random.h"
#include "stochastic/draw.h"

#include <cblas.h>
#include <gsl/gsl_sort.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

static const double share_left_out = 0.05; // of the error that is allowed: smaller directions do not enter the basis

enum { B = PDMC_BLOCK, CAPACITY = PDMC_REDUCED_CAPACITY, MOST_ROUNDS = 12, PART = B / 4, PANEL = 2048 };

// How often the basis is projected out of new vectors. Twice is enough for any (Kahan); those whose residuals are orthogonal
// to the basis, but for rounding, have nothing to lose but that.
enum { ORTHOGONAL = 1, ANY = 2 };

static const double margin = 0.6; // of the goal that training samples meet: the worst of thousands is worse than theirs

static const uint64_t training_samples = UINT64_C(1) << 63; // the first; far from those of any study

pdmc_status pdmc_reduced_builder_create(const pdmc_reduced_goal *goal, pdmc_reduced_builder *b)
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)b->n, terms = (size_t)b->full->terms;
    PDMC_TRY(pdmc_reduced_system_create(b->full, goal, &b->system));
    const int sides = b->system->sides, added = b->system->added;
    PDMC_NEW(b->probe, (PDMC_PROBES + CAPACITY) * n);
    b->basis = b->probe + PDMC_PROBES * n;
    PDMC_NEW(b->direction, CAPACITY * CAPACITY);
    PDMC_NEW(b->load, (size_t)(sides + added) * n);
    PDMC_NEW(b->block, B * n);
    PDMC_NEW(b->product, B * n);
    PDMC_NEW(b->overlap, B * CAPACITY);
    PDMC_NEW(b->training, PDMC_TRAINING * terms);
    PDMC_NEW(b->training_share, PDMC_TRAINING * added);
    PDMC_NEW(b->xi, B * terms);
    PDMC_NEW(b->none, B * terms);
    PDMC_NEW(b->allowed, sides);
done:
    return status;
}

void pdmc_reduced_builder_clear(pdmc_reduced_builder *b)
{
    pdmc_reduced_system_destroy(b->system);
    pdmc_free(b->probe);
    pdmc_free(b->direction);
    pdmc_free(b->load);
    pdmc_free(b->block);
    pdmc_free(b->product);
    pdmc_free(b->overlap);
    pdmc_free(b->training);
    pdmc_free(b->training_share);
    pdmc_free(b->xi);
    pdmc_free(b->none);
    pdmc_free(b->allowed);
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

// load = K_0 times the model's answers to `count` cases from `first` on.
static pdmc_status make_cases(pdmc_reduced_builder *b, int first, int count, double load[])
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)b->n;
    for (int done = 0; done < count; done += B) {
        const size_t values = (size_t)(count - done < B ? count - done : B) * n;
        memset(b->block, 0, B * n * sizeof *b->block);
        memcpy(b->block, pdmc_affine_solution(b->full, first + done), values * sizeof *b->block);
        PDMC_TRY(b->full->verbs->multiply(b->full, 1.0, b->none, b->block, b->product));
        memcpy(&load[(size_t)done * n], b->product, values * sizeof *load);
    }
done:
    return status;
}

// F = K_0 times the answer to the mean load, and the rows of the stress intensities but for unknowns that are held, where
// probes are zero.
static pdmc_status make_loads(pdmc_reduced_builder *b)
{
    const size_t n = (size_t)b->n;
    const int sides = b->system->sides, added = b->system->added;
    pdmc_status status = make_cases(b, 1, 1, b->load);
    if (status == PDMC_OK) status = make_cases(b, 2, added, &b->load[(size_t)sides * n]);
    if (status != PDMC_OK) return status;
    for (size_t k = n; k < (size_t)sides * n; k++)
        b->load[k] = b->probe[k % n] != 0.0 ? b->full->stress_intensity[k - n] : 0.0;
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, sides + added, PDMC_PROBES, b->n, 1.0, b->load, b->n, b->probe,
                b->n, 0.0, b->system->probe_load, PDMC_PROBES);
    return PDMC_OK;
}

// block -= V V' K_0 block, some vectors at a time.
static void project_out(const pdmc_reduced_builder *b)
{
    const int n = b->n, r = b->system->dimension;
#pragma omp parallel for schedule(static) num_threads(b->threads)
    for (int first = 0; first < B; first += PART) {
        double *block = &b->block[(size_t)first * (size_t)n], *overlap = &b->overlap[first * CAPACITY];
        cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, PART, r, n, 1.0, &b->product[(size_t)first * (size_t)n], n,
                    b->basis, n, 0.0, overlap, CAPACITY);
        cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, PART, n, r, -1.0, overlap, CAPACITY, b->basis, n, 1.0,
                    block, n);
    }
}

// Scratch of one thread: blocks, coefficients that select a term, and what the images have in the basis.
typedef struct {
    double *xi, *vectors, *products, *overlap;
} selection;

static pdmc_status selection_create(const pdmc_reduced_builder *b, selection *made)
{
    pdmc_status status = PDMC_OK;
    *made = (selection){0};
    PDMC_NEW(made->xi, B * b->full->terms);
    PDMC_NEW(made->vectors, (size_t)B * (size_t)b->n);
    PDMC_NEW(made->products, (size_t)B * (size_t)b->n);
    PDMC_NEW(made->overlap, B * CAPACITY);
done:
    return status;
}

static void selection_clear(selection *made)
{
    pdmc_free(made->xi);
    pdmc_free(made->vectors);
    pdmc_free(made->products);
    pdmc_free(made->overlap);
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

// Columns first .. first + count - 1 of the triangle of V' K_m V.
static void project_on_basis(const pdmc_reduced_builder *b, int m, int first, int count, const double product[],
                             double overlap[])
{
    const int n = b->n, r = first + count;
    double *matrix = &b->system->matrix[(size_t)m * PDMC_REDUCED_TRIANGLE];
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, count, r, n, 1.0, product, n, b->basis, n, 0.0, overlap, r);
    for (int j = first; j < r; j++)
        memcpy(&matrix[pdmc_triangle_column((size_t)j)], &overlap[(j - first) * r], (size_t)(j + 1) * sizeof *matrix);
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
            project_on_basis(b, m, first, count, work.products, work.overlap);
        }
        selection_clear(&work);
        if (mine != PDMC_OK) {
#pragma omp critical(pdmc_reduced)
            status = mine;
        }
    }
    return status;
}

// All terms at once, by the model's own verb, on probes and basis.
static pdmc_status project_at_once(pdmc_reduced_builder *b, int first, int count)
{
    pdmc_status status = PDMC_OK;
    const size_t terms = (size_t)b->full->terms, rows = (size_t)count;
    const size_t r = (size_t)(first + count), width = PDMC_PROBES + r;
    double *products = NULL;
    PDMC_NEW(products, terms * rows * width);
    PDMC_TRY(b->full->verbs->project(b->full, count, &b->basis[(size_t)first * (size_t)b->n], (int)width, b->probe,
                                     products));
    for (size_t m = 0; m < terms; m++)
        for (size_t k = 0; k < rows; k++) {
            const size_t j = (size_t)first + k;
            const double *row = &products[(m * rows + k) * width];
            memcpy(&b->system->probe_matrix[((m + 1) * CAPACITY + j) * PDMC_PROBES], row, PDMC_PROBES * sizeof *row);
            memcpy(&b->system->matrix[(m + 1) * PDMC_REDUCED_TRIANGLE + pdmc_triangle_column(j)], row + PDMC_PROBES,
                   (j + 1) * sizeof *row);
        }
done:
    pdmc_free(products);
    return status;
}

// The mean's on the probes, of combinations of the block.
static void project_mean(const pdmc_reduced_builder *b, int count, const double combination[])
{
    const int n = b->n;
    double of_block[B * PDMC_PROBES];
#pragma omp parallel for schedule(static) num_threads(b->threads)
    for (int k = 0; k < B; k += PART)
        cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, PART, PDMC_PROBES, n, 1.0,
                    &b->product[(size_t)k * (size_t)n], n, b->probe, n, 0.0, &of_block[k * PDMC_PROBES], PDMC_PROBES);
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, count, PDMC_PROBES, B, 1.0, combination, B, of_block,
                PDMC_PROBES, 0.0, &b->system->probe_matrix[b->system->dimension * PDMC_PROBES], PDMC_PROBES);
}

// What solving needs of `count` <= B new vectors at the end of the basis, but for the mean's operator.
static pdmc_status project(pdmc_reduced_builder *b, int count)
{
    const int n = b->n, first = b->system->dimension;
    const double *vectors = &b->basis[(size_t)first * (size_t)n];
    b->system->dimension += count;
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, b->system->sides + b->system->added, count, n, 1.0, b->load, n,
                vectors, n, 0.0, &b->system->load[first], CAPACITY);
    return (b->full->verbs->project ? project_at_once : project_terms)(b, first, count);
}

// Puts combinations of the block behind the end of the basis, some numbers of every vector at a time.
static void append(const pdmc_reduced_builder *b, int count, const double combination[])
{
    const int n = b->n;
    double *end = &b->basis[(size_t)b->system->dimension * (size_t)n];
#pragma omp parallel for schedule(static) num_threads(b->threads)
    for (int first = 0; first < n; first += PANEL) {
        const int width = n - first < PANEL ? n - first : PANEL;
        cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, count, width, B, 1.0, combination, B, &b->block[first],
                    n, 0.0, &end[first], n);
    }
}

// Takes the basis out of the block, whose product is known, and finds that of what is left.
static pdmc_status orthogonalise(pdmc_reduced_builder *b, int passes)
{
    pdmc_status status = PDMC_OK;
    for (int pass = 0; pass < passes && b->system->dimension > 0; pass++) {
        project_out(b);
        PDMC_TRY(b->full->verbs->multiply(b->full, 1.0, b->none, b->block, b->product));
    }
done:
    return status;
}

// Appends to the basis those combinations of the block that are new and large: the eigenvectors of its Gram matrix in the
// energy of the mean. What is `small` against the errors that are allowed is left out.
static pdmc_status enrich(pdmc_reduced_builder *b, int passes, double small, int *added)
{
    pdmc_status status = PDMC_OK;
    const int n = b->n, room = CAPACITY - b->system->dimension;
    const double rounding = 1e-10; // of the largest eigenvalue: beyond it vectors are no longer orthogonal
    double gram[B * B], eigenvalue[B];
    PDMC_TRY(orthogonalise(b, passes));
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, B, B, n, 1.0, b->block, n, b->product, n, 0.0, gram, B);
    const int info = LAPACKE_dsyev(LAPACK_COL_MAJOR, 'V', 'L', B, gram, B, eigenvalue); // ascending
    if (info != 0) PDMC_FAIL(PDMC_ERR_EXTERN, "LAPACKE_dsyev returned %d", info);
    const double negligible = fmax(rounding * eigenvalue[B - 1], small * small);
    *added = 0;
    while (*added < B && *added < room && eigenvalue[B - 1 - *added] > negligible) ++*added;
    for (int k = 0; k < *added; k++) cblas_dscal(B, 1.0 / sqrt(eigenvalue[B - 1 - k]), &gram[(B - 1 - k) * B], 1);
    if (*added == 0) goto done;
    append(b, *added, &gram[(B - *added) * B]);
    project_mean(b, *added, &gram[(B - *added) * B]);
    PDMC_TRY(project(b, *added));
done:
    return status;
}

static void clear_block(const pdmc_reduced_builder *b)
{
    const size_t values = (size_t)B * (size_t)b->n;
    memset(b->block, 0, values * sizeof *b->block);
    memset(b->product, 0, values * sizeof *b->product);
}

// The answers at the mean: those of the loads are the model's own, those of the rows are found some at a time.
static pdmc_status begin_basis(pdmc_reduced_builder *b, int *added)
{
    pdmc_status status = PDMC_OK;
    const size_t n = (size_t)b->n;
    clear_block(b);
    memcpy(b->block, pdmc_affine_solution(b->full, 1), n * sizeof *b->block);
    memcpy(b->product, b->load, n * sizeof *b->product);
    PDMC_TRY(enrich(b, ANY, 0.0, added));
    for (int first = 1; first < b->system->sides; first += B) {
        const int left = b->system->sides - first, count = left < B ? left : B;
        clear_block(b);
        memcpy(b->product, &b->load[(size_t)first * n], (size_t)count * n * sizeof *b->product);
        PDMC_TRY(b->full->verbs->precondition(b->full, count, b->product, b->block));
        PDMC_TRY(enrich(b, ANY, 0.0, added));
    }
done:
    return status;
}

// The answers to what is added to the loads, but for what combines those that are there already.
static pdmc_status add_cases(pdmc_reduced_builder *b)
{
    pdmc_status status = PDMC_OK;
    const double combined = 1e-8; // of the answer to the given loads: what projections leave is smaller
    const double size = cblas_dnrm2(b->system->dimension, b->system->load, 1);
    const size_t n = (size_t)b->n;
    int added;
    for (int first = 2; first < b->full->cases; first += B) {
        const int left = b->full->cases - first, count = left < B ? left : B;
        const size_t values = (size_t)count * n;
        clear_block(b);
        memcpy(b->block, pdmc_affine_solution(b->full, first), values * sizeof *b->block);
        memcpy(b->product, &b->load[(size_t)(b->system->sides + first - 2) * n], values * sizeof *b->product);
        PDMC_TRY(enrich(b, ANY, combined * size, &added));
    }
done:
    return status;
}

// Errors whose products meet the goal, each the same share of its answer's size at the mean as nearly as tips allow: the
// basis holds the answers at the mean, so that these sizes are those of the coordinates of the loads.
static void share_out(const pdmc_reduced_goal *goal, pdmc_reduced_builder *b)
{
    const pdmc_reduced_system *system = b->system;
    const double size = cblas_dnrm2(system->dimension, system->load, 1);
    double square = INFINITY; // of the share
    b->allowed[0] = goal->error;
    if (!goal->intensity) return;
    for (int t = 0; t < b->full->tips; t++) {
        const double *row = &system->load[(size_t)(1 + 2 * t) * CAPACITY];
        const double rows =
            hypot(cblas_dnrm2(system->dimension, row, 1), cblas_dnrm2(system->dimension, row + CAPACITY, 1));
        square = fmin(square, goal->intensity[t] / (size * rows));
    }
    b->allowed[0] = size * sqrt(square);
    for (int k = 1; k < system->sides; k++) b->allowed[k] = goal->intensity[(k - 1) / 2] / (sqrt(2.0) * b->allowed[0]);
}

// V y of the training samples and right-hand sides that are chosen, and their coefficients.
static void expand_chosen(pdmc_reduced_builder *b, const double y[], const size_t chosen[B])
{
    const size_t n = (size_t)b->n, r = (size_t)b->system->dimension, sides = (size_t)b->system->sides;
    const size_t terms = (size_t)b->full->terms;
    for (size_t c = 0; c < B; c++) {
        memcpy(&b->overlap[c * CAPACITY], &y[chosen[c] * r], r * sizeof *y);
        memcpy(&b->xi[c * terms], &b->training[chosen[c] / sides * terms], terms * sizeof *b->xi);
    }
#pragma omp parallel for schedule(static) num_threads(b->threads)
    for (size_t first = 0; first < B; first += PART)
        cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, PART, (int)n, (int)r, 1.0, &b->overlap[first * CAPACITY],
                    CAPACITY, b->basis, (int)n, 0.0, &b->block[first * n], (int)n);
}

// No more vectors than that are independent among the residuals.
static int most_independent(const pdmc_reduced_builder *b)
{
    const int most = b->system->sides + b->system->added + b->system->terms * b->system->dimension;
    return most < B ? most : B;
}

// The block becomes the preconditioned residuals K_0^-1 (F - K(xi) V y), and its product the residuals, of those of the training samples and right-hand
// sides whose errors are the largest shares of what is allowed, as shares of it. Samples without a bound are left out.
static pdmc_status residuals(pdmc_reduced_builder *b, const double y[], const double error[])
{
    pdmc_status status = PDMC_OK;
    const int n = b->n, sides = b->system->sides, count = most_independent(b);
    double *share = NULL;
    size_t chosen[B];
    PDMC_NEW(share, PDMC_TRAINING * sides);
    for (int k = 0; k < PDMC_TRAINING * sides; k++)
        share[k] = isfinite(error[k]) ? error[k] / b->allowed[k % sides] : 0.0;
    gsl_sort_largest_index(chosen, B, share, 1, (size_t)(PDMC_TRAINING * sides));
    expand_chosen(b, y, chosen);
    PDMC_TRY(b->full->verbs->multiply(b->full, 1.0, b->xi, b->block, b->product));
    for (int c = 0; c < count; c++) {
        const int side = (int)chosen[c] % sides;
        const double *load = &b->load[(size_t)side * (size_t)n];
        const double scale = share[chosen[c]] > 0.0 ? 1.0 / b->allowed[side] : 0.0;
        double *row = &b->product[(size_t)c * (size_t)n];
        for (int k = 0; k < n; k++) row[k] = scale * (load[k] - row[k]);
        const double *shares = &b->training_share[chosen[c] / (size_t)sides * (size_t)b->system->added];
        for (int l = 0; l < b->system->added && side == 0; l++)
            cblas_daxpy(n, scale * shares[l], &b->load[(size_t)(sides + l) * (size_t)n], 1, row, 1);
    }
    const size_t solved = (size_t)count * (size_t)n, others = (size_t)(B - count) * (size_t)n;
    memset(&b->block[solved], 0, others * sizeof *b->block);
    memset(&b->product[solved], 0, others * sizeof *b->product);
    PDMC_TRY(b->full->verbs->precondition(b->full, count, b->product, b->block));
done:
    pdmc_free(share);
    return status;
}

// Draws and solves a block of training samples.
static pdmc_status train_block(const pdmc_reduced_builder *b, uint64_t first, double xi[], double share[], double y[],
                               double error[])
{
    pdmc_status status = PDMC_OK;
    pdmc_draws drawn = {0};
    double alpha[B];
    PDMC_TRY(pdmc_draws_create(b->variables, &drawn));
    for (int s = 0; s < B; s++)
        pdmc_variables_sample(b->variables, first + (uint64_t)s, &drawn.z[s * b->variables->count]);
    PDMC_TRY(pdmc_variables_draw(b->variables, B, drawn.z, drawn.draw));
    memcpy(xi, drawn.xi, (size_t)(B * b->full->terms) * sizeof *xi);
    for (int s = 0; s < B; s++)
        for (int l = 0; l < b->system->added; l++) share[s * b->system->added + l] = drawn.draw[s].load_pattern[2 + l];
    PDMC_TRY(pdmc_reduced_system_solve(b->system, xi, share, y, error, alpha));
done:
    pdmc_draws_clear(&drawn);
    return status;
}

// Solves training samples, others in every round: those of the last one are in the basis, and say nothing of others. Tells
// the largest share of the goal, of those that have bounds.
static pdmc_status train(pdmc_reduced_builder *b, int round, double y[], double error[], double *worst)
{
    pdmc_status status = PDMC_OK;
    const size_t sides = (size_t)b->system->sides, r = (size_t)b->system->dimension, terms = (size_t)b->full->terms;
    const size_t added = (size_t)b->system->added;
#pragma omp parallel for schedule(dynamic) num_threads(b->threads)
    for (size_t s = 0; s < PDMC_TRAINING; s += B) {
        const uint64_t first = training_samples + (uint64_t)round * PDMC_TRAINING + s;
        const pdmc_status mine = train_block(b, first, &b->training[s * terms], &b->training_share[s * added],
                                             &y[s * sides * r], &error[s * sides]);
        if (mine != PDMC_OK) {
#pragma omp critical(pdmc_reduced)
            status = mine;
        }
    }
    *worst = 0.0;
    for (size_t s = 0; s < PDMC_TRAINING && status == PDMC_OK; s++)
        if (isfinite(error[s * sides])) *worst = fmax(*worst, pdmc_reduced_share(b->system, &error[s * sides]));
    return status;
}

pdmc_status pdmc_reduced_build(const pdmc_reduced_goal *goal, pdmc_reduced_builder *b)
{
    pdmc_status status = PDMC_OK;
    double *y = NULL, *error = NULL, worst = INFINITY;
    int added = 0;
    PDMC_NEW(y, (size_t)(PDMC_TRAINING * b->system->sides) * CAPACITY);
    PDMC_NEW(error, PDMC_TRAINING * b->system->sides);
    PDMC_TRY(make_probes(b));
    PDMC_TRY(make_loads(b));
    PDMC_TRY(begin_basis(b, &added));
    PDMC_TRY(add_cases(b));
    share_out(goal, b);
    for (int round = 0;; round++) {
        PDMC_TRY(train(b, round, y, error, &worst));
        if (worst <= margin || added == 0 || round == MOST_ROUNDS) break;
        PDMC_TRY(residuals(b, y, error));
        PDMC_TRY(enrich(b, ORTHOGONAL, share_left_out, &added));
    }
    PDMC_TRY(pdmc_reduced_order(b, y));
done:
    pdmc_free(y);
    pdmc_free(error);
    return status;
}
