// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Where the state of bodies is recorded, whatever moves them.

#include "pdmc/explicit.h"
#include "pdmc/results.h"

typedef struct {
    const pdmc_explicit *study;
    pdmc_particles *particles;
    pdmc_explicit_record *record;
    int records;    // at most
    int snapshots;  // that are asked for
    bool tips_alone; // of samples, for time's sake: records of the tips, and of conditions at rest;
                     // sums with the last one, snapshots without pieces
    double *front;  // [tips] at the start
    double *damage; // [nodes]
    int *piece;     // [nodes] that they are in, as of the last record
    int pieces;
    bool is_kept; // whether there is a state after the last snapshot
    pdmc_rigid_sphere *spheres;
    uint64_t *bonds; // [2, interfaces] at the start, and broken
} pdmc_recorder;

/// Describes what moves and makes room for `records` records and the snapshots, and one more for where a run is stopped.
/// @param[in,out] recorder  with all but its arrays; clear with pdmc_recorder_clear(), whatever is returned
PDMC_NODISCARD pdmc_status pdmc_recorder_prepare(pdmc_recorder *recorder);
void pdmc_recorder_clear(pdmc_recorder *recorder);

/// Records where the bodies are, unless the last record is of the same time.
PDMC_NODISCARD pdmc_status pdmc_recorder_take_record(pdmc_recorder *recorder);
/// Keeps the state of all nodes.
PDMC_NODISCARD pdmc_status pdmc_recorder_take_snapshot(pdmc_recorder *recorder);
/// Keeps it in the next snapshot's place, until there is another one; and makes it that snapshot, if it is not yet.
PDMC_NODISCARD pdmc_status pdmc_recorder_keep_state(pdmc_recorder *recorder);
void pdmc_recorder_count_state(pdmc_recorder *recorder);
/// Whether a snapshot belongs to that record: they are as evenly spread as they can be, and the last record has one.
bool pdmc_recorder_is_snapshot(const pdmc_recorder *recorder, int record);
