// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/explicit.h"

#include "base/base_impl.h"
#include "run/tips.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// What moves, and where it is recorded.
typedef struct {
    const pdmc_explicit *study;
    const pdmc_run_options *options;
    pdmc_results *results;
    pdmc_explicit_record *record;
    pdmc_particles *particles;
    int steps, stride; // in all, and from record to record
    int records;       // at most
    int snapshots;     // that are asked for
    double *front;     // [tips] at the start
    double *damage;    // [nodes]
    int *piece;        // [nodes] that they are in, as of the last record
    int pieces;
    pdmc_rigid_sphere *spheres;
} recorder;

static bool go_on(const recorder *r, int done)
{
    return !r->options->progress || r->options->progress(r->options->context, done, r->steps);
}

static void plan(recorder *r)
{
    const double step = pdmc_particles_step_size(r->particles);
    r->steps = (int)ceil(r->study->duration / step * (1.0 - 1e-9)); // decimals that were rounded make no step more
    r->stride = (int)fmax(1.0, round(r->study->interval / step));
    r->records = 1 + (r->steps + r->stride - 1) / r->stride;
    r->snapshots = r->study->snapshots < r->records ? r->study->snapshots : r->records - 1;
}

static pdmc_status prepare_records(recorder *r)
{
    pdmc_status status = PDMC_OK;
    pdmc_explicit_record *record = r->record;
    const int n = r->records;
    PDMC_NEW(record->time, n);
    PDMC_NEW(record->kinetic, n);
    PDMC_NEW(record->elastic, n);
    PDMC_NEW(record->contact, n);
    PDMC_NEW(record->fracture, n);
    PDMC_NEW(record->work, n);
    PDMC_NEW(record->momentum, (size_t)PDMC_AXES * (size_t)n);
    PDMC_NEW(record->mean_damage, n);
    PDMC_NEW(record->broken, n);
    PDMC_NEW(record->fragments, n);
    PDMC_NEW(record->loose_nodes, n);
    PDMC_NEW(record->largest_fragment, n);
done:
    return status;
}

static pdmc_status prepare_tips(recorder *r)
{
    pdmc_status status = PDMC_OK;
    pdmc_explicit_record *record = r->record;
    record->tip_count = pdmc_tips_of(r->study, NULL);
    const size_t values = (size_t)r->records * (size_t)record->tip_count;
    PDMC_NEW(record->tips, record->tip_count);
    PDMC_NEW(record->tip_advance, values);
    PDMC_NEW(record->tip_speed, values);
    PDMC_NEW(r->front, record->tip_count);
    PDMC_NEW(r->damage, record->node_count);
    pdmc_tips_of(r->study, record->tips);
done:
    return status;
}

static pdmc_status prepare_spheres(recorder *r)
{
    pdmc_status status = PDMC_OK;
    pdmc_explicit_record *record = r->record;
    record->sphere_count = r->study->sphere_count;
    const size_t values = (size_t)PDMC_AXES * (size_t)r->records * (size_t)record->sphere_count;
    PDMC_NEW(record->spheres, record->sphere_count);
    PDMC_NEW(record->sphere_centre, values);
    PDMC_NEW(record->sphere_velocity, values);
    PDMC_NEW(r->spheres, record->sphere_count);
    pdmc_particles_spheres(r->particles, r->spheres);
    for (int s = 0; s < record->sphere_count; s++) {
        memcpy(record->spheres[s].name, r->spheres[s].name, sizeof r->spheres[s].name);
        record->spheres[s].radius = r->spheres[s].radius;
        record->spheres[s].mass = r->spheres[s].mass;
    }
done:
    return status;
}

// One snapshot more than is asked for, of where an interrupted run ends.
static pdmc_status prepare_nodes(recorder *r)
{
    pdmc_status status = PDMC_OK;
    pdmc_explicit_record *record = r->record;
    const int count = pdmc_particles_count(r->particles);
    const size_t n = (size_t)count, states = n * ((size_t)r->snapshots + 1);
    if (states > INT32_MAX)
        PDMC_FAIL(PDMC_ERR_CONFIG, "%d snapshots of %d nodes are more than a result file takes, %d numbers at most",
                  r->snapshots, count, INT32_MAX);
    record->node_count = count;
    record->body_count = r->study->body_count;
    PDMC_NEW(record->node_position, PDMC_AXES * n);
    PDMC_NEW(record->node_body, n);
    PDMC_NEW(record->bodies, record->body_count);
    PDMC_NEW(record->snapshot_time, r->snapshots + 1);
    PDMC_NEW(record->displacement, PDMC_AXES * states);
    PDMC_NEW(record->velocity, PDMC_AXES * states);
    PDMC_NEW(record->damage, states);
    PDMC_NEW(record->fragment, states);
    PDMC_NEW(r->piece, n);
    pdmc_particles_reference(r->particles, record->node_position, record->node_body);
    for (int b = 0; b < record->body_count; b++)
        memcpy(record->bodies[b].name, r->study->bodies[b].name, sizeof r->study->bodies[b].name);
done:
    return status;
}

static pdmc_status describe(recorder *r)
{
    const pdmc_explicit *study = r->study;
    pdmc_explicit_record *record = r->record;
    record->dimension = study->dimension;
    record->spacing = study->spacing;
    record->horizon = study->horizon;
    record->tip_damage = study->tip_damage;
    record->speed_window = study->speed_window;
    record->step = pdmc_particles_step_size(r->particles);
    record->stable_step = pdmc_particles_stable_step(r->particles);
    record->bonds = (double)pdmc_particles_bonds(r->particles);
    record->kernel = pdmc_strdup(pdmc_particles_kernel(r->particles));
    return record->kernel ? PDMC_OK : PDMC_ERR_NOMEM;
}

static pdmc_status prepare(recorder *r)
{
    pdmc_status status = PDMC_OK;
    plan(r);
    PDMC_TRY(describe(r));
    PDMC_TRY(prepare_records(r));
    PDMC_TRY(prepare_nodes(r));
    PDMC_TRY(prepare_tips(r));
    PDMC_TRY(prepare_spheres(r));
done:
    return status;
}

static void record_sums(recorder *r, int at)
{
    pdmc_explicit_record *record = r->record;
    const pdmc_particles_sums sums = pdmc_particles_sum(r->particles);
    record->time[at] = pdmc_particles_time(r->particles);
    record->kinetic[at] = sums.kinetic;
    record->elastic[at] = sums.elastic;
    record->contact[at] = sums.contact;
    record->fracture[at] = sums.fracture;
    record->work[at] = sums.work;
    record->first = sums.first;
    memcpy(&record->momentum[PDMC_AXES * at], sums.momentum, sizeof sums.momentum);
    record->mean_damage[at] = sums.mean_damage;
    record->broken[at] = (double)sums.broken;
}

// Beyond the front at the start; where no node was damaged then, beyond the end of the crack.
static void record_tips(recorder *r, int at)
{
    pdmc_explicit_record *record = r->record;
    if (record->tip_count == 0) return;
    pdmc_particles_state(r->particles, NULL, NULL, r->damage);
    for (int t = 0; t < record->tip_count; t++) {
        const double front =
            pdmc_tip_front(r->study, &record->tips[t], record->node_count, record->node_position, r->damage);
        if (at == 0) r->front[t] = isfinite(front) ? front : 0.0;
        record->tip_advance[at * record->tip_count + t] = fmax(0.0, front - r->front[t]);
    }
}

static void record_spheres(recorder *r, int at)
{
    const size_t bytes = sizeof r->spheres->centre;
    pdmc_particles_spheres(r->particles, r->spheres);
    for (int s = 0; s < r->record->sphere_count; s++) {
        const size_t place = PDMC_AXES * ((size_t)at * (size_t)r->record->sphere_count + (size_t)s);
        memcpy(&r->record->sphere_centre[place], r->spheres[s].centre, bytes);
        memcpy(&r->record->sphere_velocity[place], r->spheres[s].velocity, bytes);
    }
}

static void repeat_fragments(pdmc_explicit_record *record, int at)
{
    record->fragments[at] = record->fragments[at - 1];
    record->loose_nodes[at] = record->loose_nodes[at - 1];
    record->largest_fragment[at] = record->largest_fragment[at - 1];
}

// As long as no bond breaks the pieces are the same.
static pdmc_status record_fragments(recorder *r, int at)
{
    pdmc_status status = PDMC_OK;
    pdmc_explicit_record *record = r->record;
    pdmc_fragment *list = NULL;
    int loose = 0;
    if (at > 0 && record->broken[at] == record->broken[at - 1]) {
        repeat_fragments(record, at);
        return PDMC_OK;
    }
    PDMC_TRY(pdmc_particles_find_fragments(r->particles, r->piece, &r->pieces));
    PDMC_NEW(list, r->pieces);
    pdmc_particles_fragments(r->particles, r->piece, r->pieces, list);
    for (int i = 0; i < r->pieces; i++) loose += list[i].nodes == 1;
    record->loose_nodes[at] = loose;
    record->fragments[at] = r->pieces - loose;
    record->largest_fragment[at] = list[0].mass;
done:
    pdmc_free(list);
    return status;
}

// A run that stops may not have moved since the last one.
static pdmc_status take_record(recorder *r)
{
    const int at = r->record->record_count;
    if (at > 0 && r->record->time[at - 1] == pdmc_particles_time(r->particles)) return PDMC_OK;
    r->record->record_count++;
    record_sums(r, at);
    record_tips(r, at);
    record_spheres(r, at);
    return record_fragments(r, at);
}

static pdmc_status keep_fragments(recorder *r)
{
    pdmc_status status = PDMC_OK;
    pdmc_explicit_record *record = r->record;
    const size_t n = (size_t)record->node_count, at = (size_t)(record->snapshot_count - 1) * n;
    pdmc_free(record->fragment_list);
    record->fragment_count = 0;
    PDMC_NEW(record->fragment_list, r->pieces);
    record->fragment_count = r->pieces;
    pdmc_particles_fragments(r->particles, r->piece, r->pieces, record->fragment_list);
    memcpy(&record->fragment[at], r->piece, n * sizeof *r->piece);
done:
    return status;
}

static pdmc_status take_snapshot(recorder *r)
{
    pdmc_explicit_record *record = r->record;
    const size_t at = (size_t)record->snapshot_count++ * (size_t)record->node_count;
    record->snapshot_time[record->snapshot_count - 1] = pdmc_particles_time(r->particles);
    record->state_count = record->snapshot_count * record->node_count;
    pdmc_particles_state(r->particles, &record->displacement[PDMC_AXES * at], &record->velocity[PDMC_AXES * at],
                         &record->damage[at]);
    return keep_fragments(r);
}

// Snapshots are as evenly spread over the records as they can be, and the last record has one.
static bool is_snapshot(const recorder *r, int record)
{
    const int64_t intervals = r->records - 1, n = r->snapshots;
    return record * n / intervals > (record - 1) * n / intervals;
}

// In pieces, so that an interruption need not wait for the next record.
static pdmc_status move(recorder *r, int steps, bool *goes_on)
{
    enum { PIECE = 8 };
    pdmc_status status = PDMC_OK;
    for (int done = 0; done < steps && status == PDMC_OK && *goes_on; done += PIECE) {
        status = pdmc_particles_advance(r->particles, steps - done < PIECE ? steps - done : PIECE);
        *goes_on = go_on(r, pdmc_particles_steps(r->particles));
    }
    return status;
}

static pdmc_status stop_at_the_last_state(recorder *r)
{
    r->results->status = PDMC_RUN_NOT_FINITE;
    r->record->stop = pdmc_strdup(pdmc_last_error());
    return r->record->stop ? PDMC_OK : PDMC_ERR_NOMEM;
}

static pdmc_status move_through(recorder *r)
{
    pdmc_status status = PDMC_OK;
    bool goes_on = true;
    PDMC_TRY(take_record(r));
    for (int i = 1; i < r->records && goes_on && r->results->status == PDMC_RUN_COMPLETE; i++) {
        const int left = r->steps - (i - 1) * r->stride;
        status = move(r, left < r->stride ? left : r->stride, &goes_on);
        if (status == PDMC_ERR_SINGULAR) status = stop_at_the_last_state(r);
        if (status != PDMC_OK) goto done;
        const bool is_whole = pdmc_particles_steps(r->particles) == r->steps;
        if (!goes_on && !is_whole && r->results->status == PDMC_RUN_COMPLETE) r->results->status = PDMC_RUN_INTERRUPTED;
        PDMC_TRY(take_record(r));
        if (is_snapshot(r, i) || r->results->status != PDMC_RUN_COMPLETE) PDMC_TRY(take_snapshot(r));
    }
done:
    return status;
}

pdmc_status pdmc_run_explicit(const pdmc_explicit *study, const pdmc_run_options *options, pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    recorder r = {.study = study,
                  .options = options,
                  .results = results,
                  .record = &results->particles,
                  .steps = (int)fmin(1e9, pdmc_explicit_count(study).steps)};
    if (!go_on(&r, 0)) PDMC_FAIL(PDMC_ERR_INTERRUPTED, "stopped before the first time step: there is nothing to save");
    PDMC_TRY(pdmc_explicit_particles(study, options->threads, &r.particles));
    PDMC_TRY(prepare(&r));
    const double start = pdmc_seconds();
    PDMC_TRY(move_through(&r));
    pdmc_tip_speeds(r.record);
    r.record->steps = pdmc_particles_steps(r.particles);
    results->runtime.motion = pdmc_seconds() - start;
    results->runtime.threads = options->threads;
done:
    pdmc_particles_destroy(r.particles);
    pdmc_free(r.front);
    pdmc_free(r.damage);
    pdmc_free(r.piece);
    pdmc_free(r.spheres);
    return status;
}
