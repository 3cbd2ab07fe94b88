// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The study file: libconfig syntax, one table of settings as its schema. It ends in a plain problem.

#include "pdmc/elastic.h"
#include "pdmc/explicit.h"
#include "pdmc/horizon_study.h"
#include "pdmc/scalar.h"

typedef struct pdmc_study_source pdmc_study_source;

typedef struct {
    pdmc_problem problem;
    pdmc_explicit motion; // of an explicit study, of which the problem has only kind, title and units
    pdmc_scalar scalar;   // of a scalar study, in the same way
    pdmc_elastic elastic; // of an elastic study, in the same way
    pdmc_horizon_study quadrature; // of a study of quadrature, as the last
    char *input;    // the study file as it was given
    char *resolved; // every setting, defaults filled in, with its unit; itself a valid study file
    char *warnings; // one line each, "file:line: warning: ..."; "" if there are none
    pdmc_study_source *source; // the file, for the places of what is found out later
} pdmc_study;

/// Reads a study file.
/// Every setting is checked: unknown keys (with the nearest known one), kinds, ranges, and meaning (cracks inside the
/// plate, a horizon that fits the cracks, a load, tips that exist). The message of a failure is one line,
/// "file:line: what is wrong, what is allowed".
/// @param[in]  path   the file; an @include line is relative to the file in which it stands
/// @param[out] study  free with pdmc_study_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_NO_INPUT, PDMC_ERR_CONFIG, or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_study_read(const char *path, pdmc_study *study);

/// Puts the place in the file before the message of a failure that was found out after the study was read, by pdmc_run() or
/// pdmc_explicit_particles(), where the message begins with what is to blame, as in "bodies[1]: " or "time.step: ".
/// @return the status
PDMC_API PDMC_NODISCARD pdmc_status pdmc_study_place(const pdmc_study *study, pdmc_status status);

/// Writes `study->resolved` anew after the problem was changed (another seed, another number of samples).
PDMC_API PDMC_NODISCARD pdmc_status pdmc_study_resolve(pdmc_study *study);

/// Takes another number of samples, and writes study->resolved anew.
/// @return PDMC_OK, PDMC_ERR_ARG where it is no multiple of the design's replicates, or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_study_set_samples(pdmc_study *study, int samples);

/// The table of settings as text, one line a setting: key, kind, unit, range, default, meaning. Free with free().
PDMC_API PDMC_NODISCARD pdmc_status pdmc_study_describe(char **text);

/// Frees what the study owns and sets it to zero; a zeroed study is allowed.
PDMC_API void pdmc_study_clear(pdmc_study *study);
