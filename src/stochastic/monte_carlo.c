// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/stochastic.h"

#include "base/base_impl.h"
#include "stochastic/block.h"
#include "stochastic/certify.h"
#include "stochastic/rare_event.h"
#include "stochastic/reduced.h"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

// Shared by the threads of a run.
typedef struct {
    const pdmc_problem *problem;
    const pdmc_variables *variables;
    const pdmc_affine *model; // that the samples are solved by
    const pdmc_run_options *options;
    pdmc_results *results;
    int blocks, done;
    double *residual;             // [samples] of the iteration
    double *delta[PDMC_MEASURES]; // [samples] what an energy's root may be off by in the reduced model
    bool *finished;               // [blocks]
    bool stop;
    pdmc_status status;
    char message[512]; // of the thread that failed
} run;

static int block_size(const run *r, int block)
{
    const int left = r->results->sample_count - block * PDMC_BLOCK;
    return left < PDMC_BLOCK ? left : PDMC_BLOCK;
}

static void note_accuracy(const run *r, const pdmc_block *block, int count)
{
    for (int s = 0; s < count; s++) {
        const int sample = block->sample[s];
        r->residual[sample] = block->residual[s];
        for (int m = 0; m < PDMC_MEASURES && !isnan(block->error[s]); m++)
            r->delta[m][sample] = pdmc_certify_root_energy(r->problem, r->model, r->results, &block->drawn.draw[s],
                                                           (pdmc_measure)m, block->error[s]);
    }
}

static pdmc_status solve_block(const run *r, pdmc_block *block, int index)
{
    const int first = index * PDMC_BLOCK, count = block_size(r, index);
    pdmc_status status = pdmc_block_draw(block, first, count);
    if (status == PDMC_OK) status = pdmc_block_solve(block, count);
    if (status != PDMC_OK) return status;
    pdmc_block_energies(block, r->problem->energy.bonds);
    pdmc_block_store(block, count, r->results);
    note_accuracy(r, block, count);
    return PDMC_OK;
}

static void report_block(run *r, int index)
{
    r->finished[index] = true;
    r->done += block_size(r, index);
    if (r->options->progress && !r->options->progress(r->options->context, r->done, r->results->sample_count))
        r->stop = true;
}

static pdmc_status first_block(run *r, pdmc_block *block)
{
    pdmc_status status = pdmc_block_nominal(block, r->results);
    if (status == PDMC_OK) status = solve_block(r, block, 0);
    if (status == PDMC_OK) report_block(r, 0);
    return status;
}

static void work(run *r)
{
    pdmc_block *block = NULL;
    pdmc_status mine = pdmc_block_create(r->variables, r->model, &block);
#pragma omp single
    {
        if (mine == PDMC_OK) mine = first_block(r, block);
        if (mine != PDMC_OK) r->stop = true;
    }
#pragma omp for schedule(dynamic)
    for (int b = 1; b < r->blocks; b++) {
        bool stop;
#pragma omp atomic read
        stop = r->stop;
        if (stop || mine != PDMC_OK) continue;
        mine = solve_block(r, block, b);
#pragma omp critical(pdmc_report)
        if (mine == PDMC_OK) report_block(r, b);
    }
#pragma omp critical(pdmc_report)
    {
        if (mine != PDMC_OK) {
            r->status = mine;
            snprintf(r->message, sizeof r->message, "%s", pdmc_last_error());
        }
        if (block) {
            r->results->runtime.sampling += block->solve_seconds / r->options->threads;
            r->results->runtime.energy += block->energy_seconds / r->options->threads;
        }
    }
    pdmc_block_destroy(&block);
}

static pdmc_status allocate_samples(const pdmc_problem *problem, pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    const size_t samples = (size_t)problem->sampling.samples;
    const size_t directions = (size_t)(results->tip_count * results->angle_count);
    results->sample_count = problem->sampling.samples;
    PDMC_NEW(results->load_factor, samples);
    PDMC_NEW(results->micromodulus, samples * (size_t)results->bin_count);
    PDMC_NEW(results->effective_modulus, samples);
    PDMC_NEW(results->contraction, samples);
    PDMC_NEW(results->failure, samples);
    PDMC_NEW(results->sample_solver, samples);
    PDMC_NEW(results->sample_fracture_energy, samples);
    PDMC_NEW(results->growth_given_rest, samples * (size_t)results->tip_count);
    PDMC_NEW(results->stress_intensity, samples * 2 * (size_t)results->tip_count);
    for (int m = 0; m < PDMC_MEASURES; m++) PDMC_NEW(results->energy[m], samples * directions);
    PDMC_NEW(results->nominal_bond_energy, directions);
    PDMC_NEW(results->nominal_bond_energy_tensile, directions);
    PDMC_NEW(results->nominal_griffith_energy, directions);
done:
    return status;
}

// The samples before the first block that is missing; the arrays keep their size.
static void cut_to_finished(const run *r)
{
    int blocks = 0;
    while (blocks < r->blocks && r->finished[blocks]) blocks++;
    if (blocks == r->blocks) return;
    r->results->sample_count = blocks * PDMC_BLOCK;
    r->results->status = PDMC_RUN_INTERRUPTED;
}

// Solves the listed samples by conjugate gradients on the full model, a block after the other.
static pdmc_status solve_in_full(const run *r, const pdmc_affine *full, int count, const int sample[])
{
    pdmc_status status = PDMC_OK;
    pdmc_block *block = NULL;
    PDMC_TRY(pdmc_block_create(r->variables, full, &block));
    for (int first = 0; first < count; first += PDMC_BLOCK) {
        const int size = count - first < PDMC_BLOCK ? count - first : PDMC_BLOCK;
        PDMC_TRY(pdmc_block_draw_samples(block, &sample[first], size));
        PDMC_TRY(pdmc_block_solve_by(block, PDMC_INVERSE_KRYLOV, size));
        for (int s = 0; s < size; s++) block->solver[s] = PDMC_SOLVED_BY_KRYLOV;
        pdmc_block_energies(block, r->problem->energy.bonds);
        pdmc_block_store(block, size, r->results);
        note_accuracy(r, block, size);
        for (int s = 0; s < size; s++)
            for (int m = 0; m < PDMC_MEASURES; m++) r->delta[m][sample[first + s]] = 0.0;
    }
    r->results->runtime.sampling += block->solve_seconds;
    r->results->runtime.energy += block->energy_seconds;
done:
    pdmc_block_destroy(&block);
    return status;
}

// The reduced model is not asked for what its bound cannot answer.
static pdmc_status settle_doubts(const run *r, const pdmc_affine *full)
{
    pdmc_status status = PDMC_OK;
    const double *delta = r->delta[r->results->measure];
    int count = 0, *sample = NULL;
    PDMC_NEW(sample, r->results->sample_count);
    for (int s = 0; s < r->results->sample_count; s++)
        if (pdmc_certify_is_in_doubt(r->results, s, delta[s])) sample[count++] = s;
    PDMC_TRY(solve_in_full(r, full, count, sample));
    r->results->accuracy.solved_in_full = count;
done:
    pdmc_free(sample);
    return status;
}

static pdmc_status summarise_accuracy(const run *r)
{
    pdmc_status status = PDMC_OK;
    pdmc_sample_accuracy *accuracy = &r->results->accuracy;
    const int samples = r->results->sample_count;
    double *relative = NULL;
    PDMC_NEW(relative, samples);
    for (int s = 0; s < samples; s++) accuracy->iteration_residual = fmax(accuracy->iteration_residual, r->residual[s]);
    for (int m = 0; m < PDMC_MEASURES && r->delta[m]; m++) {
        int count = 0;
        for (int s = 0; s < samples; s++)
            if (r->results->failure[s] == PDMC_SAMPLE_OK)
                relative[count++] = pdmc_certify_relative(r->results, (pdmc_measure)m, s, r->delta[m][s]);
        if (count == 0) continue;
        gsl_sort(relative, 1, (size_t)count);
        accuracy->energy_error[m] = relative[count - 1];
        accuracy->typical_error[m] = gsl_stats_median_from_sorted_data(relative, 1, (size_t)count);
    }
done:
    pdmc_free(relative);
    return status;
}

// Draws and solves all samples by one model.
static pdmc_status run_all(run *r)
{
    pdmc_status status = PDMC_OK;
    PDMC_NEW(r->residual, r->results->sample_count);
    for (int m = 0; m < PDMC_MEASURES && r->problem->sampling.inverse == PDMC_INVERSE_REDUCED; m++)
        PDMC_NEW(r->delta[m], r->results->sample_count);
    r->blocks = (r->results->sample_count + PDMC_BLOCK - 1) / PDMC_BLOCK;
    PDMC_NEW(r->finished, r->blocks);
#pragma omp parallel num_threads(pdmc_block_threads(r->model, r->options->threads))
    work(r);
    if (r->status != PDMC_OK) PDMC_FAIL(r->status, "%s", r->message);
    cut_to_finished(r);
done:
    return status;
}

// The tolerance of |e| that gives the largest energies at the mean the relative error that is asked for.
static double reduced_tolerance(const pdmc_problem *problem, const pdmc_affine *full, const pdmc_results *results)
{
    const double margin = 0.5; // the worst of thousands is worse than that of a block
    const int angles = results->angle_count;
    double least = INFINITY;
    for (int t = 0; t < results->tip_count; t++) {
        double largest = 0.0;
        for (int a = 0; a < angles; a++) largest = fmax(largest, results->nominal_bond_energy[t * angles + a]);
        least = fmin(least, largest);
    }
    return margin * 0.5 * problem->sampling.energy_tolerance * sqrt(least) / full->crossing_bound;
}

static pdmc_status make_reduced(const pdmc_variables *variables, int threads, pdmc_results *results,
                                pdmc_affine *reduced)
{
    const pdmc_affine *full = variables->model;
    pdmc_status status = PDMC_OK;
    pdmc_block *block = NULL;
    const double begin = pdmc_seconds();
    PDMC_TRY(pdmc_block_create(variables, full, &block));
    PDMC_TRY(pdmc_block_nominal(block, results));
    pdmc_block_destroy(&block);
    PDMC_TRY(pdmc_reduced_create(variables, reduced_tolerance(variables->problem, full, results), threads, reduced));
    results->accuracy.reduced_unknowns = reduced->unknowns;
    results->runtime.operators += pdmc_seconds() - begin;
done:
    pdmc_block_destroy(&block);
    return status;
}

pdmc_status pdmc_monte_carlo(const pdmc_problem *problem, const pdmc_affine *model, const pdmc_run_options *options,
                             pdmc_results *results)
{
    PDMC_REQUIRE(options->threads >= 1, "%d threads: at least one is needed", options->threads);
    PDMC_REQUIRE(problem->sampling.samples >= 1, "%d samples: at least one is needed", problem->sampling.samples);
    pdmc_status status = PDMC_OK;
    const bool is_reduced = problem->sampling.inverse == PDMC_INVERSE_REDUCED;
    pdmc_affine reduced = {0};
    pdmc_variables variables = {0};
    run r = {.problem = problem,
             .variables = &variables,
             .model = is_reduced ? &reduced : model,
             .options = options,
             .results = results};
    results->accuracy = pdmc_no_accuracy;
    pdmc_blas_prepare();
    PDMC_TRY(pdmc_variables_create(problem, model, &variables));
    PDMC_TRY(allocate_samples(problem, results));
    if (is_reduced) PDMC_TRY(make_reduced(&variables, options->threads, results, &reduced));
    PDMC_TRY(run_all(&r));
    if (is_reduced) PDMC_TRY(settle_doubts(&r, model));
    PDMC_TRY(summarise_accuracy(&r));
    if (results->status == PDMC_RUN_COMPLETE) PDMC_TRY(pdmc_rare_event(&variables, r.model, model, options, results));
    for (int s = 0; s < results->sample_count; s++) results->failed_count += results->failure[s] != PDMC_SAMPLE_OK;
done:
    pdmc_affine_clear(&reduced);
    pdmc_variables_clear(&variables);
    pdmc_free(r.finished);
    pdmc_free(r.residual);
    for (int m = 0; m < PDMC_MEASURES; m++) pdmc_free(r.delta[m]);
    return status;
}
