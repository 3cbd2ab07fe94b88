// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/explicit.h"

#include "base/base_impl.h"
#include "run/recorder.h"
#include "run/tips.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// What moves, and where it is recorded.
typedef struct {
    const pdmc_run_options *options;
    pdmc_results *results;
    pdmc_recorder recorder;
    int steps, stride; // in all, and from record to record
} run;

static bool go_on(const run *r, int done)
{
    return !r->options->progress || r->options->progress(r->options->context, done, r->steps);
}

static void plan(run *r)
{
    const double step = pdmc_particles_step_size(r->recorder.particles);
    r->steps =
        (int)ceil(r->recorder.study->duration / step * (1.0 - 1e-9)); // decimals that were rounded make no step more
    r->stride = (int)fmax(1.0, round(r->recorder.study->interval / step));
    r->recorder.records = 1 + (r->steps + r->stride - 1) / r->stride;
    r->recorder.snapshots =
        r->recorder.study->snapshots < r->recorder.records ? r->recorder.study->snapshots : r->recorder.records - 1;
}

// In pieces, so that an interruption need not wait for the next record.
static pdmc_status move(run *r, int steps, bool *goes_on)
{
    enum { PIECE = 8 };
    pdmc_status status = PDMC_OK;
    for (int done = 0; done < steps && status == PDMC_OK && *goes_on; done += PIECE) {
        status = pdmc_particles_advance(r->recorder.particles, steps - done < PIECE ? steps - done : PIECE);
        *goes_on = go_on(r, pdmc_particles_steps(r->recorder.particles));
    }
    return status;
}

static pdmc_status stop_at_the_last_state(run *r)
{
    r->results->status = PDMC_RUN_NOT_FINITE;
    r->results->particles.stop = pdmc_strdup(pdmc_last_error());
    return r->results->particles.stop ? PDMC_OK : PDMC_ERR_NOMEM;
}

static pdmc_status move_through(run *r)
{
    pdmc_status status = PDMC_OK;
    bool goes_on = true;
    PDMC_TRY(pdmc_recorder_take_record(&r->recorder));
    for (int i = 1; i < r->recorder.records && goes_on && r->results->status == PDMC_RUN_COMPLETE; i++) {
        const int left = r->steps - (i - 1) * r->stride;
        status = move(r, left < r->stride ? left : r->stride, &goes_on);
        if (status == PDMC_ERR_SINGULAR) status = stop_at_the_last_state(r);
        if (status != PDMC_OK) goto done;
        const bool is_whole = pdmc_particles_steps(r->recorder.particles) == r->steps;
        if (!goes_on && !is_whole && r->results->status == PDMC_RUN_COMPLETE) r->results->status = PDMC_RUN_INTERRUPTED;
        PDMC_TRY(pdmc_recorder_take_record(&r->recorder));
        if (pdmc_recorder_is_snapshot(&r->recorder, i) || r->results->status != PDMC_RUN_COMPLETE)
            PDMC_TRY(pdmc_recorder_take_snapshot(&r->recorder));
    }
done:
    return status;
}

pdmc_status pdmc_run_explicit(const pdmc_explicit *study, const pdmc_explicit_sample *sample,
                              const pdmc_run_options *options, pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    run r = {.options = options,
             .results = results,
             .recorder = {.study = study, .record = &results->particles, .tips_alone = sample != NULL},
             .steps = (int)fmin(1e9, pdmc_explicit_count(study).steps)};
    pdmc_particles *particles = NULL;
    if (!go_on(&r, 0)) PDMC_FAIL(PDMC_ERR_INTERRUPTED, "stopped before the first time step: there is nothing to save");
    PDMC_TRY(sample ? pdmc_explicit_sample_particles(study, sample, options->threads, &particles)
                    : pdmc_explicit_particles(study, options->threads, &particles));
    r.recorder.particles = particles;
    plan(&r);
    PDMC_TRY(pdmc_recorder_prepare(&r.recorder));
    const double start = pdmc_seconds();
    PDMC_TRY(move_through(&r));
    pdmc_tip_speeds(r.recorder.record);
    results->particles.steps = pdmc_particles_steps(particles);
    results->runtime.motion = pdmc_seconds() - start;
    results->runtime.threads = options->threads;
done:
    pdmc_recorder_clear(&r.recorder);
    pdmc_particles_destroy(particles);
    return status;
}
