// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What can be seen from where in a plate with straight cracks.

#include "pdmc/problem.h"

/// What a crack cuts, in its own frame: local x along it from its middle, local y to the left of from -> to. Where the
/// crack's end is not a tip, since it lies on the plate's edge or beyond, the cut goes on far outside: nothing sees
/// round a mouth.
typedef struct {
    double centre[2], half_length; // length
    double cosine, sine;           // of its direction
    double low, high;              // local x of the ends of the part inside the plate
    bool has_tip[2];               // whether its "from" is a tip, its "to"
} pdmc_cut;

/// A point from which one looks: off the cracks, or on a face.
typedef struct {
    double x[2]; // length
    int crack;   // -1 off the cracks
    int side;    // of a face: 1 left of from -> to, -1 right, 0 off the cracks
} pdmc_view;

typedef struct {
    int count;
    pdmc_cut *cut; // [count]
} pdmc_cuts;

/// @param[out] cuts  free with pdmc_cuts_clear(); zero on failure
PDMC_NODISCARD pdmc_status pdmc_cuts_create(const pdmc_problem *problem, pdmc_cuts *cuts);
void pdmc_cuts_clear(pdmc_cuts *cuts);

/// Coordinates in the crack's frame.
void pdmc_cut_local(const pdmc_cut *cut, const double x[2], double local[2]);

/// The inverse: a point of the plate from coordinates along and across the crack.
void pdmc_cut_global(const pdmc_cut *cut, double along, double across, double x[2]);

/// Distance from x to the nearest crack, infinite without cracks.
double pdmc_cuts_distance(const pdmc_cuts *cuts, const double x[2]);

/// Whether the segment between two points meets no crack. A face sees, and is seen from, its own half plane only;
/// points straight ahead of a tip count to the left, so that no point sees both faces.
bool pdmc_view_sees(const pdmc_cuts *cuts, const pdmc_view *a, const pdmc_view *b);

/// x as a point to look from: on a face where a crack passes within rounding, the one that `anchor` lies on.
pdmc_view pdmc_view_at(const pdmc_cuts *cuts, const double x[2], const double anchor[2]);
