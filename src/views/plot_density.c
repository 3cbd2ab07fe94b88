// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "views/density.h"
#include "views/plots.h"

#include <math.h>

enum { SHOWN = 2, POINTS = 400 };
static const char *const colours[SHOWN] = {PDMC_BLUE, PDMC_VERMILION};

typedef struct {
    size_t at; // place of [T, A]
    double degrees;
    double energy[POINTS];
    pdmc_estimate smooth[POINTS]; // NaN where there is none
} shown_density;

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

static pdmc_status find_density(const pdmc_results *r, int tip, pdmc_measure measure, int i, shown_density *d)
{
    const int k = pdmc_nearest_angle(r, shown_direction(&r->tips[tip], i));
    const size_t bins = (size_t)r->histogram_bins;
    d->at = pdmc_place(r, tip, k);
    d->degrees = r->angles[k] * pdmc_degrees;
    // The bins leave out one sample of five hundred.
    const double *edges = &r->statistics[measure].histogram_edges[d->at * (bins + 1)];
    const double margin = 0.1 * (edges[bins] - edges[0]), first = fmax(edges[0] - margin, 0.0);
    for (int p = 0; p < POINTS; p++) d->energy[p] = first + (edges[bins] + margin - first) * p / (POINTS - 1);
    return pdmc_view_density(r, measure, d->at, POINTS, d->energy, d->smooth);
}

static bool is_smooth(const shown_density *d)
{
    return isfinite(d->smooth[0].value);
}

/// The data block $smooth<block>: energy and smooth density.
static void put_smooth(const shown_density *d, int block, FILE *script)
{
    fprintf(script, "$smooth%d << EOD\n", block);
    for (int p = 0; p < POINTS; p++) fprintf(script, "%.9g %.9g\n", d->energy[p], d->smooth[p].value);
    fputs("EOD\n", script);
}

/// Sets the axes to where the densities and the energies end; returns the largest energy.
static double put_ranges(const pdmc_results *r, pdmc_measure measure, const shown_density shown[SHOWN], FILE *script)
{
    const size_t bins = (size_t)r->histogram_bins;
    double top = 0.0, right = 0.0;
    for (int i = 0; i < SHOWN; i++) {
        const pdmc_energy_statistics *s = &r->statistics[measure];
        right = fmax(right, s->histogram_edges[shown[i].at * (bins + 1) + bins]);
        for (size_t b = 0; b < bins; b++) top = fmax(top, finite_or(s->density[shown[i].at * bins + b].upper, 0.0));
        for (int p = 0; p < POINTS; p++) top = fmax(top, finite_or(shown[i].smooth[p].value, 0.0));
    }
    if (right > 0.0) fprintf(script, "set xrange [0:%.9g]\n", 1.02 * right);
    if (top > 0.0) fprintf(script, "set yrange [0:%.9g]\n", 1.05 * top);
    return right;
}

// A space of no width follows an index: librsvg drops spaces there, and this one is none.
static void put_labels(const pdmc_results *r, int tip, pdmc_measure measure, const pdmc_figure *figure)
{
    char unit[PDMC_UNIT_SIZE], label[PDMC_UNIT_SIZE + sizeof r->tips[tip].name + 4];
    pdmc_results_unit(r, PDMC_UNIT_DENSITY, sizeof unit, unit);
    pdmc_figure_label(figure, "ylabel", "Probability density (", unit, ")");
    pdmc_results_unit(r, PDMC_UNIT_ENERGY, sizeof unit, unit);
    snprintf(label, sizeof label, "%s (%s)", r->tips[tip].name, unit);
    pdmc_figure_label(figure, "xlabel",
                      measure == PDMC_MEASURE_BOND ? "Bond energy G_E\u200b at " : "Griffith energy G at ", label, "");
}

/// What lines of one kind are, whatever their colour.
static void put_key(const pdmc_results *r, bool has_smooth, bool has_line, FILE *script)
{
    fprintf(script, "NaN with filledcurves linecolor " PDMC_GREY " title '%g %% confidence'", 100.0 * r->confidence);
    if (has_smooth) {
        fputs(", NaN with lines linewidth 2 linecolor " PDMC_GREY " title 'Gaussian kernel", script);
        if (r->kept_count < r->sample_count) fprintf(script, ", first %d samples", r->kept_count);
        fputc('\'', script);
    }
    if (has_line)
        fprintf(script, ", NaN with lines dashtype 2 linewidth 0.9 linecolor " PDMC_GREY " title 'G_c\u200b = %.4g'",
                r->fracture_energy);
    fputc('\n', script);
}

static void put_curves(const shown_density shown[SHOWN], FILE *script)
{
    for (int i = 0; i < SHOWN; i++)
        fprintf(script, "$density%d using 1:3:4 with filledcurves linecolor %s notitle, ", i, colours[i]);
    for (int i = 0; i < SHOWN; i++)
        fprintf(script, "$density%d using 1:2 with lines linecolor %s linewidth 0.8 title 'φ = %.4g°, %s', ", i,
                colours[i], shown[i].degrees, i ? "45° off" : "straight ahead");
    for (int i = 0; i < SHOWN; i++)
        if (is_smooth(&shown[i]))
            fprintf(script, "$smooth%d using 1:2 with lines linecolor %s linewidth 2 notitle, ", i, colours[i]);
}

pdmc_status pdmc_draw_density(const pdmc_results *r, int tip, pdmc_measure measure, const pdmc_figure *figure)
{
    pdmc_status status = PDMC_OK;
    FILE *script = figure->script;
    shown_density shown[SHOWN];
    bool has_smooth = false;
    for (int i = 0; i < SHOWN; i++) {
        PDMC_TRY(find_density(r, tip, measure, i, &shown[i]));
        pdmc_draw_steps(r, measure, shown[i].at, i, script);
        if (is_smooth(&shown[i])) put_smooth(&shown[i], i, script);
        has_smooth = has_smooth || is_smooth(&shown[i]);
    }
    const bool has_line = r->fracture_energy < put_ranges(r, measure, shown, script);
    if (has_line) pdmc_figure_mark(figure, r->fracture_energy);
    put_labels(r, tip, measure, figure);
    fputs("set key outside top center horizontal maxcols 2\nplot ", script);
    put_curves(shown, script);
    put_key(r, has_smooth, has_line, script);

done:
    return status;
}
