// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/plots.h"

#include <math.h>

enum { SHOWN = 2 };
static const char *const colours[SHOWN] = {PDMC_BLUE, PDMC_VERMILION};

/// Straight ahead, and 45 degrees off to the side that points up: the left tip's are pi and 3 pi / 4, as in figure 11
/// of Evangelatos & Spanos (2011).
static double shown_direction(const pdmc_tip *tip, int i)
{
    const double turn = 45.0 / pdmc_degrees;
    if (i == 0) return tip->direction;
    return tip->direction + (sin(tip->direction + turn) >= sin(tip->direction - turn) ? turn : -turn);
}

static double finite_or(double x, double otherwise)
{
    return isfinite(x) ? x : otherwise;
}

void pdmc_draw_steps(const pdmc_results *r, pdmc_measure measure, size_t at, int block, FILE *script)
{
    const size_t bins = (size_t)r->histogram_bins;
    const double *edges = &r->statistics[measure].histogram_edges[at * (bins + 1)];
    const pdmc_estimate *density = &r->statistics[measure].density[at * bins];
    fprintf(script, "$density%d << EOD\n%.9g 0 0 0\n", block, edges[0]);
    for (size_t b = 0; b < bins; b++) {
        const double value = density[b].value;
        const double lower = finite_or(density[b].lower, value), upper = finite_or(density[b].upper, value);
        fprintf(script, "%.9g %.9g %.9g %.9g\n", edges[b], value, lower, upper);
        fprintf(script, "%.9g %.9g %.9g %.9g\n", edges[b + 1], value, lower, upper);
    }
    fprintf(script, "%.9g 0 0 0\nEOD\n", edges[bins]);
}

/// Sets the axes to where the densities and the energies end; returns the largest energy.
static double put_ranges(const pdmc_results *r, pdmc_measure measure, const size_t at[SHOWN], FILE *script)
{
    const size_t bins = (size_t)r->histogram_bins;
    double top = 0.0, right = 0.0;
    for (int i = 0; i < SHOWN; i++) {
        const pdmc_energy_statistics *s = &r->statistics[measure];
        right = fmax(right, s->histogram_edges[at[i] * (bins + 1) + bins]);
        for (size_t b = 0; b < bins; b++) top = fmax(top, finite_or(s->density[at[i] * bins + b].upper, 0.0));
    }
    if (right > 0.0) fprintf(script, "set xrange [0:%.9g]\n", 1.02 * right);
    if (top > 0.0) fprintf(script, "set yrange [0:%.9g]\n", 1.05 * top);
    return right;
}

// A space of no width follows an index: librsvg drops spaces there, and this one is none.
void pdmc_draw_density(const pdmc_results *r, int tip, pdmc_measure measure, const pdmc_figure *figure)
{
    FILE *script = figure->script;
    char unit[PDMC_UNIT_SIZE], label[PDMC_UNIT_SIZE + sizeof r->tips[tip].name + 4];
    size_t at[SHOWN];
    double degrees[SHOWN];
    for (int i = 0; i < SHOWN; i++) {
        const int k = pdmc_nearest_angle(r, shown_direction(&r->tips[tip], i));
        at[i] = pdmc_place(r, tip, k);
        degrees[i] = r->angles[k] * pdmc_degrees;
        pdmc_draw_steps(r, measure, at[i], i, script);
    }
    const bool has_line = r->fracture_energy < put_ranges(r, measure, at, script);
    if (has_line) pdmc_figure_mark(figure, r->fracture_energy);
    pdmc_results_unit(r, PDMC_UNIT_DENSITY, sizeof unit, unit);
    pdmc_figure_label(figure, "ylabel", "Probability density (", unit, ")");
    pdmc_results_unit(r, PDMC_UNIT_ENERGY, sizeof unit, unit);
    snprintf(label, sizeof label, "%s (%s)", r->tips[tip].name, unit);
    pdmc_figure_label(figure, "xlabel",
                      measure == PDMC_MEASURE_BOND ? "Bond energy G_E\u200b at " : "Griffith energy G at ", label, "");
    fputs("set key outside top center horizontal maxcols 2\nplot ", script);
    for (int i = 0; i < SHOWN; i++)
        fprintf(script, "$density%d using 1:3:4 with filledcurves linecolor %s notitle, ", i, colours[i]);
    for (int i = 0; i < SHOWN; i++)
        fprintf(script, "$density%d using 1:2 with lines linecolor %s linewidth 1.2 title 'φ = %.4g°, %s', ", i,
                colours[i], degrees[i], i ? "45° off" : "straight ahead");
    fprintf(script, "NaN with filledcurves linecolor " PDMC_GREY " title '%g %% confidence'", 100.0 * r->confidence);
    if (has_line)
        fprintf(script, ", NaN with lines dashtype 2 linewidth 0.9 linecolor " PDMC_GREY " title 'G_c\u200b = %.4g'",
                r->fracture_energy);
    fputc('\n', script);
}
