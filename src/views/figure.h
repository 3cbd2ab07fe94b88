// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A picture that gnuplot draws, as PNG and as SVG.
///
/// A drawing is a script: settings, data blocks and `plot` commands; it is run once for each file. What comes from the
/// results as text goes through pdmc_figure_text(), so that it cannot be a command.

#include "results/whole_file.h"
#include "views/views_impl.h"

typedef struct {
    FILE *script; // into which is drawn
    int height;   // of the PNG, which is 1600 pixels wide; a drawing may change it
    char *drawing;
    size_t drawing_size;
    pdmc_whole_file png, svg;
} pdmc_figure;

/// Colours that the colour-blind can tell apart (Okabe & Ito).
#define PDMC_BLUE "'#0072b2'"
#define PDMC_VERMILION "'#d55e00'"
#define PDMC_GREEN "'#009e73'"
#define PDMC_GREY "'#808080'"

/// Starts "<folder>/<stem>.png" and ".svg"; what cannot be in a file's name is replaced in the stem.
/// @param[out] figure  to be closed, also after a failure
pdmc_status pdmc_figure_open(const char *folder, const char *stem, pdmc_figure *figure);

/// Writes a text as a quoted string of gnuplot that shows it as it is.
void pdmc_figure_text(const pdmc_figure *figure, const char *text);

/// Writes "set <what> '<before><text><after>'"; `before` and `after` may use gnuplot's enhanced text.
void pdmc_figure_label(const pdmc_figure *figure, const char *what, const char *before, const char *text,
                       const char *after);

/// Marks a place on the x axis by a dashed line from bottom to top.
void pdmc_figure_mark(const pdmc_figure *figure, double x);

/// Runs gnuplot and lets both files appear.
pdmc_status pdmc_figure_draw(pdmc_figure *figure);

/// Frees everything and removes what has not appeared; a zeroed figure is allowed.
void pdmc_figure_close(pdmc_figure *figure);
