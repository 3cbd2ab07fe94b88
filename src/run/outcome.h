// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What becomes of the tips of a sample, and the path that they take.

#include "pdmc/explicit.h"
#include "pdmc/results.h"

/// How far the body reaches ahead of a tip: the farthest node along the tip's direction, of those within two horizons of its
/// line.
double pdmc_tip_reach(const pdmc_explicit *study, const pdmc_followed_tip *tip, int count, const double x[]);

/// The path of the damage ahead of a tip. At stations a spacing apart, from the end of the crack on, its offset to the left of
/// the crack's line: the mean over the nodes of the station whose damage exceeds `study->tip_damage`, weighed by it, of those
/// within a horizon of the offset before. The path ends where a station has none.
/// @param[in]  damage  [nodes]
/// @param[out] offset  [stations] NaN beyond the end
/// @return the number of stations that it has
int pdmc_tip_path(const pdmc_explicit *study, const pdmc_explicit_record *record, const pdmc_followed_tip *tip,
                  const double damage[], int stations, double offset[]);

/// A tip still runs if it moved in the study's window of speeds before the end, or at the last load.
/// @param[in] reach  of the body ahead of the tip
/// @param[in] front  of the path, ahead of the end of the crack
pdmc_outcome pdmc_tip_outcome(const pdmc_explicit *study, const pdmc_explicit_record *record, int tip, double reach,
                              double front);
