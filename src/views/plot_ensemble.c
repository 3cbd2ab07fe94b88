// SPDX-License-Identifier: GPL-3.0-or-later

/// Pictures of the samples of an explicit study: how far a tip grows, and which way.

#include "base/base_impl.h"
#include "views/plots.h"

#include <gsl/gsl_sort.h>
#include <math.h>

/// The bars of the bins, and marks of the quantiles.
void pdmc_draw_growth(const pdmc_results *r, int tip, const pdmc_figure *figure)
{
    FILE *script = figure->script;
    const pdmc_ensemble_results *e = &r->ensemble;
    const size_t bins = (size_t)r->histogram_bins, t = (size_t)tip;
    const double *edges = &e->growth_edges[t * (bins + 1)];
    fputs("$bins << EOD\n", script);
    for (size_t b = 0; b < bins; b++) {
        const pdmc_estimate *density = &e->growth_density[t * bins + b];
        fprintf(script, "%.9g %.9g %.9g %.9g %.9g\n", 0.5 * (edges[b] + edges[b + 1]), density->value, density->lower,
                density->upper, edges[b + 1] - edges[b]);
    }
    fputs("EOD\n", script);
    for (size_t q = 0; q < PDMC_QUANTILES; q++)
        pdmc_figure_mark(figure, e->growth_quantiles[t * PDMC_QUANTILES + q].value);
    pdmc_figure_label(figure, "xlabel", "Growth (", r->length_unit, ")");
    pdmc_figure_label(figure, "ylabel", "Probability density (1/", r->length_unit, ")");
    fputs("set yrange [0:*]\nset style fill solid 0.4 noborder\nset key outside top center horizontal\n"
          "plot $bins using 1:2:5 with boxes linecolor " PDMC_BLUE " notitle, "
          "$bins using 1:2:3:4 with yerrorbars pointsize 0 linecolor " PDMC_BLUE " title '",
          script);
    fprintf(script, "%d samples, intervals at %.3g; dashed: 5, 50 and 95 %%'\n", e->sample_count - e->failed_count,
            r->confidence);
}

/// The share of samples that have broken up to a force, and the quantiles with their intervals.
pdmc_status pdmc_draw_forces(const pdmc_results *r, int condition, const pdmc_figure *figure)
{
    pdmc_status status = PDMC_OK;
    FILE *script = figure->script;
    const pdmc_ensemble_results *e = &r->ensemble;
    size_t count = 0;
    double *force = NULL;
    PDMC_NEW(force, e->sample_count);
    for (int s = 0; s < e->sample_count; s++)
        if (e->failure[s] == PDMC_SAMPLE_OK) force[count++] = e->largest_force[s * e->condition_count + condition];
    gsl_sort(force, 1, count);
    fputs("$share << EOD\n", script);
    for (size_t k = 0; k < count; k++)
        fprintf(script, "%.9g %.9g\n%.9g %.9g\n", force[k], (double)k / (double)count, force[k],
                (double)(k + 1) / (double)count);
    fputs("EOD\n$quantiles << EOD\n", script);
    for (int q = 0; q < PDMC_QUANTILES; q++) {
        const pdmc_estimate *x = &e->force_quantiles[condition * PDMC_QUANTILES + q];
        fprintf(script, "%.9g %.9g %.9g %.9g\n", x->value, pdmc_quantile_levels[q], x->lower, x->upper);
    }
    fputs("EOD\n", script);
    pdmc_figure_label(figure, "xlabel", "Largest force (", r->force_unit, ")");
    pdmc_figure_label(figure, "ylabel", "Share of samples up to it", "", "");
    fprintf(script,
            "set yrange [0:1]\nset key outside top center horizontal\n"
            "plot $share using 1:2 with lines linecolor " PDMC_BLUE " title '%zu samples', "
            "$quantiles using 1:2:3:4 with xerrorbars pointtype 7 linecolor " PDMC_VERMILION
            " title '5, 50 and 95 %%, intervals at %.3g'\n",
            count, r->confidence);
done:
    pdmc_free(force);
    return status;
}

/// A path from the end of the crack on, in the plate's coordinates.
static void put_point(const pdmc_followed_tip *tip, double ahead, double left, FILE *script)
{
    fprintf(script, "%.9g %.9g\n", tip->position[0] + ahead * tip->direction[0] - left * tip->direction[1],
            tip->position[1] + ahead * tip->direction[1] + left * tip->direction[0]);
}

static void put_samples(const pdmc_results *r, FILE *script)
{
    const pdmc_ensemble_results *e = &r->ensemble;
    const size_t stations = (size_t)e->station_count;
    fputs("$samples << EOD\n", script);
    for (size_t i = 0; i < (size_t)e->sample_count * (size_t)e->tip_count; i++) {
        for (size_t j = 0; j < stations && !isnan(e->path[i * stations + j]); j++)
            put_point(&r->particles.tips[i % (size_t)e->tip_count], e->station[j], e->path[i * stations + j], script);
        fputc('\n', script);
    }
    fputs("EOD\n", script);
}

/// One quantile of the paths that reach a station, tip by tip.
static void put_quantile(const pdmc_results *r, size_t q, FILE *script)
{
    const pdmc_ensemble_results *e = &r->ensemble;
    fprintf(script, "$quantile%zu << EOD\n", q);
    for (size_t i = 0; i < (size_t)e->tip_count * (size_t)e->station_count; i++) {
        const size_t j = i % (size_t)e->station_count;
        if (j == 0) fputc('\n', script);
        if (e->path_samples[i] > 0.0)
            put_point(&r->particles.tips[i / (size_t)e->station_count], e->station[j],
                      e->path_quantiles[i * PDMC_QUANTILES + q].value, script);
    }
    fputs("EOD\n", script);
}

void pdmc_draw_paths(const pdmc_results *r, const pdmc_figure *figure)
{
    FILE *script = figure->script;
    put_samples(r, script);
    for (size_t q = 0; q < PDMC_QUANTILES; q++) put_quantile(r, q, script);
    pdmc_figure_label(figure, "xlabel", "x (", r->length_unit, ")");
    pdmc_figure_label(figure, "ylabel", "y (", r->length_unit, ")");
    fputs("set key outside top center horizontal\n"
          "plot $samples with lines linecolor '#c0c0c0' title 'paths', "
          "$quantile0 with lines linecolor " PDMC_GREEN " title '5 %', "
          "$quantile1 with lines linecolor " PDMC_BLUE " title 'median', "
          "$quantile2 with lines linecolor " PDMC_VERMILION " title '95 % of those that come so far'\n",
          script);
}
