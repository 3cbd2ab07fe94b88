// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/recorder.h"

#include "base/base_impl.h"
#include "run/tips.h"

#include <math.h>
#include <string.h>

static pdmc_status prepare_records(pdmc_recorder *r)
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
    PDMC_NEW(record->dissipated, n);
    PDMC_NEW(record->momentum, (size_t)PDMC_AXES * (size_t)n);
    PDMC_NEW(record->mean_damage, n);
    PDMC_NEW(record->broken, n);
    PDMC_NEW(record->fragments, n);
    PDMC_NEW(record->loose_nodes, n);
    PDMC_NEW(record->largest_fragment, n);
    PDMC_NEW(record->force_error, n);
done:
    return status;
}

static pdmc_status prepare_tips(pdmc_recorder *r)
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

static pdmc_status prepare_spheres(pdmc_recorder *r)
{
    pdmc_status status = PDMC_OK;
    pdmc_explicit_record *record = r->record;
    record->sphere_count = r->study->sphere_count;
    const size_t values = (size_t)PDMC_AXES * (size_t)r->records * (size_t)record->sphere_count;
    PDMC_NEW(record->spheres, record->sphere_count);
    PDMC_NEW(record->sphere_centre, values);
    PDMC_NEW(record->sphere_velocity, values);
    PDMC_NEW(record->sphere_force, values);
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
static pdmc_status prepare_nodes(pdmc_recorder *r)
{
    pdmc_status status = PDMC_OK;
    pdmc_explicit_record *record = r->record;
    const int count = pdmc_particles_count(r->particles);
    const size_t n = (size_t)count, states = n * ((size_t)r->snapshots + 1);
    if (states > INT32_MAX)
        PDMC_FAIL(PDMC_ERR_CONFIG, "record.snapshots: %d of %d nodes are more than a result file takes, %d numbers at most",
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
        memcpy(record->bodies[b].name, r->study->bodies[b].body.name, sizeof r->study->bodies[b].body.name);
done:
    return status;
}

static pdmc_status prepare_conditions(pdmc_recorder *r)
{
    pdmc_status status = PDMC_OK;
    pdmc_explicit_record *record = r->record;
    record->condition_count = r->study->condition_count;
    const size_t values = (size_t)PDMC_AXES * (size_t)r->records * (size_t)record->condition_count;
    PDMC_NEW(record->conditions, record->condition_count);
    PDMC_NEW(record->condition_force, values);
    PDMC_NEW(record->condition_displacement, values);
    for (int c = 0; c < record->condition_count; c++) {
        memcpy(record->conditions[c].name, r->study->conditions[c].layer.name,
               sizeof r->study->conditions[c].layer.name);
        record->conditions[c].kind = (int)r->study->conditions[c].layer.kind;
    }
done:
    return status;
}

static pdmc_status prepare_interfaces(pdmc_recorder *r)
{
    pdmc_status status = PDMC_OK;
    pdmc_explicit_record *record = r->record;
    const int count = record->interface_count = r->study->interface_count;
    PDMC_NEW(record->interfaces, count);
    PDMC_NEW(record->interface_broken, (size_t)r->records * (size_t)count);
    PDMC_NEW(r->bonds, 2 * count);
    pdmc_particles_interfaces(r->particles, r->bonds, &r->bonds[count]);
    for (int i = 0; i < count; i++) {
        memcpy(record->interfaces[i].name, r->study->interfaces[i].bonds.name,
               sizeof r->study->interfaces[i].bonds.name);
        record->interfaces[i].bonds = (double)r->bonds[i];
    }
done:
    return status;
}

static pdmc_status describe(pdmc_recorder *r)
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

pdmc_status pdmc_recorder_prepare(pdmc_recorder *r)
{
    pdmc_status status = PDMC_OK;
    PDMC_TRY(describe(r));
    PDMC_TRY(prepare_records(r));
    PDMC_TRY(prepare_nodes(r));
    PDMC_TRY(prepare_tips(r));
    PDMC_TRY(prepare_spheres(r));
    PDMC_TRY(prepare_conditions(r));
    PDMC_TRY(prepare_interfaces(r));
done:
    return status;
}

void pdmc_recorder_clear(pdmc_recorder *r)
{
    pdmc_free(r->front);
    pdmc_free(r->damage);
    pdmc_free(r->piece);
    pdmc_free(r->spheres);
    pdmc_free(r->bonds);
    *r = (pdmc_recorder){0};
}

static void record_sums(pdmc_recorder *r, int at)
{
    pdmc_explicit_record *record = r->record;
    const pdmc_particles_sums sums = pdmc_particles_sum(r->particles);
    record->kinetic[at] = sums.kinetic;
    record->elastic[at] = sums.elastic;
    record->contact[at] = sums.contact;
    record->fracture[at] = sums.fracture;
    record->work[at] = sums.work;
    record->dissipated[at] = sums.dissipated;
    record->first = sums.first;
    memcpy(&record->momentum[PDMC_AXES * at], sums.momentum, sizeof sums.momentum);
    record->mean_damage[at] = sums.mean_damage;
    record->broken[at] = (double)sums.broken;
}

// Beyond the front at the start; where no node was damaged then, beyond the end of the crack.
static void record_tips(pdmc_recorder *r, int at)
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

static void record_spheres(pdmc_recorder *r, int at)
{
    const size_t bytes = sizeof r->spheres->centre;
    const size_t first = (size_t)PDMC_AXES * (size_t)at * (size_t)r->record->sphere_count;
    pdmc_particles_spheres(r->particles, r->spheres);
    for (int s = 0; s < r->record->sphere_count; s++) {
        const size_t place = first + PDMC_AXES * (size_t)s;
        memcpy(&r->record->sphere_centre[place], r->spheres[s].centre, bytes);
        memcpy(&r->record->sphere_velocity[place], r->spheres[s].velocity, bytes);
    }
    pdmc_particles_sphere_forces(r->particles, &r->record->sphere_force[first]);
}

static void record_conditions(pdmc_recorder *r, int at)
{
    const size_t place = (size_t)PDMC_AXES * (size_t)at * (size_t)r->record->condition_count;
    pdmc_particles_conditions(r->particles, &r->record->condition_force[place],
                              &r->record->condition_displacement[place]);
}

static void record_interfaces(pdmc_recorder *r, int at)
{
    const int count = r->record->interface_count;
    uint64_t *broken = &r->bonds[count];
    pdmc_particles_interfaces(r->particles, r->bonds, broken);
    for (int i = 0; i < count; i++) r->record->interface_broken[at * count + i] = (double)broken[i];
}

static void repeat_fragments(pdmc_explicit_record *record, int at)
{
    record->fragments[at] = record->fragments[at - 1];
    record->loose_nodes[at] = record->loose_nodes[at - 1];
    record->largest_fragment[at] = record->largest_fragment[at - 1];
}

// As long as no bond breaks the pieces are the same.
static pdmc_status record_fragments(pdmc_recorder *r, int at)
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

static pdmc_status record_precision(pdmc_recorder *r, int at)
{
    if (r->study->precision != PDMC_PRECISION_SINGLE) return PDMC_OK;
    r->record->compared_count = at + 1;
    return pdmc_particles_precision(r->particles, &r->record->force_error[at]);
}

// A run that stops may not have moved since the last one.
pdmc_status pdmc_recorder_take_record(pdmc_recorder *r)
{
    const int at = r->record->record_count;
    if (at > 0 && r->record->time[at - 1] == pdmc_particles_time(r->particles)) return PDMC_OK;
    r->record->record_count++;
    r->record->time[at] = pdmc_particles_time(r->particles);
    record_tips(r, at);
    if (!r->tips_alone || at == r->records - 1) record_sums(r, at);
    if (!r->tips_alone || r->study->load_steps > 0) record_conditions(r, at);
    if (r->tips_alone) return PDMC_OK;
    record_spheres(r, at);
    record_interfaces(r, at);
    const pdmc_status status = record_precision(r, at);
    return status == PDMC_OK ? record_fragments(r, at) : status;
}

static pdmc_status keep_fragments(pdmc_recorder *r)
{
    pdmc_status status = PDMC_OK;
    pdmc_explicit_record *record = r->record;
    const size_t n = (size_t)record->node_count, at = (size_t)record->snapshot_count * n;
    pdmc_free(record->fragment_list);
    record->fragment_count = 0;
    PDMC_NEW(record->fragment_list, r->pieces);
    record->fragment_count = r->pieces;
    pdmc_particles_fragments(r->particles, r->piece, r->pieces, record->fragment_list);
    memcpy(&record->fragment[at], r->piece, n * sizeof *r->piece);
done:
    return status;
}

void pdmc_recorder_count_state(pdmc_recorder *r)
{
    if (!r->is_kept) return;
    r->is_kept = false;
    r->record->snapshot_count++;
    r->record->state_count = r->record->snapshot_count * r->record->node_count;
}

pdmc_status pdmc_recorder_take_snapshot(pdmc_recorder *r)
{
    const pdmc_status status = pdmc_recorder_keep_state(r);
    if (status == PDMC_OK) pdmc_recorder_count_state(r);
    return status;
}

pdmc_status pdmc_recorder_keep_state(pdmc_recorder *r)
{
    pdmc_explicit_record *record = r->record;
    const size_t at = (size_t)record->snapshot_count * (size_t)record->node_count;
    r->is_kept = true;
    record->snapshot_time[record->snapshot_count] = pdmc_particles_time(r->particles);
    pdmc_particles_state(r->particles, &record->displacement[PDMC_AXES * at], &record->velocity[PDMC_AXES * at],
                         &record->damage[at]);
    return r->tips_alone ? PDMC_OK : keep_fragments(r);
}

bool pdmc_recorder_is_snapshot(const pdmc_recorder *r, int record)
{
    const int64_t intervals = r->records - 1, n = r->snapshots;
    return record * n / intervals > (record - 1) * n / intervals;
}
