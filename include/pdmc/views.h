// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Views of results: a table for people, JSON for programs, CSV for other tools, pictures. They read and compute
/// nothing but layout. Numbers have a decimal point whatever the locale.

#include "pdmc/results.h"

#include <stdio.h>

/// A table a person can read in a terminal of 100 columns.
/// @return PDMC_OK, PDMC_ERR_IO, or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_view_table(const pdmc_results *results, FILE *stream);

/// One JSON object on one line; what is not finite is null.
/// @return PDMC_OK, PDMC_ERR_IO, or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_view_json(const pdmc_results *results, FILE *stream);

/// Tidy CSV files in a folder, which is made if it is missing: pdf.csv, quantiles.csv, samples.csv, direction.csv, and
/// energy_samples.csv where that has at most a million rows; of a dynamic study, motion.csv. Older ones are replaced.
/// @return PDMC_OK, PDMC_ERR_CREATE, PDMC_ERR_IO, or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_view_export(const pdmc_results *results, const char *folder);

/// Pictures in a folder, which is made if it is missing, each as PNG and SVG, drawn by gnuplot. Older ones are
/// replaced.
/// @return PDMC_OK, PDMC_ERR_CREATE, PDMC_ERR_IO, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN where gnuplot is missing or fails
PDMC_API PDMC_NODISCARD pdmc_status pdmc_view_plot(const pdmc_results *results, const char *folder);
