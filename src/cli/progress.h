// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/stochastic.h"

#include <stdbool.h>

/// How a run says how far it is, and how it is told to stop.
typedef struct {
    bool quiet, live; // live: one line that is redrawn; otherwise a line for each tenth
    bool line_open;
    int tenth;
    const char *what; // is counted: "samples", "time steps"
    double begin;     // when the counting began, s
} progress;

/// Catches SIGINT, SIGTERM and SIGHUP: the first stops the run after what is under way, the third leaves at once.
/// @param[in] what  is counted, for people
void progress_start(bool quiet, const char *what, progress *state);

/// A pdmc_run_options.progress with a progress as its context.
bool progress_show(void *context, int done, int total);

/// A pdmc_run_options.round with a progress as its context: a line that says what is known worst, how well, and how many
/// samples that leaves.
void progress_round(void *context, const pdmc_round *round);

/// Ends the line that is redrawn, so that what follows has a line of its own.
void progress_end(progress *state);
