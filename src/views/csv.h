// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What CSV files are made of.

#include "pdmc/results.h"

#include <stdio.h>

/// A field that may hold commas or quotes.
void pdmc_csv_text(FILE *stream, const char *text);

/// A column's name and its unit behind a comma: ",name[unit]".
void pdmc_csv_column(FILE *stream, const char *name, const char *unit);

/// The columns "<name><what>.x[unit]", ... y, z.
void pdmc_csv_axes(FILE *stream, const char *name, const char *what, const char *unit);

/// Numbers with 17 digits, each behind a comma.
void pdmc_csv_number(FILE *stream, double x);
void pdmc_csv_numbers(FILE *stream, int count, const double x[]);

/// Of a scalar study: a row a level, and a row a value of the last one.
pdmc_status pdmc_csv_levels(const pdmc_results *results, FILE *stream);
pdmc_status pdmc_csv_values(const pdmc_results *results, FILE *stream);

/// Of an elastic study: a row a node of the line, a node of the body, a face, and a step of damped motion.
pdmc_status pdmc_csv_line(const pdmc_results *results, FILE *stream);
pdmc_status pdmc_csv_solid_nodes(const pdmc_results *results, FILE *stream);
pdmc_status pdmc_csv_faces(const pdmc_results *results, FILE *stream);
pdmc_status pdmc_csv_energies(const pdmc_results *results, FILE *stream);

/// Of an explicit study: a row a record, a row a node of the last snapshot, and a row a piece of that.
pdmc_status pdmc_csv_records(const pdmc_results *results, FILE *stream);
pdmc_status pdmc_csv_nodes(const pdmc_results *results, FILE *stream);
pdmc_status pdmc_csv_fragments(const pdmc_results *results, FILE *stream);

/// ... of its samples: a row a sample and tip, and a row a tip and station of the paths.
pdmc_status pdmc_csv_draws(const pdmc_results *results, FILE *stream);
pdmc_status pdmc_csv_paths(const pdmc_results *results, FILE *stream);
pdmc_status pdmc_csv_forces(const pdmc_results *results, FILE *stream);
/// Of a study of quadrature: a row a rule and spacing.
pdmc_status pdmc_csv_quadrature(const pdmc_results *results, FILE *stream);
