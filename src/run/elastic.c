// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/elastic.h"

#include "base/base_impl.h"

#include <math.h>
#include <stdio.h>

static pdmc_status prepare(const pdmc_elastic *study, const pdmc_solid *solid, pdmc_elastic_record *record)
{
    pdmc_status status = PDMC_OK;
    const size_t n = pdmc_solid_nodes(solid);
    const int *nodes = study->nodes;
    record->spacing = study->spacing;
    record->horizon = study->horizon;
    record->axis = nodes[1] > nodes[0] ? 1 : 0;
    if (nodes[2] > nodes[record->axis]) record->axis = 2;
    PDMC_NEW(record->position, 3 * n);
    PDMC_NEW(record->displacement, 3 * n);
    PDMC_NEW(record->compensation, n);
    PDMC_NEW(record->line_position, nodes[record->axis]);
    PDMC_NEW(record->line_displacement, nodes[record->axis]);
    PDMC_NEW(record->line_strain, nodes[record->axis]);
    PDMC_NEW(record->face_displacement, 3 * PDMC_SOLID_FACES);
    PDMC_NEW(record->face_force, 3 * PDMC_SOLID_FACES);
    PDMC_NEW(record->time, study->steps + 1);
    PDMC_NEW(record->kinetic, study->steps + 1);
    PDMC_NEW(record->elastic, study->steps + 1);
done:
    return status;
}

static pdmc_status come_to_rest(const pdmc_elastic *study, const pdmc_solid *solid, double u[],
                                pdmc_elastic_record *record)
{
    pdmc_status status = PDMC_OK;
    pdmc_solid_solution solution;
    pdmc_relaxation_state relaxed;
    const pdmc_solid_motion motion = {study->density, study->damping, study->safety, study->steps};
    switch (study->method) {
    case PDMC_ELASTIC_STATIC:
        PDMC_TRY(pdmc_solid_rest(solid, study->tolerance, u, &solution));
        record->iterations = solution.iterations;
        record->residual = solution.residual;
        break;
    case PDMC_ELASTIC_RELAXATION:
        PDMC_TRY(pdmc_solid_relax(solid, study->tolerance, study->most_steps,
                                  study->has_constant_damping ? study->constant_damping : -1.0, u, &relaxed));
        record->iterations = relaxed.steps;
        record->residual = relaxed.residual;
        break;
    case PDMC_ELASTIC_DAMPED:
        PDMC_TRY(pdmc_solid_move(solid, &motion, u, record->kinetic, record->elastic));
        record->iterations = study->steps;
        record->energy_count = study->steps + 1;
        record->step = pdmc_solid_step(solid, &motion);
        for (int i = 0; i <= study->steps; i++) record->time[i] = i * record->step;
        break;
    }
done:
    return status;
}

/// Along the longest direction, through the node next to the middle.
static void record_line(const pdmc_elastic *study, const pdmc_solid *solid, const double u[],
                        pdmc_elastic_record *record)
{
    const size_t n = pdmc_solid_nodes(solid), axis = (size_t)record->axis;
    size_t index[3], stride = 1;
    for (size_t k = 0; k < 3; k++) index[k] = (size_t)(study->nodes[k] - 1) / 2;
    for (size_t k = 0; k < axis; k++) stride *= (size_t)study->nodes[k];
    index[axis] = 0;
    const size_t first = (index[2] * (size_t)study->nodes[1] + index[1]) * (size_t)study->nodes[0] + index[0];
    record->line_count = study->nodes[axis];
    for (int i = 0; i < record->line_count; i++) {
        const size_t node = first + (size_t)i * stride;
        record->line_position[i] = record->position[3 * node + axis];
        record->line_displacement[i] = u[axis * n + node];
        record->line_strain[i] =
            i == 0 ? NAN : (record->line_displacement[i] - record->line_displacement[i - 1]) / study->spacing;
    }
}

/// Mean displacement of a face's outermost nodes, and the force that holds or pulls it.
static void record_face(const pdmc_elastic *study, const pdmc_solid *solid, int face, const double u[],
                        const double force[], pdmc_elastic_record *record)
{
    const size_t n = pdmc_solid_nodes(solid);
    const double volume = study->spacing * study->spacing * study->spacing;
    const pdmc_solid_options body = pdmc_elastic_body(study, 1);
    const double *traction = pdmc_solid_traction_force(solid);
    const int layers = body.layers[face], axis = face / 2;
    int outermost = 0;
    for (size_t i = 0; i < n; i++) {
        const double outwards = (face % 2 ? 1.0 : -1.0) * record->position[3 * i + (size_t)axis] / study->spacing;
        const int layer = (int)lround(0.5 * (study->nodes[axis] - 1) - outwards);
        outermost += layer == 0;
        for (size_t k = 0; k < 3; k++) {
            if (layer == 0) record->face_displacement[3 * (size_t)face + k] += u[k * n + i];
            if (layer < layers) record->face_force[3 * (size_t)face + k] -= volume * force[k * n + i];
            if (layers == 0 && layer * study->spacing < study->horizon && body.load[face].traction[k] != 0.0)
                record->face_force[3 * (size_t)face + k] += volume * traction[k * n + i];
        }
    }
    for (int k = 0; k < 3; k++) record->face_displacement[3 * face + k] /= outermost;
}

static pdmc_status record_body(const pdmc_elastic *study, const pdmc_solid *solid, const double u[],
                               pdmc_elastic_record *record)
{
    pdmc_status status = PDMC_OK;
    const size_t n = pdmc_solid_nodes(solid);
    const double volume = study->spacing * study->spacing * study->spacing;
    double *force = NULL, *energy = NULL;
    PDMC_NEW(force, 3 * n);
    PDMC_NEW(energy, n);
    pdmc_solid_force(solid, u, force, energy);
    record->node_count = (int)n;
    record->energy = 0.0;
    for (size_t i = 0; i < n; i++) {
        pdmc_solid_position(solid, i, &record->position[3 * i]);
        for (size_t k = 0; k < 3; k++) record->displacement[3 * i + k] = u[k * n + i];
        record->compensation[i] = pdmc_solid_compensation_factors(solid)[i];
        record->energy += volume * energy[i];
    }
    for (int face = 0; face < PDMC_SOLID_FACES; face++) record_face(study, solid, face, u, force, record);
    record_line(study, solid, u, record);
done:
    pdmc_free(force);
    pdmc_free(energy);
    return status;
}

pdmc_status pdmc_run_elastic(const pdmc_elastic *study, const pdmc_run_options *options, pdmc_results *results)
{
    pdmc_status status = PDMC_OK;
    const pdmc_solid_options body = pdmc_elastic_body(study, options->threads);
    pdmc_elastic_record *record = &results->elastic;
    pdmc_solid *solid = NULL;
    double *u = NULL;
    const double start = pdmc_seconds();
    results->runtime.threads = options->threads;
    if (options->progress && !options->progress(options->context, 0, 1))
        PDMC_FAIL(PDMC_ERR_INTERRUPTED, "stopped before there was anything to save");
    status = pdmc_solid_create(&body, &solid);
    if (status == PDMC_ERR_SINGULAR) PDMC_FAIL(PDMC_ERR_CONFIG, "%s", pdmc_last_error());
    PDMC_TRY(status);
    results->runtime.assembly = pdmc_seconds() - start;
    PDMC_TRY(prepare(study, solid, record));
    PDMC_NEW(u, 3 * pdmc_solid_nodes(solid));
    pdmc_solid_start(solid, u);
    PDMC_TRY(come_to_rest(study, solid, u, record));
    PDMC_TRY(record_body(study, solid, u, record));
    results->runtime.motion = pdmc_seconds() - start - results->runtime.assembly;
    if (options->progress) options->progress(options->context, 1, 1);
done:
    pdmc_free(u);
    pdmc_solid_destroy(solid);
    return status == PDMC_ERR_ARG ? pdmc_raise(PDMC_ERR_CONFIG, "%s", pdmc_last_error()) : status;
}
