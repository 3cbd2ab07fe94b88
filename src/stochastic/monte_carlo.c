// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/stochastic.h"

#include "base/base_impl.h"
#include "stochastic/block.h"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics.h>
#include <stdio.h>
#include <string.h>

// Shared by the threads of a run.
typedef struct {
    const pdmc_problem *problem;
    const pdmc_affine *model;
    const pdmc_run_options *options;
    pdmc_results *results;
    int blocks, done;
    bool *finished; // [blocks]
    bool stop;
    pdmc_status status;
    char message[512]; // of the thread that failed
} run;

static int block_size(const run *r, int block)
{
    const int left = r->results->sample_count - block * PDMC_BLOCK;
    return left < PDMC_BLOCK ? left : PDMC_BLOCK;
}

static pdmc_status solve_block(const run *r, pdmc_block *block, int index)
{
    const int first = index * PDMC_BLOCK, count = block_size(r, index);
    pdmc_block_draw(block, first, count);
    const pdmc_status status = pdmc_block_solve(block, count);
    if (status != PDMC_OK) return status;
    pdmc_block_energies(block, r->problem->energy.bonds);
    pdmc_block_store(block, first, count, r->results);
    return PDMC_OK;
}

static void report_block(run *r, int index)
{
    r->finished[index] = true;
    r->done += block_size(r, index);
    if (r->options->progress && !r->options->progress(r->options->context, r->done, r->results->sample_count))
        r->stop = true;
}

// An expansion that fails for the typical sample is refused before thousands of samples are spent on it.
static pdmc_status check_contraction(const run *r, const pdmc_block *block)
{
    const int count = block_size(r, 0);
    int diverged = 0;
    double factor[PDMC_BLOCK];
    for (int s = 0; s < count; s++) {
        diverged += block->failure[s] == PDMC_SAMPLE_DIVERGED;
        factor[s] = block->contraction[s];
    }
    if (2 * diverged < count || diverged == 0) return PDMC_OK;
    gsl_sort(factor, 1, (size_t)count);
    return pdmc_raise(PDMC_ERR_DATA,
                      "the Neumann expansion does not contract: its measured factor is %.3g in the median of the first "
                      "%d samples and must be < 1; take inverse = \"direct\" or a smaller variation",
                      gsl_stats_median_from_sorted_data(factor, 1, (size_t)count), count);
}

static pdmc_status first_block(run *r, pdmc_block *block)
{
    pdmc_block_nominal(block, r->results);
    pdmc_status status = solve_block(r, block, 0);
    if (status == PDMC_OK) status = check_contraction(r, block);
    if (status == PDMC_OK) report_block(r, 0);
    return status;
}

static void work(run *r)
{
    pdmc_block *block = NULL;
    pdmc_status mine = pdmc_block_create(r->problem, r->model, &block);
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

pdmc_status pdmc_monte_carlo(const pdmc_problem *problem, const pdmc_affine *model, const pdmc_run_options *options,
                             pdmc_results *results)
{
    PDMC_REQUIRE(options->threads >= 1, "%d threads: at least one is needed", options->threads);
    PDMC_REQUIRE(problem->sampling.samples >= 1, "%d samples: at least one is needed", problem->sampling.samples);
    pdmc_status status = PDMC_OK;
    run r = {.problem = problem, .model = model, .options = options, .results = results};
    pdmc_blas_prepare();
    PDMC_TRY(allocate_samples(problem, results));
    r.blocks = (results->sample_count + PDMC_BLOCK - 1) / PDMC_BLOCK;
    PDMC_NEW(r.finished, r.blocks);
#pragma omp parallel num_threads(options->threads)
    work(&r);
    if (r.status != PDMC_OK) PDMC_FAIL(r.status, "%s", r.message);
    cut_to_finished(&r);
    for (int s = 0; s < results->sample_count; s++) results->failed_count += results->failure[s] != PDMC_SAMPLE_OK;
done:
    pdmc_free(r.finished);
    return status;
}
