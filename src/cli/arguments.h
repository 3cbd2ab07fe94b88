// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdmc/problem.h"

#include <stdbool.h>
#include <stdint.h>

enum { PDMC_ASKED = 12 }; // tips, and angles, that a comparison takes at most

typedef enum {
    COMMAND_RUN,
    COMMAND_CHECK,
    COMMAND_SHOW,
    COMMAND_EXPORT,
    COMMAND_PLOT,
    COMMAND_COMPARE,
    COMMAND_DESCRIBE,
    COMMAND_HELP,
    COMMAND_VERSION,
} command;

typedef struct {
    command command;
    const char *input, *folder; // study or result file; folder of export, plot and --plot
    const char *other;          // the result file it is compared with
    int tip_count, angle_count; // 0 for the defaults of a comparison
    const char *tips[PDMC_ASKED];
    double angles[PDMC_ASKED]; // degrees
    bool has_measure;
    pdmc_measure measure;
    const char *output; // NULL for the study's name with .h5, in the working folder
    int threads;        // as many as OpenMP would use, unless given
    int samples;        // 0 for the study's
    bool has_seed, force, quiet, json;
    uint64_t seed;
} arguments;

extern const char usage[];

/// Reads the command line. A mistake is reported to standard error.
/// @return false after a mistake
bool read_arguments(int argc, char *argv[], arguments *out);
