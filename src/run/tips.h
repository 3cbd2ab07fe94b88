// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/explicit.h"
#include "pdmc/results.h"

/// The ends of the cracks that are segments. @param[out] tips  [2 crack_count], or NULL @return their number
int pdmc_tips_of(const pdmc_explicit *study, pdmc_followed_tip tips[]);

/// Where a point of the reference configuration is as a tip sees it, in the plane.
typedef struct {
    double ahead, left;
} pdmc_ahead;

static inline pdmc_ahead pdmc_ahead_of(const pdmc_followed_tip *tip, const double x[])
{
    const double *d = tip->direction, r[2] = {x[0] - tip->position[0], x[1] - tip->position[1]};
    return (pdmc_ahead){r[0] * d[0] + r[1] * d[1], r[1] * d[0] - r[0] * d[1]};
}

/// How far beyond the end of its crack a tip is: the largest distance, along the tip's direction, of a node whose damage
/// exceeds `study->tip_damage` (Silling & Askari 2005, section 5), of those within two horizons of the crack's line that are
/// reached from its end without a gap of more than a horizon: a crack that begins elsewhere is another one. -infinity where
/// there is none.
/// @param[in] x       [count, 3] nodes in the reference configuration
/// @param[in] damage  [count]
double pdmc_tip_front(const pdmc_explicit *study, const pdmc_followed_tip *tip, int count, const double x[],
                      const double damage[]);

/// The speeds of all tips at all records, by central differences over the study's window of positions linear in between;
/// at both ends of the time over what there is of the window. 0 with one record.
void pdmc_tip_speeds(pdmc_explicit_record *record);
