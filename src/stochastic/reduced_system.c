// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/reduced_impl.h"

#include <cblas.h>
#include <gsl/gsl_cdf.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

// The operators of a panel of samples are made at once: enough to read the terms seldom, few enough for little memory.
enum { B = PDMC_BLOCK, CAPACITY = PDMC_REDUCED_CAPACITY, PROBES = PDMC_PROBES, PANEL = 16 };

static const double failure_probability = 1e-9; // of the bound of one sample

pdmc_status pdmc_reduced_system_create(const pdmc_affine *full, const pdmc_reduced_goal *goal,
                                       pdmc_reduced_system **system)
{
    pdmc_status status = PDMC_OK;
    const int sides = goal->intensity ? 1 + 2 * full->tips : 1;
    const size_t operators = 1 + (size_t)full->terms;
    pdmc_reduced_system *made = NULL;
    PDMC_NEW(made, 1);
    made->full = full;
    made->terms = full->terms;
    made->sides = sides;
    made->added = full->cases - 2;
    made->goal = goal->error;
    made->quantile = gsl_cdf_chisq_Pinv(failure_probability, PROBES);
    if (goal->intensity) {
        PDMC_NEW(made->intensity, full->tips);
        memcpy(made->intensity, goal->intensity, (size_t)full->tips * sizeof *made->intensity);
    }
    PDMC_NEW(made->matrix, operators * PDMC_REDUCED_TRIANGLE);
    PDMC_NEW(made->load, (size_t)(sides + made->added) * CAPACITY);
    PDMC_NEW(made->probe_matrix, operators * CAPACITY * PROBES);
    PDMC_NEW(made->probe_load, (size_t)(sides + made->added) * PROBES);
    for (size_t j = 0; j < CAPACITY; j++) made->matrix[pdmc_triangle_column(j) + j] = 1.0;
    *system = made;
    made = NULL;
done:
    pdmc_reduced_system_destroy(made);
    return status;
}

void pdmc_reduced_system_destroy(void *system)
{
    pdmc_reduced_system *old = system;
    if (!old) return;
    pdmc_free(old->intensity);
    pdmc_free(old->matrix);
    pdmc_free(old->load);
    pdmc_free(old->probe_matrix);
    pdmc_free(old->probe_load);
    pdmc_free(old);
}

double pdmc_reduced_share(const pdmc_reduced_system *system, const double error[])
{
    double largest = 0.0;
    if (!system->intensity) return error[0] / system->goal;
    for (int t = 0; t < system->full->tips; t++)
        largest = fmax(largest, error[0] * hypot(error[1 + 2 * t], error[2 + 2 * t]) / system->intensity[t]);
    return largest;
}

// What a panel is solved with, by the first d vectors.
typedef struct {
    double *coefficient; // [PANEL, 1 + terms] 1 and xi
    double *triangle;    // [PANEL, d (d + 1) / 2] A = V' K(xi) V
    double *factor;      // [d, d] of one sample
    double *answer;      // [PANEL, sides, d]
    double *residual;    // [PANEL, sides, PROBES]
    double *part;        // [PANEL, sides, PROBES] of the residuals, of one term
} workspace;

static pdmc_status workspace_create(const pdmc_reduced_system *system, workspace *work)
{
    pdmc_status status = PDMC_OK;
    const size_t r = (size_t)system->dimension;
    *work = (workspace){0};
    PDMC_NEW(work->coefficient, PANEL * (1 + system->terms));
    PDMC_NEW(work->triangle, PANEL * pdmc_triangle_column(r));
    PDMC_NEW(work->factor, r * r);
    PDMC_NEW(work->answer, (size_t)(PANEL * system->sides) * r);
    PDMC_NEW(work->residual, PANEL * system->sides * PROBES);
    PDMC_NEW(work->part, PANEL * system->sides * PROBES);
done:
    return status;
}

static void workspace_clear(workspace *work)
{
    pdmc_free(work->coefficient);
    pdmc_free(work->triangle);
    pdmc_free(work->factor);
    pdmc_free(work->answer);
    pdmc_free(work->residual);
    pdmc_free(work->part);
}

// The operators of a panel: sums over the terms, for all entries at once. A panel that is not full has the mean's as well.
static void assemble(const pdmc_reduced_system *system, int d, int count, const int sample[], const double xi[],
                     workspace *work)
{
    const int terms = system->terms, operators = 1 + terms;
    const int entries = (int)pdmc_triangle_column((size_t)d);
    memset(work->coefficient, 0, (size_t)(PANEL * operators) * sizeof *work->coefficient);
    for (int p = 0; p < PANEL; p++) work->coefficient[p * operators] = 1.0;
    for (int p = 0; p < count; p++)
        memcpy(&work->coefficient[p * operators + 1], &xi[sample[p] * terms], (size_t)terms * sizeof *xi);
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, PANEL, entries, operators, 1.0, work->coefficient, operators,
                system->matrix, PDMC_REDUCED_TRIANGLE, 0.0, work->triangle, entries);
}

// A^-1 f for all right-hand sides. False where A is not positive definite. From the last vector to the first, so that the
// columns of the triangle are those of a lower one, whose factorisation takes two thirds of the time of an upper one's.
static bool solve_one(const pdmc_reduced_system *system, int d, const double triangle[], const double share[],
                      const workspace *work, double answer[])
{
    for (int j = 0; j < d; j++) {
        double *last = &work->factor[(size_t)(d - 1 - j) * (size_t)d + (size_t)(d - 1)];
        for (int i = 0; i <= j; i++) last[-i] = triangle[pdmc_triangle_column((size_t)j) + (size_t)i];
    }
    for (int k = 0; k < system->sides; k++)
        memcpy(&answer[k * d], &system->load[k * CAPACITY], (size_t)d * sizeof *answer);
    for (int l = 0; l < system->added && share; l++)
        cblas_daxpy(d, share[l], &system->load[(system->sides + l) * CAPACITY], 1, answer, 1);
    if (LAPACKE_dpotrf_work(LAPACK_COL_MAJOR, 'L', d, work->factor, d) != 0) return false;
    for (int k = 0; k < system->sides; k++) {
        cblas_dtrsv(CblasColMajor, CblasLower, CblasNoTrans, CblasNonUnit, d, work->factor, d, &answer[k * d], -1);
        cblas_dtrsv(CblasColMajor, CblasLower, CblasTrans, CblasNonUnit, d, work->factor, d, &answer[k * d], -1);
    }
    return true;
}

// z' K(xi) V y - z' F of a panel, term by term.
static void probe_residuals(const pdmc_reduced_system *system, int d, int count, const int sample[],
                            const double share[], workspace *work)
{
    const int sides = system->sides, operators = 1 + system->terms, values = sides * PROBES;
    for (int p = 0; p < PANEL; p++) {
        double *residual = &work->residual[p * values];
        for (int i = 0; i < values; i++) residual[i] = -system->probe_load[i];
        for (int l = 0; l < system->added && share && p < count; l++)
            cblas_daxpy(PROBES, -share[sample[p] * system->added + l], &system->probe_load[(sides + l) * PROBES], 1,
                        residual, 1);
    }
    for (int m = 0; m < operators; m++) {
        cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, PANEL * sides, PROBES, d, 1.0, work->answer, d,
                    &system->probe_matrix[(size_t)m * CAPACITY * PROBES], PROBES, 0.0, work->part, PROBES);
        for (int p = 0; p < PANEL; p++)
            cblas_daxpy(values, work->coefficient[p * operators + m], &work->part[p * values], 1,
                        &work->residual[p * values], 1);
    }
}

static void store_answer(const pdmc_reduced_system *system, int d, const double answer[], double y[])
{
    const size_t r = (size_t)system->dimension;
    memset(y, 0, (size_t)system->sides * r * sizeof *y);
    for (size_t k = 0; k < (size_t)system->sides; k++) memcpy(&y[k * r], &answer[k * (size_t)d], (size_t)d * sizeof *y);
}

// Samples of a block by the first d vectors, at most a panel of them.
static void solve_panel(const pdmc_reduced_system *system, int d, int count, const int sample[], const double xi[],
                        const double share[], const double alpha[], workspace *work, double y[], double error[])
{
    const int sides = system->sides;
    bool is_solved[PANEL];
    assemble(system, d, count, sample, xi, work);
    for (int p = 0; p < count; p++)
        is_solved[p] = solve_one(system, d, &work->triangle[(size_t)p * pdmc_triangle_column((size_t)d)],
                                 share ? &share[sample[p] * system->added] : NULL, work, &work->answer[p * sides * d]);
    probe_residuals(system, d, count, sample, share, work);
    for (int p = 0; p < count; p++) {
        const bool is_bounded = is_solved[p] && alpha[sample[p]] > 0.0;
        for (int k = 0; k < sides; k++) {
            const double norm = cblas_dnrm2(PROBES, &work->residual[(p * sides + k) * PROBES], 1);
            error[sample[p] * sides + k] = is_bounded ? norm / sqrt(system->quantile * alpha[sample[p]]) : INFINITY;
        }
        store_answer(system, d, &work->answer[p * sides * d],
                     &y[(size_t)(sample[p] * sides) * (size_t)system->dimension]);
    }
}

static pdmc_status find_coercivity(const pdmc_reduced_system *system, const double xi[], double alpha[B])
{
    const pdmc_affine *full = system->full;
    if (full->verbs->coercivity) return full->verbs->coercivity(full, xi, alpha);
    for (int s = 0; s < B; s++) {
        double least = 0.0;
        for (int m = 0; m < full->terms; m++) least = fmin(least, xi[s * full->terms + m]);
        alpha[s] = 1.0 + least;
    }
    return PDMC_OK;
}

// Keeps those whose bounds do not meet the goal; more vectors are of no help to samples without a bound.
static int keep_unmet(const pdmc_reduced_system *system, const double error[], int count, int sample[])
{
    int kept = 0;
    for (int k = 0; k < count; k++) {
        const double *mine = &error[sample[k] * system->sides];
        if (isfinite(mine[0]) && pdmc_reduced_share(system, mine) > 1.0) sample[kept++] = sample[k];
    }
    return kept;
}

pdmc_status pdmc_reduced_system_solve(const pdmc_reduced_system *system, const double xi[], const double share[],
                                      double y[], double error[], double alpha[B])
{
    pdmc_status status = PDMC_OK;
    const int r = system->dimension, eighth = (r + 7) / 8;
    int sample[B], left = B;
    workspace work;
    PDMC_TRY(workspace_create(system, &work));
    PDMC_TRY(find_coercivity(system, xi, alpha));
    for (int s = 0; s < B; s++) sample[s] = s;
    for (int part = system->is_ordered ? 3 : 8; part <= 8 && left > 0; part++) {
        const int d = part * eighth < r ? part * eighth : r;
        for (int first = 0; first < left; first += PANEL)
            solve_panel(system, d, left - first < PANEL ? left - first : PANEL, &sample[first], xi, share, alpha, &work,
                        y, error);
        left = keep_unmet(system, error, left, sample);
    }
done:
    workspace_clear(&work);
    return status;
}
