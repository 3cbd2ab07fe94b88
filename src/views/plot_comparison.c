// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "views/comparison.h"
#include "views/plots.h"

#include <math.h>
#include <string.h>

static const char *const colours[PDMC_COMPARED] = {PDMC_BLUE, PDMC_VERMILION};
static const char *const dashes[PDMC_COMPARED] = {"1", "(12, 12)"}; // the first is seen below an equal second

/// What a file is called in the key: without its folder, unless that is all that tells the two apart.
static const char *short_label(const pdmc_comparison *c, int which)
{
    const char *names[PDMC_COMPARED];
    for (int i = 0; i < PDMC_COMPARED; i++) {
        const char *slash = strrchr(c->labels[i], '/');
        names[i] = slash ? slash + 1 : c->labels[i];
    }
    return strcmp(names[0], names[1]) == 0 ? c->labels[which] : names[which];
}

/// Sets the axes to where the densities of both end, and lets energies begin with 0 unless they are far from it.
/// Returns the largest energy.
static double put_ranges(const pdmc_comparison *c, const pdmc_compared_angle *angle, FILE *script)
{
    double top = 0.0, left = INFINITY, right = -INFINITY;
    for (int i = 0; i < PDMC_COMPARED; i++) {
        const size_t bins = (size_t)c->results[i]->histogram_bins, at = angle->place[i];
        const pdmc_energy_statistics *s = &c->results[i]->statistics[c->measure];
        left = fmin(left, s->histogram_edges[at * (bins + 1)]);
        right = fmax(right, s->histogram_edges[at * (bins + 1) + bins]);
        for (size_t b = 0; b < bins; b++)
            if (isfinite(s->density[at * bins + b].upper)) top = fmax(top, s->density[at * bins + b].upper);
    }
    const double margin = 0.02 * (right - left);
    left = left > 0.0 && left < 0.5 * right ? 0.0 : left - margin;
    if (right > left) fprintf(script, "set xrange [%.9g:%.9g]\n", left, right + margin);
    if (top > 0.0) fprintf(script, "set yrange [0:%.9g]\n", 1.05 * top);
    return right;
}

/// Where the density is low on the right: the angle and the distances.
static void put_distances(const pdmc_comparison *c, const pdmc_compared_angle *angle, const pdmc_figure *figure)
{
    char unit[PDMC_UNIT_SIZE], text[2 * PDMC_UNIT_SIZE];
    const pdmc_estimate *d = &angle->distances.kolmogorov_smirnov, *w = &angle->distances.wasserstein;
    fprintf(figure->script, "unset label\nset label 'φ = %.4g°' at graph 0.98, 0.93 right font ',24'\n",
            angle->angle * pdmc_degrees);
    if (isnan(d->value)) return;
    fprintf(figure->script, "set label 'D = %.3g [%.3g, %.3g]' at graph 0.98, 0.93 right offset character 0, -1.4\n",
            d->value, d->lower, d->upper);
    pdmc_results_unit(c->results[0], PDMC_UNIT_ENERGY, sizeof unit, unit);
    snprintf(text, sizeof text, "W = %.3g [%.3g, %.3g] %s", w->value, w->lower, w->upper, unit);
    fputs("set label ", figure->script);
    pdmc_figure_text(figure, text);
    fputs(" at graph 0.98, 0.93 right offset character 0, -2.7\n", figure->script);
}

static void put_labels(const pdmc_comparison *c, const pdmc_compared_tip *tip, const pdmc_figure *figure)
{
    char unit[PDMC_UNIT_SIZE], label[PDMC_UNIT_SIZE + PDMC_LONG_NAME_SIZE + 4];
    pdmc_results_unit(c->results[0], PDMC_UNIT_DENSITY, sizeof unit, unit);
    pdmc_figure_label(figure, "ylabel", "Probability density (", unit, ")");
    pdmc_results_unit(c->results[0], PDMC_UNIT_ENERGY, sizeof unit, unit);
    snprintf(label, sizeof label, "%s (%s)", pdmc_compared_name(c, tip), unit);
    pdmc_figure_label(figure, "xlabel",
                      c->measure == PDMC_MEASURE_BOND ? "Bond energy G_E\u200b at " : "Griffith energy G at ", label,
                      "");
}

/// G_c of both, or once where it is the same; one that is beyond the energies is not shown.
static void put_fracture_energies(const pdmc_comparison *c, double right, const pdmc_figure *figure)
{
    const double first = c->results[0]->fracture_energy, second = c->results[1]->fracture_energy;
    fputs("unset arrow\n", figure->script);
    if (first < right) pdmc_figure_mark(figure, first);
    if (second < right && second != first) pdmc_figure_mark(figure, second);
}

static void put_fracture_key(const pdmc_comparison *c, double right, FILE *script)
{
    const double first = c->results[0]->fracture_energy, second = c->results[1]->fracture_energy;
    if (!(fmin(first, second) < right)) return;
    fputs(", NaN with lines dashtype 2 linewidth 0.9 linecolor " PDMC_GREY " title 'G_c\u200b = ", script);
    if (first < right) fprintf(script, "%.4g", first);
    if (second < right && second != first) fprintf(script, "%s%.4g", first < right ? " and " : "", second);
    fputc('\'', script);
}

static void put_panel(const pdmc_comparison *c, const pdmc_compared_angle *angle, const pdmc_figure *figure)
{
    FILE *script = figure->script;
    const double right = put_ranges(c, angle, script);
    for (int i = 0; i < PDMC_COMPARED; i++) pdmc_draw_steps(c->results[i], c->measure, angle->place[i], i, script);
    put_fracture_energies(c, right, figure);
    put_distances(c, angle, figure);
    fputs("plot ", script);
    for (int i = 0; i < PDMC_COMPARED; i++)
        fprintf(script, "$density%d using 1:3:4 with filledcurves linecolor %s notitle, ", i, colours[i]);
    for (int i = 0; i < PDMC_COMPARED; i++) {
        fprintf(script, "$density%d using 1:2 with lines linecolor %s dashtype %s linewidth 1.2 title ", i, colours[i],
                dashes[i]);
        pdmc_figure_text(figure, short_label(c, i));
        fputs(", ", script);
    }
    fprintf(script, "NaN with filledcurves linecolor " PDMC_GREY " title '%g %% confidence'",
            100.0 * c->results[0]->confidence);
    put_fracture_key(c, right, script);
    fputc('\n', script);
}

/// A panel an angle, one below the other.
static void draw(const pdmc_comparison *c, const pdmc_compared_tip *tip, pdmc_figure *figure)
{
    if (tip->angle_count > 2) figure->height = figure->height / 2 * tip->angle_count;
    put_labels(c, tip, figure);
    fprintf(figure->script, "set key outside top center horizontal maxcols 4\nset multiplot layout %d, 1\n",
            tip->angle_count);
    for (int k = 0; k < tip->angle_count; k++) put_panel(c, &tip->angles[k], figure);
    fputs("unset multiplot\n", figure->script);
}

static pdmc_status plot_tip(const pdmc_comparison *c, const pdmc_compared_tip *tip, const char *folder)
{
    pdmc_status status = PDMC_OK;
    pdmc_figure figure;
    char stem[PDMC_LONG_NAME_SIZE + 32];
    snprintf(stem, sizeof stem, "compare_%s_%s", pdmc_compared_name(c, tip), pdmc_measure_names[c->measure]);
    PDMC_TRY(pdmc_figure_open(folder, stem, &figure));
    draw(c, tip, &figure);
    PDMC_TRY(pdmc_figure_draw(&figure));

done:
    pdmc_figure_close(&figure);
    return status;
}

pdmc_status pdmc_view_comparison_plot(const pdmc_comparison *comparison, const char *folder)
{
    pdmc_status status = PDMC_OK;
    pdmc_locale locale;
    PDMC_TRY(pdmc_locale_plain(&locale));
    PDMC_TRY(pdmc_folder_make(folder));
    for (int i = 0; i < PDMC_COMPARED; i++)
        if (comparison->results[i]->histogram_bins == 0) goto done;
    for (int t = 0; t < comparison->tip_count; t++)
        if (comparison->tips[t].angle_count > 0) PDMC_TRY(plot_tip(comparison, &comparison->tips[t], folder));

done:
    pdmc_locale_restore(&locale);
    return status;
}
