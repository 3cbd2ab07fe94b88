// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/motion.h"

#include "base/base_impl.h"

#include <cblas.h>
#include <math.h>
#include <string.h>

// What is integrated, and where it is recorded.
typedef struct {
    const pdmc_problem *problem;
    const pdmc_run_options *run;
    pdmc_results *results;
    pdmc_motion_model model;
    pdmc_motion_options options;
    double *time, *factor; // [history_count] of the options
    double *rows;          // [2 probes, unknowns]
    int steps;
} recorder;

// A point on the probe's side of a crack, nearer than any tip.
static void anchor_of(const pdmc_problem *problem, const pdmc_probe *probe, double anchor[2])
{
    memcpy(anchor, probe->at, sizeof probe->at);
    const int c = pdmc_problem_crack_at(problem, probe->at);
    if (c < 0) return;
    const pdmc_crack *crack = &problem->cracks[c];
    const double d[2] = {crack->to[0] - crack->from[0], crack->to[1] - crack->from[1]}, length = hypot(d[0], d[1]);
    const double from_tip = fmin(hypot(probe->at[0] - crack->from[0], probe->at[1] - crack->from[1]),
                                 hypot(probe->at[0] - crack->to[0], probe->at[1] - crack->to[1]));
    const double offset = (probe->face == PDMC_FACE_LEFT ? 0.1 : -0.1) * from_tip / length;
    anchor[0] -= offset * d[1];
    anchor[1] += offset * d[0];
}

static pdmc_status prepare_probes(recorder *r, const pdmc_discretisation *plate)
{
    pdmc_status status = PDMC_OK;
    const pdmc_problem *problem = r->problem;
    pdmc_motion_record *record = &r->results->motion;
    const size_t n = (size_t)r->model.unknowns;
    PDMC_NEW(r->rows, 2 * n * (size_t)problem->probe_count);
    PDMC_NEW(record->probes, problem->probe_count);
    record->probe_count = problem->probe_count;
    for (int p = 0; p < problem->probe_count; p++) {
        const pdmc_probe *probe = &problem->probes[p];
        double anchor[2];
        memcpy(record->probes[p].name, probe->name, sizeof probe->name);
        memcpy(record->probes[p].position, probe->at, sizeof probe->at);
        record->probes[p].face = (int)probe->face;
        anchor_of(problem, probe, anchor);
        PDMC_TRY(plate->verbs->motion_rows(plate->method, probe->at, anchor, &r->rows[2 * n * (size_t)p]));
    }
done:
    return status;
}

static pdmc_status prepare_options(recorder *r)
{
    pdmc_status status = PDMC_OK;
    const pdmc_problem *problem = r->problem;
    PDMC_NEW(r->time, problem->history_count);
    PDMC_NEW(r->factor, problem->history_count);
    for (int i = 0; i < problem->history_count; i++) {
        r->time[i] = problem->history[i].time;
        r->factor[i] = problem->history[i].factor;
    }
    r->steps = pdmc_problem_steps(problem);
    r->options = (pdmc_motion_options){
        .density = problem->dynamics.density,
        .damping = problem->dynamics.damping,
        .step = problem->dynamics.step,
        .steps = r->steps,
        .history = {problem->history_count, r->time, r->factor},
    };
done:
    return status;
}

static pdmc_status prepare_record(recorder *r)
{
    pdmc_status status = PDMC_OK;
    pdmc_motion_record *record = &r->results->motion;
    const size_t times = (size_t)r->steps + 1;
    PDMC_NEW(record->time, times);
    PDMC_NEW(record->load_factor, times);
    PDMC_NEW(record->kinetic, times);
    PDMC_NEW(record->elastic, times);
    PDMC_NEW(record->dissipated, times);
    PDMC_NEW(record->work, times);
    PDMC_NEW(record->displacement, 2 * times * (size_t)record->probe_count);
done:
    return status;
}

// The model's energies are those of a unit of thickness. At the start nothing is loaded yet, whatever the history says.
static bool record_state(void *context, const pdmc_motion_state *state)
{
    recorder *r = context;
    pdmc_motion_record *record = &r->results->motion;
    const double thickness = r->problem->plate.thickness;
    const int at = record->time_count++, n = r->model.unknowns, rows = 2 * record->probe_count;
    record->time[at] = state->time;
    record->load_factor[at] = at == 0 ? 0.0 : pdmc_history_at(&r->options.history, state->time);
    record->kinetic[at] = thickness * state->kinetic;
    record->elastic[at] = thickness * state->elastic;
    record->dissipated[at] = thickness * state->dissipated;
    record->work[at] = thickness * state->work;
    for (int k = 0; k < rows; k++)
        record->displacement[(size_t)at * (size_t)rows + (size_t)k] =
            cblas_ddot(n, &r->rows[(size_t)k * (size_t)n], 1, state->x, 1);
    return at == 0 || !r->run->progress || r->run->progress(r->run->context, at, r->steps);
}

pdmc_status pdmc_run_motion(const pdmc_problem *problem, const pdmc_discretisation *plate,
                            const pdmc_run_options *options, pdmc_results *results)
{
    if (!plate->verbs->motion) return pdmc_raise(PDMC_ERR_CONFIG, "this crack model has no motion");
    pdmc_status status = PDMC_OK;
    recorder r = {.problem = problem, .run = options, .results = results};
    const double start = pdmc_seconds();
    PDMC_TRY(prepare_options(&r));
    PDMC_TRY(plate->verbs->motion(plate->method, pdmc_motion_inertia(&r.options), &r.model));
    PDMC_TRY(prepare_probes(&r, plate));
    PDMC_TRY(prepare_record(&r));
    PDMC_TRY(pdmc_motion_run(&r.model, &r.options, record_state, &r));
    if (results->motion.time_count <= r.steps) results->status = PDMC_RUN_INTERRUPTED;
    results->runtime.motion = pdmc_seconds() - start;
done:
    pdmc_motion_model_clear(&r.model);
    pdmc_free(r.time);
    pdmc_free(r.factor);
    pdmc_free(r.rows);
    return status;
}
