// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/stochastic.h"

#include "base/base_impl.h"
#include "stochastic/block.h"
#include "stochastic/certify.h"
#include "stochastic/counts.h"
#include "stochastic/model_error.h"
#include "stochastic/rare_event.h"
#include "stochastic/reduced.h"
#include "stochastic/stop_rule.h"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics.h>
#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <string.h>

// Shared by the threads of a run.
typedef struct {
    pdmc_problem *problem; // its samples are those of the round
    const pdmc_variables *variables;
    const pdmc_affine *model, *full; // that the samples are solved by, and what it stands for
    const pdmc_run_options *options;
    pdmc_results *results;
    int workers;                  // threads that blocks are shared out to
    pdmc_block **block;           // [workers]
    pdmc_energy_forms *forms;     // of the model, or NULL
    pdmc_sample_counts **counts;  // [workers], or NULL where all samples are kept
    int most, most_kept;          // samples of the last round, at most, and those of them that are kept
    int blocks, given, done;      // blocks of the round, blocks given out, samples done
    int settled, solved_in_full;  // samples whose doubts are settled, and how many had one
    int together;                 // blocks that are given out at once
    double *residual;             // [samples] of the iteration
    double *delta[PDMC_MEASURES]; // [samples] what an energy's root may be off by in the reduced model
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
    double delta[PDMC_BLOCK];
    for (int s = 0; s < count; s++) r->residual[block->sample[s]] = block->residual[s];
    for (int m = 0; m < PDMC_MEASURES && block->model != r->full; m++) {
        pdmc_certify_root_energies(block, count, r->results, (pdmc_measure)m, delta);
        for (int s = 0; s < count; s++) r->delta[m][block->sample[s]] = delta[s];
    }
}

// The reduced model is not asked for what its bound cannot answer: those samples are solved and counted later.
static bool is_settled(const run *r, int sample)
{
    const double *delta = r->delta[r->results->measure];
    return !delta || !pdmc_certify_is_in_doubt(r->results, sample, delta[sample]);
}

static pdmc_status solve_block(const run *r, int worker, int index)
{
    pdmc_block *block = r->block[worker];
    const int first = index * PDMC_BLOCK, count = block_size(r, index);
    bool settled[PDMC_BLOCK];
    pdmc_status status = pdmc_block_draw(block, first, count);
    if (status == PDMC_OK) status = pdmc_block_solve(block, count);
    if (status != PDMC_OK) return status;
    pdmc_block_energies(block, r->problem->energy.bonds);
    pdmc_block_griffith(block, r->results);
    pdmc_block_store(block, count, r->results);
    note_accuracy(r, block, count);
    for (int s = 0; s < count; s++) settled[s] = is_settled(r, first + s);
    if (r->counts) pdmc_sample_counts_add(r->counts[worker], block, count, settled);
    return PDMC_OK;
}

static void report_block(run *r, int index)
{
    r->done += block_size(r, index);
    if (r->options->progress && !r->options->progress(r->options->context, r->done, r->results->sample_count))
        r->stop = true;
}

// The next blocks, of which all are solved that are given out: what is done is always a beginning.
static bool take_blocks(run *r, int *first, int *end)
{
    bool found = false;
#pragma omp critical(pdmc_report)
    if (!r->stop && r->given < r->blocks) {
        *first = r->given;
        *end = r->given + r->together < r->blocks ? r->given + r->together : r->blocks;
        r->given = *end;
        found = true;
    }
    return found;
}

static pdmc_status solve_blocks(run *r, int worker, int first, int end)
{
    for (int b = first; b < end; b++) {
        const pdmc_status status = solve_block(r, worker, b);
        if (status != PDMC_OK) return status;
#pragma omp critical(pdmc_report)
        report_block(r, b);
    }
    return r->counts ? pdmc_sample_counts_flush(r->counts[worker]) : PDMC_OK;
}

static void work(run *r, int worker)
{
    pdmc_status mine = PDMC_OK;
    int first, end;
    while (mine == PDMC_OK && take_blocks(r, &first, &end)) mine = solve_blocks(r, worker, first, end);
    if (mine == PDMC_OK) return;
#pragma omp critical(pdmc_report)
    {
        r->stop = true;
        r->status = mine;
        snprintf(r->message, sizeof r->message, "%s", pdmc_last_error());
    }
}

// Room for the last round; pages that no sample is written to take no memory.
static pdmc_status allocate_samples(const pdmc_problem *problem, pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    const size_t samples = (size_t)problem->sampling.samples, kept = (size_t)pdmc_problem_kept(problem);
    const size_t tips = (size_t)results->tip_count, directions = tips * (size_t)results->angle_count;
    PDMC_NEW(results->load_factor, samples);
    PDMC_NEW(results->micromodulus, kept * (size_t)results->bin_count);
    PDMC_NEW(results->effective_modulus, samples);
    PDMC_NEW(results->contraction, samples);
    PDMC_NEW(results->failure, samples);
    PDMC_NEW(results->sample_solver, samples);
    PDMC_NEW(results->sample_fracture_energy, samples * tips);
    PDMC_NEW(results->growth_given_rest, samples * tips);
    PDMC_NEW(results->stress_intensity, samples * 2 * tips);
    for (int m = 0; m < PDMC_MEASURES; m++) {
        PDMC_NEW(results->largest_energy[m], samples * tips);
        PDMC_NEW(results->energy[m], kept * directions);
    }
    PDMC_NEW(results->nominal_bond_energy, directions);
    PDMC_NEW(results->nominal_bond_energy_tensile, directions);
    PDMC_NEW(results->nominal_griffith_energy, directions);
done:
    return status;
}

// The arrays keep their size.
static void cut_to_done(const run *r)
{
    pdmc_results *results = r->results;
    if (r->done == results->sample_count) return;
    results->sample_count = r->done;
    if (results->kept_count > r->done) results->kept_count = r->done;
    results->status = PDMC_RUN_INTERRUPTED;
}

// One by one: a tally's bits depend on which samples it takes together, and in rounds there are fewer doubts at a time.
static pdmc_status count_each(const run *r, const pdmc_block *block, int count)
{
    pdmc_status status = PDMC_OK;
    for (int s = 0; s < count && r->counts && status == PDMC_OK; s++) {
        bool only[PDMC_BLOCK] = {false};
        only[s] = true;
        pdmc_sample_counts_add(r->counts[0], block, count, only);
        status = pdmc_sample_counts_flush(r->counts[0]);
    }
    return status;
}

// Solves the listed samples by conjugate gradients on the full model, a block after the other.
static pdmc_status solve_in_full(const run *r, int count, const int sample[])
{
    pdmc_status status = PDMC_OK;
    pdmc_block *block = NULL;
    PDMC_TRY(pdmc_block_create(r->variables, r->full, &block));
    for (int first = 0; first < count; first += PDMC_BLOCK) {
        const int size = count - first < PDMC_BLOCK ? count - first : PDMC_BLOCK;
        PDMC_TRY(pdmc_block_draw_samples(block, &sample[first], size));
        PDMC_TRY(pdmc_block_solve_by(block, PDMC_INVERSE_KRYLOV, size));
        for (int s = 0; s < size; s++) block->solver[s] = PDMC_SOLVED_BY_KRYLOV;
        pdmc_block_energies(block, r->problem->energy.bonds);
        pdmc_block_griffith(block, r->results);
        pdmc_block_store(block, size, r->results);
        note_accuracy(r, block, size);
        PDMC_TRY(count_each(r, block, size));
        for (int s = 0; s < size; s++)
            for (int m = 0; m < PDMC_MEASURES; m++) r->delta[m][sample[first + s]] = 0.0;
    }
    r->results->runtime.sampling += block->solve_seconds;
    r->results->runtime.energy += block->energy_seconds;
done:
    pdmc_block_destroy(&block);
    return status;
}

static pdmc_status settle_doubts(run *r)
{
    pdmc_status status = PDMC_OK;
    int count = 0, *sample = NULL;
    PDMC_NEW(sample, r->results->sample_count);
    for (int s = r->settled; s < r->results->sample_count; s++)
        if (!is_settled(r, s)) sample[count++] = s;
    PDMC_TRY(solve_in_full(r, count, sample));
    r->settled = r->results->sample_count;
    r->solved_in_full += count;
    r->results->accuracy.solved_in_full = r->solved_in_full;
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
        pdmc_model_error(r->results, (pdmc_measure)m, r->delta[m], relative, &accuracy->mean_error[m],
                         accuracy->quantile_error[m]);
    }
done:
    pdmc_free(relative);
    return status;
}

// Where a stop need not wait long for them, as many as a tally likes.
static int blocks_together(const run *r)
{
    const bool is_quick = r->problem->sampling.inverse == PDMC_INVERSE_NEUMANN && !r->model->family;
    return r->counts && is_quick ? PDMC_COUNTED_BLOCKS : 1;
}

// The nominal energies, and what each worker has; counts, where the last round may have more samples than are kept.
static pdmc_status employ(run *r)
{
    pdmc_status status = PDMC_OK;
    PDMC_NEW(r->block, r->workers);
    PDMC_TRY(pdmc_block_create(r->variables, r->model, &r->block[0]));
    PDMC_TRY(pdmc_block_make_forms(r->block[0], &r->forms));
    for (int w = 1; w < r->workers; w++) PDMC_TRY(pdmc_block_create(r->variables, r->model, &r->block[w]));
    for (int w = 0; w < r->workers; w++) PDMC_TRY(pdmc_block_use_forms(r->block[w], r->forms));
    PDMC_TRY(pdmc_block_nominal(r->block[0], r->results));
    if (r->most_kept == r->most) goto done;
    PDMC_NEW(r->counts, r->workers);
    for (int w = 0; w < r->workers; w++) PDMC_TRY(pdmc_sample_counts_create(r->results, &r->counts[w]));
done:
    return status;
}

static void dismiss(run *r)
{
    for (int w = 0; w < r->workers; w++) {
        if (r->block) pdmc_block_destroy(&r->block[w]);
        if (r->counts) pdmc_sample_counts_destroy(&r->counts[w]);
    }
    pdmc_energy_forms_destroy(&r->forms);
    pdmc_free(r->block);
    pdmc_free(r->counts);
    pdmc_free(r->residual);
    for (int m = 0; m < PDMC_MEASURES; m++) pdmc_free(r->delta[m]);
}

// Into those of the first worker; the others begin anew.
static pdmc_status merge_counts(const run *r)
{
    pdmc_status status = PDMC_OK;
    for (int w = 1; w < r->workers && r->counts; w++) {
        PDMC_TRY(pdmc_sample_counts_merge(r->counts[0], r->counts[w]));
        pdmc_sample_counts_destroy(&r->counts[w]);
        PDMC_TRY(pdmc_sample_counts_create(r->results, &r->counts[w]));
    }
done:
    return status;
}

// Where all samples are kept in the end, their statistics are those of a study that never counted.
static const pdmc_sample_counts *needed_counts(const run *r)
{
    return r->counts && r->results->kept_count < r->results->sample_count ? r->counts[0] : NULL;
}

// Draws and solves the samples from those that are done up to a number, of which the blocks before are whole.
static pdmc_status run_round(run *r, int samples)
{
    pdmc_status status = PDMC_OK;
    pdmc_results *results = r->results;
    r->problem->sampling.samples = results->sample_count = samples;
    results->kept_count = pdmc_problem_kept(r->problem);
    r->blocks = (samples + PDMC_BLOCK - 1) / PDMC_BLOCK;
#pragma omp parallel num_threads(r->workers)
    work(r, omp_get_thread_num());
    if (r->status != PDMC_OK) PDMC_FAIL(r->status, "%s", r->message);
    cut_to_done(r);
    PDMC_TRY(merge_counts(r));
    if (r->problem->sampling.inverse == PDMC_INVERSE_REDUCED) PDMC_TRY(settle_doubts(r));
    results->failed_count = 0;
    for (int s = 0; s < results->sample_count; s++) results->failed_count += results->failure[s] != PDMC_SAMPLE_OK;
done:
    return status;
}

// Whether the target is known, or will not be; otherwise the samples of the next round.
static pdmc_status judge_round(const run *r, bool *goes_on, int *samples)
{
    pdmc_status status = PDMC_OK;
    pdmc_round found;
    *goes_on = false;
    if (r->problem->sampling.target == PDMC_TARGET_NONE || r->results->status == PDMC_RUN_INTERRUPTED) goto done;
    PDMC_TRY(pdmc_stop_rule_judge(r->problem, needed_counts(r), r->results, &found));
    if (r->options->round) r->options->round(r->options->context, &found);
    *goes_on = found.error > found.wanted && found.samples < r->most && !r->stop;
    if (found.error <= found.wanted) r->results->status = PDMC_RUN_TARGET_MET;
    else if (found.samples == r->most) r->results->status = PDMC_RUN_SAMPLE_CAP;
    else if (r->stop) r->results->status = PDMC_RUN_INTERRUPTED;
    if (*goes_on) *samples = pdmc_stop_rule_next(r->problem, r->together * PDMC_BLOCK, &found);
done:
    return status;
}

// Draws and solves all samples by one model; with a target, in rounds.
static pdmc_status run_all(run *r)
{
    pdmc_status status = PDMC_OK;
    pdmc_runtime *runtime = &r->results->runtime;
    bool goes_on = true;
    PDMC_NEW(r->residual, r->most);
    for (int m = 0; m < PDMC_MEASURES && r->problem->sampling.inverse == PDMC_INVERSE_REDUCED; m++)
        PDMC_NEW(r->delta[m], r->most);
    PDMC_TRY(employ(r));
    r->together = blocks_together(r);
    int samples = pdmc_stop_rule_first(r->problem, r->together * PDMC_BLOCK);
    while (goes_on) {
        PDMC_TRY(run_round(r, samples));
        PDMC_TRY(judge_round(r, &goes_on, &samples));
    }
    for (int w = 0; w < r->workers; w++) {
        runtime->sampling += r->block[w]->solve_seconds / r->options->threads;
        runtime->energy += r->block[w]->energy_seconds / r->options->threads;
    }
done:
    return status;
}

static pdmc_status make_reduced(const pdmc_variables *variables, int threads, pdmc_results *results,
                                pdmc_affine *reduced)
{
    pdmc_status status = PDMC_OK;
    pdmc_block *block = NULL;
    pdmc_reduced_goal goal;
    double *intensity = NULL;
    const double begin = pdmc_seconds();
    PDMC_NEW(intensity, results->tip_count);
    PDMC_TRY(pdmc_block_create(variables, variables->model, &block));
    PDMC_TRY(pdmc_block_nominal(block, results));
    pdmc_block_destroy(&block);
    pdmc_certify_goal(variables, results, intensity, &goal);
    PDMC_TRY(pdmc_reduced_create(variables, &goal, threads, reduced));
    results->accuracy.reduced_unknowns = reduced->unknowns;
    results->runtime.operators += pdmc_seconds() - begin;
done:
    pdmc_block_destroy(&block);
    pdmc_free(intensity);
    return status;
}

pdmc_status pdmc_monte_carlo(const pdmc_problem *problem, const pdmc_affine *model, const pdmc_run_options *options,
                             pdmc_results *results, pdmc_sample_counts **counts)
{
    *counts = NULL;
    PDMC_REQUIRE(options->threads >= 1, "%d threads: at least one is needed", options->threads);
    PDMC_REQUIRE(problem->sampling.samples >= 1, "%d samples: at least one is needed", problem->sampling.samples);
    pdmc_status status = PDMC_OK;
    const bool is_reduced = problem->sampling.inverse == PDMC_INVERSE_REDUCED;
    pdmc_affine reduced = {0};
    pdmc_variables variables = {0};
    pdmc_problem asked = *problem;
    run r = {.problem = &asked,
             .variables = &variables,
             .model = is_reduced ? &reduced : model,
             .full = model,
             .most = pdmc_stop_rule_most(problem),
             .options = options,
             .results = results,
             .workers = pdmc_block_threads(model, options->threads)};
    results->accuracy = pdmc_no_accuracy;
    pdmc_blas_prepare();
    asked.sampling.samples = r.most;
    PDMC_TRY(pdmc_variables_create(&asked, model, &variables));
    PDMC_TRY(allocate_samples(&asked, results));
    r.most_kept = pdmc_problem_kept(&asked);
    asked.sampling.samples = problem->sampling.samples;
    if (is_reduced) PDMC_TRY(make_reduced(&variables, options->threads, results, &reduced));
    PDMC_TRY(run_all(&r));
    PDMC_TRY(summarise_accuracy(&r));
    if (results->status != PDMC_RUN_INTERRUPTED)
        PDMC_TRY(pdmc_rare_event(&variables, r.model, model, options, results));
    if (needed_counts(&r)) {
        *counts = r.counts[0];
        r.counts[0] = NULL;
    }
done:
    dismiss(&r);
    pdmc_affine_clear(&reduced);
    pdmc_variables_clear(&variables);
    return status;
}
