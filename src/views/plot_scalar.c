// SPDX-License-Identifier: GPL-3.0-or-later

/// Pictures of a scalar study: the errors of its levels, and the field of the last one.

#include "views/plots.h"
#include "views/scalar.h"

#include <math.h>

enum { POINTS = 4000 }; // that a picture can show

// Over what varies, with a line of the second order, or of the first in the horizon, through the last error.
void pdmc_draw_scalar_convergence(const pdmc_results *r, const pdmc_figure *figure)
{
    FILE *script = figure->script;
    const pdmc_scalar_record *s = &r->scalar;
    const bool by_horizon = s->level_count > 0 && !isnan(s->classical[0]);
    const bool has_wave = !isnan(s->wave_number);
    const double *over = by_horizon ? s->horizon : s->spacing, *last = by_horizon ? s->classical : s->error;
    const int n = s->level_count;
    fputs("set datafile missing 'nan'\n$levels << EOD\n", script);
    for (int i = 0; i < n; i++)
        fprintf(script, "%.9g %.9g %.9g %.9g %.9g\n", over[i], s->error[i], s->classical[i], s->motion_error[i],
                last[n - 1] * pow(over[i] / over[n - 1], by_horizon ? 1.0 : 2.0));
    fputs("EOD\nset logscale xy\nset format y '10^{%L}'\nset key bottom right\n", script);
    pdmc_figure_label(figure, "xlabel", by_horizon ? "Horizon (" : "Spacing (", r->length_unit, ")");
    fprintf(script,
            "set ylabel 'Root of the mean square error'\n"
            "plot $levels using 1:2 with linespoints linecolor " PDMC_BLUE " title 'to the %s'",
            has_wave ? "wave" : "coarser level");
    if (by_horizon)
        fputs(", $levels using 1:3 with linespoints linecolor " PDMC_VERMILION " title 'to classical elements'",
              script);
    if (n > 0 && !isnan(s->motion_error[0]))
        fprintf(script, ", $levels using 1:4 with linespoints linecolor " PDMC_GREEN " title '%s'",
                has_wave ? "to the standing wave" : "of motion, to the coarser level");
    fprintf(script, ", $levels using 1:5 with lines linecolor " PDMC_GREY " dashtype 2 title '%s order'\n",
            by_horizon ? "first" : "second");
}

void pdmc_draw_scalar_field(const pdmc_results *r, const pdmc_figure *figure)
{
    FILE *script = figure->script;
    const pdmc_scalar_record *s = &r->scalar;
    const int stride = 1 + s->value_count / POINTS;
    fputs("$values << EOD\n", script);
    for (int i = 0; i < s->value_count; i += stride)
        fprintf(script, "%.9g %.9g %.9g %.9g\n", s->position[2 * i], s->position[2 * i + 1], s->value[i], s->wave[i]);
    fputs("EOD\n", script);
    pdmc_figure_label(figure, "xlabel", "x (", r->length_unit, ")");
    if (s->dimension == 2) {
        pdmc_figure_label(figure, "ylabel", "y (", r->length_unit, ")");
        fputs("set size ratio -1\nset palette defined (-1 " PDMC_BLUE ", 0 'white', 1 " PDMC_VERMILION ")\n"
              "plot $values using 1:2:3 with points pointtype 7 pointsize 0.7 palette notitle\n",
              script);
        return;
    }
    fputs("set ylabel 'Field'\nplot ", script);
    if (!isnan(s->wave_number))
        fputs("$values using 1:4 smooth unique with lines linecolor " PDMC_GREY " title 'wave', ", script);
    fputs("$values using 1:3 with points pointtype 6 linecolor " PDMC_BLUE " title 'elements'\n", script);
}
