// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Results that no solver computed but that look as if: a square plate with a centre crack in tension, whose load and
/// micromodulus are random. For tests of what is written, read and shown.

#include "pdmc/results.h"

typedef struct {
    int cracks; // 0 to 2; each has two tips
    int angles;
    int samples;
    int failed; // of the samples; with any, some numbers are NaN and some bounds infinite
    int radial_bins;
    int histogram_bins;
    int times, probes; // with times, the study is dynamic
} made_up_size;

extern const made_up_size made_up_small;
extern const made_up_size made_up_motion; // a dynamic study
extern const made_up_size made_up_paper; // as large as the study of Evangelatos & Spanos (2011), section 6.3

/// Free with pdmc_results_clear().
pdmc_results made_up_results(made_up_size size);

/// An explicit study of two bodies, 8 x 4 nodes in the plane or 8 x 4 x 3 in space, with two tips of which one grows at a
/// constant speed, two spheres and three snapshots. Free with pdmc_results_clear().
pdmc_results made_up_explicit(int dimension);

/// Adds four samples of its two tips to made_up_explicit(), of which the last failed.
void made_up_samples(pdmc_results *results);
