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

/// Tidy CSV files in a folder, which is made if it is missing: pdf.csv, quantiles.csv, samples.csv, direction.csv,
/// faces.csv (the displacement of the cracks' faces at the mean), and energy_samples.csv where that has at most a million
/// rows; of a dynamic study, motion.csv. Older ones are replaced.
/// @return PDMC_OK, PDMC_ERR_CREATE, PDMC_ERR_IO, or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_view_export(const pdmc_results *results, const char *folder);

/// Pictures in a folder, which is made if it is missing, each as PNG and SVG, drawn by gnuplot. Older ones are
/// replaced.
/// @return PDMC_OK, PDMC_ERR_CREATE, PDMC_ERR_IO, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN where gnuplot is missing or fails
PDMC_API PDMC_NODISCARD pdmc_status pdmc_view_plot(const pdmc_results *results, const char *folder);

/// What is compared of two results.
typedef struct {
    const char *labels[2];   // what they are called, e.g. the names of their files
    int tip_count;           // of the tips whose energies are compared; 0 for the first that both have
    const char *const *tips; // [tip_count] names
    int angle_count;         // 0 for straight ahead and the direction of the first's largest mean
    const double *angles;    // [angle_count] rad
    bool has_measure;        // false for the one that decides in the first
    pdmc_measure measure;
} pdmc_comparison_request;

/// Two results side by side, and the distances of their distributions.
typedef struct pdmc_comparison pdmc_comparison;

/// Compares two results. Tips go by their names. Where seeds and numbers of samples are equal, sample i of both is
/// drawn with the same random numbers, and samples are compared as pairs; see pdmc_statistics_distances(), _means() and
/// _pairs().
/// @param[in]  first, second  must outlive the comparison
/// @param[out] comparison     free with pdmc_comparison_destroy()
/// @return PDMC_OK, PDMC_ERR_DATA (different units, dynamic with static, no tip in common), PDMC_ERR_ARG (a tip or an
/// angle that not both have), or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_comparison_create(const pdmc_results *first, const pdmc_results *second,
                                                           const pdmc_comparison_request *request,
                                                           pdmc_comparison **comparison);

/// NULL is allowed; sets the pointer to NULL.
PDMC_API void pdmc_comparison_destroy(pdmc_comparison **comparison);

/// What else makes the two differ, or is not compared: lines, "" where there is nothing to say.
PDMC_API const char *pdmc_comparison_notes(const pdmc_comparison *comparison);

/// A table of 100 columns.
/// @return PDMC_OK, PDMC_ERR_IO, or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_view_comparison_table(const pdmc_comparison *comparison, FILE *stream);

/// One JSON object on one line; what is not finite is null.
/// @return PDMC_OK, PDMC_ERR_IO, or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_view_comparison_json(const pdmc_comparison *comparison, FILE *stream);

/// For each tip the probability densities of both, a panel an angle, as compare_<tip>_<measure>.png and .svg in a
/// folder that is made if it is missing. Older ones are replaced. A tip or file without densities has no picture.
/// @return as pdmc_view_plot()
PDMC_API PDMC_NODISCARD pdmc_status pdmc_view_comparison_plot(const pdmc_comparison *comparison, const char *folder);
