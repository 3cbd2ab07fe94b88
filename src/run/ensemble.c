// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/ensemble.h"

#include "base/base_impl.h"
#include "run/draws.h"
#include "run/ensemble_summary.h"
#include "run/explicit.h"
#include "run/outcome.h"
#include "run/quasi_static.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>

enum { MESSAGE_SIZE = 512 };

// What all samples share.
typedef struct {
    pdmc_explicit study; // with one snapshot
    const pdmc_run_options *options;
    const pdmc_explicit_record *nominal; // of the study at its means
    pdmc_ensemble_draws draws;
    pdmc_ensemble_results *results;
    double *reach; // [tips]
    bool *is_done; // [samples]
    int total, done, inner_threads;
    bool stops;
    pdmc_status status; // of the first sample in time that met an error, with its message
    char message[MESSAGE_SIZE];
} ensemble;

// Called between the steps of any sample: the first answer of false stops them all.
static bool go_on(void *context, int done, int total)
{
    (void)done, (void)total;
    ensemble *e = context;
    bool goes_on;
#pragma omp critical(pdmc_ensemble)
    {
        const pdmc_run_options *o = e->options;
        if (!e->stops && o->progress && !o->progress(o->context, e->done, e->total)) e->stops = true;
        goes_on = !e->stops;
    }
    return goes_on;
}

static void give_up(ensemble *e, pdmc_status status)
{
#pragma omp critical(pdmc_ensemble)
    {
        if (e->status == PDMC_OK) {
            e->status = status;
            snprintf(e->message, sizeof e->message, "%s", pdmc_last_error());
        }
        e->stops = true;
    }
}

static void mark_done(ensemble *e, int index, pdmc_sample_failure failure)
{
#pragma omp critical(pdmc_ensemble)
    {
        e->results->failure[index] = (uint8_t)failure;
        e->is_done[index] = true;
        e->done++;
    }
}

static void keep_tip(const ensemble *e, const pdmc_explicit_record *r, size_t index, size_t t)
{
    pdmc_ensemble_results *out = e->results;
    const size_t at = index * (size_t)out->tip_count + t, stations = (size_t)out->station_count;
    const pdmc_followed_tip *tip = &r->tips[t];
    const double *damage = &r->damage[(size_t)(r->snapshot_count - 1) * (size_t)r->node_count];
    const pdmc_tip_growth g = pdmc_results_growth(r, (int)t);
    double *path = &out->path[at * stations];
    const int count = pdmc_tip_path(&e->study, r, tip, damage, out->station_count, path);
    const double front = count > 0 ? out->station[count - 1] : 0.0, left = count > 0 ? path[count - 1] : 0.0;
    out->growth[at] = g.growth;
    out->begin[at] = g.begin;
    out->mean_speed[at] = e->study.load_steps > 0 ? NAN : g.mean_speed; // loads are no time
    out->most_speed[at] = e->study.load_steps > 0 ? NAN : g.most_speed;
    out->outcome[at] = (uint8_t)pdmc_tip_outcome(&e->study, r, (int)t, e->reach[t], front);
    out->end[2 * at] = tip->position[0] + front * tip->direction[0] - left * tip->direction[1];
    out->end[2 * at + 1] = tip->position[1] + front * tip->direction[1] + left * tip->direction[0];
}

static void keep_force(const ensemble *e, const pdmc_explicit_record *r, size_t index, size_t condition)
{
    const size_t at = index * (size_t)e->results->condition_count + condition;
    const int record = pdmc_results_largest_force(r, (int)condition, &e->results->largest_force[at]);
    e->results->load_of_force[at] = r->time[record];
}

static void keep_factors(const ensemble *e, size_t index, const pdmc_explicit_sample *sample)
{
    e->results->load[index] = sample->load;
    e->results->velocity[index] = sample->velocity;
    e->results->youngs_modulus[index] = sample->youngs_modulus;
    e->results->fracture_energy[index] = sample->fracture_energy;
}

// Everything is NaN until it is known, and stays so where the sample fails.
static void forget(const ensemble *e, size_t index)
{
    pdmc_ensemble_results *out = e->results;
    const size_t tips = (size_t)out->tip_count, stations = tips * (size_t)out->station_count;
    const size_t conditions = (size_t)out->condition_count;
    out->fracture[index] = NAN;
    for (size_t t = index * tips; t < (index + 1) * tips; t++) {
        out->growth[t] = out->begin[t] = out->mean_speed[t] = out->most_speed[t] = NAN;
        out->end[2 * t] = out->end[2 * t + 1] = NAN;
    }
    for (size_t j = index * stations; j < (index + 1) * stations; j++) out->path[j] = NAN;
    for (size_t c = index * conditions; c < (index + 1) * conditions; c++)
        out->largest_force[c] = out->load_of_force[c] = NAN;
}

static pdmc_status run_study(const pdmc_explicit *study, const pdmc_explicit_sample *sample,
                             const pdmc_run_options *options, pdmc_results *results)
{
    return (study->load_steps > 0 ? pdmc_run_quasi_static : pdmc_run_explicit)(study, sample, options, results);
}

// What the engine refuses of a sample, such as a step that its stiffness makes unstable, is a sample that fails.
static pdmc_status move_sample(ensemble *e, int index, const pdmc_explicit_sample *sample)
{
    pdmc_results r = {0};
    const pdmc_run_options options = {.threads = e->inner_threads, .progress = go_on, .context = e};
    pdmc_status status = run_study(&e->study, sample, &options, &r);
    const bool is_refused = status == PDMC_ERR_CONFIG;
    if (status == PDMC_ERR_INTERRUPTED || is_refused) status = PDMC_OK;
    else if (status == PDMC_OK && r.status == PDMC_RUN_COMPLETE) {
        e->results->fracture[index] = r.particles.fracture[r.particles.record_count - 1];
        for (size_t t = 0; t < (size_t)r.particles.tip_count; t++) keep_tip(e, &r.particles, (size_t)index, t);
        for (size_t c = 0; c < (size_t)e->results->condition_count; c++) keep_force(e, &r.particles, (size_t)index, c);
        mark_done(e, index, PDMC_SAMPLE_OK);
    }
    if (is_refused || r.status == PDMC_RUN_NOT_FINITE || r.status == PDMC_RUN_NO_REST)
        mark_done(e, index, PDMC_SAMPLE_DIVERGED);
    pdmc_results_clear(&r);
    return status;
}

static void run_sample(ensemble *e, int index)
{
    pdmc_status status = PDMC_OK;
    pdmc_explicit_sample sample;
    double *stiffness = NULL, *strength = NULL;
    PDMC_NEW(stiffness, e->nominal->node_count);
    PDMC_NEW(strength, e->nominal->node_count);
    forget(e, (size_t)index);
    const bool is_positive = pdmc_ensemble_draws_sample(&e->draws, (uint64_t)index, stiffness, strength, &sample);
    keep_factors(e, (size_t)index, &sample);
    if (is_positive) status = move_sample(e, index, &sample);
    else mark_done(e, index, PDMC_SAMPLE_SOFT);
done:
    if (status != PDMC_OK) give_up(e, status);
    pdmc_free(stiffness);
    pdmc_free(strength);
}

static pdmc_status allocate(ensemble *e)
{
    pdmc_status status = PDMC_OK;
    pdmc_ensemble_results *out = e->results;
    const size_t samples = (size_t)e->total, tips = samples * (size_t)e->nominal->tip_count;
    PDMC_NEW(out->failure, samples);
    PDMC_NEW(out->load, samples);
    PDMC_NEW(out->velocity, samples);
    PDMC_NEW(out->youngs_modulus, samples);
    PDMC_NEW(out->fracture_energy, samples);
    PDMC_NEW(out->fracture, samples);
    PDMC_NEW(out->outcome, tips);
    PDMC_NEW(out->growth, tips);
    PDMC_NEW(out->begin, tips);
    PDMC_NEW(out->mean_speed, tips);
    PDMC_NEW(out->most_speed, tips);
    PDMC_NEW(out->end, 2 * tips);
    PDMC_NEW(out->path, tips * (size_t)out->station_count);
    PDMC_NEW(out->largest_force, samples * (size_t)out->condition_count);
    PDMC_NEW(out->load_of_force, samples * (size_t)out->condition_count);
    PDMC_NEW(e->is_done, samples);
done:
    return status;
}

// Stations as far as there is a body ahead of any tip.
static pdmc_status place_stations(ensemble *e)
{
    pdmc_status status = PDMC_OK;
    const pdmc_explicit_record *r = e->nominal;
    double farthest = 0.0;
    PDMC_NEW(e->reach, r->tip_count);
    for (int t = 0; t < r->tip_count; t++) {
        e->reach[t] = pdmc_tip_reach(&e->study, &r->tips[t], r->node_count, r->node_position);
        farthest = fmax(farthest, e->reach[t]);
    }
    e->results->station_count = r->tip_count > 0 ? 1 + (int)(farthest / r->spacing) : 0;
    PDMC_NEW(e->results->station, e->results->station_count);
    for (int j = 0; j < e->results->station_count; j++) e->results->station[j] = j * r->spacing;
done:
    return status;
}

static void run_samples(ensemble *e)
{
    const int side_by_side = e->total >= e->options->threads ? e->options->threads : 1;
    e->inner_threads = side_by_side > 1 ? 1 : e->options->threads;
#pragma omp parallel for schedule(dynamic, 1) num_threads(side_by_side)
    for (int i = 0; i < e->total; i++)
        if (go_on(e, 0, 0)) run_sample(e, i);
    go_on(e, 0, 0); // tells of the last one
}

// The samples up to the first that is missing.
static void count_samples(ensemble *e)
{
    pdmc_ensemble_results *out = e->results;
    while (out->sample_count < e->total && e->is_done[out->sample_count])
        out->failed_count += out->failure[out->sample_count++] != PDMC_SAMPLE_OK;
}

static pdmc_status sample(const pdmc_study *study, const pdmc_run_options *options, pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    const double start = pdmc_seconds();
    ensemble e = {.study = study->motion,
                  .options = options,
                  .nominal = &results->particles,
                  .results = &results->ensemble,
                  .total = study->problem.sampling.samples};
    e.study.snapshots = 1;
    PDMC_TRY(pdmc_ensemble_draws_create(study, &results->particles, options->threads, &e.draws));
    results->ensemble.tip_count = results->particles.tip_count;
    if (e.study.load_steps > 0) results->ensemble.condition_count = results->particles.condition_count;
    PDMC_TRY(place_stations(&e));
    PDMC_TRY(allocate(&e));
    run_samples(&e);
    if (e.status != PDMC_OK) PDMC_FAIL(e.status, "%s", e.message);
    count_samples(&e);
    if (results->ensemble.sample_count < e.total) results->status = PDMC_RUN_INTERRUPTED;
    if (results->ensemble.sample_count > 0) status = pdmc_ensemble_summarise(results);
    else results->ensemble.tip_count = results->ensemble.condition_count = 0;
    results->runtime.sampling = pdmc_seconds() - start;
done:
    pdmc_ensemble_draws_clear(&e.draws);
    pdmc_free(e.reach);
    pdmc_free(e.is_done);
    return status;
}

// While the study moves at its means no sample is done.
typedef struct {
    const pdmc_run_options *options;
    int total;
} prelude;

static bool go_on_before(void *context, int done, int total)
{
    (void)done, (void)total;
    const prelude *p = context;
    return !p->options->progress || p->options->progress(p->options->context, 0, p->total);
}

pdmc_status pdmc_run_ensemble(const pdmc_study *study, const pdmc_run_options *options, pdmc_results *results)
{
    const bool is_random = study->problem.uncertainty_count > 0;
    prelude before = {options, study->problem.sampling.samples};
    pdmc_run_options own = *options;
    if (is_random) own.progress = go_on_before, own.context = &before;
    const pdmc_status status = run_study(&study->motion, NULL, &own, results);
    if (status != PDMC_OK || !is_random || results->status != PDMC_RUN_COMPLETE) return status;
    return sample(study, options, results);
}
