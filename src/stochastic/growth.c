// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/growth.h"

#include "base/base_impl.h"
#include "stochastic/certify.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <string.h>

enum { B = PDMC_BLOCK };

// Where nothing drives the crack, or nothing holds it.
static const double certain = 50.0;

pdmc_status pdmc_growth_create(const pdmc_variables *variables, const pdmc_affine *model, const pdmc_affine *full,
                               const pdmc_run_options *options, pdmc_results *results, pdmc_growth *growth)
{
    pdmc_status status = PDMC_OK;
    *growth = (pdmc_growth){
        .variables = variables, .model = model, .full = full, .options = options, .results = results, .tip = -1};
    PDMC_NEW(growth->block, options->threads);
    PDMC_NEW(growth->full_block, options->threads);
    for (int t = 0; t < options->threads; t++) {
        PDMC_TRY(pdmc_block_create(variables, model, &growth->block[t]));
        growth->block[t]->measure_alone = true;
        if (t == 0 && variables->problem->energy.measure == PDMC_MEASURE_BOND)
            PDMC_TRY(pdmc_block_make_forms(growth->block[0], &growth->forms));
        PDMC_TRY(pdmc_block_use_forms(growth->block[t], growth->forms));
        if (full != model) PDMC_TRY(pdmc_block_create(variables, full, &growth->full_block[t]));
    }
done:
    return status;
}

void pdmc_growth_clear(pdmc_growth *growth)
{
    for (int t = 0; growth->block && growth->full_block && t < growth->options->threads; t++) {
        pdmc_block_destroy(&growth->block[t]);
        pdmc_block_destroy(&growth->full_block[t]);
    }
    pdmc_energy_forms_destroy(&growth->forms);
    pdmc_free(growth->block);
    pdmc_free(growth->full_block);
    *growth = (pdmc_growth){0};
}

static double growth_of_tip(const pdmc_block *block, int s, int t)
{
    const double energy = pdmc_block_largest_energy(block, s, t);
    const double toughness = block->drawn.draw[s].fracture_energy[t];
    if (toughness <= 0.0) return certain;
    if (energy <= 0.0) return -certain;
    return fmax(-certain, fmin(certain, log(energy / toughness)));
}

static double growth_of(const pdmc_growth *growth, const pdmc_block *block, int s)
{
    double largest = -certain;
    if (block->failure[s] != PDMC_SAMPLE_OK) return NAN;
    for (int t = 0; t < growth->results->tip_count; t++)
        if (growth->tip < 0 || growth->tip == t) largest = fmax(largest, growth_of_tip(block, s, t));
    return largest;
}

// The event hangs on the sign of g alone. A tip that grows by more than delta grows, and where all are below G_c by more
// none does; in between, a reduced answer does not tell.
static bool is_in_doubt(const pdmc_growth *growth, const pdmc_block *block, int s, double delta)
{
    double most = -INFINITY; // of sqrt(G) - sqrt(G_c)
    for (int t = 0; t < growth->results->tip_count; t++) {
        const double toughness = fmax(block->drawn.draw[s].fracture_energy[t], 0.0);
        if (growth->tip < 0 || growth->tip == t)
            most = fmax(most, sqrt(pdmc_block_largest_energy(block, s, t)) - sqrt(toughness));
    }
    return fabs(most) <= delta;
}

static void measure(const pdmc_growth *growth, pdmc_block *block)
{
    pdmc_block_measure(block);
    if (block->problem->energy.measure == PDMC_MEASURE_GRIFFITH) pdmc_block_griffith(block, growth->results);
}

static pdmc_status solve_block(pdmc_growth *growth, pdmc_block *block, int count, const double z[], double g[],
                               bool doubt[])
{
    double delta[B];
    pdmc_status status = pdmc_block_draw_points(block, z, count);
    if (status == PDMC_OK) status = pdmc_block_solve(block, count);
    if (status != PDMC_OK) return status;
    measure(growth, block);
    const bool is_reduced = growth->full != growth->model;
    if (is_reduced) pdmc_certify_root_energies(block, count, growth->results, block->problem->energy.measure, delta);
    for (int s = 0; s < count; s++) {
        g[s] = growth_of(growth, block, s);
        doubt[s] = is_reduced && !isnan(g[s]) && is_in_doubt(growth, block, s, delta[s]);
    }
    return PDMC_OK;
}

// One block of the points that are named, on the full model.
static pdmc_status solve_in_full(pdmc_growth *growth, pdmc_block *block, int count, const int place[], const double z[],
                                 double g[])
{
    pdmc_status status = PDMC_OK;
    const size_t variables = (size_t)growth->variables->count;
    double *point = NULL;
    PDMC_NEW(point, B * variables);
    for (int k = 0; k < count; k++)
        memcpy(&point[(size_t)k * variables], &z[(size_t)place[k] * variables], variables * sizeof *point);
    PDMC_TRY(pdmc_block_draw_points(block, point, count));
    PDMC_TRY(pdmc_block_solve_by(block, PDMC_INVERSE_KRYLOV, count));
    measure(growth, block);
    for (int k = 0; k < count; k++) g[place[k]] = growth_of(growth, block, k);
done:
    pdmc_free(point);
    return status;
}

// What is evaluated, block by block: all points, or in full those that are named.
typedef struct {
    pdmc_growth *growth;
    int count;        // of points
    const double *z;  // [points, variables]
    double *g;        // [points]
    bool *doubt;      // [points]
    const int *place; // [count] of the points in doubt; NULL for all
} evaluation;

static pdmc_status evaluate_block(const evaluation *e, int thread, int first)
{
    pdmc_growth *growth = e->growth;
    const int size = e->count - first < B ? e->count - first : B;
    const size_t at = (size_t)first * (size_t)growth->variables->count;
    if (e->place) return solve_in_full(growth, growth->full_block[thread], size, &e->place[first], e->z, e->g);
    return solve_block(growth, growth->block[thread], size, &e->z[at], &e->g[first], &e->doubt[first]);
}

static pdmc_status evaluate_blocks(const evaluation *e)
{
    pdmc_status status = PDMC_OK;
    char message[512] = "";
    const pdmc_growth *growth = e->growth;
#pragma omp parallel for schedule(dynamic) num_threads(pdmc_block_threads(growth->model, growth->options->threads))
    for (int first = 0; first < e->count; first += B) {
        const pdmc_status mine = evaluate_block(e, omp_get_thread_num(), first);
        if (mine == PDMC_OK) continue;
#pragma omp critical(pdmc_growth)
        {
            status = mine;
            snprintf(message, sizeof message, "%s", pdmc_last_error());
        }
    }
    return status == PDMC_OK ? PDMC_OK : pdmc_raise(status, "%s", message);
}

// The points in doubt are few, and are gathered into full blocks.
static pdmc_status evaluate_doubts(evaluation *e)
{
    pdmc_status status = PDMC_OK;
    int found = 0, *place = NULL;
    PDMC_NEW(place, e->count);
    for (int k = 0; k < e->count; k++)
        if (e->doubt[k]) place[found++] = k;
    e->place = place;
    e->count = found;
    e->growth->solved_in_full += found;
    PDMC_TRY(evaluate_blocks(e));
done:
    pdmc_free(place);
    return status;
}

static pdmc_status evaluate(void *context, int count, const double z[], double g[])
{
    pdmc_growth *growth = context;
    const pdmc_run_options *options = growth->options;
    const int samples = growth->results->sample_count;
    pdmc_status status = PDMC_OK;
    evaluation e = {.growth = growth, .count = count, .z = z, .g = g};
    if (options->progress && !options->progress(options->context, samples, samples))
        return pdmc_raise(PDMC_ERR_INTERRUPTED, "stopped during the search for rare growth");
    PDMC_NEW(e.doubt, count);
    PDMC_TRY(evaluate_blocks(&e));
    PDMC_TRY(evaluate_doubts(&e));
done:
    pdmc_free(e.doubt);
    return status;
}

pdmc_limit_state pdmc_growth_limit(pdmc_growth *growth)
{
    return (pdmc_limit_state){growth->variables->count, evaluate, growth};
}
