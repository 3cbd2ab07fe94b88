// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What the parts of the table share.

#include "views/views_impl.h"

enum { PDMC_BRIEF_SIZE = 32, PDMC_LINE_SIZE = 99 };

/// A number short enough for a column; a dash where there is none.
const char *pdmc_brief(char text[PDMC_BRIEF_SIZE], double x);

/// A text of the results as part of one line: what would move the cursor of a terminal becomes a space.
const char *pdmc_one_line(char text[PDMC_LINE_SIZE], const char *from);

/// Rare growth, where it was asked for.
void pdmc_table_reliability(const pdmc_results *results, FILE *stream);

/// A tip's mean and probability with a control, and what the control took; nothing where there is none.
void pdmc_table_controlled_tip(const pdmc_results *r, int tip, FILE *stream);
void pdmc_table_control(const pdmc_results *r, FILE *stream);

/// What a dynamic study has: its last state, its probes, and the balance of its energy.
void pdmc_table_motion(const pdmc_results *r, FILE *stream);

/// What an elastic study has: how it came to rest, its faces, and the line along it.
void pdmc_table_elastic(const pdmc_results *r, FILE *stream);

/// What a scalar study has: its levels, and the rates from one to the next.
void pdmc_table_scalar(const pdmc_results *r, FILE *stream);
/// What a study of quadrature has: errors, points and times of the rules.
void pdmc_table_quadrature(const pdmc_results *r, FILE *stream);

/// What an explicit study has: its grid, energies at the end, tips, spheres.
void pdmc_table_explicit(const pdmc_results *r, FILE *stream);

/// What its samples say; nothing where there are none.
void pdmc_table_ensemble(const pdmc_results *r, FILE *stream);
