// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/quasi_static.h"

#include "base/base_impl.h"
#include "run/recorder.h"

// What is loaded, and where it is recorded.
typedef struct {
    const pdmc_explicit *study;
    const pdmc_run_options *options;
    pdmc_results *results;
    pdmc_recorder recorder;
    int loads; // that are done
} run;

static bool go_on(void *context, int steps)
{
    const run *r = context;
    (void)steps;
    return !r->options->progress || r->options->progress(r->options->context, r->loads, r->study->load_steps);
}

static pdmc_status prepare(run *r)
{
    pdmc_status status = PDMC_OK;
    pdmc_explicit_record *record = r->recorder.record;
    const int loads = r->study->load_steps;
    r->recorder.records = loads + 1;
    r->recorder.snapshots = r->study->snapshots < loads ? r->study->snapshots : loads;
    PDMC_TRY(pdmc_recorder_prepare(&r->recorder));
    PDMC_NEW(record->residual, loads + 1);
    PDMC_NEW(record->relaxation_steps, loads + 1);
    PDMC_NEW(record->breakages, loads + 1);
done:
    return status;
}

static pdmc_status come_to_rest(run *r, int load, pdmc_rest *rest)
{
    const pdmc_explicit *study = r->study;
    const pdmc_rest_options options = {.tolerance = study->rest_tolerance,
                                       .most_steps = study->most_relaxation_steps,
                                       .damping = -1.0,
                                       .go_on = go_on,
                                       .context = r};
    return pdmc_particles_come_to_rest(r->recorder.particles, study->load_ends[1] * load / study->load_steps, &options,
                                       rest);
}

// The state is kept in any case, as the last one where the next load does not come to rest.
static pdmc_status record_rest(run *r, int load, const pdmc_rest *rest)
{
    pdmc_explicit_record *record = r->recorder.record;
    record->residual[load] = rest->residual;
    record->relaxation_steps[load] = rest->steps;
    record->breakages[load] = rest->breakages;
    record->steps += rest->steps;
    const pdmc_status status = pdmc_recorder_take_record(&r->recorder);
    if (status != PDMC_OK) return status;
    const bool is_snapshot = load > 0 && pdmc_recorder_is_snapshot(&r->recorder, load);
    return is_snapshot ? pdmc_recorder_take_snapshot(&r->recorder) : pdmc_recorder_keep_state(&r->recorder);
}

static pdmc_status stop(run *r, pdmc_status why)
{
    pdmc_explicit_record *record = r->recorder.record;
    if (record->record_count == 0) return why;
    r->results->status = why == PDMC_ERR_SINGULAR ? PDMC_RUN_NO_REST : PDMC_RUN_INTERRUPTED;
    if (why == PDMC_ERR_SINGULAR && !(record->stop = pdmc_strdup(pdmc_last_error()))) return PDMC_ERR_NOMEM;
    pdmc_recorder_count_state(&r->recorder);
    return PDMC_OK;
}

static pdmc_status load_all(run *r)
{
    pdmc_status status = PDMC_OK;
    for (int load = 0; load <= r->study->load_steps; load++) {
        pdmc_rest rest;
        status = come_to_rest(r, load, &rest);
        if (status == PDMC_ERR_SINGULAR || status == PDMC_ERR_INTERRUPTED) return stop(r, status);
        if (status == PDMC_OK) status = record_rest(r, load, &rest);
        if (status != PDMC_OK) return status;
        r->loads = load;
    }
    return status;
}

pdmc_status pdmc_run_quasi_static(const pdmc_explicit *study, const pdmc_explicit_sample *sample,
                                  const pdmc_run_options *options, pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    pdmc_particles *particles = NULL;
    run r = {.study = study,
             .options = options,
             .results = results,
             .recorder = {.study = study, .record = &results->particles, .tips_alone = sample != NULL}};
    if (!go_on(&r, 0)) PDMC_FAIL(PDMC_ERR_INTERRUPTED, "stopped before the first load: there is nothing to save");
    PDMC_TRY(sample ? pdmc_explicit_sample_particles(study, sample, options->threads, &particles)
                    : pdmc_explicit_particles(study, options->threads, &particles));
    r.recorder.particles = particles;
    PDMC_TRY(prepare(&r));
    const double start = pdmc_seconds();
    PDMC_TRY(load_all(&r));
    results->runtime.motion = pdmc_seconds() - start;
    results->runtime.threads = options->threads;
done:
    pdmc_recorder_clear(&r.recorder);
    pdmc_particles_destroy(particles);
    return status;
}
